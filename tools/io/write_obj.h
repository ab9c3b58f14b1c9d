// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_WRITE_OBJ_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_WRITE_OBJ_H

#include "io/shape.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace Shape_io {

// Writes OBJ with a group a part: `part_0`, `part_1`, ..., or of another kind, behind which are the names of the object
// and the groups that a face has in the input. All points are written in their order, with their colors; the faces come part by
// part, as groups want it, with their texture coordinates, normals, materials and smoothing groups.
void write_obj_groups(std::ostream& out, const Shape& shape, const std::vector<int>& labels,
                      std::size_t number_of_parts, const std::string& kind = "part");

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_WRITE_OBJ_H
