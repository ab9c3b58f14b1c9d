// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CONVEX_DIVISION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CONVEX_DIVISION_H

#include "io/shape.h"

#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <memory>
#include <vector>

// Cuts a solid by planes, until the pieces are nearly convex.

namespace Shape_io {

using Hull_mesh = CGAL::Surface_mesh<Point>;

// Whether the points span a body.
bool has_hull(const std::vector<Point>& points);

Hull_mesh hull_of(const std::vector<Point>& points);

// A part whose inside is known if it is closed.
class Solid_part
{
public:
  explicit Solid_part(const Shape& triangles_or_polygons);

  bool holds(const Point& p) const { return m_side && (*m_side)(p) != CGAL::ON_UNBOUNDED_SIDE; }

private:
  std::unique_ptr<Hull_mesh> m_mesh; // stays where it is when a part is moved
  std::unique_ptr<CGAL::Side_of_triangle_mesh<Hull_mesh, Kernel>> m_side;
};

// What of a part's surface lies in one piece of it: convex polygons.
using Piece = std::vector<std::vector<Point>>;

std::vector<Point> points_of(const Piece& piece);

// Where a hull is furthest from what it is the hull of.
struct Hull_error
{
  double distance = 0.;
  Point nearest = CGAL::ORIGIN; // of the surface
};

// Points of the hull that are in one of the parts are no errors: cuts have no surface. They are
// sampled so closely that an error, if it is as large as the largest one that is allowed, is found to about a hundredth.
Hull_error hull_error(const Hull_mesh& hull, const Piece& piece,
                      const std::vector<const Solid_part*>& parts, double largest_error);

// The pieces of a part, none of which has a larger error than that, as far as cuts can bring it about.
std::vector<Piece> divided(const Piece& whole, const Solid_part& part, double largest_error);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CONVEX_DIVISION_H
