// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_SHAPE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_SHAPE_H

#include "io/shape.h"

#include <string>

// Reading of meshes (OFF, PLY, OBJ, STL; by assimp glTF, GLB, 3MF, DAE, FBX) and clouds (PLY, PCD, XYZ, PWN, OFF,
// OBJ, glTF) from files, which gzip may have compressed, and from standard input. Points and faces keep the order of
// the file; none is moved, dropped or invented.

namespace Shape_io {
namespace internal {

using Reader = void (*)(const std::string&, Shape&);

// The format of bytes that come without a name.
Reader reader_for_bytes(const std::string& bytes);

// Refuses what no algorithm could work on, and names the first bad element.
void check_shape(const Shape& shape, Gaps gaps);

// Normals that are all zero are none, as some programs write them.
void drop_missing_normals(Shape& shape);

} // namespace internal

// Reads the shape in the file; the extension, in capitals or not, determines the format. A file with
// faces is a mesh, one without is a cloud. The name "-" is standard input, whose format shows in its
// first bytes.
// Throws File_error with one line that names the file, what is wrong, and what to do.
Shape read_shape(const std::string& path, Gaps gaps = Gaps::REFUSED);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_SHAPE_H
