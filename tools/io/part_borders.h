// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_BORDERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_BORDERS_H

#include "io/shape.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Where the parts of a mesh meet on its surface, and the closed curves that go from there through its inside.

namespace Shape_io {

// A mesh whose corners at one position are one point.
struct Welded_shape
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>>
      polygons; // those of the shape, in its order; flat ones have no corners
};

// Sides are turned where they contradict each other, outwards as a whole; where that can't be, points are doubled.
Welded_shape welded_shape(const Shape& shape);

using Label_pair = std::pair<int, int>;           // the smaller first
using Edge = std::pair<std::size_t, std::size_t>; // from, to
using Border =
    std::map<Label_pair, std::vector<Edge>>; // edges as the faces of the first label have them

// Borders that do not touch each other, with one label a polygon.
std::vector<Border> part_borders(const Welded_shape& shape, const std::vector<int>& labels);

// Closes the curves between each two parts. Where three parts meet at the surface, edges are added on which they meet
// inside, from there to a counterpart, or to a new point.
void close_border(Border& border, std::vector<Point>& points);

// Points in their order, the last before the first.
using Loop = std::vector<std::size_t>;

// The loops that edges make. Those of two edges, which bound nothing, are left out.
std::vector<Loop> loops_of(const std::vector<Edge>& edges);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_BORDERS_H
