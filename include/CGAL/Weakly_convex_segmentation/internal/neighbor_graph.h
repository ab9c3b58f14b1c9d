// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_NEIGHBOR_GRAPH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_NEIGHBOR_GRAPH_H

#include <CGAL/Weakly_convex_segmentation/internal/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/oriented_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/parallel_for.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

// The k-nearest-neighbor graph G_K (sections 4 and 5), built once and used by every stage.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// An edge of the neighbor graph, as seen from one of its ends.
struct Neighbor
{
  Index point;     ///< the other end
  float length;    ///< Euclidean distance
  float concavity; ///< angle between the normals in radians, negative where the edge is convex
};

/// An undirected graph on the points as an array of rows, each sorted by the neighbor's index.
struct Neighbor_graph
{
  std::vector<std::size_t> first; ///< begin of each point's row in `neighbors`; size n + 1
  std::vector<Neighbor> neighbors;
  std::vector<float> spacing; ///< mean distance of a point to its k nearest neighbors

  struct Row
  {
    const Neighbor *first, *last;
    const Neighbor* begin() const { return first; }
    const Neighbor* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  Row operator[](const std::size_t i) const
  {
    return {neighbors.data() + first[i], neighbors.data() + first[i + 1]};
  }
  std::size_t size() const { return spacing.size(); }
};

/// k-d tree over positions; a `Point_3` of CGAL is three floats, as ours.
class Nearest_points
{
  using Kernel = CGAL::Simple_cartesian<float>;
  using Point_3 = Kernel::Point_3;
  struct Position_map
  {
    using key_type = Index;
    using value_type = Point_3;
    using reference = const Point_3&;
    using category = boost::readable_property_map_tag;
    const Point_3* points;
    const Point_3& operator[](const Index i) const { return points[i]; }
    friend const Point_3& get(const Position_map& map, const Index i) { return map.points[i]; }
  };
  using Traits = CGAL::Search_traits_adapter<Index, Position_map, CGAL::Search_traits_3<Kernel>>;
  using Splitter = CGAL::Sliding_midpoint<Traits>;
  using Tree = CGAL::Kd_tree<Traits, Splitter, CGAL::Tag_true, CGAL::Tag_true>;
  using Distance = CGAL::Distance_adapter<Index, Position_map,
                                          CGAL::Euclidean_distance<CGAL::Search_traits_3<Kernel>>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits, Distance, Splitter, Tree>;

public:
  explicit Nearest_points(const std::vector<Vector3>& positions)
    : m_points(positions.size()), m_map{nullptr}
  {
    for (std::size_t i = 0; i < positions.size(); ++i)
      m_points[i] = Point_3(positions[i].x, positions[i].y, positions[i].z);
    m_map.points = m_points.data();
    std::vector<Index> indices(positions.size());
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<Index>(i);
    m_tree = std::make_unique<Tree>(indices.begin(), indices.end(), Splitter(20), Traits(m_map));
    m_tree->build();
  }

  /// calls `found(index, squared_distance)` for the `k` points nearest to `query`.
  template <typename Found>
  void nearest(const Vector3& query, const std::size_t k, const Found& found) const
  {
    const Distance distance(m_map);
    const Search search(*m_tree, Point_3(query.x, query.y, query.z), static_cast<unsigned int>(k),
                        0.f, true, distance, false);
    for (const auto& hit : search) found(hit.first, hit.second);
  }

private:
  std::vector<Point_3> m_points;
  Position_map m_map;
  std::unique_ptr<Tree> m_tree;
};

/// returns the angle between the normals, negative if the edge is convex: concave iff
/// (n_j - n_i) . (p_j - p_i) < 0, that is iff the normals lean towards each other.
inline float signed_concavity(const Oriented_points& points, const Index i, const Index j)
{
  const Vector3 along = points.positions[j] - points.positions[i];
  const float turn = dot(points.normals[j] - points.normals[i], along);
  const float a = angle(points.normals[i], points.normals[j]);
  return turn < 0.f ? a : -a;
}

/// fills the `k` nearest other points of each point; rows of fewer points end with the point itself.
inline std::vector<Index> nearest_neighbors(const Oriented_points& points, const std::size_t k,
                                            std::vector<float>& spacing, const bool parallel)
{
  const std::size_t n = points.size();
  const Nearest_points tree(points.positions);
  std::vector<Index> nearest(n * k);
  spacing.assign(n, 0.f);
  parallel_for(n, parallel,
               [&](const std::size_t i)
               {
                 Index* row = &nearest[i * k];
                 std::array<std::pair<float, Index>, 128> found;
                 std::size_t count = 0;
                 tree.nearest(points.positions[i], (std::min)(k + 1, found.size()),
                              [&](const Index j, const float d2)
                              {
                                if (j != i) found[count++] = {d2, j};
                              });
                 // ties are cut by index, so that the search's own order does not matter
                 std::sort(found.begin(), found.begin() + count);
                 count = (std::min)(count, k);
                 float sum = 0.f;
                 for (std::size_t j = 0; j < count; ++j)
                 {
                   row[j] = found[j].second;
                   sum += std::sqrt(found[j].first);
                 }
                 std::fill(row + count, row + k, static_cast<Index>(i));
                 spacing[i] = count > 0 ? sum / static_cast<float>(count) : 0.f;
               });
  return nearest;
}

/// gives points without a normal the mean of their neighbors' normals.
inline void fill_missing_normals(Oriented_points& points, const std::vector<Index>& nearest,
                                 const std::size_t k)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (squared_length(points.normals[i]) > 0.5f) continue;
    Vector3 sum;
    for (std::size_t j = i * k; j < (i + 1) * k; ++j) sum = sum + points.normals[nearest[j]];
    points.normals[i] = normalized(sum);
  }
}

/// builds the union of both directions of the k nearest neighbors and of the points' links.
///
/// `points` is changed only where it has no normal. Complexity: O(n log n).
inline Neighbor_graph build_neighbor_graph(Oriented_points& points, const std::size_t k,
                                           const bool parallel)
{
  Neighbor_graph graph;
  const std::size_t n = points.size();
  const std::vector<Index> nearest = nearest_neighbors(points, k, graph.spacing, parallel);
  fill_missing_normals(points, nearest, k);

  std::vector<std::size_t> fill(n + 1, 0);
  const auto for_each_pair = [&](const auto& visit)
  {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i * k; j < (i + 1) * k; ++j)
        if (nearest[j] != i) visit(static_cast<Index>(i), nearest[j]);
    for (const auto& link : points.links) visit(link[0], link[1]);
  };
  for_each_pair([&](const Index i, const Index j) { ++fill[i + 1], ++fill[j + 1]; });
  for (std::size_t i = 0; i < n; ++i) fill[i + 1] += fill[i];
  std::vector<Index> ends(fill[n]);
  std::vector<std::size_t> begin(fill.begin(), fill.end());
  for_each_pair([&](const Index i, const Index j) { ends[fill[i]++] = j, ends[fill[j]++] = i; });

  graph.first.assign(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto first = ends.begin() + begin[i], last = ends.begin() + begin[i + 1];
    std::sort(first, last);
    graph.first[i + 1] = graph.first[i] + (std::unique(first, last) - first);
  }
  graph.neighbors.resize(graph.first[n]);
  parallel_for(n, parallel,
               [&](const std::size_t i)
               {
                 Neighbor* out = graph.neighbors.data() + graph.first[i];
                 const Neighbor* end = graph.neighbors.data() + graph.first[i + 1];
                 for (const Index* j = ends.data() + begin[i]; out != end; ++j, ++out)
                   *out = {*j, length(points.positions[*j] - points.positions[i]),
                           signed_concavity(points, static_cast<Index>(i), *j)};
               });
  return graph;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_NEIGHBOR_GRAPH_H
