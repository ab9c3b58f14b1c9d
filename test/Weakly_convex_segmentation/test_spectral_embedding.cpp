// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/Patch_clustering.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

// The lowest eigenvectors of a graph's Laplacian, on graphs whose eigenvectors are known.

BOOST_AUTO_TEST_SUITE(test_spectral_embedding)

namespace {

using CGAL::Weakly_convex_segmentation::Convexity_graph;
using CGAL::Weakly_convex_segmentation::Spectral_patch_clustering;
using namespace CGAL::Weakly_convex_segmentation::internal;

const double pi = std::acos(-1.);

/// a torus of squares: its eigenvectors are waves, and all but one have several of the same length
Convexity_graph torus(const Index columns, const Index rows)
{
  Convexity_graph graph;
  graph.number_of_nodes = columns * rows;
  for (Index y = 0; y < rows; ++y)
    for (Index x = 0; x < columns; ++x)
    {
      graph.edges.push_back({y * columns + x, y * columns + (x + 1) % columns, 1.});
      graph.edges.push_back({y * columns + x, (y + 1) % rows * columns + x, 1.});
    }
  return graph;
}

/// a ring of cliques of ten that hardly hang together: as many eigenvalues as cliques are nearly 1
Convexity_graph ring_of_cliques(const Index count, const double weight)
{
  Convexity_graph graph;
  graph.number_of_nodes = 10 * count;
  for (Index c = 0; c < count; ++c)
  {
    for (Index i = 0; i < 10; ++i)
      for (Index j = 0; j < i; ++j) graph.edges.push_back({10 * c + j, 10 * c + i, 1.});
    graph.edges.push_back({10 * c + 9, 10 * ((c + 1) % count), weight});
  }
  return graph;
}

/// the share of a vector that lies in the space of orthonormal columns
double share_in_space(const Eigen::MatrixXf& columns, const Eigen::VectorXf& vector)
{
  return (columns.transpose() * vector).squaredNorm() / vector.squaredNorm();
}

} // namespace

BOOST_AUTO_TEST_CASE(a_normalized_adjacency_has_the_eigenvalue_one_for_the_degrees)
{
  Convexity_graph path;
  path.number_of_nodes = 3;
  path.edges = {{0, 1, 4.}, {2, 1, 1.}};
  const Eigen::MatrixXf matrix = Eigen::MatrixXf(normalized_adjacency(path));
  BOOST_CHECK_CLOSE(matrix(0, 1), 4.f / std::sqrt(20.f), 1e-3);
  BOOST_CHECK_CLOSE(matrix(1, 2), 1.f / std::sqrt(5.f), 1e-3);
  BOOST_CHECK(matrix == matrix.transpose());
  const Eigen::Vector3f roots(2.f, std::sqrt(5.f), 1.f);
  BOOST_CHECK_SMALL((matrix * roots - roots).norm(), 1e-5f);
}

BOOST_AUTO_TEST_CASE(the_longest_waves_lie_in_the_space)
{
  constexpr Index columns = 24, rows = 20;
  const Graph_matrix adjacency = normalized_adjacency(torus(columns, rows));
  const Eigen::MatrixXf vectors = lanczos_eigenvectors(adjacency, 20, 50).vectors;
  BOOST_REQUIRE_EQUAL(vectors.cols(), 20);
  BOOST_CHECK_SMALL(
      (vectors.transpose() * vectors - Eigen::MatrixXf::Identity(20, 20)).cwiseAbs().maxCoeff(),
      1e-3f);
  const Eigen::MatrixXf products = adjacency * vectors;
  for (Eigen::Index k = 0; k < vectors.cols(); ++k)
  {
    const float value = vectors.col(k).dot(products.col(k));
    BOOST_CHECK_GT(value, 0.8f); // that of the twentieth is 0.88
    BOOST_CHECK_SMALL((products.col(k) - value * vectors.col(k)).norm(), 1e-2f);
  }
  for (const double phase : {0., 0.5 * pi})
    for (const bool is_along : {false, true})
    {
      Eigen::VectorXf wave(columns * rows);
      for (Index i = 0; i < columns * rows; ++i)
      {
        const double turn = is_along ? static_cast<double>(i % columns) / columns
                                     : static_cast<double>(i / columns) / rows;
        wave[static_cast<Eigen::Index>(i)] = static_cast<float>(std::cos(2. * pi * turn + phase));
      }
      BOOST_CHECK_GT(share_in_space(vectors, wave), 0.999);
    }
}

BOOST_AUTO_TEST_CASE(rows_have_unit_length_for_graphs_of_any_size)
{
  for (const Index columns : {3u, 4u, 7u, 30u})
    for (const std::size_t dimensions : {1u, 5u, 24u})
    {
      const Graph_matrix adjacency = normalized_adjacency(torus(columns, 4));
      const Embedding rows = spectral_embedding(adjacency, dimensions);
      BOOST_REQUIRE_EQUAL(rows.rows(), adjacency.rows());
      BOOST_CHECK_LE(rows.cols(), adjacency.rows());
      BOOST_CHECK_GE(rows.cols(), 1);
      BOOST_CHECK_SMALL((rows.rowwise().norm().array() - 1.f).abs().maxCoeff(), 1e-4f);
      BOOST_CHECK(rows == spectral_embedding(adjacency, dimensions));
    }
}

BOOST_AUTO_TEST_CASE(nearly_separate_pieces_are_found_though_their_eigenvalues_are_equal)
{
  for (const double weight : {1e-2, 1e-6})
    for (const Index cliques : {12u, 60u})
    {
      const Convexity_graph graph = ring_of_cliques(cliques, weight);
      const auto clusters = Spectral_patch_clustering(1.)(graph, cliques);
      const std::vector<Index> cluster = clusters(7);
      std::map<Index, std::set<Index>> cliques_of_cluster;
      for (Index i = 0; i < cluster.size(); ++i) cliques_of_cluster[cluster[i]].insert(i / 10);
      BOOST_CHECK_EQUAL(cliques_of_cluster.size(), cliques);
      for (const auto& entry : cliques_of_cluster) BOOST_CHECK_EQUAL(entry.second.size(), 1u);
    }
}

BOOST_AUTO_TEST_CASE(what_does_not_converge_is_left_out)
{
  // in a space of hardly more dimensions than are wanted, the solver runs out of restarts
  const Graph_matrix adjacency = normalized_adjacency(torus(60, 50));
  const Eigen::MatrixXf vectors = lanczos_eigenvectors(adjacency, 100, 101).vectors;
  BOOST_REQUIRE_LT(vectors.cols(), 100);
  BOOST_CHECK(vectors.allFinite());
  // without any coordinates nodes stay where they are
  const Cost_graph lengths = edge_lengths(adjacency);
  std::vector<Index> cluster = spread_cells(lengths, 9, 0), before = cluster;
  move_to_nearest_means(lengths, Embedding(adjacency.rows(), 0), 9, cluster);
  BOOST_CHECK(cluster == before);
}

BOOST_AUTO_TEST_SUITE_END()
