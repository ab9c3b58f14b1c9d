// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CUT_SHAPE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CUT_SHAPE_H

#include "io/shape.h"
#include "io/write_parts.h"

#include <cstddef>
#include <vector>

// A mesh with its faces split along the smoothed borders of its parts.

namespace Shape_io {

struct Cut_shape
{
  Shape shape;
  Parts parts;
  std::vector<std::size_t>
      source_faces; // of each face; also a property of the shape, `source_face`
};

// Pieces have the properties of their face; those of corners, such as texture coordinates, and of points are
// interpolated where they are no integers. If the file has a `source_face` itself, that is `input_source_face` then.
Cut_shape cut_shape(const Shape& shape, const Parts& parts);

// Throws std::invalid_argument for a cloud.
void check_can_be_cut(const Shape& shape);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CUT_SHAPE_H
