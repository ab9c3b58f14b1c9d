// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SORT_IN_RUNS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SORT_IN_RUNS_H

// Sorting of many entries of which only few have the same number, in two passes.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// sorts entries by the number of each, less than `bound`, and those of one number by `less`.
/// Complexity: linear in entries and numbers where few entries have the same one.
template <typename Entry, typename Number, typename Less>
void sort_in_runs(std::vector<Entry>& entries, const std::size_t bound, const Number& number_of,
                  const Less& less)
{
  std::vector<std::size_t> end(bound + 1, 0);
  for (const Entry& entry : entries) ++end[number_of(entry) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Entry> sorted(entries.size());
  for (const Entry& entry : entries) sorted[end[number_of(entry)]++] = entry;
  entries.swap(sorted);
  std::size_t begin = 0;
  for (std::size_t n = 0; n < bound; begin = end[n++])
    if (end[n] - begin > 1)
      std::sort(entries.begin() + static_cast<std::ptrdiff_t>(begin),
                entries.begin() + static_cast<std::ptrdiff_t>(end[n]), less);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SORT_IN_RUNS_H
