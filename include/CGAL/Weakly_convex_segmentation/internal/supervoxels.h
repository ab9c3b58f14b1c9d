// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SUPERVOXELS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SUPERVOXELS_H

#include <CGAL/Weakly_convex_segmentation/internal/neighbor_graph.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

// Graph-Voronoi cells of well spread seeds: the bounded number of nodes that stand for the points in
// the eigenproblem of the patches.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A partition of the points into small connected cells.
struct Supervoxels
{
  std::vector<Index> of_point;
  std::size_t count = 0;
};

/// Length of an edge for the cells: concave edges are long, so that cells end at concavities.
class Edge_cost
{
  float m_tolerance;

public:
  explicit Edge_cost(const double tolerance_degrees) : m_tolerance(radians(tolerance_degrees)) {}
  float operator()(const Neighbor& edge) const
  {
    if (edge.concavity <= m_tolerance) return edge.length;
    return edge.length * (1.f + 4.f * (0.3f + edge.concavity - m_tolerance));
  }
};

/// Dijkstra's search from seeds that are added one after the other; every point belongs to the seed
/// that is nearest along the graph.
class Voronoi_cells
{
public:
  Voronoi_cells(const Neighbor_graph& graph, const Edge_cost& cost)
    : m_graph(graph), m_cost(cost), m_distance(graph.size(), infinity()), m_cell(graph.size(), 0)
  {}

  static constexpr float infinity() { return std::numeric_limits<float>::infinity(); }
  float distance(const Index point) const { return m_distance[point]; }
  const std::vector<Index>& cells() const { return m_cell; }

  void add_seed(const Index point, const Index cell)
  {
    m_distance[point] = 0.f;
    m_cell[point] = cell;
    m_front.push({0.f, point});
  }

  /// lets the seeds added so far take all points that are nearer to them.
  void grow()
  {
    while (!m_front.empty())
    {
      const auto [d, i] = m_front.top();
      m_front.pop();
      if (d > m_distance[i]) continue;
      for (const Neighbor& edge : m_graph[i])
      {
        const float through = d + m_cost(edge);
        if (through >= m_distance[edge.point]) continue;
        m_distance[edge.point] = through;
        m_cell[edge.point] = m_cell[i];
        m_front.push({through, edge.point});
      }
    }
  }

private:
  using Entry = std::pair<float, Index>;
  const Neighbor_graph& m_graph;
  const Edge_cost m_cost;
  std::vector<float> m_distance;
  std::vector<Index> m_cell;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_front;
};

/// returns seeds each of which is farthest from those before, beginning next to the centroid's
/// farthest point; every connected piece of the graph gets at least one.
inline std::vector<Index> farthest_seeds(const Oriented_points& points, const Neighbor_graph& graph,
                                         const Edge_cost& cost, const std::size_t count)
{
  Voronoi_cells cells(graph, cost);
  Index seed = 0;
  for (Index i = 1; i < points.size(); ++i)
    if (squared_length(points.positions[i]) > squared_length(points.positions[seed])) seed = i;

  std::vector<Index> seeds;
  // distances only ever fall, so an entry that is still right when it comes up is the largest
  std::priority_queue<std::pair<float, Index>> farthest;
  for (Index i = 0; i < points.size(); ++i) farthest.push({Voronoi_cells::infinity(), i});
  while (true)
  {
    cells.add_seed(seed, static_cast<Index>(seeds.size()));
    seeds.push_back(seed);
    cells.grow();
    while (!farthest.empty() && farthest.top().first != cells.distance(farthest.top().second))
    {
      const Index i = farthest.top().second;
      farthest.pop();
      if (cells.distance(i) > 0.f) farthest.push({cells.distance(i), i});
    }
    if (farthest.empty()) break;
    const bool unreached = farthest.top().first == Voronoi_cells::infinity();
    if (seeds.size() >= count && !unreached) break;
    seed = farthest.top().second;
  }
  return seeds;
}

/// returns the member of each cell that is nearest to the cell's centroid (Lloyd's step).
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
  std::vector<Index> center(count, 0);
  std::vector<float> best(count, Voronoi_cells::infinity());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Index c = cells[i];
    const float d = squared_length(points.positions[i] - (1.f / size[c]) * sum[c]);
    if (d < best[c])
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
  const Edge_cost cost(concavity_tolerance);
  const auto cells_of = [&](const std::vector<Index>& seeds)
  {
    Voronoi_cells cells(graph, cost);
    for (std::size_t i = 0; i < seeds.size(); ++i) cells.add_seed(seeds[i], static_cast<Index>(i));
    cells.grow();
    return cells.cells();
  };
  const std::vector<Index> seeds = farthest_seeds(points, graph, cost, count);
  Supervoxels result;
  result.count = seeds.size();
  result.of_point = cells_of(central_points(points, cells_of(seeds), result.count));
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SUPERVOXELS_H
