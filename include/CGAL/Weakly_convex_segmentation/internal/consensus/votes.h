// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_VOTES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_VOTES_H

// What one set of patches says of a shape: which of its regions belong together, for certain or with a
// probability.

#include <CGAL/Weakly_convex_segmentation/internal/merging/judged_merges.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The vote of one set of patches. Points of one region are together; those of two regions with the probability
/// that a row of the first has for the second, and not at all where it has none: so a cut, whose regions are
/// segments, has no rows.
struct Votes
{
  std::vector<int> labels; ///< the region of each point, from 0 on
  /// of each region, by the other's number; symmetric
  std::vector<std::vector<std::pair<int, double>>> together = {};
};

/// returns the votes of a tree: two regions are together as likely as the merge that joins them is right.
inline Votes votes_of_merges(const Judged_merges& tree, const std::vector<int>& patch_of_point)
{
  Votes votes;
  votes.labels.reserve(patch_of_point.size());
  for (const int p : patch_of_point) votes.labels.push_back(tree.region_of_patch[p]);
  votes.together.resize(tree.number_of_regions);
  std::vector<std::vector<int>> members(tree.number_of_regions);
  for (std::size_t r = 0; r < members.size(); ++r) members[r] = {static_cast<int>(r)};
  for (const Judged_merge& merge : tree.merges)
  {
    for (const int a : members[merge.first])
      for (const int b : members[merge.second])
      {
        votes.together[a].push_back({b, merge.probability});
        votes.together[b].push_back({a, merge.probability});
      }
    auto &into = members[merge.first], &from = members[merge.second];
    into.insert(into.end(), from.begin(), from.end());
    from.clear();
  }
  for (auto& row : votes.together) std::sort(row.begin(), row.end());
  return votes;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_VOTES_H
