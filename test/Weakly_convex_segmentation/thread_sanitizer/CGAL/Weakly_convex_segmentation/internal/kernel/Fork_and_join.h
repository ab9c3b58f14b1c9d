// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FORK_AND_JOIN_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FORK_AND_JOIN_H

#include <sanitizer/tsan_interface.h>

// Takes the place of the library's header in a build with WCS_SANITIZE=thread. The libraries of TBB are not
// instrumented, so ThreadSanitizer is told here: what came before a parallel loop is before its pieces, and
// these are before what follows. Races between the pieces still show.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

class Fork_and_join
{
public:
  static constexpr bool is_watched = true;
  Fork_and_join() { __tsan_release(&m_fork); }
  ~Fork_and_join() { __tsan_acquire(&m_join); }
  void piece_begins() { __tsan_acquire(&m_fork); }
  void piece_ends() { __tsan_release(&m_join); }

private:
  char m_fork = 0, m_join = 0;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FORK_AND_JOIN_H
