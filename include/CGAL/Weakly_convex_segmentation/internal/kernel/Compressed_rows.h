// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_COMPRESSED_ROWS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_COMPRESSED_ROWS_H

// Rows of different lengths in one array: graphs, and members of groups.

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Rows of entries, one after the other.
template <typename Entry>
struct Compressed_rows
{
  std::vector<std::size_t> first = {0}; ///< begin of each row in `entries`, and the end
  std::vector<Entry> entries;

  template <typename Pointer>
  struct Row
  {
    Pointer first, last;
    Pointer begin() const { return first; }
    Pointer end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  Row<const Entry*> operator[](const std::size_t i) const
  {
    return {entries.data() + first[i], entries.data() + first[i + 1]};
  }
  Row<Entry*> operator[](const std::size_t i)
  {
    return {entries.data() + first[i], entries.data() + first[i + 1]};
  }
  std::size_t size() const { return first.size() - 1; } ///< number of rows

  /// ends the row of the entries that were added last.
  void end_row() { first.push_back(entries.size()); }

  /// makes room for `size` rows whose lengths were counted in `first`, one place after their own.
  void allocate_counted()
  {
    std::partial_sum(first.begin(), first.end(), first.begin());
    entries.resize(first.back());
  }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_COMPRESSED_ROWS_H
