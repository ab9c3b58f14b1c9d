// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_NUMBER_LABELS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_NUMBER_LABELS_H

// Labels from 0 on without gaps.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// renames labels, from 0 on, to 0, 1, ... in the order of their first element; returns how many there are.
inline std::size_t number_labels(std::vector<int>& labels)
{
  int largest = -1;
  for (const int l : labels) largest = (std::max)(largest, l);
  std::vector<int> number(static_cast<std::size_t>(largest + 1), -1);
  int next = 0;
  for (int& l : labels)
  {
    if (number[l] < 0) number[l] = next++;
    l = number[l];
  }
  return static_cast<std::size_t>(next);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_NUMBER_LABELS_H
