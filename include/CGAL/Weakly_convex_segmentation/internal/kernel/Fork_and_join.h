// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FORK_AND_JOIN_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FORK_AND_JOIN_H

// Where tests watch the threads of parallel loops.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Is notified when a parallel loop begins and ends, and each of its pieces. It does nothing: a build that
/// watches the threads puts a header of this name before this one (`WCS_SANITIZE`).
class Fork_and_join
{
public:
  static constexpr bool is_watched = false;
  void piece_begins() {}
  void piece_ends() {}
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FORK_AND_JOIN_H
