// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FORK_AND_JOIN_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FORK_AND_JOIN_H

// Tells ThreadSanitizer what it can't see in the libraries of TBB, which are not instrumented: what came
// before a parallel loop is before its pieces, and these are before what follows. Races between the
// pieces still show. Nothing in any other build.

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_WCS_THREAD_SANITIZER
#endif
#elif defined(__SANITIZE_THREAD__)
#define CGAL_WCS_THREAD_SANITIZER
#endif

#ifdef CGAL_WCS_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

#ifdef CGAL_WCS_THREAD_SANITIZER
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
#undef CGAL_WCS_THREAD_SANITIZER
#else
class Fork_and_join
{
public:
  static constexpr bool is_watched = false;
  void piece_begins() {}
  void piece_ends() {}
};
#endif

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FORK_AND_JOIN_H
