// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_PATCHES_FOR_TESTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_PATCHES_FOR_TESTS_H

// One set of patches, where a run makes several.

#include <CGAL/Weakly_convex_segmentation/Patch_clustering.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>

#include <utility>

namespace Shapes_for_tests {

/// over-segments the points into one set of patches.
inline CGAL::Weakly_convex_segmentation::internal::Patches
one_patch_set(const CGAL::Weakly_convex_segmentation::internal::Oriented_points& points,
              const CGAL::Weakly_convex_segmentation::internal::Neighbor_graph& graph,
              CGAL::Weakly_convex_segmentation::Parameters parameters)
{
  using namespace CGAL::Weakly_convex_segmentation;
  parameters.number_of_patch_sets = 1;
  return std::move(
      internal::extract_patch_sets(points, graph, parameters, false,
                                   Spectral_patch_clustering(parameters.spectral_dimensions))
          .front());
}

} // namespace Shapes_for_tests

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_PATCHES_FOR_TESTS_H
