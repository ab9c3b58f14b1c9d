// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SEPARATE_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SEPARATE_PARTS_H

#include "io/shape.h"

#include <cstddef>
#include <vector>

// Parts of a shape as shapes of their own.

namespace Shape_io {

// The elements of each label, in the order of the input. Those without a label (-1) are in none.
std::vector<std::vector<std::size_t>> elements_of_parts(const std::vector<int>& labels,
                                                        std::size_t number_of_parts);

// The shape of some of the elements, with all properties that the file has of them. The points of a mesh keep
// their order; those that none of the faces has are left out.
Shape shape_of_elements(const Shape& shape, const std::vector<std::size_t>& elements);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SEPARATE_PARTS_H
