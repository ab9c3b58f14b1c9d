// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/shape_generator.h"

#include "shapes/polygonize_shape.h"
#include "shapes/shape_catalog.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Shape_generator {
namespace internal {

namespace {

using Catalog = std::vector<std::pair<std::string, Implicit_shape (*)()>>;

const Catalog& catalog()
{
  static const Catalog result = {{"sphere", sphere},     {"box", box},
                                 {"torus", torus},       {"thin_plate", thin_plate},
                                 {"l_shape", l_shape},   {"two_spheres", two_spheres},
                                 {"dumbbell", dumbbell}, {"cup", cup},
                                 {"table", table},       {"chair", chair},
                                 {"figure", figure},     {"four_leg", four_leg},
                                 {"airplane", airplane}, {"octopus", octopus},
                                 {"hand", hand},         {"ant", ant},
                                 {"pliers", pliers},     {"glasses", glasses}};
  return result;
}

} // namespace

Implicit_shape implicit_shape(const std::string& name)
{
  std::string known;
  for (const auto& entry : catalog())
  {
    if (entry.first == name) return entry.second();
    known += " " + entry.first;
  }
  throw std::invalid_argument("Shape_generator: there is no shape \"" + name +
                              "\"; choose one of:" + known);
}

namespace {

Labeled_mesh polygonized(const std::string& name, std::size_t number_of_faces, unsigned seed)
{
  const Implicit_shape shape = implicit_shape(name);
  Polygonized_shape mesh = polygonize(name, shape, number_of_faces, seed);
  return {std::move(mesh.points), std::move(mesh.faces), std::move(mesh.labels),
          shape.part_names()};
}

Point face_normal(const Labeled_mesh& mesh, std::size_t face)
{
  const std::array<std::size_t, 3>& f = mesh.faces[face];
  const Point& a = mesh.points[f[0]];
  return cross(subtract(mesh.points[f[1]], a), subtract(mesh.points[f[2]], a));
}

Point random_point_in_face(const Labeled_mesh& mesh, std::size_t face, std::mt19937& generator)
{
  double s = uniform(generator), t = uniform(generator);
  if (s + t > 1)
  {
    s = 1 - s;
    t = 1 - t;
  }
  const std::array<std::size_t, 3>& f = mesh.faces[face];
  return add(scale(mesh.points[f[0]], 1 - s - t),
             add(scale(mesh.points[f[1]], s), scale(mesh.points[f[2]], t)));
}

} // namespace
} // namespace internal

std::vector<std::string> shape_names()
{
  std::vector<std::string> result;
  for (const auto& entry : internal::catalog()) result.push_back(entry.first);
  return result;
}

Labeled_mesh make_mesh(const std::string& name, std::size_t approximate_number_of_faces,
                       unsigned seed)
{
  if (approximate_number_of_faces < 1000)
    throw std::invalid_argument("Shape_generator: " + std::to_string(approximate_number_of_faces) +
                                " faces are too few for a shape; ask for 1000 or more");
  return internal::polygonized(name, approximate_number_of_faces, seed);
}

Labeled_cloud make_cloud(const std::string& name, std::size_t number_of_points, unsigned seed)
{
  const Implicit_shape shape = internal::implicit_shape(name);
  const Labeled_mesh mesh = internal::polygonized(name, 12000, 0);
  std::vector<double> area_up_to;
  double area = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    area += internal::length(internal::face_normal(mesh, f)) / 2;
    area_up_to.push_back(area);
  }
  Labeled_cloud cloud;
  cloud.part_names = mesh.part_names;
  std::mt19937 generator(seed);
  for (std::size_t i = 0; i < number_of_points; ++i)
  {
    const auto chosen = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1,
                                         internal::uniform(generator) * area);
    const std::size_t face = static_cast<std::size_t>(chosen - area_up_to.begin());
    const Point flat_normal = internal::normalized(internal::face_normal(mesh, face));
    Point p = internal::random_point_in_face(mesh, face, generator);
    // The faces cut off a little of the curved surface; at a crease the gradient may be that of
    // the other side, then the face knows better.
    p = shape.project(p, 0.01);
    const Point gradient = internal::normalized(shape.gradient(p));
    const bool use_gradient = internal::dot(gradient, flat_normal) > 0.7;
    cloud.points.push_back(p);
    cloud.normals.push_back(use_gradient ? gradient : flat_normal);
    cloud.labels.push_back(mesh.labels[face]);
  }
  return cloud;
}

} // namespace Shape_generator
