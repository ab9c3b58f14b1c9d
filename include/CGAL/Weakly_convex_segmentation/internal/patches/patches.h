// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_PATCHES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_PATCHES_H

// Initial patches (section 4): spectral clustering of the point-convexity graph.
//
// The paper clusters the points; we cluster a bounded number of supervoxels and carry the labels to
// the points, so that the eigenproblem does not grow with the shape. The paper is silent on the
// number of patches and on what becomes of patches that are not connected: we split them. Concave pairs are "not
// connected" there; here their edges weigh a thousandth, so that the graph stays in one piece. Without any weight
// the `paper` preset has 0.131 instead of 0.134 on 38 meshes, which is within the noise.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/number_labels.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/oracle_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/supervoxels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// connected pieces of patches with fewer points are given to a neighbor
constexpr std::size_t minimum_patch_size = 5;

/// A partition of the points into connected, nearly convex patches.
struct Patches
{
  std::vector<int> of_point;
  std::vector<std::vector<Index>> members; ///< points of each patch, ascending
  std::size_t size() const { return members.size(); }
};

/// Connected pieces of the classes of a labeling.
struct Pieces
{
  std::vector<int> of_point;
  std::vector<std::size_t> sizes;
};

/// returns the connected pieces of points of equal label, numbered in the order of the points.
inline Pieces connected_pieces(const Neighbor_graph& graph, const std::vector<Index>& labels)
{
  Pieces pieces;
  pieces.of_point.assign(graph.size(), -1);
  std::vector<Index> stack;
  for (Index i = 0; i < graph.size(); ++i)
  {
    if (pieces.of_point[i] >= 0) continue;
    const int piece = static_cast<int>(pieces.sizes.size());
    pieces.sizes.push_back(0);
    pieces.of_point[i] = piece;
    stack.push_back(i);
    while (!stack.empty())
    {
      const Index j = stack.back();
      stack.pop_back();
      ++pieces.sizes.back();
      for (const Neighbor& edge : graph[j])
        if (pieces.of_point[edge.point] < 0 && labels[edge.point] == labels[i])
        {
          pieces.of_point[edge.point] = piece;
          stack.push_back(edge.point);
        }
    }
  }
  return pieces;
}

/// returns the weighted graph of the supervoxels: a convex edge between two points counts 1, a
/// concave one `concave_weight`.
inline std::vector<Convexity_graph::Edge> supervoxel_edges(const Neighbor_graph& graph,
                                                           const Supervoxels& supervoxels,
                                                           const Patch_parameters& parameters)
{
  constexpr double concave_edge_weight = 0.001; // relative to 1 for the others
  const float tolerance = radians(parameters.patch_concavity_tolerance);
  std::vector<std::pair<std::uint64_t, double>> crossings;
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const std::uint64_t a = supervoxels.of_point[i], b = supervoxels.of_point[edge.point];
      if (a < b)
        crossings.push_back({a << 32 | b, edge.concavity > tolerance ? concave_edge_weight : 1.});
    }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Convexity_graph::Edge> edges;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (i == 0 || crossings[i].first != crossings[i - 1].first)
      edges.push_back({static_cast<Index>(crossings[i].first >> 32),
                       static_cast<Index>(crossings[i].first & 0xffffffff), 0.});
    edges.back().weight += crossings[i].second;
  }
  // an edge of weight 0 would leave a node without a degree
  for (Convexity_graph::Edge& e : edges) e.weight = (std::max)(e.weight, 1e-6);
  return edges;
}

/// A connected piece of the graph of the supervoxels.
struct Supervoxel_piece
{
  std::vector<Index> supervoxels; ///< its nodes
  Clusters_of_seed clusters;      ///< of its nodes
};

/// returns a function that makes clusters of the nodes. There is nothing to cluster where one is wanted, or
/// one for each.
inline Clusters_of_seed clusters_of(const Patch_clustering& clustering,
                                    const Convexity_graph& graph, const std::size_t wanted)
{
  const std::size_t nodes = graph.number_of_nodes;
  if (wanted <= 1 || nodes <= 2)
    return [nodes](unsigned int) { return std::vector<Index>(nodes, 0); };
  if (wanted + 1 < nodes) return clustering(graph, wanted);
  return [nodes](unsigned int)
  {
    std::vector<Index> own(nodes);
    std::iota(own.begin(), own.end(), Index(0));
    return own;
  };
}

/// returns the place of each supervoxel, of a grid whose cells do not end where symmetric and regular shapes have their
/// points.
inline std::vector<std::uint32_t> places_of(const Supervoxels& supervoxels,
                                            const Oriented_points& points)
{
  constexpr float side = 1.f / 31.4f;
  std::vector<std::uint32_t> places;
  for (const Index i : supervoxels.centers)
    places.push_back(static_cast<std::uint32_t>(voxel_key(points.positions[i], side)));
  return places;
}

/// prepares the clustering of each connected piece of the supervoxels' graph, with its share of the wanted
/// patches: a shape of thousands of pieces then has small eigenproblems, and most have none.
inline std::vector<Supervoxel_piece>
supervoxel_pieces(const Oriented_points& positions, const Supervoxels& supervoxels,
                  const std::vector<Convexity_graph::Edge>& edges,
                  const std::size_t number_of_patches, const Patch_clustering& clustering)
{
  Disjoint_sets<Index> sets(supervoxels.count);
  for (const Convexity_graph::Edge& e : edges) sets.join(e.first, e.second);

  std::vector<Supervoxel_piece> pieces(supervoxels.count); // by the names of the sets, for now
  std::vector<Convexity_graph> graphs(supervoxels.count);
  std::vector<Index> local(supervoxels.count);
  std::vector<std::size_t> points(supervoxels.count, 0);
  const std::vector<std::uint32_t> places = places_of(supervoxels, positions);
  for (Index i = 0; i < supervoxels.count; ++i)
  {
    local[i] = static_cast<Index>(graphs[sets.find(i)].number_of_nodes++);
    graphs[sets.find(i)].places.push_back(places[i]);
    pieces[sets.find(i)].supervoxels.push_back(i);
  }
  for (const Index s : supervoxels.of_point) ++points[sets.find(s)];
  for (const Convexity_graph::Edge& e : edges)
    graphs[sets.find(e.first)].edges.push_back({local[e.first], local[e.second], e.weight});
  const double all = static_cast<double>(number_of_near_points(positions));
  for (Index r = 0; r < supervoxels.count; ++r)
  {
    const double wanted = static_cast<double>(number_of_patches) * static_cast<double>(points[r]);
    if (points[r] > 0)
      pieces[r].clusters = clusters_of(clustering, graphs[r],
                                       static_cast<std::size_t>(std::ceil(wanted / all - 1e-9)));
  }
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [](const Supervoxel_piece& p) { return p.supervoxels.empty(); }),
               pieces.end());
  return pieces;
}

/// returns the cluster of each supervoxel.
/// \throws std::invalid_argument if the clustering does not give each node a cluster
inline std::vector<Index> cluster_supervoxels(const std::size_t count,
                                              const std::vector<Supervoxel_piece>& pieces,
                                              const unsigned int seed)
{
  std::vector<Index> cluster(count);
  Index first_cluster = 0;
  for (const Supervoxel_piece& piece : pieces)
  {
    const std::vector<Index> own = piece.clusters(seed);
    if (own.size() != piece.supervoxels.size())
      throw std::invalid_argument("the clustering of the patches returned " +
                                  std::to_string(own.size()) + " clusters for " +
                                  std::to_string(piece.supervoxels.size()) +
                                  " nodes; it has to give each node one");
    Index used = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      cluster[piece.supervoxels[i]] = first_cluster + own[i];
      used = (std::max)(used, own[i] + 1);
    }
    first_cluster += used;
  }
  return cluster;
}

/// gives small pieces to the neighbor with the most edges to them, smallest first, and renumbers.
/// Pieces without a neighbor stay; with `segments` of the points, neighbors are those in the same segment.
inline std::vector<int> absorb_small_pieces(const Neighbor_graph& graph, const Pieces& pieces,
                                            const std::size_t minimum_size,
                                            const std::vector<int>* const segments = nullptr)
{
  const std::size_t count = pieces.sizes.size();
  std::vector<std::map<int, std::size_t>> contacts(count);
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const int a = pieces.of_point[i], b = pieces.of_point[edge.point];
      if (a != b && (segments == nullptr || (*segments)[i] == (*segments)[edge.point]))
        ++contacts[a][b];
    }
  std::vector<int> by_size(count);
  std::iota(by_size.begin(), by_size.end(), 0);
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](const int a, const int b) { return pieces.sizes[a] < pieces.sizes[b]; });
  std::vector<std::size_t> sizes = pieces.sizes;
  Disjoint_sets<int> joined(count);
  for (const int piece : by_size)
  {
    if (sizes[piece] >= minimum_size || joined.find(piece) != piece) continue;
    std::pair<std::size_t, int> best(0, -1);
    for (const auto& [other, edges] : contacts[piece])
      if (joined.find(other) != piece) best = (std::max)(best, {edges, joined.find(other)});
    if (best.second < 0) continue;
    joined.join_named(best.second, piece);
    sizes[best.second] += sizes[piece];
    for (const auto& [other, edges] : contacts[piece])
      contacts[best.second][joined.find(other)] += edges;
  }
  std::vector<int> result;
  result.reserve(pieces.of_point.size());
  for (const int piece : pieces.of_point) result.push_back(joined.find(piece));
  number_labels(result);
  return result;
}

/// returns the patches of a labeling of the points from 0 on without gaps.
inline Patches patches_of_labels(std::vector<int> labels)
{
  Patches patches;
  patches.of_point = std::move(labels);
  const int count = 1 + *std::max_element(patches.of_point.begin(), patches.of_point.end());
  patches.members.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < patches.of_point.size(); ++i)
    patches.members[patches.of_point[i]].push_back(static_cast<Index>(i));
  return patches;
}

/// returns the patches that one clustering of the supervoxels gives.
inline Patches cluster_to_patches(const Neighbor_graph& graph, const Supervoxels& supervoxels,
                                  const std::vector<Supervoxel_piece>& pieces,
                                  const unsigned int seed)
{
  const std::vector<Index> cluster = cluster_supervoxels(supervoxels.count, pieces, seed);
  std::vector<Index> labels(graph.size());
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = cluster[supervoxels.of_point[i]];

  return patches_of_labels(
      absorb_small_pieces(graph, connected_pieces(graph, labels), minimum_patch_size));
}

/// over-segments the points into patches, `Parameters::number_of_patch_sets` times: the clusterings
/// begin at different supervoxels.
inline std::vector<Patches> extract_patch_sets(const Oriented_points& points,
                                               const Neighbor_graph& graph,
                                               const Patch_parameters& parameters,
                                               const bool parallel,
                                               const Patch_clustering& clustering)
{
  // what is far away has supervoxels of its own besides
  const std::size_t supervoxel_count =
      parameters.number_of_supervoxels * points.size() / number_of_near_points(points);
  const Supervoxels supervoxels =
      build_supervoxels(points, graph, supervoxel_count, parameters.patch_concavity_tolerance);
  const std::vector<Supervoxel_piece> pieces =
      supervoxel_pieces(points, supervoxels, supervoxel_edges(graph, supervoxels, parameters),
                        parameters.number_of_patches, clustering);
  std::mt19937 random(parameters.seed);
  std::vector<unsigned int> seeds = {parameters.seed};
  while (seeds.size() < parameters.number_of_patch_sets)
    seeds.push_back(static_cast<unsigned int>(random()));
  std::vector<Patches> sets(seeds.size());
  parallel_for(
      sets.size(), parallel,
      [&](const std::size_t s)
      { sets[s] = cluster_to_patches(graph, supervoxels, pieces, seeds[s]); },
      1);
  return sets;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_PATCHES_H
