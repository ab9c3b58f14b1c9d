// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws a shape with its labels, in milliseconds: draw_labels SHAPE LABELS PICTURE.ppm

#include "report/draw_parts.h"

#include "io/part_colors.h"
#include "io/read_shape.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::vector<int> read_labels(const std::string& path, const std::size_t number_of_elements)
{
  std::ifstream in(path);
  std::vector<int> labels;
  for (int l = 0; in >> l;)
  {
    if (l < 0) throw std::runtime_error(path + ": labels must not be negative");
    labels.push_back(l);
  }
  if (labels.size() != number_of_elements)
    throw std::runtime_error(path + " has " + std::to_string(labels.size()) + " labels for " +
                             std::to_string(number_of_elements) +
                             " points or faces; give the labels of this shape");
  return labels;
}

/// the scene, with polygons cut into triangles; `labels` become those of the triangles
Draw_parts::Scene make_scene(const Shape_io::Shape& shape, std::vector<int>& labels)
{
  Draw_parts::Scene scene;
  for (const auto& p : shape.points) scene.points.push_back({p.x(), p.y(), p.z()});
  if (!shape.is_mesh())
    for (const auto& v : shape.normals) scene.normals.push_back({v.x(), v.y(), v.z()});
  std::vector<int> of_triangles;
  for (std::size_t f = 0; f < shape.polygons.size(); ++f)
  {
    const auto& polygon = shape.polygons[f];
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      scene.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
      of_triangles.push_back(labels[f]);
    }
  }
  if (shape.is_mesh()) labels = of_triangles;
  return scene;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc != 4) throw std::invalid_argument("give a shape, its labels, and the picture to make");
    const Shape_io::Shape shape = Shape_io::read_shape(argv[1]);
    std::vector<int> labels = read_labels(argv[2], shape.number_of_elements());
    std::size_t count = 0;
    for (const int l : labels) count = (std::max)(count, static_cast<std::size_t>(l) + 1);
    const auto colors = Shape_io::part_colors(Shape_io::part_neighbors(shape, labels, count));
    const Draw_parts::Scene scene = make_scene(shape, labels);
    Draw_parts::write_picture(Draw_parts::look(scene, Draw_parts::best_camera(scene, labels), 440),
                              labels, colors, argv[3]);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "draw_labels: " << error.what() << '\n';
    return 1;
  }
}
