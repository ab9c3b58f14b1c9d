// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_STL_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_STL_H

#include "io/shape.h"

#include <string>

// STL, ASCII and binary. Equal corners become one point. Not with CGAL's reader: that of 5.5.1 and
// 6.0.1 takes what is left of a text cut within its first triangle for a cloud, and knows no capitals
// (test_cgal_faults).

namespace Shape_io {
namespace internal {

void read_stl(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_STL_H
