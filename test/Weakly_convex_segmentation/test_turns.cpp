// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

// Turns that take a shape to itself, and that what comes several times is treated alike.

BOOST_AUTO_TEST_SUITE(test_turns)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;
using Labels = std::vector<int>;

constexpr double tolerance = 0.008, whole_turn = 2. * 3.14159265358979323846;

struct Found
{
  Oriented_points points;
  Neighbor_graph graph;
  Turn turn;

  explicit Found(const Raw_shape& raw)
    : points(orient_points(raw, false, {}, true)), graph(build_neighbor_graph(points, 10, false)),
      turn(find_turn(Motion_judge(points, graph.spacing), tolerance, false))
  {}
};

/// how far from the axis the outside of a thing is, at an angle
using Outline_of_thing = std::function<double(double)>;

/// A thing with a bore of radius 0.55 about an oblique axis, 1.2 high.
Shape_generator::Labeled_mesh bored(const Outline_of_thing& outline)
{
  constexpr int around = 240, up = 8, inwards = 4, loop = 2 * (up + inwards);
  constexpr double height = 1.2, bore = 0.55;
  Shape_generator::Labeled_mesh mesh;
  for (int a = 0; a < around; ++a)
    for (int j = 0; j < loop; ++j)
    {
      const double angle = whole_turn * a / around;
      const auto share = [&](const int from, const int count)
      { return std::clamp(static_cast<double>(j - from) / count, 0., 1.); };
      const double z = height * (share(0, up) - share(up + inwards, up));
      const double in = share(up, inwards) - share(2 * up + inwards, inwards);
      const double radius = (1. - in) * outline(angle) + in * bore;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      mesh.points.push_back({x, 0.8 * y - 0.6 * z + 3., 0.6 * y + 0.8 * z});
    }
  for (int a = 0; a < around; ++a)
    for (int j = 0; j < loop; ++j)
    {
      const auto corner = [&](const int b, const int k)
      { return static_cast<std::size_t>(b % around * loop + k % loop); };
      const auto p = corner(a, j), q = corner(a + 1, j), r = corner(a + 1, j + 1),
                 s = corner(a, j + 1);
      mesh.faces.push_back({p, q, r});
      mesh.faces.push_back({p, r, s});
    }
  return mesh;
}

/// the outline of a gear whose teeth rise to 1.25 over slopes, as involutes do
Outline_of_thing gear(const int teeth)
{
  return [teeth](const double angle)
  { return 1. + 0.25 * std::clamp(0.5 + 1.5 * std::cos(teeth * angle), 0., 1.); };
}

/// of each point the tooth that it is on, from 1 on; 0 on the hub
Labels teeth_of(const Found& gear, const Raw_shape& raw, const int teeth)
{
  Labels labels;
  for (const Index element : gear.points.elements)
  {
    const Coordinates& p = raw.positions[element];
    const double y = 0.8 * (p[1] - 3.) + 0.6 * p[2], angle = std::atan2(y, p[0]);
    const int tooth = static_cast<int>(std::lround(angle / whole_turn * teeth)) + teeth;
    labels.push_back(std::hypot(p[0], y) > 1.02 ? 1 + tooth % teeth : 0);
  }
  return labels;
}

std::size_t number_of_parts(const Labels& labels)
{
  return std::set<int>(labels.begin(), labels.end()).size();
}

} // namespace

BOOST_AUTO_TEST_CASE(the_smallest_turn_of_a_shape_is_found)
{
  const auto order = [](const Outline_of_thing& outline)
  { return Found(points_of_mesh(bored(outline))).turn.order; };
  for (const int teeth : {3, 4, 5, 8, 10, 15}) BOOST_CHECK_EQUAL(order(gear(teeth)), teeth);
  BOOST_CHECK_EQUAL(order([](double) { return 1.; }), 16); // a body of revolution has any
  BOOST_CHECK_EQUAL(order([](const double angle) { return 1. + 0.2 * std::cos(2. * angle); }), 1);
  const auto whole = gear(8);
  const auto one_lost = [&](const double angle)
  { return std::abs(angle - whole_turn / 2.) < whole_turn / 16. ? 1. : whole(angle); };
  BOOST_CHECK_EQUAL(order(one_lost), 1);
  // shapes that are near themselves after a small turn
  for (const char* name : {"airplane", "hand", "figure"})
    BOOST_CHECK_EQUAL(Found(points_of_mesh(Shape_generator::make_mesh(name, 4000))).turn.order, 1);
}

BOOST_AUTO_TEST_CASE(points_go_where_the_turn_takes_them)
{
  constexpr int teeth = 5;
  const Raw_shape raw = points_of_mesh(bored(gear(teeth)));
  const Found found(raw);
  BOOST_REQUIRE_EQUAL(found.turn.order, teeth);
  const Labels labels = teeth_of(found, raw, teeth);
  // forwards or backwards, and from tooth to tooth everywhere
  std::set<int> steps;
  for (Index i = 0; i < labels.size(); ++i)
  {
    const int before = labels[i], after = labels[found.turn.image[i]];
    BOOST_REQUIRE_EQUAL(before == 0, after == 0);
    if (before > 0) steps.insert((after - before + teeth) % teeth);
  }
  BOOST_CHECK_EQUAL(steps.size(), 1u);
  BOOST_CHECK(*steps.begin() == 1 || *steps.begin() == teeth - 1);
}

BOOST_AUTO_TEST_CASE(teeth_are_cut_off_where_half_of_them_are)
{
  constexpr int teeth = 8;
  const Raw_shape raw = points_of_mesh(bored(gear(teeth)));
  const Found found(raw);
  const Labels all = teeth_of(found, raw, teeth);
  for (const int cut : {0, 1, 3, 4, 5, 7, 8})
  {
    Labels labels = all;
    for (int& label : labels)
      if (label > cut) label = 0;
    decide_places_alike(found.turn, labels);
    const bool are_cut = 2 * cut >= teeth;
    BOOST_TEST_CONTEXT(cut << " of " << teeth << " teeth are cut off")
    {
      BOOST_CHECK_EQUAL(number_of_parts(labels), are_cut ? teeth + 1u : 1u);
      if (are_cut) BOOST_CHECK_LT(rand_distance(labels, all), 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_most_places_have_is_everywhere)
{
  constexpr int teeth = 8;
  const Raw_shape raw = points_of_mesh(bored(gear(teeth)));
  const Found found(raw);
  const Labels all = teeth_of(found, raw, teeth);
  Labels labels = all; // with some of the hub apart
  for (Index i = 0; i < labels.size(); ++i)
    if (all[i] == 0 && raw.positions[found.points.elements[i]][0] > 0.5) labels[i] = teeth + 1;
  BOOST_CHECK_EQUAL(number_of_parts(labels), teeth + 2u);
  decide_places_alike(found.turn, labels);
  BOOST_CHECK_LT(rand_distance(labels, all), 1e-9);
  // where nothing turns, nothing changes
  Labels half = all;
  for (int& label : half) label = label > 3 ? 0 : label;
  const Labels before = half;
  decide_places_alike(Turn(), half);
  BOOST_CHECK(half == before);
}

BOOST_AUTO_TEST_CASE(all_teeth_of_a_gear_are_segmented_alike)
{
  constexpr int teeth = 10;
  const Raw_shape raw = points_of_mesh(bored(gear(teeth)));
  int uneven = 0; // without turns
  for (const std::uint64_t seed : {0u, 1u, 2u, 3u})
    for (const bool has_turns : {true, false})
    {
      Parameters parameters;
      parameters.seed = seed;
      if (!has_turns) parameters.symmetry_tolerance = 0.;
      const Labels labels = Compiled_core::segment_points(raw, parameters, {}).labels;
      const std::size_t parts = number_of_parts(labels);
      BOOST_TEST_MESSAGE("seed " << seed << (has_turns ? "" : ", no turns") << ": " << parts
                                 << " parts");
      const bool is_even = parts == 1 || parts == teeth + 1u;
      if (has_turns)
        BOOST_CHECK_MESSAGE(is_even, "seed " << seed << ": " << parts << " parts");
      else if (!is_even)
        ++uneven;
    }
  BOOST_CHECK_GT(uneven, 0); // else this tests nothing
}

BOOST_AUTO_TEST_SUITE_END()
