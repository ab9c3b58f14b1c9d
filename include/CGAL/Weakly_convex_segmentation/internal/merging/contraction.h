// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_CONTRACTION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_CONTRACTION_H

// The greedy contraction of the region graph by ascending cost, by which patches are fused and components
// merged (sections 4 and 5).

#include <CGAL/Weakly_convex_segmentation/Merge_tree.h>
#include <CGAL/Weakly_convex_segmentation/Visitor.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Function_ref.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_graph.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Where merges are recorded, and the segments across which there are none.
struct Contraction_log
{
  Merge_tree& tree;
  Visitor* visitor = nullptr;
  std::vector<int> segment_of_patch = {}; ///< only regions of one segment are merged; empty: any
  /// is told of the two regions and the cost while both are still there; may be empty
  std::function<void(int, int, double)> before_merge = {};

  bool may_merge(const int a, const int b) const
  {
    return segment_of_patch.empty() || segment_of_patch[a] == segment_of_patch[b];
  }
  void add(const int a, const int b, const double cost) const
  {
    tree.add(a, b, cost);
    if (visitor != nullptr) visitor->merged(a, b, cost);
  }
};

/// A merge that may be next.
struct Contraction_candidate
{
  double cost;
  int a, b;
  std::size_t age_a, age_b;
  bool operator<(const Contraction_candidate& other) const // the queue's top is its largest element
  {
    return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
  }
};

/// merges adjacent regions by ascending cost while there is one of finite cost and more than
/// `fewest` regions are left.
///
/// `criterion(a, b)` returns the cost of merging two adjacent regions of the graph, infinity if they
/// must not be. It may depend on nothing but these regions and their seam.
inline void contract(Region_graph& graph, const Function_ref<double(int, int)> criterion,
                     const Contraction_log& log, const std::size_t fewest = 1)
{
  std::vector<std::size_t> age(graph.regions().size(), 0);
  std::priority_queue<Contraction_candidate> queue;
  const auto consider = [&](const int a, const int b)
  {
    const int low = (std::min)(a, b), high = (std::max)(a, b);
    if (!log.may_merge(low, high)) return; // a region is named by one of its patches
    const double cost = criterion(low, high);
    if (cost < std::numeric_limits<double>::infinity())
      queue.push({cost, low, high, age[low], age[high]});
  };
  for (int a = 0; a < static_cast<int>(graph.regions().size()); ++a)
    for (const auto& entry : graph.seams(a))
      if (a < entry.first) consider(a, entry.first);
  while (!queue.empty() && graph.number_of_regions() > fewest)
  {
    const Contraction_candidate best = queue.top();
    queue.pop();
    if (age[best.a] != best.age_a || age[best.b] != best.age_b) continue;
    if (log.before_merge) log.before_merge(best.a, best.b, best.cost);
    graph.merge(best.a, best.b);
    log.add(best.a, best.b, best.cost);
    ++age[best.a];
    ++age[best.b];
    for (const auto& entry : graph.seams(best.a)) consider(best.a, entry.first);
  }
}

/// merges adjacent regions by ascending cost while it is at most `threshold`.
inline void contract_up_to(Region_graph& graph, const Function_ref<double(int, int)> cost,
                           const double threshold, const Contraction_log& log)
{
  contract(
      graph,
      [&](const int a, const int b)
      {
        const double c = cost(a, b);
        return c <= threshold ? c : std::numeric_limits<double>::infinity();
      },
      log);
}

/// goes once, by ascending cost, over the pairs of regions that are adjacent when it begins, but those of
/// infinite cost, and merges the regions that the two have grown to if `criterion` holds for these.
inline void sweep(Region_graph& graph, const Function_ref<double(int, int)> cost,
                  const Function_ref<bool(int, int)> criterion, const Contraction_log& log)
{
  std::vector<std::tuple<double, int, int>> pairs;
  for (int a = 0; a < static_cast<int>(graph.regions().size()); ++a)
    for (const auto& entry : graph.seams(a))
    {
      if (entry.first < a || !log.may_merge(a, entry.first)) continue;
      const double c = cost(a, entry.first);
      if (c < std::numeric_limits<double>::infinity()) pairs.push_back({c, a, entry.first});
    }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [c, a, b] : pairs)
  {
    const int of_a = graph.region_of(a), of_b = graph.region_of(b);
    const int low = (std::min)(of_a, of_b), high = (std::max)(of_a, of_b);
    if (low == high || !criterion(low, high)) continue;
    graph.merge(low, high);
    log.add(low, high, c);
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_CONTRACTION_H
