// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ORACLES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ORACLES_H

#include <CGAL/Weakly_convex_segmentation/Merge_cost.h>
#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Patch_clustering.h>
#include <CGAL/Weakly_convex_segmentation/internal/Line_of_sight_functions.h>

// The parts of the method that a caller can put in the place of ours.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What the caller gives; empty where it is ours.
struct Oracles
{
  Line_of_sight_functions line_of_sight;
  Patch_clustering patch_clustering;
  Merge_cost merge_cost;

  /// returns the clustering that makes the patches.
  Patch_clustering clustering(const Parameters& parameters) const
  {
    if (patch_clustering) return patch_clustering;
    return Spectral_patch_clustering(parameters.spectral_dimensions);
  }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ORACLES_H
