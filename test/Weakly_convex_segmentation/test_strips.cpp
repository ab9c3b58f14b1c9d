// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/borders/absorb_strips.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include "shapes_for_tests.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

// What is left over between segments, told by its outline.

BOOST_AUTO_TEST_SUITE(test_strips)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

constexpr double pi = 3.14159265358979323846;

/// How points are spread: as representatives are, or with gaps and clumps.
enum class Spread
{
  EVEN,
  RANDOM
};

/// Points of a square, whose side is 1 long.
struct Square
{
  Raw_shape raw;
  Oriented_points points;
  Neighbor_graph graph;

  explicit Square(const Spread spread = Spread::EVEN)
  {
    constexpr int side = 63; // points
    std::mt19937 random(1);
    const auto any = [&] { return static_cast<double>(random()) / 4294967296.; };
    const auto coordinate = [&](const int cell)
    { return spread == Spread::RANDOM ? any() : (cell + 0.2 + 0.6 * any()) / side; };
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
      {
        const double x = coordinate(i);
        raw.positions.push_back({x, coordinate(j), 0.});
        raw.normals.push_back({0., 0., 1.});
      }
    points = orient_points(raw);
    graph = build_neighbor_graph(points, 10, false);
  }
  /// labels of the points from a function of x and y
  template <typename Label>
  std::vector<int> labels(const Label& label) const
  {
    std::vector<int> result;
    for (const Index e : points.elements)
      result.push_back(label(raw.positions[e][0], raw.positions[e][1]));
    return result;
  }
  std::vector<int> after_absorbing(std::vector<int> labels,
                                   const std::map<int, int>& images = {}) const
  {
    absorb_strips(graph, labels, images);
    return labels;
  }
};

std::vector<Index> points_of(const std::vector<int>& labels, const int label)
{
  std::vector<Index> points;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == label) points.push_back(static_cast<Index>(i));
  return points;
}

bool is_within(const double x, const double low, const double high) { return low < x && x < high; }

/// two halves, 0 and 1, and between them 2, as wide as twice `half_width`
auto strip_between_halves(const double half_width)
{
  return [half_width](const double x, const double y)
  {
    if (std::abs(x - 0.5) < half_width && is_within(y, 0.2, 0.8)) return 2;
    return x < 0.5 ? 0 : 1;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(an_outline_has_the_length_and_area_of_what_it_is_about)
{
  const Square square(Spread::RANDOM);
  const std::vector<int> labels = square.labels(
      [](const double x, const double y) { return std::hypot(x - 0.5, y - 0.5) < 0.3 ? 1 : 0; });
  const Outline outline = outline_of(square.graph, labels, points_of(labels, 1));
  // the diagonal is the method's unit
  BOOST_TEST(2. * outline.area == 0.09 * pi, boost::test_tools::tolerance(0.1));
  BOOST_TEST(std::sqrt(2.) * outline.length == 0.6 * pi, boost::test_tools::tolerance(0.1));
  BOOST_TEST(outline.crease_length == 0.);
  BOOST_REQUIRE(outline.with.size() == 1U);
  BOOST_TEST(outline.with.at(0).length == outline.length, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_strip_goes_to_its_neighbor)
{
  const Square square;
  const std::vector<int> before = square.labels(strip_between_halves(0.05));
  const std::vector<int> after = square.after_absorbing(before);
  BOOST_TEST(points_of(after, 2).empty());
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i] != 2) BOOST_REQUIRE(after[i] == before[i]);
}

BOOST_AUTO_TEST_CASE(the_mirror_image_of_a_strip_goes_with_it)
{
  const Square square;
  const std::vector<int> labels = square.labels(
      [](const double x, const double y)
      {
        if (is_within(x, 0.05, 0.45) && std::abs(y - 0.5) < 0.05) return 2;
        if (std::hypot(x - 0.75, y - 0.5) < 0.12) return 5; // about as much, but no strip
        return (y < 0.5 ? 0 : 1) + (x < 0.5 ? 0 : 3);
      });
  const std::vector<int> alone = square.after_absorbing(labels);
  BOOST_TEST(points_of(alone, 2).empty());
  BOOST_TEST(!points_of(alone, 5).empty());
  const std::vector<int> together =
      square.after_absorbing(labels, {{0, 3}, {1, 4}, {2, 5}, {3, 0}, {4, 1}, {5, 2}});
  BOOST_TEST(points_of(together, 2).empty());
  BOOST_TEST(points_of(together, 5).empty());
  BOOST_TEST((points_of(together, 0) == points_of(labels, 0)) ==
             (points_of(together, 3) == points_of(labels, 3))); // both above, or both below
}

BOOST_AUTO_TEST_CASE(a_strip_across_the_plane_stays_unless_it_is_a_sliver)
{
  const Square square;
  const std::map<int, int> images = {{0, 1}, {1, 0}, {2, 2}};
  const std::vector<int> wide = square.labels(strip_between_halves(0.05)),
                         narrow = square.labels(strip_between_halves(0.02));
  BOOST_TEST(square.after_absorbing(wide, images) == wide, boost::test_tools::per_element());
  BOOST_TEST(points_of(square.after_absorbing(narrow, images), 2).empty());
}

BOOST_AUTO_TEST_CASE(what_is_as_wide_as_long_stays)
{
  const Square square;
  const std::vector<int> labels = square.labels(
      [](const double x, const double y) {
        return std::hypot(x - 0.5, y - 0.5) < 0.2 ? 2 : x < 0.5 ? 0 : 1;
      });
  BOOST_TEST(square.after_absorbing(labels) == labels, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_strip_within_one_segment_stays)
{
  const Square square;
  const std::vector<int> labels = square.labels(
      [](const double x, const double y) {
        return is_within(x, 0.2, 0.3) && is_within(y, 0.2, 0.8) ? 2 : x < 0.5 ? 0 : 1;
      });
  BOOST_TEST(square.after_absorbing(labels) == labels, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_strip_that_is_not_much_smaller_than_its_neighbors_stays)
{
  const Square square;
  const auto label = [](const double x, const double y)
  {
    if (!is_within(y, 0.2, 0.8)) return 3;
    if (std::abs(x - 0.5) < 0.1) return 2;
    return is_within(x, 0.25, 0.5) ? 0 : is_within(x, 0.5, 0.75) ? 1 : 3;
  };
  const std::vector<int> labels = square.labels(label);
  BOOST_TEST(is_strip(outline_of(square.graph, labels, points_of(labels, 2))));
  BOOST_TEST(points_of(square.after_absorbing(labels), 2).size() == points_of(labels, 2).size());
}

BOOST_AUTO_TEST_CASE(what_is_all_border_goes_to_a_neighbor)
{
  // from one edge of the square to the other, so that its outline is two lines, like that of a ring
  const Square square;
  const auto across = [&](const double half_width)
  {
    return square.labels([&](const double x, double)
                         { return std::abs(x - 0.5) < half_width ? 2
                                  : x < 0.5                      ? 0
                                                                 : 1; });
  };
  const std::vector<int> thin = across(0.011), wide = across(0.05);
  BOOST_REQUIRE(!points_of(thin, 2).empty());
  BOOST_TEST(points_of(square.after_absorbing(thin), 2).empty());
  BOOST_TEST(square.after_absorbing(wide) == wide);
}

BOOST_AUTO_TEST_CASE(lines_that_come_near_each_other_are_two)
{
  const Square square;
  // a body a few points wide, from one side of the square to the other
  const std::vector<int> labels = square.labels(
      [](const double x, double) { return std::abs(x - 0.5) < 0.05 ? 2
                                          : x < 0.5                ? 0
                                                                   : 1; });
  BOOST_TEST(Border_loops(square.graph, labels, points_of(labels, 2)).count() == 2U);
  const std::vector<int> closed = square.labels(strip_between_halves(0.05));
  BOOST_TEST(Border_loops(square.graph, closed, points_of(closed, 2)).count() == 1U);
}

BOOST_AUTO_TEST_CASE(what_lies_between_creases_is_no_strip)
{
  Outline outline;
  outline.area = 1.;
  outline.length = 10.;
  outline.with = {{0, {5., 5.}}, {1, {5., 5.}}};
  BOOST_TEST(is_strip(outline));
  outline.crease_length = 5.;
  BOOST_TEST(!is_strip(outline));
}

BOOST_AUTO_TEST_SUITE_END()
