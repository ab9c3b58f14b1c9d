// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_MERGE_PATCHES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_MERGE_PATCHES_H

// From patches to segments by one contraction, and the merge tree of given segments: what is in one of them is
// merged first, and then segments until one region is left, so that the tree serves any granularity.

#include <CGAL/Weakly_convex_segmentation/Merge_tree.h>
#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Visitor.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/oracle_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Merge_strategy.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/contraction.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/judged_merges.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/cut_patches.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Asks the callback at each merge of a set of patches, whose merges nobody else hears of.
class Silent_visitor : public Visitor
{
  const Run_control& m_control;

public:
  explicit Silent_visitor(const Run_control& control) : m_control(control) {}
  void merged(int, int, double) override { m_control.check_on_any_thread(); }
};

/// returns the segment of each point that one set of patches leads to.
inline std::vector<int> segments_of_patches(const Shape_analysis& shape, const Patch_set& set,
                                            const Parameters& parameters,
                                            const Run_control& control, const Merge_cost& own_cost)
{
  Region_graph graph(shape.points(), shape.graph, set.patches, *set.visibility, parameters);
  Merge_tree tree(set.patches.size());
  Silent_visitor asking(control);
  const Contraction_log log{tree, &asking};
  const auto strategy =
      make_strategy(shape, set.patches, graph, parameters, control.parallel, own_cost);
  strategy->fuse(log);
  strategy->merge(log);
  const std::vector<int> regions = graph.labels();
  std::vector<int> labels;
  labels.reserve(shape.points().size());
  for (const int p : set.patches.of_point) labels.push_back(regions[p]);
  return labels;
}

/// judges the merges of a set of patches by trees.
inline Judged_merges judge_patches(const Shape_analysis& shape, const Patch_set& set,
                                   const Parameters& parameters, const Run_control& control,
                                   const Boosted_trees& trees)
{
  Region_graph graph(shape.points(), shape.graph, set.patches, *set.visibility, parameters);
  measure_pairs(graph, shape.points(), shape.graph, set.patches, shape.diameters);
  Pair_features features(graph, set.patches, shape.diameters);
  Silent_visitor asking(control);
  return judge_merges(graph, features, trees, &asking);
}

/// merges two regions for which there is no cost.
inline void merge_without_cost(Region_graph& graph, const int a, const int b,
                               const Contraction_log& log)
{
  graph.merge(a, b);
  log.add(a, b, (std::numeric_limits<double>::max)());
}

/// goes on merging what is not adjacent until `fewest` regions are left: the smallest region with its nearest.
inline void merge_nonadjacent(Region_graph& graph, const Contraction_log& log,
                              const std::size_t fewest)
{
  while (graph.number_of_regions() > fewest)
  {
    const auto& regions = graph.regions();
    int smallest = -1, nearest = -1;
    for (int r = 0; r < static_cast<int>(regions.size()); ++r)
      if (graph.is_region(r) && (smallest < 0 || regions[r].size < regions[smallest].size))
        smallest = r;
    const auto center = [&](const int r)
    { return (1.f / static_cast<float>(regions[r].size)) * regions[r].center_sum; };
    float best = std::numeric_limits<float>::infinity();
    for (int r = 0; r < static_cast<int>(regions.size()); ++r)
    {
      if (!graph.is_region(r) || r == smallest) continue;
      const float d = squared_length(center(r) - center(smallest));
      if (d < best)
      {
        best = d;
        nearest = r;
      }
    }
    merge_without_cost(graph, nearest, smallest, log);
  }
}

/// merges what is left of each segment, and pieces of it that do not touch at last.
inline void complete_segments(Region_graph& graph, Merge_strategy& strategy,
                              const Contraction_log& within)
{
  contract(
      graph, [&](const int a, const int b) { return strategy.cost_above_threshold(a, b); }, within);
  std::map<int, int> first_of_segment;
  for (int r = 0; r < static_cast<int>(graph.regions().size()); ++r)
  {
    if (!graph.is_region(r)) continue;
    const auto [first, is_new] = first_of_segment.emplace(within.segment_of_patch[r], r);
    if (!is_new) merge_without_cost(graph, first->second, r, within);
  }
}

/// marks the segments in the merge tree, after more merges if there are too many, and goes on to one region.
/// Returns the number of segments.
inline std::size_t merge_segments(Region_graph& graph, Merge_strategy& strategy,
                                  const Merging_parameters& parameters, const Contraction_log& log)
{
  const std::size_t most = parameters.maximum_number_of_segments;
  const auto cost = [&](const int a, const int b) { return strategy.cost_above_threshold(a, b); };
  if (most > 0)
  {
    contract(graph, cost, log, most);
    merge_nonadjacent(graph, log, most);
  }
  log.tree.set_accepted(strategy.merging_threshold(), parameters.minimum_number_of_segments);
  const std::size_t accepted = log.tree.number_of_patches() - log.tree.number_of_accepted_merges();
  contract(graph, cost, log);
  merge_nonadjacent(graph, log, 1);
  return accepted;
}

/// returns the merge tree of `patches`, each of which lies in one of the segments. What they see is what those
/// patches of the shape see that they are pieces of.
inline Merge_tree merge_within_segments(const Shape_analysis& shape, const Cut_patches& patches,
                                        const Parameters& parameters, const Run_control& control,
                                        const Merge_cost& own_cost)
{
  Merge_tree tree(patches.patches.size());
  Region_graph graph(shape.points(), shape.graph, patches.patches, shape.visibility(), parameters,
                     patches.piece_of);
  const auto strategy =
      make_strategy(shape, patches.patches, graph, parameters, control.parallel, own_cost);
  Asking_visitor asking(control);
  const Contraction_log log{tree, &asking}, within{tree, &asking, patches.segments};
  control.stage(Stage::FUSION,
                [&]
                {
                  strategy->fuse(within);
                  tree.set_fused();
                  return graph.number_of_regions();
                });
  control.stage(Stage::MERGING,
                [&]
                {
                  strategy->merge(within);
                  complete_segments(graph, *strategy, within);
                  return merge_segments(graph, *strategy, parameters, log);
                });
  return tree;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_MERGE_PATCHES_H
