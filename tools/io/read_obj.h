// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_OBJ_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_OBJ_H

#include "io/shape.h"

#include <string>

// OBJ: points with colors, faces of any number of corners with texture coordinates and normals, the names of their
// materials, objects, groups and smoothing groups; negative indices. A note tells what is left out, such as lines.
// Not with CGAL's reader: that of 5.5.1 and 6.0.1 refuses files without faces
// and takes faces with a corner beyond the last point; that of 5.5.1 also takes only the first of corners with
// tabs between them, and no lines that go on in the next (test_cgal_faults).

namespace Shape_io {
namespace internal {

void read_obj(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_OBJ_H
