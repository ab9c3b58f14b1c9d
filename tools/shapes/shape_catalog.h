// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_CATALOG_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_CATALOG_H

#include "shapes/implicit_shape.h"

#include <array>
#include <cstddef>
#include <utility>

// The shapes that can be generated. They are about one unit large and stand upright on z.

namespace Shape_generator {
namespace internal {

const std::array<std::pair<double, const char*>, 2>& sides();

void add_block(Implicit_shape& shape, std::size_t part, const Point& lower, const Point& upper);
Implicit_shape sphere();
Implicit_shape box();
Implicit_shape torus();
Implicit_shape thin_plate();
Implicit_shape two_spheres();
Implicit_shape l_shape();
Implicit_shape dumbbell();
Implicit_shape cup();
Implicit_shape table();
Implicit_shape chair();

void add_person_torso_and_head(Implicit_shape& shape);
Implicit_shape figure();
Implicit_shape four_leg();

// those with many, thin or small parts
Implicit_shape airplane();
Implicit_shape octopus();
Implicit_shape hand();
Implicit_shape ant();
Implicit_shape pliers();
Implicit_shape glasses();

} // namespace internal
} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SHAPE_CATALOG_H
