// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H

#include <CGAL/Weakly_convex_segmentation/internal/Voronoi_cells.h>
#include <CGAL/Weakly_convex_segmentation/internal/spectral_embedding.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

// Normalized spectral clustering of a small weighted graph (section 4, "Initial patches").
//
// k-means sees only distances in the space of the lowest eigenvectors of the normalized Laplacian, not
// the vectors themselves, so any basis of that space will do: a low-pass filter of the graph's spectrum
// makes one out of the indicators of as many cells as clusters are wanted. The same cells are what
// k-means starts from, so that little is left to chance, and it only asks for the clusters of a node's
// neighbors. All of it takes a fraction of the time of eigenvectors and of k-means as they are.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// divides a connected graph into at most `count` cells about nodes that are far from each other. An
/// edge of low weight is long.
inline std::vector<Index> spread_cells(const Normalized_graph& graph, const std::size_t count,
                                       Index seed)
{
  Cost_graph costs{graph.first, {}};
  costs.edges.reserve(graph.edges.size());
  for (const auto& edge : graph.edges) costs.edges.push_back({edge.node, 1.f / edge.weight});
  Voronoi_cells cells(costs);
  for (Index c = 0; c < count && cells.distance(seed) > 0.f; ++c)
  {
    cells.add_seed(seed, c);
    cells.grow();
    seed = 0;
    for (Index i = 1; i < graph.size(); ++i)
      if (cells.distance(i) > cells.distance(seed)) seed = i;
  }
  return cells.cells();
}

/// returns the means of the rows of each cluster.
inline Row_matrix cluster_means(const Row_matrix& rows, const std::vector<Index>& cluster,
                                const std::size_t count)
{
  Row_matrix means(count, rows.columns());
  std::vector<float> size(count, 0.f);
  for (std::size_t i = 0; i < rows.rows(); ++i)
  {
    size[cluster[i]] += 1.f;
    add_multiple(means.row(cluster[i]), rows.groups(), 1.f, rows.row(i));
  }
  for (std::size_t c = 0; c < count; ++c)
    if (size[c] > 0.f) divide(means.row(c), means.groups(), size[c]);
  return means;
}

/// Lloyd's algorithm from given clusters; a node moves only to the cluster of a neighbor.
inline void move_to_nearest_means(const Normalized_graph& graph, const Row_matrix& rows,
                                  const std::size_t count, std::vector<Index>& cluster)
{
  constexpr int maximum_iterations = 30;
  constexpr float rounding = 1e-6f; // where all are equally near, a node stays
  std::vector<float> half_norm(count);
  for (int iteration = 0; iteration < maximum_iterations; ++iteration)
  {
    const Row_matrix means = cluster_means(rows, cluster, count);
    for (std::size_t c = 0; c < count; ++c)
      half_norm[c] = 0.5f * product_of(means.row(c), means.row(c), means.groups());
    std::vector<Index> next = cluster;
    std::vector<std::size_t> asked(count, graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i)
    {
      float best = -std::numeric_limits<float>::infinity();
      const auto ask = [&](const Index c)
      {
        if (std::exchange(asked[c], i) == i) return;
        // |x - c|^2 = |x|^2 - 2 x.c + |c|^2
        const float nearness = product_of(rows.row(i), means.row(c), rows.groups()) - half_norm[c];
        if (nearness <= best + rounding) return;
        best = nearness;
        next[i] = c;
      };
      ask(cluster[i]);
      for (std::size_t e = graph.first[i]; e < graph.first[i + 1]; ++e)
        ask(cluster[graph.edges[e].node]);
    }
    if (next == cluster) break;
    cluster.swap(next);
  }
}

/// clusters the `size` nodes of a connected graph into at most `count` clusters.
///
/// Complexity: O((size + number of edges) * count + size * count^2).
inline std::vector<Index> spectral_clusters(const std::size_t size,
                                            const std::vector<Weighted_edge>& edges,
                                            const std::size_t count, const unsigned int seed)
{
  if (count <= 1 || size <= 2) return std::vector<Index>(size, 0);
  if (count + 1 >= size)
  {
    std::vector<Index> own(size);
    for (std::size_t i = 0; i < size; ++i) own[i] = static_cast<Index>(i);
    return own;
  }
  const Normalized_graph graph(size, edges);
  std::vector<Index> cluster =
      spread_cells(graph, count, static_cast<Index>(std::mt19937(seed)() % size));
  const Row_matrix rows = spectral_embedding(graph, cluster, count);
  move_to_nearest_means(graph, rows, count, cluster);
  return cluster;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H
