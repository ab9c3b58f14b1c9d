// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_HULLS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_HULLS_H

#include "io/shape.h"

#include <cstddef>
#include <limits>
#include <vector>

// Convex hulls of the parts: an approximate convex decomposition, as physics engines take it.

namespace Shape_io {

struct Hull_options
{
  // Parts of a mesh are cut by planes until no hull is further from its part than this, in diagonals of the shape's
  // box.
  double largest_error = std::numeric_limits<double>::infinity();
  // Then hulls are joined until there are no more than this, at least 1, ...
  std::size_t most_hulls = (std::numeric_limits<std::size_t>::max)();
  // ... and corners are left out, those that matter least, until each hull has no more than this, at least 4.
  std::size_t most_corners = (std::numeric_limits<std::size_t>::max)();
};

struct Part_hull
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles; // of indices of points, turned outwards
  int label; // of the part; of the largest, if several were joined
  double error =
      0; // how far it goes from its part, in diagonals of the shape's box, if a largest one is given
};

struct Part_hulls
{
  std::vector<Part_hull> hulls;
  std::vector<int> flat_parts; // labels of parts that have no hull
};

// Throws std::invalid_argument for a cloud with a largest error: the inside of its parts is not known.
Part_hulls part_hulls(const Shape& shape, const std::vector<int>& labels,
                      std::size_t number_of_parts, const Hull_options& options = {});

// All hulls as one mesh; the number of each face's hull is the property `hull`.
Shape mesh_of_hulls(const std::vector<Part_hull>& hulls);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_HULLS_H
