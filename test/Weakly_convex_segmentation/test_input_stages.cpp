// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/sort_in_runs.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/downsampling.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// From the caller's points to the neighbor graph (sections 3 and 4).

BOOST_AUTO_TEST_SUITE(test_input_stages)

namespace {

using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

Raw_shape random_points(const std::size_t count, const unsigned int seed)
{
  std::mt19937 random(seed);
  const auto coordinate = [&random] { return 2. * uniform(random) - 1.; };
  Raw_shape raw;
  for (std::size_t i = 0; i < count; ++i)
    add_point(raw, {3. * coordinate(), coordinate(), coordinate()},
              {coordinate(), coordinate(), 1.1});
  return raw;
}

/// positions and normals in input order
std::vector<std::pair<Vector3, Vector3>> in_input_order(const Oriented_points& points)
{
  std::vector<std::pair<Vector3, Vector3>> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result[points.elements[i]] = {points.positions[i], points.normals[i]};
  return result;
}

double largest_difference(const Oriented_points& a, const Oriented_points& b)
{
  const auto first = in_input_order(a), second = in_input_order(b);
  float largest = 0.f;
  for (std::size_t i = 0; i < first.size(); ++i)
    largest = (std::max)({largest, length(first[i].first - second[i].first),
                          length(first[i].second - second[i].second)});
  return static_cast<double>(largest);
}

std::string message_of_refusal(const Raw_shape& raw)
{
  try
  {
    orient_points(raw);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

/// a plate of two sheets, `thickness` apart, with outward normals
Raw_shape thin_plate(const int n, const double thickness)
{
  Raw_shape raw;
  const double step = 1. / n;
  add_rectangle(raw, {0., 0., 0.}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., -1.});
  add_rectangle(raw, {0., 0., thickness}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., 1.});
  return raw;
}

bool has_edge(const Neighbor_graph& graph, const Index i, const Index j)
{
  for (const Neighbor& edge : graph[i])
    if (edge.point == j) return true;
  return false;
}

/// every edge both ways with the same numbers, no loops, rows sorted and without repetition
bool is_well_formed(const Neighbor_graph& graph)
{
  for (Index i = 0; i < graph.size(); ++i)
  {
    const Neighbor* previous = nullptr;
    for (const Neighbor& edge : graph[i])
    {
      if (edge.point == i || edge.point >= graph.size() || !(edge.length >= 0.f)) return false;
      if (previous != nullptr && previous->point >= edge.point) return false;
      previous = &edge;
      bool back = false;
      for (const Neighbor& other : graph[edge.point])
        back = back || (other.point == i && other.length == edge.length &&
                        std::abs(other.concavity - edge.concavity) < 1e-6f);
      if (!back) return false;
    }
  }
  return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(frame_has_the_centroid_at_0_and_extent_1)
{
  const Raw_shape raw = random_points(500, 1);
  const Oriented_points points = orient_points(raw);
  BOOST_REQUIRE_EQUAL(points.size(), 500u);
  Vector3 sum;
  float farthest = 0.f;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sum = sum + points.positions[i];
    farthest = (std::max)(farthest, length(points.positions[i]));
    BOOST_CHECK_SMALL(length(points.normals[i]) - 1.f, 1e-5f);
  }
  BOOST_CHECK_SMALL(length(sum), 1e-3f);
  BOOST_CHECK_CLOSE(farthest, 0.5f, 1e-3);
  // distances are those of the input divided by the extent
  const auto frame = in_input_order(points);
  const Coordinates d = plus(raw.positions[7], raw.positions[3], -1.);
  BOOST_CHECK_CLOSE(static_cast<double>(length(frame[7].first - frame[3].first)) * points.extent,
                    std::hypot(d[0], d[1], d[2]), 1e-3);
  // every element once
  const std::set<Index> elements(points.elements.begin(), points.elements.end());
  BOOST_CHECK_EQUAL(elements.size(), 500u);
  BOOST_CHECK_EQUAL(*elements.rbegin(), 499u);
}

BOOST_AUTO_TEST_CASE(frame_does_not_change_with_place_scale_or_order)
{
  const Raw_shape raw = random_points(400, 2);
  const Oriented_points points = orient_points(raw);
  Raw_shape moved = raw;
  for (auto& p : moved.positions) p = {p[0] + 1000., p[1] - 300., p[2] + 77.};
  BOOST_CHECK_SMALL(largest_difference(points, orient_points(moved)), 1e-6);
  BOOST_CHECK_CLOSE(orient_points(moved).extent, points.extent, 1e-9);
  for (const double factor : {1e-310, 1e-9, 1e9})
  {
    Raw_shape scaled = raw;
    for (auto& p : scaled.positions) p = {factor * p[0], factor * p[1], factor * p[2]};
    for (auto& n : scaled.normals) n = {factor * n[0], factor * n[1], factor * n[2]};
    BOOST_CHECK_SMALL(largest_difference(points, orient_points(scaled)), 1e-6);
    BOOST_CHECK_CLOSE(orient_points(scaled).extent, factor * points.extent, 1e-9);
    BOOST_CHECK(orient_points(scaled).elements == points.elements);
  }
  // points in another order come out in the same order
  Raw_shape reversed = raw;
  std::reverse(reversed.positions.begin(), reversed.positions.end());
  std::reverse(reversed.normals.begin(), reversed.normals.end());
  const Oriented_points again = orient_points(reversed);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    BOOST_REQUIRE_EQUAL(again.elements[i], 399u - points.elements[i]);
    BOOST_REQUIRE_SMALL(length(again.positions[i] - points.positions[i]), 1e-6f);
  }
}

BOOST_AUTO_TEST_CASE(a_frame_along_the_axes_turns_with_the_points)
{
  const Raw_shape raw = random_points(400, 2);
  const Oriented_points points = orient_points(raw, false, {}, true);
  Raw_shape moved = raw;
  for (auto* vectors : {&moved.positions, &moved.normals})
    for (auto& v : *vectors)
      v = {-0.48 * v[0] - 0.64 * v[1] + 0.6 * v[2], 0.8 * v[0] - 0.6 * v[1],
           0.36 * v[0] + 0.48 * v[1] + 0.8 * v[2]};
  for (auto& p : moved.positions) p = plus(p, {5., -7., 2.});
  BOOST_CHECK_SMALL(largest_difference(points, orient_points(moved, false, {}, true)), 1e-6);
  BOOST_CHECK(orient_points(moved, false, {}, true).elements == points.elements);
  BOOST_CHECK_GT(largest_difference(orient_points(raw), orient_points(moved)), 0.1);
  // it is a rotation: distances stay, and so do the volumes that three points span
  const auto frame = in_input_order(points), plain = in_input_order(orient_points(raw));
  const auto volume = [](const std::vector<std::pair<Vector3, Vector3>>& p, const std::size_t i)
  { return dot(cross(p[i].first, p[i + 1].first), p[i + 2].first); };
  for (std::size_t i = 0; i + 2 < frame.size(); ++i)
  {
    BOOST_REQUIRE_SMALL(length(frame[i].first - frame[i + 1].first) -
                            length(plain[i].first - plain[i + 1].first),
                        1e-6f);
    BOOST_REQUIRE_SMALL(volume(frame, i) - volume(plain, i), 1e-6f);
  }
}

BOOST_AUTO_TEST_CASE(a_frame_along_the_axes_is_the_same_in_any_order)
{
  Raw_shape raw = random_points(5000, 12);
  const Frame frame = pca_frame(raw.positions, false);
  std::reverse(raw.positions.begin(), raw.positions.end());
  const Frame again = pca_frame(raw.positions, false);
  for (std::size_t k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) BOOST_CHECK_EQUAL(frame.axes[k][c], again.axes[k][c]);
  // points that span no space have some frame as well
  for (const Coordinates& direction : {Coordinates{0., 0., 0.}, {1., 1., 0.}})
  {
    const Frame flat = pca_frame({{1., 2., 3.}, plus({1., 2., 3.}, direction)}, false);
    for (const Double3& axis : flat.axes) BOOST_CHECK_CLOSE(length(axis), 1., 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(last_digits_do_not_turn_the_frame_of_an_even_shape)
{
  const auto radius_of_vase = [](const double x) { return 0.3 + 0.1 * x; };
  const auto radius_of_barrel = [](const double x) { return 0.4 - 0.1 * x * x; };
  const auto body = [](const auto& radius)
  {
    constexpr double pi = 3.14159265358979323846;
    std::vector<Coordinates> points;
    for (int i = -10; i <= 10; ++i)
      for (int k = 0; k < 12; ++k)
      {
        const double x = 0.1 * i, r = radius(x);
        const double y = r * std::cos(pi * k / 6.), z = r * std::sin(pi * k / 6.);
        points.push_back(
            {-0.48 * x - 0.64 * y + 0.6 * z, 0.8 * x - 0.6 * y, 0.36 * x + 0.48 * y + 0.8 * z});
      }
    return points;
  };
  std::vector<Coordinates> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({1. * (i & 1), 1. * ((i >> 1) & 1), 1. * (i >> 2)});
  std::mt19937 random(7);
  for (const auto& points : {body(radius_of_vase), body(radius_of_barrel), cube})
  {
    const Frame frame = pca_frame(points, false);
    for (int round = 0; round < 8; ++round)
    {
      std::vector<Coordinates> moved = points;
      for (Coordinates& p : moved)
        for (double& c : p) c += 1e-8 * (uniform(random) - 0.5);
      const Frame again = pca_frame(moved, false);
      for (std::size_t k = 0; k < 3; ++k)
      {
        BOOST_CHECK_SMALL(length(again.axes[k] - frame.axes[k]), 1e-6);
        BOOST_CHECK_SMALL(dot(frame.axes[k], frame.axes[(k + 1) % 3]), 1e-12);
      }
      BOOST_CHECK_CLOSE(dot(cross(frame.axes[0], frame.axes[1]), frame.axes[2]), 1., 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(sums_are_the_same_in_any_order)
{
  std::mt19937 random(3);
  std::vector<double> terms(30000);
  for (double& t : terms) t = std::pow(2. * uniform(random) - 1., 9.);
  const auto sum = [&terms]
  {
    return sums_in_any_order<1>(terms.size(), false,
                                [&terms](const std::size_t i)
                                { return std::array<double, 1>{terms[i]}; })[0];
  };
  const double in_order = sum();
  BOOST_CHECK_SMALL(in_order - std::accumulate(terms.begin(), terms.end(), 0.), 1e-9);
  std::sort(terms.begin(), terms.end());
  BOOST_CHECK_EQUAL(sum(), in_order);
  terms.assign(1000, 1.); // the largest that there may be
  BOOST_CHECK_EQUAL(sum(), 1000.);
}

BOOST_AUTO_TEST_CASE(duplicates_stay_and_links_are_renamed)
{
  Raw_shape raw = random_points(50, 3);
  for (std::size_t i = 0; i < 50; ++i) add_point(raw, raw.positions[i], raw.normals[i]);
  raw.links = {{0, 60}, {60, 0}, {5, 5}, {99, 1}};
  const Oriented_points points = orient_points(raw);
  BOOST_CHECK_EQUAL(points.size(), 100u);
  BOOST_REQUIRE_EQUAL(points.links.size(), 2u); // no loop, none twice
  std::set<std::set<Index>> links;
  for (const auto& link : points.links)
    links.insert({points.elements[link[0]], points.elements[link[1]]});
  BOOST_CHECK(links == (std::set<std::set<Index>>{{0, 60}, {1, 99}}));
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_by_name)
{
  BOOST_CHECK(message_of_refusal(random_points(5, 4)).empty());
  BOOST_CHECK(message_of_refusal(Raw_shape()).find("no points") != std::string::npos);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
  {
    Raw_shape raw = random_points(200, 4);
    raw.positions[137][1] = bad;
    BOOST_CHECK(message_of_refusal(raw).find("position of element 137 ") != std::string::npos);
    raw = random_points(200, 4);
    raw.normals[58][2] = bad;
    BOOST_CHECK(message_of_refusal(raw).find("normal of element 58 ") != std::string::npos);
  }
  Raw_shape huge = random_points(20, 4);
  huge.positions[0] = {1.5e308, 0., 0.};
  huge.positions[1] = {-1.5e308, 0., 0.};
  BOOST_CHECK(message_of_refusal(huge).find("overflow") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(few_points_are_their_own_representatives)
{
  const Oriented_points points = orient_points(random_points(300, 5));
  const Representatives all = downsample(points, 300);
  BOOST_CHECK(all.of_point.empty());
  BOOST_CHECK_EQUAL(all.points.size(), 300u);
  BOOST_CHECK(all.points.elements == points.elements);
}

BOOST_AUTO_TEST_CASE(representatives_are_about_as_many_as_wanted_and_near_their_points)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 60000);
  const Oriented_points points = orient_points(raw);
  for (const std::size_t wanted : {1000u, 3000u, 8000u, 20000u})
  {
    const Representatives chosen = downsample(points, wanted);
    BOOST_CHECK_GT(chosen.points.size(), wanted / 2);
    BOOST_CHECK_LT(chosen.points.size(), 2 * wanted);
    BOOST_REQUIRE_EQUAL(chosen.of_point.size(), points.size());
    std::vector<char> used(chosen.points.size(), 0);
    const float near = 4.f / std::sqrt(static_cast<float>(wanted)); // the sphere has radius 0.5
    bool all_near = true, all_facing = true;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Index r = chosen.of_point[i];
      BOOST_REQUIRE_LT(r, chosen.points.size());
      used[r] = 1;
      all_near = all_near && length(chosen.points.positions[r] - points.positions[i]) < near;
      all_facing = all_facing && dot(chosen.points.normals[r], points.normals[i]) > 0.5f;
    }
    BOOST_CHECK(all_near);
    BOOST_CHECK(all_facing);
    BOOST_CHECK_EQUAL(std::count(used.begin(), used.end(), 1),
                      used.size()); // none stands for nobody
  }
}

BOOST_AUTO_TEST_CASE(both_sides_of_a_thin_plate_survive_thinning)
{
  const Oriented_points points = orient_points(thin_plate(150, 1e-4));
  const Representatives chosen = downsample(points, 2000);
  BOOST_CHECK_LT(chosen.points.size(), 6000u);
  std::size_t up = 0;
  for (const Vector3& n : chosen.points.normals)
  {
    BOOST_REQUIRE_SMALL(std::abs(n.z) - 1.f, 1e-5f); // none mixes the sides
    up += n.z > 0.f ? 1 : 0;
  }
  BOOST_CHECK_GT(up, 500u);
  BOOST_CHECK_GT(chosen.points.size() - up, 500u);
  for (std::size_t i = 0; i < points.size(); ++i)
    BOOST_REQUIRE_GT(dot(chosen.points.normals[chosen.of_point[i]], points.normals[i]), 0.9f);
}

BOOST_AUTO_TEST_CASE(points_without_normals_are_thinned_too)
{
  Raw_shape raw = random_points(50000, 6);
  for (auto& n : raw.normals) n = {0., 0., 0.};
  const Representatives chosen = downsample(orient_points(raw), 1000);
  BOOST_CHECK_LT(chosen.points.size(), 3000u);
}

BOOST_AUTO_TEST_CASE(heaps_of_duplicates_and_far_outliers_do_not_collapse)
{
  // 40000 points at 60 places: each place keeps a representative of its own
  const Raw_shape places = random_points(60, 7);
  Raw_shape raw;
  for (std::size_t i = 0; i < 40000; ++i)
    add_point(raw, places.positions[i % 60], places.normals[i % 60]);
  const Oriented_points points = orient_points(raw);
  const Representatives chosen = downsample(points, 5000);
  float farthest = 0.f;
  for (std::size_t i = 0; i < points.size(); ++i)
    farthest = (std::max)(
        farthest, length(chosen.points.positions[chosen.of_point[i]] - points.positions[i]));
  BOOST_CHECK_GE(chosen.points.size(), 60u);
  BOOST_CHECK_LT(farthest, 1e-4f);

  // an outlier a million times as far away stays on its own
  Raw_shape ball;
  add_sphere(ball, {0., 0., 0.}, 1., 30000);
  add_point(ball, {1e6, 0., 0.}, {1., 0., 0.});
  const Oriented_points with_outlier = orient_points(ball);
  const Representatives of_ball = downsample(with_outlier, 5000);
  for (std::size_t i = 0; i < with_outlier.size(); ++i)
    BOOST_REQUIRE_LT(
        length(of_ball.points.positions[of_ball.of_point[i]] - with_outlier.positions[i]), 1e-4f);
}

BOOST_AUTO_TEST_CASE(neighbors_are_the_k_nearest)
{
  constexpr std::size_t n = 600, k = 10;
  Oriented_points points = orient_points(random_points(n, 8));
  const Neighbor_graph graph = build_neighbor_graph(points, k, false);
  BOOST_REQUIRE_EQUAL(graph.size(), n);
  BOOST_CHECK(is_well_formed(graph));
  std::set<std::pair<Index, Index>> expected;
  for (Index i = 0; i < n; ++i)
  {
    std::vector<std::pair<float, Index>> by_distance;
    for (Index j = 0; j < n; ++j)
      if (j != i) by_distance.push_back({length(points.positions[j] - points.positions[i]), j});
    std::sort(by_distance.begin(), by_distance.end());
    float sum = 0.f;
    for (std::size_t j = 0; j < k; ++j)
    {
      expected.insert({i, by_distance[j].second});
      expected.insert({by_distance[j].second, i});
      sum += by_distance[j].first;
    }
    BOOST_CHECK_CLOSE(graph.spacing[i], sum / k, 1e-2);
  }
  BOOST_CHECK_EQUAL(graph.entries.size(), expected.size());
  for (const auto& [i, j] : expected) BOOST_REQUIRE(has_edge(graph, i, j));
}

BOOST_AUTO_TEST_CASE(the_inner_edge_of_an_l_is_concave_and_its_outer_edge_convex)
{
  Raw_shape raw = concave_corner(12, 0.05);
  for (const double side : {1., -1.}) // the same surface seen from the other side
  {
    for (auto& n : raw.normals) n = {side * n[0], side * n[1], side * n[2]};
    Oriented_points points = orient_points(raw);
    const Neighbor_graph graph = build_neighbor_graph(points, 10, false);
    BOOST_CHECK(is_well_formed(graph));
    std::size_t across = 0;
    for (Index i = 0; i < graph.size(); ++i)
      for (const Neighbor& edge : graph[i])
      {
        const bool same_wall = dot(points.normals[i], points.normals[edge.point]) > 0.5f;
        if (same_wall)
          BOOST_REQUIRE_SMALL(edge.concavity, 1e-3f);
        else
          BOOST_REQUIRE_CLOSE(edge.concavity, radians(side * 90.), 0.1);
        across += same_wall ? 0 : 1;
      }
    BOOST_CHECK_GT(across, 20u);
  }
}

BOOST_AUTO_TEST_CASE(links_become_edges)
{
  Raw_shape raw;
  add_rectangle(raw, {0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, 20, 20, {0., 0., 1.});
  raw.links = {{0, 399}};
  Oriented_points points = orient_points(raw);
  std::vector<Index> rank(400);
  for (Index i = 0; i < 400; ++i) rank[points.elements[i]] = i;
  const Neighbor_graph graph = build_neighbor_graph(points, 8, false);
  BOOST_CHECK(has_edge(graph, rank[0], rank[399]));
  BOOST_CHECK(!has_edge(graph, rank[0], rank[398]));
  BOOST_CHECK(is_well_formed(graph));
}

BOOST_AUTO_TEST_CASE(few_or_equal_points_have_a_graph)
{
  for (const std::size_t n : {1u, 2u, 3u, 7u})
  {
    Oriented_points points = orient_points(random_points(n, 9));
    const Neighbor_graph graph = build_neighbor_graph(points, 10, false);
    BOOST_CHECK_EQUAL(graph.size(), n);
    BOOST_CHECK_EQUAL(graph.entries.size(), n * (n - 1)); // all with all
    BOOST_CHECK(is_well_formed(graph));
  }
  Raw_shape raw;
  for (int i = 0; i < 300; ++i) add_point(raw, {4., 5., 6.}, {0., 0., 0.});
  Oriented_points equal = orient_points(raw);
  BOOST_CHECK_EQUAL(equal.extent, 1.);
  const Neighbor_graph graph = build_neighbor_graph(equal, 10, false);
  BOOST_CHECK(is_well_formed(graph));
  for (std::size_t i = 0; i < 300; ++i)
  {
    BOOST_REQUIRE_GE(graph[i].size(), 10u);
    BOOST_REQUIRE_EQUAL(graph.spacing[i], 0.f);
    BOOST_REQUIRE_SMALL(length(equal.normals[i]) - 1.f, 1e-6f); // a direction all the same
  }
}

BOOST_AUTO_TEST_CASE(missing_normals_come_from_the_neighbors)
{
  Raw_shape raw;
  add_rectangle(raw, {0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, 10, 10, {0., 1., 0.});
  raw.normals[44] = {0., 0., 0.};
  Oriented_points points = orient_points(raw);
  build_neighbor_graph(points, 10, false);
  for (const Vector3& n : points.normals)
    BOOST_CHECK_SMALL(length(n - Vector3{0.f, 1.f, 0.f}), 1e-5f);
}

BOOST_AUTO_TEST_CASE(rings_of_points_are_one_graph)
{
  const auto pieces = [](const Neighbor_graph& graph)
  {
    std::vector<char> seen(graph.size(), 0);
    std::size_t count = 0;
    for (Index first = 0; first < graph.size(); ++first)
    {
      if (seen[first] != 0) continue;
      ++count;
      std::vector<Index> pending = {first};
      seen[first] = 1;
      while (!pending.empty())
      {
        const Index i = pending.back();
        pending.pop_back();
        for (const Neighbor& edge : graph[i])
          if (seen[edge.point] == 0) seen[edge.point] = 1, pending.push_back(edge.point);
      }
    }
    return count;
  };
  Oriented_points points = orient_points(rings(4., [](const double) { return 0.8; }));
  BOOST_CHECK_EQUAL(pieces(build_neighbor_graph(points, 10, false)), 20u);
  const Neighbor_graph graph = build_neighbor_graph(points, 10, false, true);
  BOOST_CHECK_EQUAL(pieces(graph), 1u);
  BOOST_CHECK(is_well_formed(graph));

  // points that are spread evenly have neighbors on all sides already, and other bodies stay apart
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 3000);
  add_sphere(raw, {2.06, 0., 0.}, 1., 3000);
  Oriented_points spheres = orient_points(raw);
  const Neighbor_graph usual = build_neighbor_graph(spheres, 10, false);
  const Neighbor_graph linked = build_neighbor_graph(spheres, 10, false, true);
  BOOST_CHECK_EQUAL(pieces(linked), pieces(usual));
  BOOST_CHECK_LT(linked.entries.size(), usual.entries.size() * 101 / 100);
}

BOOST_AUTO_TEST_CASE(a_turned_part_in_rings_has_the_parts_of_the_shape)
{
  // a thick and a thin cylinder, open at their ends
  const auto radius = [](const double x) { return x < 1.99 ? 1. : 0.4; };
  const Raw_shape raw = rings(4., radius);
  CGAL::Weakly_convex_segmentation::Parameters parameters;
  parameters.number_of_patches = 40;
  const auto labels = Compiled_core::segment_points(raw, parameters, {}).labels;
  std::vector<int> wanted;
  for (const auto& p : raw.positions) wanted.push_back(p[0] < 1.99 ? 0 : 1);
  BOOST_CHECK_LT(rand_distance(labels, wanted), 0.05);
  parameters.extra_neighbors = CGAL::Weakly_convex_segmentation::Extra_neighbors::NONE;
  BOOST_CHECK_GT(rand_distance(Compiled_core::segment_points(raw, parameters, {}).labels, wanted),
                 0.3);
}

BOOST_AUTO_TEST_CASE(runs_are_sorted_as_all_at_once)
{
  std::mt19937 random(1);
  std::vector<std::pair<unsigned int, unsigned int>> entries(3000);
  for (auto& entry : entries) entry = {random() % 500, random() % 10};
  auto sorted = entries;
  std::sort(sorted.begin(), sorted.end());
  sort_in_runs(
      entries, 500, [](const auto& entry) { return entry.first; },
      [](const auto& a, const auto& b) { return a.second < b.second; });
  BOOST_TEST((entries == sorted));
  entries.clear();
  sort_in_runs(
      entries, 0, [](const auto& entry) { return entry.first; },
      [](const auto& a, const auto& b) { return a.second < b.second; });
  BOOST_TEST(entries.empty());
}

BOOST_AUTO_TEST_CASE(soups_are_welded_to_the_first_of_each_place)
{
  const std::vector<Coordinates> points = {{1., 0., 0.},  {0., 0., 0.}, {1., 0., 0.},
                                           {-0., 0., 0.}, {0., 1., 0.}, {1., 0., 0.}};
  for (const bool parallel : {false, true})
    BOOST_TEST(welded_vertices(points, parallel) == (std::vector<std::size_t>{0, 1, 0, 1, 4, 0}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
