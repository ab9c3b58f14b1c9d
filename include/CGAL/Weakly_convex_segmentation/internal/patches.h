// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/spectral_clustering.h>
#include <CGAL/Weakly_convex_segmentation/internal/supervoxels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

// Initial patches (section 4): spectral clustering of the point-convexity graph.
//
// The paper clusters the points; we cluster a bounded number of supervoxels and carry the labels to
// the points, so that the eigenproblem does not grow with the shape. The paper is silent on the
// number of patches and on what becomes of patches that are not connected: we split them.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

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
inline std::vector<Weighted_edge> supervoxel_edges(const Neighbor_graph& graph,
                                                   const Supervoxels& supervoxels,
                                                   const Parameters& parameters)
{
  const float tolerance = radians(parameters.patch_concavity_tolerance);
  std::vector<std::pair<std::uint64_t, double>> crossings;
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const std::uint64_t a = supervoxels.of_point[i], b = supervoxels.of_point[edge.point];
      if (a < b)
        crossings.push_back(
            {a << 32 | b, edge.concavity > tolerance ? parameters.concave_edge_weight : 1.});
    }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Weighted_edge> edges;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (i == 0 || crossings[i].first != crossings[i - 1].first)
      edges.push_back({static_cast<Index>(crossings[i].first >> 32),
                       static_cast<Index>(crossings[i].first & 0xffffffff), 0.});
    edges.back().weight += crossings[i].second;
  }
  // an edge of weight 0 would leave a node without a degree
  for (Weighted_edge& e : edges) e.weight = (std::max)(e.weight, 1e-6);
  return edges;
}

/// clusters the supervoxels, each connected piece of their graph on its own with its share of the
/// wanted patches: a shape of thousands of pieces then has small eigenproblems, and most have none.
inline std::vector<Index> cluster_supervoxels(const Supervoxels& supervoxels,
                                              const std::vector<Weighted_edge>& edges,
                                              const Parameters& parameters, const unsigned int seed)
{
  std::vector<Index> parent(supervoxels.count);
  std::iota(parent.begin(), parent.end(), Index(0));
  const auto root = [&parent](Index i)
  {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Weighted_edge& e : edges) parent[root(e.second)] = root(e.first);

  std::vector<std::vector<Index>> nodes(supervoxels.count);
  std::vector<Index> local(supervoxels.count);
  std::vector<std::size_t> points(supervoxels.count, 0);
  for (Index i = 0; i < supervoxels.count; ++i)
  {
    auto& piece = nodes[root(i)];
    local[i] = static_cast<Index>(piece.size());
    piece.push_back(i);
  }
  for (const Index s : supervoxels.of_point) ++points[root(s)];
  std::vector<std::vector<Weighted_edge>> piece_edges(supervoxels.count);
  for (const Weighted_edge& e : edges)
    piece_edges[root(e.first)].push_back({local[e.first], local[e.second], e.weight});

  std::vector<Index> cluster(supervoxels.count);
  Index first_cluster = 0;
  for (Index r = 0; r < supervoxels.count; ++r)
  {
    if (nodes[r].empty()) continue;
    const double share = static_cast<double>(points[r]) / supervoxels.of_point.size();
    const std::size_t wanted = static_cast<std::size_t>(
        std::ceil(share * static_cast<double>(parameters.number_of_patches) - 1e-9));
    const std::vector<Index> own =
        spectral_clusters(nodes[r].size(), piece_edges[r], wanted, parameters, seed);
    Index used = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      cluster[nodes[r][i]] = first_cluster + own[i];
      used = (std::max)(used, own[i] + 1);
    }
    first_cluster += used;
  }
  return cluster;
}

/// gives small pieces to the neighbor with the most edges to them, smallest first, and renumbers.
/// Pieces without a neighbor stay.
inline std::vector<int> absorb_small_pieces(const Neighbor_graph& graph, const Pieces& pieces,
                                            const std::size_t minimum_size)
{
  const std::size_t count = pieces.sizes.size();
  std::vector<std::map<int, std::size_t>> contacts(count);
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const int a = pieces.of_point[i], b = pieces.of_point[edge.point];
      if (a != b) ++contacts[a][b];
    }
  std::vector<int> by_size(count), target(count);
  std::iota(by_size.begin(), by_size.end(), 0);
  target = by_size;
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](const int a, const int b) { return pieces.sizes[a] < pieces.sizes[b]; });
  std::vector<std::size_t> sizes = pieces.sizes;
  const auto root = [&target](int i)
  {
    while (target[i] != i) i = target[i];
    return i;
  };
  for (const int piece : by_size)
  {
    if (sizes[piece] >= minimum_size || target[piece] != piece) continue;
    std::pair<std::size_t, int> best(0, -1);
    for (const auto& [other, edges] : contacts[piece])
      if (root(other) != piece) best = (std::max)(best, {edges, root(other)});
    if (best.second < 0) continue;
    target[piece] = best.second;
    sizes[best.second] += sizes[piece];
    for (const auto& [other, edges] : contacts[piece]) contacts[best.second][root(other)] += edges;
  }
  std::vector<int> number(count, -1), result(pieces.of_point.size());
  int next = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    int& label = number[root(pieces.of_point[i])];
    if (label < 0) label = next++;
    result[i] = label;
  }
  return result;
}

/// returns the patches that one clustering of the supervoxels gives.
inline Patches cluster_to_patches(const Neighbor_graph& graph, const Supervoxels& supervoxels,
                                  const std::vector<Weighted_edge>& edges,
                                  const Parameters& parameters, const unsigned int seed)
{
  const std::vector<Index> cluster = cluster_supervoxels(supervoxels, edges, parameters, seed);
  std::vector<Index> labels(graph.size());
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = cluster[supervoxels.of_point[i]];

  Patches patches;
  patches.of_point =
      absorb_small_pieces(graph, connected_pieces(graph, labels), parameters.minimum_patch_size);
  const int count = 1 + *std::max_element(patches.of_point.begin(), patches.of_point.end());
  patches.members.resize(static_cast<std::size_t>(count));
  for (Index i = 0; i < graph.size(); ++i) patches.members[patches.of_point[i]].push_back(i);
  return patches;
}

/// over-segments the points into patches, `Parameters::number_of_patch_sets` times: the clusterings
/// begin at different supervoxels.
inline std::vector<Patches> extract_patch_sets(const Oriented_points& points,
                                               const Neighbor_graph& graph,
                                               const Parameters& parameters, const bool parallel)
{
  const Supervoxels supervoxels = build_supervoxels(points, graph, parameters.number_of_supervoxels,
                                                    parameters.patch_concavity_tolerance);
  const std::vector<Weighted_edge> edges = supervoxel_edges(graph, supervoxels, parameters);
  std::mt19937 random(parameters.seed);
  std::vector<unsigned int> seeds = {parameters.seed};
  while (seeds.size() < parameters.number_of_patch_sets)
    seeds.push_back(static_cast<unsigned int>(random()));
  std::vector<Patches> sets(seeds.size());
  parallel_for(
      sets.size(), parallel,
      [&](const std::size_t s)
      { sets[s] = cluster_to_patches(graph, supervoxels, edges, parameters, seeds[s]); },
      1);
  return sets;
}

/// over-segments the points into one set of patches.
inline Patches extract_patches(const Oriented_points& points, const Neighbor_graph& graph,
                               Parameters parameters)
{
  parameters.number_of_patch_sets = 1;
  return std::move(extract_patch_sets(points, graph, parameters, false).front());
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_H
