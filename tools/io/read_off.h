// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_OFF_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_OFF_H

#include "io/shape.h"

#include <string>

// OFF with colors, normals and comments, as a mesh or a cloud. Not with CGAL's reader: that of 5.5.1
// and 6.0.1 crashes on colors below 0, takes a negative number of corners for a huge one, and asks for memory
// for as many points as the header claims (test_cgal_faults).

namespace Shape_io {
namespace internal {

void read_off(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_OFF_H
