// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_OUTPUT_SEGMENT_STATISTICS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_OUTPUT_SEGMENT_STATISTICS_H

// Size, convexity, diameter and neighbors of each segment.

#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// fills size, convexity rank, diameter and neighbors of each segment.
inline std::vector<Segment> describe_segments(const Shape_analysis& shape,
                                              const std::vector<int>& point_labels,
                                              const std::vector<int>& element_labels,
                                              const std::size_t count, const bool parallel = false)
{
  constexpr std::size_t rank_sample = 40; // 780 lines of sight a segment
  constexpr double rank_tolerance = 5.;   // degrees: flat faces and noise are not concave
  std::vector<Segment> segments(count);
  std::vector<std::vector<Index>> members(count);
  std::vector<std::set<std::size_t>> neighbors(count);
  Histogram_scale scale;
  std::vector<Diameter_histogram> diameters(count);
  for (const int l : element_labels) ++segments[l].size;
  for (Index i = 0; i < point_labels.size(); ++i)
  {
    members[point_labels[i]].push_back(i);
    for (const Neighbor& edge : shape.graph[i])
      if (point_labels[edge.point] != point_labels[i])
        neighbors[point_labels[i]].insert(static_cast<std::size_t>(point_labels[edge.point]));
  }
  for (const Diameter_sample& s : shape.diameters)
    diameters[point_labels[s.point]].add(scale, s.diameter);
  parallel_for(
      count, parallel,
      [&](const std::size_t l)
      {
        segments[l].convexity_rank =
            convexity_rank(*shape.sight, members[l], rank_sample, rank_tolerance);
      },
      1);
  for (std::size_t l = 0; l < count; ++l)
  {
    segments[l].diameter = diameters[l].median(scale) * shape.input.extent;
    segments[l].neighbors.assign(neighbors[l].begin(), neighbors[l].end());
  }
  return segments;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_OUTPUT_SEGMENT_STATISTICS_H
