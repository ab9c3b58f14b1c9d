// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE Spectral_embedding
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/spectral_clustering.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

// The low-pass filter of a graph's spectrum, on graphs whose eigenvectors are waves.

namespace {

using namespace CGAL::Weakly_convex_segmentation::internal;

const double pi = std::acos(-1.);

Normalized_graph torus(const Index columns, const Index rows)
{
  std::vector<Weighted_edge> edges;
  for (Index y = 0; y < rows; ++y)
    for (Index x = 0; x < columns; ++x)
    {
      edges.push_back({y * columns + x, y * columns + (x + 1) % columns, 1.});
      edges.push_back({y * columns + x, (y + 1) % rows * columns + x, 1.});
    }
  return Normalized_graph(columns * rows, edges);
}

double product(const Row_matrix& rows, const std::size_t a, const std::size_t b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < rows.rows(); ++i)
    sum += static_cast<double>(rows.at(i, a)) * rows.at(i, b);
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_filter_keeps_long_waves_and_takes_short_ones_away)
{
  constexpr std::size_t n = 60;
  std::vector<Weighted_edge> edges;
  for (Index i = 0; i < n; ++i) edges.push_back({i, static_cast<Index>((i + 1) % n), 1.});
  const Normalized_graph cycle(n, edges);
  const auto coefficients = step_coefficients(0.25 * pi, 36);
  double before = 2.;
  for (std::size_t wave = 0; wave <= n / 2; ++wave)
  {
    Row_matrix rows(n, 1);
    const auto value = [&](const std::size_t i)
    { return std::cos(2. * pi * static_cast<double>(wave * i) / n); };
    for (std::size_t i = 0; i < n; ++i) rows.at(i, 0) = static_cast<float>(value(i));
    const Row_matrix filtered = filter_rows(cycle, coefficients, rows);
    const double kept = filtered.at(0, 0); // of 1
    for (std::size_t i = 0; i < n; ++i)    // a wave is an eigenvector: it stays what it is
      BOOST_REQUIRE_SMALL(filtered.at(i, 0) - kept * value(i), 1e-4);
    BOOST_CHECK_LT(kept, before + 1e-4); // monotone
    if (wave <= 3) BOOST_CHECK_GT(kept, 0.99);
    if (wave >= 13) BOOST_CHECK_LT(kept, 0.01);
    before = kept;
  }
}

BOOST_AUTO_TEST_CASE(columns_become_orthonormal_and_dependent_ones_vanish)
{
  Row_matrix rows(50, 4);
  for (std::size_t i = 0; i < rows.rows(); ++i)
  {
    const double x = static_cast<double>(i);
    const double values[] = {std::sin(x), std::cos(3. * x) + 0.5 * std::sin(x), 2. * std::sin(x),
                             1. + x / 50.};
    for (std::size_t c = 0; c < 4; ++c) rows.at(i, c) = static_cast<float>(values[c]);
  }
  orthonormalize_columns(rows);
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      BOOST_CHECK_SMALL(product(rows, a, b) - (a == b && a != 2 ? 1. : 0.), 1e-4);
}

BOOST_AUTO_TEST_CASE(the_longest_waves_lie_in_the_space_of_the_embedding)
{
  constexpr Index columns = 24, height = 20;
  const Normalized_graph graph = torus(columns, height);
  constexpr std::size_t count = 20;
  const Spread_cells both = spread_cells(graph, count, 2 * count, 0);
  const std::vector<Index>& cells = both.few;
  BOOST_CHECK_EQUAL(std::set<Index>(both.many.begin(), both.many.end()).size(), 2 * count);
  BOOST_CHECK_EQUAL(std::set<Index>(cells.begin(), cells.end()).size(), count);
  Row_matrix rows(graph.size(), count);
  for (std::size_t i = 0; i < graph.size(); ++i) rows.at(i, cells[i]) = 1.f;
  Row_matrix unfiltered = rows;
  orthonormalize_columns(unfiltered);
  rows =
      filter_rows(graph, step_coefficients(std::acos(1. - 2.5 * count / graph.size()), 36), rows);
  orthonormalize_columns(rows);
  const auto share = [&](const Row_matrix& space, const double phase)
  {
    double sum = 0., norm = 0.;
    for (std::size_t c = 0; c < count; ++c)
    {
      double along = 0.;
      norm = 0.;
      for (std::size_t i = 0; i < graph.size(); ++i)
      {
        const double wave = std::cos(2. * pi * static_cast<double>(i % columns) / columns + phase);
        along += wave * space.at(i, c);
        norm += wave * wave;
      }
      sum += along * along;
    }
    return sum / norm;
  };
  for (const double phase : {0., 0.5 * pi})
  {
    BOOST_CHECK_GT(share(rows, phase), 0.97);
    BOOST_CHECK_LT(1. - share(rows, phase), 0.5 * (1. - share(unfiltered, phase)));
  }
  const Row_matrix embedded = spectral_embedding(graph, cells, count, 36);
  for (std::size_t i = 0; i < graph.size(); ++i)
    BOOST_REQUIRE_CLOSE(product_of(embedded.row(i), embedded.row(i), embedded.groups()), 1.f, 1e-2);
}
