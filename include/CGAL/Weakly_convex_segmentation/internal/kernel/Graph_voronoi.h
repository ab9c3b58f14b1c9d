// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_GRAPH_VORONOI_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_GRAPH_VORONOI_H

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

// Voronoi cells along the edges of a graph: of the points (supervoxels), and of the supervoxels (what
// their clustering begins with).

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A graph with the costs of its edges, in less memory than the neighbor graph.
struct Cost_graph
{
  struct Edge
  {
    Index point;
    float cost;
  };
  std::vector<std::size_t> first; ///< begin of each point's row in `edges`; size n + 1
  std::vector<Edge> edges;

  std::size_t size() const { return first.size() - 1; }
};

/// Dijkstra's search from seeds that are added one after the other; every point belongs to the seed
/// that is nearest along the graph.
class Graph_voronoi
{
public:
  explicit Graph_voronoi(const Cost_graph& graph)
    : m_graph(graph), m_distance(graph.size(), infinity()), m_cell(graph.size(), 0)
  {}

  static constexpr float infinity() { return std::numeric_limits<float>::infinity(); }
  float distance(const Index point) const { return m_distance[point]; }
  const std::vector<Index>& cells() const { return m_cell; }

  void add_seed(const Index point, const Index cell)
  {
    m_distance[point] = 0.f;
    m_cell[point] = cell;
    m_front.push(entry(0.f, point));
  }

  /// lets the seeds added so far take all points that are nearer to them.
  void grow()
  {
    while (!m_front.empty())
    {
      const std::uint64_t top = m_front.top();
      const Index i = static_cast<Index>(top);
      m_front.pop();
      const float d = m_distance[i];
      if (top != entry(d, i)) continue; // a shorter way was found since
      for (std::size_t e = m_graph.first[i]; e < m_graph.first[i + 1]; ++e)
      {
        const auto [j, cost] = m_graph.edges[e];
        const float through = d + cost;
        if (through >= m_distance[j]) continue;
        m_distance[j] = through;
        m_cell[j] = m_cell[i];
        m_front.push(entry(through, j));
      }
    }
  }

  /// distance and point as one integer, in the same order: the bits of floats from 0 on ascend
  static std::uint64_t entry(const float distance, const Index point)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &distance, sizeof(bits));
    return static_cast<std::uint64_t>(bits) << 32 | point;
  }

private:
  const Cost_graph& m_graph;
  std::vector<float> m_distance;
  std::vector<Index> m_cell;
  std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<std::uint64_t>>
      m_front;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_GRAPH_VORONOI_H
