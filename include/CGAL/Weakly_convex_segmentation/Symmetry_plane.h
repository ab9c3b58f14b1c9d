// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_SYMMETRY_PLANE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_SYMMETRY_PLANE_H

// The plane by which a shape is its own mirror image.

#include <array>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// A plane by which a shape is its own mirror image, nearly: both sides are segmented alike. In the coordinates of
/// the input.
struct Symmetry_plane
{
  std::array<double, 3> point = {0., 0., 0.};  ///< a point of the plane
  std::array<double, 3> normal = {1., 0., 0.}; ///< unit length
  /// mean distance of the mirrored points from the surface, relative to the extent of the shape
  double residual = 0.;
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_SYMMETRY_PLANE_H
