// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_CUT_PATCHES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_CUT_PATCHES_H

// Patches cut where the segments end, so that each lies in one segment.

#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Patches that each lie in one segment.
struct Cut_patches
{
  Patches patches;
  std::vector<int> piece_of; ///< for each, the patch of the shape that most of its points are of
  std::vector<int> segments; ///< the segment of each
};

/// returns the value that most of the points have, the smallest of such.
inline int most_frequent(const std::vector<Index>& points, const std::vector<int>& values)
{
  std::map<int, std::size_t> count;
  for (const Index i : points) ++count[values[i]];
  return std::max_element(count.begin(), count.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// cuts the patches where the segments of the points end. Connected pieces of fewer than `minimum_size` points
/// join a neighbor in the same segment, if there is one.
inline Cut_patches cut_patches(const Neighbor_graph& graph, const Patches& patches,
                               const std::vector<int>& segments,
                               const std::size_t minimum_size = minimum_patch_size)
{
  std::map<std::pair<int, int>, Index> number;
  std::vector<Index> labels;
  labels.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    labels.push_back(
        number
            .emplace(std::pair(patches.of_point[i], segments[i]), static_cast<Index>(number.size()))
            .first->second);
  Cut_patches result;
  result.patches = patches_of_labels(
      absorb_small_pieces(graph, connected_pieces(graph, labels), minimum_size, &segments));
  for (const std::vector<Index>& members : result.patches.members)
  {
    result.piece_of.push_back(most_frequent(members, patches.of_point));
    result.segments.push_back(segments[members.front()]);
  }
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_CUT_PATCHES_H
