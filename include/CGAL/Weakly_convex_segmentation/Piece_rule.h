// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_PIECE_RULE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_PIECE_RULE_H

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// What the connected pieces of a mesh of several have to do with its parts. Clouds have no pieces.
enum class Piece_rule
{
  /// parts may hold several pieces, or bits of several, as where a figure is put together from pieces that
  /// penetrate each other
  JOINED,
  /// each piece is an object of its own, which may have several parts, as in furniture and assemblies: no part goes
  /// from one into another. Only crumbs, under a fiftieth of the largest piece, go with what they touch; so do
  /// open pieces that go on in each other over a gap, as those of a torn scan.
  SEPARATE,
  WHOLE ///< as `SEPARATE`, and no piece is cut
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_PIECE_RULE_H
