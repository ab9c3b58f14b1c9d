// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SUPERVOXELS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SUPERVOXELS_H

// Graph-Voronoi cells of well spread seeds: the bounded number of nodes that stand for the points in
// the spectral clustering of the patches.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Graph_voronoi.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/downsampling.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A partition of the points into small connected cells.
struct Supervoxels
{
  std::vector<Index> of_point;
  std::size_t count = 0;
  std::vector<Index> centers; ///< the point of each that its cell is about
};

/// Length of an edge for the cells: concave edges are long, so that cells end at concavities.
class Geodesic_edge_length
{
  float m_tolerance;

public:
  explicit Geodesic_edge_length(const double tolerance_degrees)
    : m_tolerance(radians(tolerance_degrees))
  {}
  float operator()(const Neighbor& edge) const
  {
    if (edge.concavity <= m_tolerance) return edge.length;
    return edge.length * (1.f + 4.f * (0.3f + edge.concavity - m_tolerance));
  }
};

/// returns the graph of the points with the costs of its edges.
inline Cost_graph cost_graph(const Neighbor_graph& graph, const Geodesic_edge_length& cost)
{
  Cost_graph costs{graph.first, {}};
  costs.entries.reserve(graph.entries.size());
  for (const Neighbor& edge : graph.entries) costs.entries.push_back({edge.point, cost(edge)});
  return costs;
}

/// returns the first point of each cell of a coarse voxel grid, about `count`.
inline std::vector<Index> voxel_seeds(const Oriented_points& points, const std::size_t count)
{
  const float side = voxel_side(points, count);
  std::unordered_set<std::uint64_t> taken;
  std::vector<Index> seeds;
  for (Index i = 0; i < points.size(); ++i)
    if (taken.insert(voxel_key(points.positions[i], side)).second) seeds.push_back(i);
  return seeds;
}

/// adds seeds to `cells`, each farthest from those before, until there are `count` and every connected
/// piece of the graph has one. Returns the number of seeds.
///
/// The first quarter comes from a voxel grid: each of these would have to search most of the shape.
inline std::size_t spread_seeds(const Oriented_points& points, const std::size_t count,
                                Graph_voronoi& cells)
{
  std::size_t seeds = 0;
  for (const Index i : voxel_seeds(points, (std::max)(count / 4, std::size_t(1))))
    if (seeds < count) cells.add_seed(i, static_cast<Index>(seeds++));
  cells.grow();

  // distances only ever fall, so an entry that is still right when it comes up is the largest
  const auto entry = [&cells](const Index i) { return distance_and_point(cells.distance(i), i); };
  std::vector<std::uint64_t> entries;
  for (Index i = 0; i < points.size(); ++i) entries.push_back(entry(i));
  std::priority_queue<std::uint64_t> farthest(std::less<std::uint64_t>(), std::move(entries));
  for (; !farthest.empty(); cells.grow())
  {
    std::uint64_t top = farthest.top();
    while (top != entry(static_cast<Index>(top)))
    {
      farthest.pop();
      farthest.push(entry(static_cast<Index>(top)));
      top = farthest.top();
    }
    const Index seed = static_cast<Index>(top);
    const bool is_unreached = cells.distance(seed) == Graph_voronoi::infinity();
    if (cells.distance(seed) == 0.f || (seeds >= count && !is_unreached)) break;
    cells.add_seed(seed, static_cast<Index>(seeds++));
  }
  return seeds;
}

/// returns the member of each cell that is nearest to the cell's centroid (Lloyd's step), the first of those that are
/// about as near: the two points of a cell of two are, and rounding would choose.
inline std::vector<Index> central_points(const Oriented_points& points,
                                         const std::vector<Index>& cells, const std::size_t count)
{
  std::vector<Vector3> sum(count);
  std::vector<float> size(count, 0.f);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    sum[cells[i]] = sum[cells[i]] + points.positions[i];
    size[cells[i]] += 1.f;
  }
  constexpr float nearer = 0.99f; // times a squared distance
  std::vector<Index> center(count, 0);
  std::vector<float> best(count, Graph_voronoi::infinity());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Index c = cells[i];
    const float d = squared_length(points.positions[i] - (1.f / size[c]) * sum[c]);
    if (d < nearer * best[c])
    {
      best[c] = d;
      center[c] = static_cast<Index>(i);
    }
  }
  return center;
}

/// partitions the points into about `count` cells (more where the graph has more pieces).
///
/// Complexity: O(n log n log(count)).
inline Supervoxels build_supervoxels(const Oriented_points& points, const Neighbor_graph& graph,
                                     const std::size_t count, const double concavity_tolerance)
{
  const Cost_graph costs = cost_graph(graph, Geodesic_edge_length(concavity_tolerance));
  Supervoxels result;
  {
    Graph_voronoi cells(costs);
    result.count = spread_seeds(points, count, cells);
    result.centers = central_points(points, cells.cells(), result.count);
  }
  Graph_voronoi cells(costs);
  for (std::size_t i = 0; i < result.count; ++i)
    cells.add_seed(result.centers[i], static_cast<Index>(i));
  cells.grow();
  result.of_point = cells.cells();
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SUPERVOXELS_H
