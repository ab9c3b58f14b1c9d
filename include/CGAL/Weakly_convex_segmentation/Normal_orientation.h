// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_NORMAL_ORIENTATION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_NORMAL_ORIENTATION_H

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How the normals that are estimated for points without any are turned to the outside.
enum class Normal_orientation
{
  /// from neighbor to neighbor, across thin walls too, for which more neighbors are asked, and each piece to its own
  /// outside
  PROPAGATION,
  /// By `CGAL::mst_orient_normals()`, which is right less often, takes longer and cannot be interrupted. What
  /// it leaves without orientation, such as pieces apart from the highest point, is turned as by `PROPAGATION`.
  MST
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_NORMAL_ORIENTATION_H
