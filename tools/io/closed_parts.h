// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CLOSED_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CLOSED_PARTS_H

#include "io/border_caps.h"
#include "io/shape.h"

#include <cstddef>
#include <string>
#include <vector>

// The parts of a mesh as closed solids, as printers take them.

namespace Shape_io {

struct Closed_part
{
  Shape shape; // its own faces, turned outwards, then the caps over its cuts
  std::vector<std::size_t> source_faces; // of its own faces
  std::string fault;                     // why it is no closed solid; empty if it is one
};

// Two parts have the same cap where they were cut, so that the volumes add up to that of a closed shape. Caps do not
// cross anything, or the fault says so. Part `number_of_parts` is that of the faces without a label, if there are any.
std::vector<Closed_part> closed_parts(const Shape& shape, const std::vector<int>& labels,
                                      std::size_t number_of_parts);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_CLOSED_PARTS_H
