// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_HULLS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_HULLS_H

#include "io/shape.h"

#include <cstddef>
#include <vector>

// The convex hulls of the parts: an approximate convex decomposition, as physics engines take it.

namespace Shape_io {

struct Part_hulls
{
  Shape shape;                 // all hulls, as one mesh
  std::vector<int> labels;     // of each face
  std::vector<int> flat_parts; // labels of parts that have no hull
};

Part_hulls part_hulls(const Shape& shape, const std::vector<int>& labels,
                      std::size_t number_of_parts);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_HULLS_H
