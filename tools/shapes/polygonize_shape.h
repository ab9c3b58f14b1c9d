// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_POLYGONIZE_SHAPE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_POLYGONIZE_SHAPE_H

#include "shapes/implicit_shape.h"

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

// From an implicit shape to a triangle mesh of a wanted size with a part label for each face.

namespace Shape_generator {
namespace internal {

using Triangle = std::array<std::size_t, 3>;

// Uniform in [0, 1). The standard distributions differ between libraries; this does not.
inline double uniform(std::mt19937& generator) { return double(generator()) / 4294967296.; }

struct Polygonized_shape
{
  std::vector<Point> points;
  std::vector<Triangle> faces;
  std::vector<int> labels;
};

// The name is for the message if the shape is finer than so many faces can be.
Polygonized_shape polygonize(const std::string& name, const Implicit_shape& shape,
                             std::size_t number_of_faces, unsigned seed);

} // namespace internal
} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_POLYGONIZE_SHAPE_H
