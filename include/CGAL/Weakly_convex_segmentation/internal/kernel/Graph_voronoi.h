// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_GRAPH_VORONOI_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_GRAPH_VORONOI_H

// Voronoi cells along the edges of a graph: of the points (supervoxels), and of the supervoxels (what
// their clustering begins with).

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Search_front.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// An edge to another point, and its cost.
struct Cost_edge
{
  Index point;
  float cost;
};
/// A graph with the costs of its edges, in less memory than the neighbor graph.
using Cost_graph = Compressed_rows<Cost_edge>;

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
    m_front.push(point, 0.f);
  }

  /// lets the seeds added so far take all points that are nearer to them, by more than rounding makes.
  void grow()
  {
    m_front.search([this](const Index i) { return m_distance[i]; },
                   [this](const Index i, const float d)
                   {
                     for (const auto& [j, cost] : m_graph[i])
                     {
                       const float through = d + cost;
                       if (through >= nearer * m_distance[j]) continue;
                       m_distance[j] = through;
                       m_cell[j] = m_cell[i];
                       m_front.push(j, through);
                     }
                   });
  }

private:
  static constexpr float nearer = 1.f - 1e-4f; ///< times a distance: less is less
  const Cost_graph& m_graph;
  std::vector<float> m_distance;
  std::vector<Index> m_cell;
  Search_front m_front;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_GRAPH_VORONOI_H
