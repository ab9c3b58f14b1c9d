// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_BORDER_CAPS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_BORDER_CAPS_H

#include "io/part_borders.h"
#include "io/shape.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

// The surfaces between parts, inside of the shape.

namespace Shape_io {

using Triangle = std::array<std::size_t, 3>;

// Ways to fill a curve.
enum class Filling
{
  PLANE,    // as it lies in the plane that fits it best
  DELAUNAY, // by CGAL's hole filling
  CONE,     // with a new point in the middle
  NONE
};

// How the surface between parts goes inwards from their border, before it goes across.
struct Entrance
{
  double depth = 0.; // in mean lengths of the border's edges
  int smoothing = 0; // rounds, which take the zigzags out
};

struct Cap_style
{
  Entrance entrance;
  std::map<Label_pair, Filling> fillings = {}; // those that are no planes
};

struct Cap
{
  Label_pair parts;
  std::vector<Triangle> triangles; // as they close the second part; turned, they close the first
};

// Unit normals, or zero where there is none.
std::vector<Vector> normals_of_points(const Welded_shape& shape);

// Where a hollow shape is cut there is a border outside and one inside, with a ring between them: they become one.
void join_hollow_cuts(std::vector<Border>& borders, const std::vector<Point>& points);

// A cap for each two parts that meet at the border. Points are added.
std::vector<Cap> caps_of(Border border, const Cap_style& style, const std::vector<Vector>& normals,
                         std::vector<Point>& points);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_BORDER_CAPS_H
