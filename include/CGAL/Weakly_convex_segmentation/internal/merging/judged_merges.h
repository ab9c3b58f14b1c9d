// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_JUDGED_MERGES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_JUDGED_MERGES_H

// The whole way from patches to one region by the weighted cost, and for each merge on it how probable it is
// that people put its two regions together. That is asked once a merge, of regions as large as they get: what
// a cost has to decide from parts of them, between many pairs, is decided when most is known.

#include <CGAL/Weakly_convex_segmentation/Merge_tree.h>
#include <CGAL/Weakly_convex_segmentation/Visitor.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Learned_cost.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/contraction.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Merges up to the first of a higher cost are certain enough, and not judged.
constexpr double certain_merge_cost = 0.5;

/// A merge of two regions, each named by the number of one of the regions in it.
struct Judged_merge
{
  int first, second;  ///< what is merged has the name of the first
  double probability; ///< that people put the two together, in [0, 1]
};

/// The merges above regions that nobody would cut.
struct Judged_merges
{
  std::vector<int> region_of_patch; ///< from 0 on
  std::size_t number_of_regions = 0;
  std::vector<Judged_merge> merges; ///< in order; none between pieces that do not touch
};

/// merges all regions of a graph of patches that was asked for shapes and profiles.
inline Judged_merges judge_merges(Region_graph& graph, Pair_features& features,
                                  const Boosted_trees& trees, Visitor* visitor = nullptr)
{
  const Learned_cost cut_probability(features, trees);
  Merge_tree tree(graph.regions().size());
  Judged_merges result;
  const auto name_regions = [&]
  {
    result.region_of_patch = graph.labels();
    result.number_of_regions = graph.number_of_regions();
  };
  const auto judge = [&](const int a, const int b, const double cost)
  {
    if (result.number_of_regions == 0 && cost > certain_merge_cost) name_regions();
    if (result.number_of_regions > 0)
      result.merges.push_back(
          {result.region_of_patch[a], result.region_of_patch[b], 1. - cut_probability(a, b)});
  };
  Contraction_log log{tree, visitor};
  log.before_merge = judge;
  contract(
      graph, [&](const int a, const int b) { return features.weighted_cost(a, b); }, log);
  if (result.number_of_regions == 0) name_regions();
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_JUDGED_MERGES_H
