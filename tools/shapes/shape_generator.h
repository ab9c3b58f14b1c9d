// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_GENERATOR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_GENERATOR_H

#include "shapes/polygonize_shape.h"
#include "shapes/shape_catalog.h"
#include "shapes/shape_catalog_small_parts.h"

#include <array>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Generator of shapes with known parts, for tests, examples and benchmarks.

namespace Shape_generator {

struct Labeled_mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> faces; // closed, oriented outwards
  std::vector<int> labels;                       // the part of each face, index in part_names
  std::vector<std::string> part_names;
};

struct Labeled_cloud
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 3>> normals; // of length one, outwards
  std::vector<int> labels;                    // the part of each point, index in part_names
  std::vector<std::string> part_names;
};

namespace internal {

using Catalogue = std::vector<std::pair<std::string, Implicit_shape (*)()>>;

inline const Catalogue& catalogue()
{
  static const Catalogue result = {{"sphere", sphere},     {"box", box},
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

inline Implicit_shape implicit_shape(const std::string& name)
{
  std::string known;
  for (const auto& entry : catalogue())
  {
    if (entry.first == name) return entry.second();
    known += " " + entry.first;
  }
  throw std::invalid_argument("Shape_generator: there is no shape \"" + name +
                              "\"; choose one of:" + known);
}

inline Labeled_mesh polygonised(const Implicit_shape& shape, std::size_t number_of_faces,
                                unsigned seed)
{
  Polygonised_shape mesh = polygonise(shape, number_of_faces, seed);
  return {std::move(mesh.points), std::move(mesh.faces), std::move(mesh.labels),
          shape.part_names()};
}

inline Point face_normal(const Labeled_mesh& mesh, std::size_t face)
{
  const std::array<std::size_t, 3>& f = mesh.faces[face];
  const Point& a = mesh.points[f[0]];
  return cross(subtract(mesh.points[f[1]], a), subtract(mesh.points[f[2]], a));
}

inline Point random_point_in_face(const Labeled_mesh& mesh, std::size_t face,
                                  std::mt19937& generator)
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

} // namespace internal

inline std::vector<std::string> shape_names()
{
  std::vector<std::string> result;
  for (const auto& entry : internal::catalogue()) result.push_back(entry.first);
  return result;
}

// A closed triangle mesh of the shape with a true part for each face. The seed moves the grid that
// the mesh comes from, so it changes the triangles but not the shape; 0 puts the grid in the
// middle of the shape.
// Throws std::invalid_argument for a name that shape_names() does not have and for fewer than 1000
// faces, and std::runtime_error if the faces are too few for the shape: all shapes have meshes from
// 6000 faces on, those without thin parts also smaller ones.
inline Labeled_mesh make_mesh(const std::string& name,
                              std::size_t approximate_number_of_faces = 12000, unsigned seed = 0)
{
  const Implicit_shape shape = internal::implicit_shape(name);
  if (approximate_number_of_faces < 1000)
    throw std::invalid_argument("Shape_generator: " + std::to_string(approximate_number_of_faces) +
                                " faces are too few for a shape; ask for 1000 or more");
  return internal::polygonised(shape, approximate_number_of_faces, seed);
}

// Points spread at random, uniformly by area, over the surface of the shape, each with the normal
// and the true part.
inline Labeled_cloud make_cloud(const std::string& name, std::size_t number_of_points,
                                unsigned seed = 0)
{
  const Implicit_shape shape = internal::implicit_shape(name);
  const Labeled_mesh mesh = internal::polygonised(shape, 12000, 0);
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

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_GENERATOR_H
