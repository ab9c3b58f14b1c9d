// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_NEAREST_ELEMENTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_NEAREST_ELEMENTS_H

#include "io/shape.h"

#include <cstddef>
#include <limits>
#include <vector>

// Which element of a segmented shape lies nearest to each element of another one: what carries labels
// to points that were not in the run.

namespace Shape_io {

constexpr std::size_t no_element = (std::numeric_limits<std::size_t>::max)();

// For each element of `to` the nearest one of `from`; `no_element` for gaps. `from` has none.
std::vector<std::size_t> nearest_elements(const Shape& from, const Shape& to);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_NEAREST_ELEMENTS_H
