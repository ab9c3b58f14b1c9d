// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_GENERATOR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_GENERATOR_H

#include "shapes/implicit_shape.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
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

Implicit_shape implicit_shape(const std::string& name);

} // namespace internal

std::vector<std::string> shape_names();

// A closed triangle mesh of the shape with a true part for each face. The seed moves the grid that
// the mesh comes from, so it changes the triangles but not the shape; 0 puts the grid in the
// middle of the shape.
// Throws std::invalid_argument for a name that shape_names() does not have and for fewer than 1000
// faces, and std::runtime_error if the faces are too few for the shape: all shapes have meshes from
// 6000 faces on, those without thin parts also smaller ones.
Labeled_mesh make_mesh(const std::string& name, std::size_t approximate_number_of_faces = 12000,
                       unsigned seed = 0);

// Points spread at random, uniformly by area, over the surface of the shape, each with the normal
// and the true part.
Labeled_cloud make_cloud(const std::string& name, std::size_t number_of_points, unsigned seed = 0);

} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_GENERATOR_H
