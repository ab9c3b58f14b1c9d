// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/Patch_clustering.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>

#include "patches_for_tests.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Initial patches (section 4): spectral clustering, supervoxels, and both together.

BOOST_AUTO_TEST_SUITE(test_patches)

namespace {

using CGAL::Weakly_convex_segmentation::Convexity_graph;
using CGAL::Weakly_convex_segmentation::Parameters;
using CGAL::Weakly_convex_segmentation::Spectral_patch_clustering;
using CGAL::Weakly_convex_segmentation::Voronoi_patch_clustering;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

using Edges = std::vector<Convexity_graph::Edge>;

std::vector<Index> spectral_clusters(const std::size_t size, const Edges& edges,
                                     const std::size_t count, const Parameters& parameters,
                                     const unsigned int seed)
{
  const Spectral_patch_clustering clustering(parameters.spectral_dimensions);
  return clusters_of(clustering, {size, edges}, count)(seed);
}

void add_clique(Edges& edges, const Index first, const Index size)
{
  for (Index i = first; i < first + size; ++i)
    for (Index j = first; j < i; ++j) edges.push_back({j, i, 1.});
}

/// number of pairs of a node and the clique of `size` nodes it is in, up to the naming of clusters
std::size_t number_of_distinct(const std::vector<Index>& clusters, const std::size_t size)
{
  std::set<std::pair<std::size_t, Index>> pairs;
  for (std::size_t i = 0; i < clusters.size(); ++i) pairs.insert({i / size, clusters[i]});
  return pairs.size();
}

/// a graph with the given flat edges, each of length 1
Neighbor_graph flat_graph(const std::size_t size, const std::vector<std::pair<Index, Index>>& edges)
{
  std::vector<std::set<Index>> rows(size);
  for (const auto& [a, b] : edges) rows[a].insert(b), rows[b].insert(a);
  Neighbor_graph graph;
  graph.first = {0};
  graph.spacing.assign(size, 1.f);
  for (const auto& row : rows)
  {
    for (const Index j : row) graph.entries.push_back({j, 1.f, 0.f});
    graph.end_row();
  }
  return graph;
}

struct Shape
{
  Oriented_points points;
  Neighbor_graph graph;
  std::vector<int> truth; ///< true part of each point

  explicit Shape(const Raw_shape& raw, const std::vector<int>& labels = {})
    : points(orient_points(raw)), graph(build_neighbor_graph(points, 10, false))
  {
    for (const Index e : points.elements) truth.push_back(labels.empty() ? 0 : labels[e]);
  }
  explicit Shape(const Shape_generator::Labeled_mesh& mesh)
    : Shape(points_of_mesh(mesh), mesh.labels)
  {}
};

/// share of the points that are not in the true part which most of their patch is in
double crossing_share(const Patches& patches, const std::vector<int>& truth)
{
  double crossing = 0.;
  for (const auto& members : patches.members)
  {
    std::map<int, std::size_t> parts;
    std::size_t most = 0;
    for (const Index i : members) most = (std::max)(most, ++parts[truth[i]]);
    crossing += static_cast<double>(members.size() - most);
  }
  return crossing / static_cast<double>(truth.size());
}

std::size_t number_of_pieces(const Neighbor_graph& graph, const std::vector<int>& labels)
{
  return connected_pieces(graph, std::vector<Index>(labels.begin(), labels.end())).sizes.size();
}

void check_partition(const Shape& shape, const Patches& patches)
{
  BOOST_REQUIRE_EQUAL(patches.of_point.size(), shape.points.size());
  std::size_t members = 0;
  bool consistent = true;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    BOOST_REQUIRE(!patches.members[p].empty());
    consistent = consistent && std::is_sorted(patches.members[p].begin(), patches.members[p].end());
    for (const Index i : patches.members[p])
      consistent = consistent && patches.of_point[i] == static_cast<int>(p);
    members += patches.members[p].size();
  }
  BOOST_CHECK(consistent);
  BOOST_CHECK_EQUAL(members, shape.points.size()); // with `consistent`: each point once
  BOOST_CHECK_EQUAL(number_of_pieces(shape.graph, patches.of_point), patches.size()); // connected
}

} // namespace

BOOST_AUTO_TEST_CASE(two_cliques_with_a_bridge_are_two_clusters)
{
  Edges edges;
  add_clique(edges, 0, 15);
  add_clique(edges, 15, 15);
  edges.push_back({14, 15, 1.});
  for (unsigned int seed = 0; seed < 10; ++seed)
  {
    const std::vector<Index> clusters = spectral_clusters(30, edges, 2, {}, seed);
    BOOST_CHECK_EQUAL(number_of_distinct(clusters, 15), 2u);
    BOOST_CHECK_NE(clusters[0], clusters[29]);
  }
}

BOOST_AUTO_TEST_CASE(a_weak_cut_decides_between_equal_pieces)
{
  // a cycle of 24 nodes with two light edges
  Edges edges;
  for (Index i = 0; i < 24; ++i) edges.push_back({i, (i + 1) % 24, i == 5 || i == 17 ? 0.01 : 1.});
  const std::vector<Index> clusters = spectral_clusters(24, edges, 2, {}, 0);
  for (Index i = 0; i < 24; ++i) BOOST_CHECK_EQUAL(clusters[i] == clusters[6], i >= 6 && i <= 17);
}

BOOST_AUTO_TEST_CASE(symmetric_graphs_with_equal_eigenvalues_converge)
{
  Edges clique, star, path, grid;
  add_clique(clique, 0, 60);
  for (Index i = 1; i < 200; ++i) star.push_back({0, i, 1.});
  for (Index i = 1; i < 1500; ++i) path.push_back({i - 1, i, 1.});
  for (Index i = 0; i < 900; ++i)
  {
    if (i % 30 < 29) grid.push_back({i, i + 1, 1.});
    if (i < 870) grid.push_back({i, i + 30, 1.});
  }
  const std::vector<std::pair<std::size_t, Edges>> graphs = {
      {60, clique}, {200, star}, {1500, path}, {900, grid}};
  for (const auto& [size, edges] : graphs)
    for (const std::size_t count : {2u, 10u, 40u})
      for (const Parameters& parameters : {Parameters(), Parameters::paper()})
      {
        const std::vector<Index> clusters = spectral_clusters(size, edges, count, parameters, 1);
        BOOST_REQUIRE_EQUAL(clusters.size(), size);
        BOOST_CHECK_LT(*std::max_element(clusters.begin(), clusters.end()), count);
        const std::set<Index> used(clusters.begin(), clusters.end());
        BOOST_CHECK_GT(used.size(), count / 2);
      }
}

BOOST_AUTO_TEST_CASE(as_many_clusters_as_nodes_need_no_eigenvectors)
{
  BOOST_CHECK(
      (spectral_clusters(3, {{0, 1, 1.}, {1, 2, 1.}}, 5, {}, 0) == std::vector<Index>{0, 1, 2}));
  BOOST_CHECK((spectral_clusters(4, {{0, 1, 1.}, {2, 3, 1.}, {1, 2, 1.}}, 1, {}, 0) ==
               std::vector<Index>(4, 0)));
}

BOOST_AUTO_TEST_CASE(cells_about_distant_nodes_cover_the_graph_and_are_connected)
{
  constexpr Index side = 30;
  Edges edges;
  for (Index i = 0; i < side * side; ++i)
  {
    if (i % side < side - 1) edges.push_back({i, i + 1, 1.});
    if (i < side * (side - 1)) edges.push_back({i, i + side, 1.});
  }
  const auto clusters = Voronoi_patch_clustering()({side * side, edges}, 12);
  std::vector<std::pair<Index, Index>> pairs;
  for (const auto& e : edges) pairs.push_back({e.first, e.second});
  const Neighbor_graph graph = flat_graph(side * side, pairs);
  for (unsigned int seed = 0; seed < 3; ++seed)
  {
    const std::vector<Index> cluster = clusters(seed);
    BOOST_REQUIRE_EQUAL(cluster.size(), side * side);
    BOOST_CHECK(cluster == clusters(seed));
    BOOST_CHECK_EQUAL(std::set<Index>(cluster.begin(), cluster.end()).size(), 12u);
    const Pieces pieces = connected_pieces(graph, cluster);
    BOOST_CHECK_EQUAL(pieces.sizes.size(), 12u);
    for (const std::size_t size : pieces.sizes) BOOST_CHECK_GT(size, side * side / 12 / 4);
  }
  BOOST_CHECK(clusters(0) != clusters(1));
}

BOOST_AUTO_TEST_CASE(a_clustering_that_leaves_nodes_out_is_refused)
{
  const auto lazy = [](const Convexity_graph&, std::size_t)
  { return [](unsigned int) { return std::vector<Index>(3, 0); }; };
  const Shape shape(Shape_generator::make_mesh("figure", 2000));
  BOOST_CHECK_THROW(extract_patch_sets(shape.points, shape.graph, Parameters(), false, lazy),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(disconnected_pieces_are_never_in_one_patch)
{
  Raw_shape raw;
  std::vector<int> labels;
  for (int b = 0; b < 4; ++b)
  {
    add_sphere(raw, {3. * b, 0., 0.}, 1., 300u * (b + 1));
    labels.resize(raw.positions.size(), b);
  }
  const Shape shape(raw, labels);
  Parameters parameters;
  for (const std::size_t wanted : {1u, 12u, 80u})
  {
    parameters.number_of_patches = wanted;
    const Patches patches = one_patch_set(shape.points, shape.graph, parameters);
    check_partition(shape, patches);
    BOOST_CHECK_EQUAL(crossing_share(patches, shape.truth), 0.);
    BOOST_CHECK_GE(patches.size(), 4u);
    BOOST_CHECK_LE(patches.size(), 2 * wanted + 4);
  }
}

BOOST_AUTO_TEST_CASE(supervoxels_are_connected_and_as_many_as_wanted)
{
  const Shape shape(Shape_generator::make_mesh("figure", 6000));
  for (const std::size_t wanted : {1u, 50u, 800u})
  {
    const Supervoxels cells = build_supervoxels(shape.points, shape.graph, wanted, 5.);
    BOOST_CHECK_EQUAL(cells.count, wanted);
    BOOST_REQUIRE_EQUAL(cells.of_point.size(), shape.points.size());
    const std::set<Index> used(cells.of_point.begin(), cells.of_point.end());
    BOOST_CHECK_EQUAL(used.size(), cells.count);
    BOOST_CHECK_EQUAL(*used.rbegin() + 1u, cells.count);
    BOOST_CHECK_EQUAL(connected_pieces(shape.graph, cells.of_point).sizes.size(), cells.count);
  }
  // a cell a point, and never more
  const Supervoxels own = build_supervoxels(shape.points, shape.graph, 20000, 5.);
  BOOST_CHECK_EQUAL(own.count, shape.points.size());
}

BOOST_AUTO_TEST_CASE(supervoxels_are_spread_evenly)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 5000);
  const Shape shape(raw);
  const Supervoxels cells = build_supervoxels(shape.points, shape.graph, 100, 5.);
  std::vector<std::size_t> sizes(cells.count, 0);
  for (const Index c : cells.of_point) ++sizes[c];
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  BOOST_CHECK_GE(*least, 15u); // 50 on average
  BOOST_CHECK_LE(*most, 150u);
}

BOOST_AUTO_TEST_CASE(small_pieces_go_to_a_neighbor)
{
  // a chain: 2 points, 1 point, 7 points, and 3 points apart
  const std::vector<std::pair<Index, Index>> edges = {{0, 1}, {0, 2}, {1, 2},   {2, 3},
                                                      {3, 4}, {4, 5}, {5, 6},   {6, 7},
                                                      {7, 8}, {8, 9}, {10, 11}, {11, 12}};
  const Neighbor_graph graph = flat_graph(13, edges);
  const Pieces pieces = connected_pieces(graph, {0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3});
  BOOST_CHECK((pieces.sizes == std::vector<std::size_t>{2, 1, 7, 3}));
  // the single point joins the two; three are still too few and go on to the seven
  BOOST_CHECK((absorb_small_pieces(graph, pieces, 5) ==
               std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}));
  BOOST_CHECK((absorb_small_pieces(graph, pieces, 2) ==
               std::vector<int>{0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2}));
  BOOST_CHECK(absorb_small_pieces(graph, pieces, 0) == pieces.of_point);
}

BOOST_AUTO_TEST_CASE(patches_keep_off_concave_borders)
{
  for (const std::string name : {"two_spheres", "l_shape", "dumbbell", "table"})
  {
    const Shape shape(Shape_generator::make_mesh(name, 6000));
    for (const bool paper : {false, true})
    {
      const Parameters parameters = paper ? Parameters::paper() : Parameters();
      const Patches patches = one_patch_set(shape.points, shape.graph, parameters);
      check_partition(shape, patches);
      // the L's true border cuts straight through its flat faces: only the inner edge is concave
      const double most = name == "l_shape" ? 0.06 : 0.02;
      BOOST_CHECK_LT(crossing_share(patches, shape.truth), most);
      if (name != "l_shape" && name != "table") continue;
      // hardly a neighbor edge within a patch bends over a sharp concave edge
      std::size_t sharp = 0, inside = 0;
      for (Index i = 0; i < shape.graph.size(); ++i)
        for (const Neighbor& edge : shape.graph[i])
          if (edge.concavity > radians(60.))
          {
            ++sharp;
            inside += patches.of_point[i] == patches.of_point[edge.point] ? 1 : 0;
          }
      BOOST_CHECK_GT(sharp, 50u);
      BOOST_CHECK_LT(static_cast<double>(inside), 0.15 * static_cast<double>(sharp));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_number_of_patches_follows_the_parameter_whatever_the_seed)
{
  const Shape shape(Shape_generator::make_mesh("four_leg", 6000));
  Parameters parameters;
  for (const std::size_t wanted : {20u, 80u, 200u})
    for (const unsigned int seed : {0u, 7u})
    {
      parameters.number_of_patches = wanted;
      parameters.seed = seed;
      const Patches patches = one_patch_set(shape.points, shape.graph, parameters);
      check_partition(shape, patches);
      BOOST_CHECK_GE(patches.size(), 2 * wanted / 3);
      BOOST_CHECK_LE(patches.size(), 3 * wanted / 2);
      for (const auto& members : patches.members)
        BOOST_REQUIRE_GE(members.size(), minimum_patch_size);
      BOOST_CHECK(patches.of_point ==
                  one_patch_set(shape.points, shape.graph, parameters).of_point);
    }
}

BOOST_AUTO_TEST_CASE(thousands_of_pieces_are_all_patches)
{
  Raw_shape raw;
  for (int i = 0; i < 2000; ++i)
    add_sphere(raw, {1. * (i % 13), 1. * (i / 13 % 13), 1. * (i / 169)}, 0.01, 12);
  const Shape shape(raw);
  const std::size_t pieces =
      number_of_pieces(shape.graph, std::vector<int>(raw.positions.size(), 0));
  BOOST_REQUIRE_EQUAL(pieces, 2000u);
  const Patches patches = one_patch_set(shape.points, shape.graph, Parameters());
  check_partition(shape, patches);
  BOOST_CHECK_EQUAL(patches.size(), pieces);
}

BOOST_AUTO_TEST_SUITE_END()
