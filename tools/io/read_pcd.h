// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_PCD_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_PCD_H

#include "io/shape.h"

#include <string>

// PCD, the point clouds of PCL: as text, binary, and compressed (in the format of LibLZF).

namespace Shape_io {
namespace internal {

void read_pcd(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_PCD_H
