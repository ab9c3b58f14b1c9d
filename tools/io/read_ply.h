// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_PLY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_PLY_H

#include "io/shape.h"

#include <string>
#include <vector>

// PLY, ASCII and both binaries. Not with CGAL's reader of soups: that of 5.5.1 and 6.0.1 crashes on integer
// coordinates, takes a missing coordinate for 0, refuses corners of 16 bits, asks for as much memory as a
// broken list claims, and has no place for normals and further properties (test_cgal_faults).

namespace Shape_io {
namespace internal {

void take_ply_points(std::vector<Property>&& columns, Shape& shape);

void read_ply(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_PLY_H
