// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/Voronoi_cells.h>
#include <CGAL/Weakly_convex_segmentation/internal/spectral_embedding.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

// Normalized spectral clustering of a small weighted graph (section 4, "Initial patches").
//
// k-means sees only distances in the space of the lowest eigenvectors of the normalized Laplacian, not
// the vectors themselves, so any basis of that space will do: a low-pass filter of the graph's spectrum
// makes one out of the indicators of as many cells as it has dimensions. From those cells, divided on into
// as many as clusters are wanted, k-means starts, so that little is left to chance, and it only asks for the
// clusters of a node's neighbors. All of it takes a fraction of the time of eigenvectors and of k-means
// as they are.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Two divisions of a graph into cells, of which the second has more.
struct Spread_cells
{
  std::vector<Index> few, many; ///< cell of each node
};

/// divides a connected graph into at most `few` and into at most `many` cells about nodes that are far
/// from each other. An edge of low weight is long.
inline Spread_cells spread_cells(const Normalized_graph& graph, const std::size_t few,
                                 const std::size_t many, Index seed)
{
  Spread_cells result;
  Cost_graph costs{graph.first, {}};
  costs.edges.reserve(graph.edges.size());
  for (const auto& edge : graph.edges) costs.edges.push_back({edge.node, 1.f / edge.weight});
  Voronoi_cells cells(costs);
  for (Index c = 0; c < many && cells.distance(seed) > 0.f; ++c)
  {
    if (c == few) result.few = cells.cells();
    cells.add_seed(seed, c);
    cells.grow();
    seed = 0;
    for (Index i = 1; i < graph.size(); ++i)
      if (cells.distance(i) > cells.distance(seed)) seed = i;
  }
  result.many = cells.cells();
  if (result.few.empty()) result.few = result.many;
  return result;
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

/// returns the dimensions of the space in which `count` clusters are looked for. Few clusters need one
/// each: in a single dimension all nodes of a graph are the same.
inline std::size_t spectral_dimensions(const std::size_t count, const double share)
{
  constexpr std::size_t few = 10;
  const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  return (std::max)(wanted, (std::min)(count, few));
}

/// clusters the `size` nodes of a connected graph into at most `count` clusters.
///
/// Complexity: O((size * degree + number of edges * degree) * dimensions + size * dimensions^2), with
/// `Parameters::spectral_filter_degree` and `Parameters::spectral_dimensions` times the count.
inline std::vector<Index> spectral_clusters(const std::size_t size,
                                            const std::vector<Weighted_edge>& edges,
                                            const std::size_t count, const Parameters& parameters,
                                            const unsigned int seed)
{
  if (count <= 1 || size <= 2) return std::vector<Index>(size, 0);
  if (count + 1 >= size)
  {
    std::vector<Index> own(size);
    for (std::size_t i = 0; i < size; ++i) own[i] = static_cast<Index>(i);
    return own;
  }
  const Normalized_graph graph(size, edges);
  const std::size_t dimensions = spectral_dimensions(count, parameters.spectral_dimensions);
  Spread_cells cells =
      spread_cells(graph, dimensions, count, static_cast<Index>(std::mt19937(seed)() % size));
  const Row_matrix rows =
      spectral_embedding(graph, cells.few, dimensions, parameters.spectral_filter_degree);
  move_to_nearest_means(graph, rows, count, cells.many);
  return std::move(cells.many);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H
