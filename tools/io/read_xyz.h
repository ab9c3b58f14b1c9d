// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_XYZ_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_XYZ_H

#include "io/shape.h"

#include <string>
#include <string_view>

// Clouds as a table in text: XYZ, PWN, and what programs write as TXT, ASC, CSV or PTS. The first line may be the
// number of points or the names of the columns. Coordinates and normals are the columns that are called so; without
// names the first three, and the next three if they are unit vectors. All others are kept, but for text.
// Numbers may have a decimal comma where columns are parted by blanks or semicolons.

namespace Shape_io {
namespace internal {

bool is_name(std::string_view word);

void read_xyz(const std::string& bytes, Shape& shape);

// PWN: normals of any length.
void read_pwn(const std::string& bytes, Shape& shape);

// PTS: x y z intensity red green blue.
void read_pts(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_XYZ_H
