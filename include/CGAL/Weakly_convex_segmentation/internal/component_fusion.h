// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_COMPONENT_FUSION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_COMPONENT_FUSION_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/contraction.h>

#include <limits>

// Component fusion (section 4): patches that see each other become weakly convex components.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// runs one round for each threshold theta: adjacent components are fused by descending visibility
/// while theta holds for all pairs of patches across them, or for their average.
///
/// The text asks for all pairs; with one bad pair as a veto the components stay small. The caption of
/// figure 4 speaks of a relaxed criterion: `Fusion_rule::AVERAGE` is our reading of it.
inline void fuse_components(Region_graph& graph, const Parameters& parameters,
                            const Contraction_log& log)
{
  for (const double theta : parameters.fusion_thresholds)
    contract(
        graph,
        [&](const int a, const int b)
        {
          const double average = graph.visibility(a, b);
          const double decisive =
              parameters.fusion == Fusion_rule::AVERAGE ? average : graph.least_visibility(a, b);
          return decisive >= theta ? 1. - average : std::numeric_limits<double>::infinity();
        },
        log);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_COMPONENT_FUSION_H
