// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/borders/straighten_borders.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>

#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

// The borders of meshes are straight paths of edges, in the creases near them.

BOOST_AUTO_TEST_SUITE(test_straight_borders)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

Border_parameters band_of(const double width)
{
  Border_parameters parameters;
  parameters.band_width = width;
  return parameters;
}

/// a grid of squares in two triangles each, folded up by an angle at x = n / 2
struct Folded_grid
{
  int n;
  Raw_shape raw;
  Folded_grid(const int size, const double fold) : n(size)
  {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
      {
        const auto at = [&](const int x, const int y) -> Coordinates
        {
          const double over = (std::max)(0., x - n / 2.), up = over * std::sin(fold);
          return {x - over + over * std::cos(fold), double(y), up};
        };
        add_polygon({at(i, j), at(i + 1, j), at(i + 1, j + 1)}, raw);
        add_polygon({at(i, j), at(i + 1, j + 1), at(i, j + 1)}, raw);
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
      {
        raw.links.push_back({face(i, j, 0), face(i, j, 1)});
        if (i + 1 < n) raw.links.push_back({face(i, j, 0), face(i + 1, j, 1)});
        if (j + 1 < n) raw.links.push_back({face(i, j, 1), face(i, j + 1, 0)});
      }
  }
  Index face(const int i, const int j, const int half) const
  {
    return static_cast<Index>(2 * (i * n + j) + half);
  }
  Mesh_faces faces() const { return {raw.first_corner, raw.corners, raw.links}; }
  void straighten(std::vector<int>& labels, const double band = 0.1) const
  {
    straighten_borders(faces(), orient_points(raw), band_of(band), Run_control(), labels);
  }
  /// labels by whether the center is beyond a line x = `place`, with steps of one square
  std::vector<int> jagged(const double place) const
  {
    std::vector<int> labels;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int half = 0; half < 2; ++half)
          labels.push_back(i + (j % 3 == 0 ? 1 : 0) - (j % 5 == half ? 1 : 0) >= place ? 1 : 0);
    return labels;
  }
  /// length of the border in the grid, by the length of the edges unfolded
  double length(const std::vector<int>& labels) const
  {
    double sum = 0.;
    for (const auto& [f, g] : raw.links)
      if (labels[f] != labels[g]) sum += f / 2 == g / 2 ? std::sqrt(2.) : 1.;
    return sum;
  }
};

BOOST_AUTO_TEST_CASE(jagged_borders_of_meshes_become_straight)
{
  const Folded_grid grid(20, 0.);
  std::vector<int> labels = grid.jagged(7.);
  BOOST_REQUIRE_GT(grid.length(labels), 35.);
  grid.straighten(labels);
  BOOST_CHECK_CLOSE(grid.length(labels), 20., 1e-6);
}

BOOST_AUTO_TEST_CASE(borders_of_meshes_go_to_the_crease_near_them)
{
  const Folded_grid grid(20, 1.);
  std::vector<int> labels = grid.jagged(11.);
  grid.straighten(labels, 0.3);
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      for (int half = 0; half < 2; ++half)
        BOOST_REQUIRE_EQUAL(labels[grid.face(i, j, half)], i >= 10 ? 1 : 0);
}

BOOST_AUTO_TEST_CASE(no_label_vanishes_and_faces_far_from_borders_stay)
{
  const Folded_grid grid(20, 0.);
  std::vector<int> labels = grid.jagged(7.);
  const std::vector<int> before = labels;
  labels[grid.face(15, 15, 0)] = 2;
  labels[grid.face(3, 3, 1)] = labels[grid.face(3, 3, 0)] = 3;
  grid.straighten(labels, 1.);
  BOOST_CHECK(std::set<int>(labels.begin(), labels.end()) == std::set<int>({0, 1, 2, 3}));
  for (int i = 12; i < 20; ++i)
    for (int j = 0; j < 10; ++j) BOOST_REQUIRE_EQUAL(labels[grid.face(i, j, 0)], 1);
  std::vector<int> one(before.size(), 0);
  grid.straighten(one);
  BOOST_CHECK(one == std::vector<int>(before.size(), 0));
}

BOOST_AUTO_TEST_CASE(the_order_of_the_faces_is_nothing_to_straight_borders)
{
  Folded_grid grid(16, 0.4);
  std::vector<int> labels = grid.jagged(9.), shuffled_labels(labels.size());
  std::vector<Index> place(labels.size());
  for (std::size_t f = 0; f < place.size(); ++f) place[f] = static_cast<Index>(f);
  std::shuffle(place.begin(), place.end(), std::mt19937(3));
  Folded_grid shuffled = grid;
  for (std::size_t f = 0; f < place.size(); ++f)
  {
    shuffled.raw.positions[place[f]] = grid.raw.positions[f];
    shuffled.raw.normals[place[f]] = grid.raw.normals[f];
    for (int c = 0; c < 3; ++c)
      shuffled.raw.corners[3 * place[f] + c] = grid.raw.corners[3 * f + c];
    shuffled_labels[place[f]] = labels[f];
  }
  for (auto& link : shuffled.raw.links) link = {place[link[1]], place[link[0]]};
  std::reverse(shuffled.raw.links.begin(), shuffled.raw.links.end());
  grid.straighten(labels);
  shuffled.straighten(shuffled_labels);
  for (std::size_t f = 0; f < place.size(); ++f)
    BOOST_REQUIRE_EQUAL(shuffled_labels[place[f]], labels[f]);
}

BOOST_AUTO_TEST_CASE(faces_of_more_corners_and_edges_of_more_faces_are_no_trouble)
{
  Raw_shape
      raw; // a row of squares with a fin along each of their common edges, and a face of no area
  for (int i = 0; i < 6; ++i)
  {
    const double x = i;
    add_polygon({{x, 0., 0.}, {x + 1., 0., 0.}, {x + 1., 1., 0.}, {x, 1., 0.}}, raw);
    add_polygon({{x, 0., 0.}, {x, 1., 0.}, {x, 1., 1.}, {x, 0., 1.}}, raw);
  }
  add_polygon({{0., 0., 0.}, {0., 0., 0.}, {1., 0., 0.}}, raw);
  for (Index i = 0; i < 6; ++i)
  {
    raw.links.push_back({2 * i, 2 * i + 1});
    if (i > 0) raw.links.push_back({2 * i - 2, 2 * i}), raw.links.push_back({2 * i - 2, 2 * i + 1});
  }
  raw.links.push_back({0, 12});
  std::vector<int> labels = {0, 1, 0, 0, 1, 0, 1, 1, 0, 1, 1, 1, 0};
  const Mesh_faces faces = {raw.first_corner, raw.corners, raw.links};
  straighten_borders(faces, orient_points(raw), band_of(0.1), Run_control(), labels);
  BOOST_CHECK(std::set<int>(labels.begin(), labels.end()) == std::set<int>({0, 1}));
}

} // namespace

BOOST_AUTO_TEST_SUITE_END()
