// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SPECTRAL_CLUSTERING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SPECTRAL_CLUSTERING_H

// Normalized spectral clustering of a weighted graph (section 4, "Initial patches").
//
// k-means begins with cells about nodes that are far from each other along the graph, so that little is
// left to chance, and only asks for the clusters of a node's neighbors: k-means++ over all clusters makes
// a whole run take 1.22 times as long.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Graph_voronoi.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/spectral_embedding.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the graph with its edges as long as their normalized weights are low.
inline Cost_graph edge_lengths(const Graph_matrix& adjacency)
{
  Cost_graph lengths;
  for (int i = 0; i < adjacency.outerSize(); ++i)
  {
    for (Graph_matrix::InnerIterator e(adjacency, i); e; ++e)
      lengths.entries.push_back({static_cast<Index>(e.row()), 1.f / e.value()});
    lengths.end_row();
  }
  return lengths;
}

/// returns a node by chance: the one whose place has the least hash, so that it is found again on a shape that was
/// moved a little or is otherwise numbered.
inline Index random_node(const std::vector<std::uint32_t>& places,
                         const std::size_t number_of_nodes, const unsigned int seed)
{
  const std::uint32_t salt = static_cast<std::uint32_t>(std::mt19937(seed)());
  const auto hash = [salt](const std::uint32_t place)
  {
    std::uint32_t h = (place ^ salt) * 2654435761u;
    h = (h ^ h >> 15) * 2246822519u;
    return h ^ h >> 13;
  };
  std::pair<std::uint32_t, Index> least(std::numeric_limits<std::uint32_t>::max(), 0);
  for (Index i = 0; i < number_of_nodes; ++i)
    least = (std::min)(least, {hash(places.empty() ? i : places[i]), i});
  return least.second;
}

/// divides a connected graph into at most `count` cells about nodes that are far from each other, from the first on.
inline std::vector<Index> spread_cells(const Cost_graph& lengths, const std::size_t count,
                                       const Index first)
{
  constexpr float farther = 1.f + 1e-4f; // than rounding makes
  Graph_voronoi cells(lengths);
  Index farthest = first;
  for (Index c = 0; c < count && cells.distance(farthest) > 0.f; ++c)
  {
    cells.add_seed(farthest, c);
    cells.grow();
    farthest = 0;
    for (Index i = 1; i < lengths.size(); ++i)
      if (cells.distance(i) > farther * cells.distance(farthest)) farthest = i;
  }
  return cells.cells();
}

/// returns the means of the rows of each cluster; of those without any, zero.
inline Embedding cluster_means(const Embedding& rows, const std::vector<Index>& cluster,
                               const std::size_t count)
{
  Embedding means = Embedding::Zero(static_cast<Eigen::Index>(count), rows.cols());
  Eigen::VectorXf sizes = Eigen::VectorXf::Zero(means.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    const auto c = static_cast<Eigen::Index>(cluster[static_cast<std::size_t>(i)]);
    means.row(c) += rows.row(i);
    sizes[c] += 1.f;
  }
  means.array().colwise() /= sizes.array().max(1.f);
  return means;
}

/// Lloyd's algorithm from given clusters; a node moves only to the cluster of a neighbor.
inline void move_to_nearest_means(const Cost_graph& graph, const Embedding& rows,
                                  const std::size_t count, std::vector<Index>& cluster)
{
  constexpr int maximum_iterations = 30;
  constexpr float rounding = 1e-6f; // where all are equally near, a node stays
  for (int iteration = 0; iteration < maximum_iterations; ++iteration)
  {
    const Embedding means = cluster_means(rows, cluster, count);
    const Eigen::VectorXf half_norms = 0.5f * means.rowwise().squaredNorm();
    std::vector<Index> next = cluster;
    std::vector<std::size_t> asked(count, graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i)
    {
      const auto row = rows.row(static_cast<Eigen::Index>(i));
      float best = -std::numeric_limits<float>::infinity();
      const auto ask = [&](const Index c)
      {
        if (std::exchange(asked[c], i) == i) return;
        // |x - c|^2 = |x|^2 - 2 x.c + |c|^2
        const float nearness = row.dot(means.row(c)) - half_norms[c];
        if (nearness <= best + rounding) return;
        best = nearness;
        next[i] = c;
      };
      ask(cluster[i]);
      for (const Cost_edge& edge : graph[i]) ask(cluster[edge.point]);
    }
    if (next == cluster) break;
    cluster.swap(next);
  }
}

/// returns the dimensions of the space in which `count` clusters are looked for. Few clusters need one
/// each: in a single dimension all nodes of a graph are the same.
inline std::size_t spectral_dimensions(const std::size_t count, const double share)
{
  constexpr std::size_t few = 10;
  const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  return (std::max)(wanted, (std::min)(count, few));
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SPECTRAL_CLUSTERING_H
