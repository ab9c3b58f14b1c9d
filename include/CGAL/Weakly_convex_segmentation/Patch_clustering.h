// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_PATCH_CLUSTERING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_PATCH_CLUSTERING_H

// The clusterings that make the initial patches (section 4): models of
// `WeaklyConvexSegmentationPatchClustering`.

#include <CGAL/Weakly_convex_segmentation/Convexity_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/spectral_clustering.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Normalized spectral clustering, as in the paper: k-means in the space of the lowest eigenvectors of the
/// graph's normalized Laplacian, which Spectra computes once; each seed begins with other clusters.
///
/// \cgalModels `WeaklyConvexSegmentationPatchClustering`
class Spectral_patch_clustering
{
  double m_dimensions;

public:
  /// `dimensions`: those of the space, relative to the number of clusters, but up to 10 clusters have one
  /// each; in `[0.01, 1]`, see `Parameters::spectral_dimensions`
  explicit Spectral_patch_clustering(const double dimensions = 0.4) : m_dimensions(dimensions) {}

  /// returns a function that gives each node its cluster for a seed.
  ///
  /// Complexity: O(n^1.5) to factor the matrix of n nodes on a surface, and O(n d^2) for each of about 4 restarts of the
  /// solver, 20 at most, with d dimensions; O(n^3) where n is at most 1.5 d + 10. For each seed O(c n log n + e d) with c
  /// clusters and e edges.
  auto operator()(const Convexity_graph& graph, const std::size_t number_of_clusters) const
  {
    const internal::Graph_matrix adjacency = internal::normalized_adjacency(graph);
    return [number_of_clusters, places = graph.places, lengths = internal::edge_lengths(adjacency),
            rows = internal::spectral_embedding(
                adjacency, internal::spectral_dimensions(number_of_clusters, m_dimensions))](
               const unsigned int seed)
    {
      std::vector<std::uint32_t> cluster = internal::spread_cells(
          lengths, number_of_clusters, internal::random_node(places, lengths.size(), seed));
      internal::move_to_nearest_means(lengths, rows, number_of_clusters, cluster);
      return cluster;
    };
  }
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Cells about nodes that are far from each other along the graph, where edges of low weight are long: in a
/// fraction of the time of `Spectral_patch_clustering`, with borders that follow concavities less.
///
/// \cgalModels `WeaklyConvexSegmentationPatchClustering`
class Voronoi_patch_clustering
{
public:
  /// returns a function that gives each node its cluster for a seed. Complexity, of that function:
  /// O(c n log n) for c clusters of n nodes.
  auto operator()(const Convexity_graph& graph, const std::size_t number_of_clusters) const
  {
    return [number_of_clusters, places = graph.places,
            lengths = internal::edge_lengths(internal::normalized_adjacency(graph))](
               const unsigned int seed)
    {
      return internal::spread_cells(lengths, number_of_clusters,
                                    internal::random_node(places, lengths.size(), seed));
    };
  }
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_PATCH_CLUSTERING_H
