// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SEARCH_FRONT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SEARCH_FRONT_H

// Dijkstra's search, as all of the shortest paths along a graph are found: cells about seeds, and bands along
// borders.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/float_bits.h>

#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns a distance from 0 on and a point as one integer, in the same order. Distances that are equal but for
/// rounding are equal.
inline std::uint64_t distance_and_point(const float distance, const Index point)
{
  return static_cast<std::uint64_t>(leading_bits(distance)) << 32 | point;
}

/// The points from which a search goes on, the nearest first, of those the one with the lowest index.
class Search_front
{
public:
  void push(const Index point, const float distance)
  {
    m_points.push(distance_and_point(distance, point));
  }

  /// calls `leave(i, distance)` for each point, from the nearest on, until there are no more. It pushes the
  /// neighbors that the way through `i` makes nearer. `distance_of(i)`: the least one found so far
  template <typename Distance, typename Leave>
  void search(const Distance& distance_of, const Leave& leave)
  {
    while (!m_points.empty())
    {
      const std::uint64_t nearest = m_points.top();
      const Index i = static_cast<Index>(nearest);
      m_points.pop();
      const float distance = distance_of(i);
      if (nearest == distance_and_point(distance, i))
        leave(i, distance); // else it was left from nearer
    }
  }

private:
  std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<std::uint64_t>>
      m_points;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SEARCH_FRONT_H
