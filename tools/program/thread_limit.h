// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_THREAD_LIMIT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_THREAD_LIMIT_H

#include <CGAL/tags.h>

#include <cstddef>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace Segment_shape {

// While it lives, at most so many threads work; 0: no limit. It does nothing in a program without
// TBB, which has one thread only.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  static constexpr bool has_threads = true;

  explicit Thread_limit(const std::size_t number_of_threads)
    : m_control(tbb::global_control::max_allowed_parallelism,
                number_of_threads > 0 ? number_of_threads
                                      : tbb::global_control::active_value(
                                            tbb::global_control::max_allowed_parallelism))
  {}

private:
  tbb::global_control m_control;
#else
  static constexpr bool has_threads = false;

  explicit Thread_limit(std::size_t) {}
#endif
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_THREAD_LIMIT_H
