// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws a shape with its labels, in milliseconds: draw_labels SHAPE LABELS PICTURE.png
//
// More pairs LABELS PICTURE.png may follow: all are seen from the side that shows most of the first, and what
// covers most of one of its parts has the color of that part.

#include "draw/draw_parts.h"
#include "io/atomic_file.h"
#include "io/part_colors.h"
#include "io/read_shape.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
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

std::size_t number_of(const std::vector<int>& labels)
{
  return labels.empty()
             ? 0
             : static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end())) + 1;
}

std::vector<Shape_io::Color> own_colors(const Shape_io::Shape& shape,
                                        const std::vector<int>& labels)
{
  return Shape_io::part_colors(Shape_io::part_neighbors(shape, labels, number_of(labels)));
}

/// the colors of other labels, for those that have most in common with them, each once; the rest get others
std::vector<Shape_io::Color> matched_colors(const std::vector<int>& labels,
                                            const std::vector<int>& others,
                                            const std::vector<Shape_io::Color>& colors_of_others)
{
  std::map<std::pair<int, int>, long> overlaps;
  for (std::size_t i = 0; i < labels.size(); ++i) ++overlaps[{labels[i], others[i]}];
  std::vector<std::pair<long, std::pair<int, int>>> order;
  for (const auto& [pair, count] : overlaps) order.push_back({-count, pair});
  std::sort(order.begin(), order.end());
  std::vector<Shape_io::Color> colors(number_of(labels));
  std::set<int> given, taken;
  for (const auto& entry : order)
  {
    const auto [label, other] = entry.second;
    if (given.count(label) > 0 || taken.count(other) > 0) continue;
    colors[static_cast<std::size_t>(label)] = colors_of_others[static_cast<std::size_t>(other)];
    given.insert(label);
    taken.insert(other);
  }
  std::size_t next = 0;
  const std::set<Shape_io::Color> used(colors.begin(), colors.end());
  for (std::size_t l = 0; l < colors.size(); ++l)
  {
    if (given.count(static_cast<int>(l)) > 0) continue;
    const auto at = [](const std::size_t i)
    { return Shape_io::internal::palette[i % Shape_io::internal::palette_size]; };
    for (std::size_t tried = 0;
         tried < Shape_io::internal::palette_size && used.count(at(next)) > 0; ++tried)
      ++next;
    colors[l] = at(next++);
  }
  return colors;
}

/// draws pairs of labels and a picture to make
void draw(const Shape_io::Shape& shape, const std::vector<std::string>& pairs)
{
  Draw_parts::View view;
  std::vector<int> first;
  std::vector<Shape_io::Color> first_colors;
  for (std::size_t i = 0; i < pairs.size(); i += 2)
  {
    const std::vector<int> labels = read_labels(pairs[i], shape.number_of_elements());
    if (i == 0)
    {
      first = labels;
      first_colors = own_colors(shape, labels);
      const Draw_parts::Scene scene = Draw_parts::make_scene(shape, labels);
      view = Draw_parts::look(scene, Draw_parts::best_camera(scene, labels), 220);
    }
    const auto colors = i == 0 ? first_colors : matched_colors(labels, first, first_colors);
    Shape_io::Atomic_file file(pairs[i + 1]);
    Draw_parts::write_png(Draw_parts::make_picture(view, labels, colors), file.stream());
    file.commit();
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc < 4 || argc % 2 != 0)
      throw std::invalid_argument("give a shape, and labels and the picture to make, once or more");
    draw(Shape_io::read_shape(argv[1]), {argv + 2, argv + argc});
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "draw_labels: " << error.what() << '\n';
    return 1;
  }
}
