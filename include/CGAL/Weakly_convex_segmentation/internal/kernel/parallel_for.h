// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_PARALLEL_FOR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_PARALLEL_FOR_H

// Loops and sorts on several threads, whose results do not depend on the number of threads.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Fork_and_join.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Function_ref.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#endif

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// calls `block(begin, end)` for pieces that make up `[0, n)`, on several threads if asked for and TBB is
/// there. It is compiled once, however many loops there are.
inline void parallel_blocks(const std::size_t n, const bool parallel,
                            const Function_ref<void(std::size_t, std::size_t)> block,
                            [[maybe_unused]] const std::size_t grain)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel && n > grain)
  {
    Fork_and_join order;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [block, &order](const tbb::blocked_range<std::size_t>& range)
                      {
                        order.piece_begins();
                        block(range.begin(), range.end());
                        order.piece_ends();
                      });
    return;
  }
#else
  static_cast<void>(parallel);
#endif
  block(0, n);
}

/// calls `f(i)` for all `i` in `[0, n)`, on several threads if asked for and TBB is there. Calls must
/// be independent of each other, so that the outcome is the same for any number of threads.
template <typename Function>
void parallel_for(const std::size_t n, const bool parallel, const Function& f,
                  const std::size_t grain = 256)
{
  parallel_blocks(
      n, parallel,
      [&f](const std::size_t begin, const std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i) f(i);
      },
      grain);
}

/// returns `f(begin, end)` for each block of `[0, n)`. The blocks are the same for any number of
/// threads, and so is what is summed over them in order. What `f` returns has a default.
template <typename Function>
auto map_blocks(const std::size_t n, const bool parallel, const Function& f)
{
  constexpr std::size_t block = 16384;
  std::vector<decltype(f(n, n))> results((n + block - 1) / block);
  parallel_for(
      results.size(), parallel,
      [&](const std::size_t b) { results[b] = f(b * block, (std::min)((b + 1) * block, n)); }, 1);
  return results;
}

/// sorts by a strict total order, so that the result does not depend on the number of threads.
template <typename Iterator, typename Less>
void parallel_sort(const Iterator first, const Iterator last, const bool parallel, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel && !Fork_and_join::is_watched) // its own pieces can't be watched
  {
    tbb::parallel_sort(first, last, less);
    return;
  }
#else
  static_cast<void>(parallel);
#endif
  std::sort(first, last, less);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_PARALLEL_FOR_H
