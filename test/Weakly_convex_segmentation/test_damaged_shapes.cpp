// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Properties: whatever is done to a shape, everything gets a label, and what says the same gets the
// same labels.

BOOST_AUTO_TEST_SUITE(test_damaged_shapes)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using namespace Shapes_for_tests;
using WCS::Parameters;
using WCS::Result;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

Soup make_soup(const std::string& name, const std::size_t faces)
{
  const auto mesh = Shape_generator::make_mesh(name, faces);
  Soup soup;
  for (const auto& p : mesh.points) soup.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : mesh.faces) soup.polygons.push_back({f[0], f[1], f[2]});
  return soup;
}

Result segment(const Soup& soup, const Parameters& parameters = {})
{
  return CGAL::weakly_convex_segmentation_of_soup(soup.points, soup.polygons, parameters);
}

void turn_over(Polygon& polygon) { std::reverse(polygon.begin(), polygon.end()); }

template <typename Element>
void shuffle(std::vector<Element>& elements, std::mt19937& random)
{
  for (std::size_t i = elements.size(); i > 1; --i)
    std::swap(elements[i - 1], elements[random() % i]);
}

/// every face with vertices of its own
void split(Soup& soup)
{
  Soup pieces;
  for (const Polygon& polygon : soup.polygons)
  {
    pieces.polygons.emplace_back();
    for (const std::size_t v : polygon)
    {
      pieces.polygons.back().push_back(pieces.points.size());
      pieces.points.push_back(soup.points[v]);
    }
  }
  soup = pieces;
}

void damage(Soup& soup, const unsigned int kind, std::mt19937& random)
{
  const std::size_t n = soup.polygons.size();
  const std::size_t count = 1 + random() % (n / 4);
  if (kind == 0) // holes
    for (std::size_t i = 0; i < count; ++i)
      soup.polygons.erase(soup.polygons.begin() +
                          static_cast<std::ptrdiff_t>(random() % soup.polygons.size()));
  if (kind == 1) // noise
    for (Point& p : soup.points)
    {
      const double x = uniform(random), y = uniform(random), z = uniform(random);
      p = Point(p.x() + 0.02 * x, p.y() + 0.02 * y, p.z() + 0.02 * z);
    }
  if (kind == 2)
    for (std::size_t i = 0; i < count; ++i) turn_over(soup.polygons[random() % n]);
  if (kind == 3) split(soup);
  if (kind == 4) // faces twice
    for (std::size_t i = 0; i < count; ++i) soup.polygons.push_back(soup.polygons[random() % n]);
  if (kind == 5) shuffle(soup.polygons, random);
  if (kind == 6) // faces of no area
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t v = soup.polygons[random() % n][0];
      soup.polygons.push_back({v, v, soup.polygons[random() % n][1]});
    }
  if (kind == 7) // faces across the shape
    for (std::size_t i = 0; i < 1 + count / 20; ++i)
      soup.polygons.push_back({soup.polygons[random() % n][0], soup.polygons[random() % n][1],
                               soup.polygons[random() % n][2]});
  if (kind == 8) // points that no face has
    for (std::size_t i = 0; i < count; ++i)
      soup.points.emplace_back(uniform(random), uniform(random), uniform(random));
}

Raw_shape cloud(const std::string& name, const std::size_t count)
{
  const auto points = Shape_generator::make_cloud(name, count);
  Raw_shape raw;
  for (std::size_t i = 0; i < points.points.size(); ++i)
    add_point(raw, points.points[i], points.normals[i]);
  return raw;
}

/// a long bar of a square section, coarse: each long side is two triangles, each end a fan of many
Soup bar(const std::size_t fan, const double length = 10.)
{
  Soup soup;
  const std::array<std::array<double, 2>, 4> square = {{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}};
  for (const double z : {0., length})
    for (const auto& [x, y] : square) soup.points.emplace_back(x, y, z);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t j = (i + 1) % 4;
    soup.polygons.push_back({i, j, j + 4});
    soup.polygons.push_back({i, j + 4, i + 4});
  }
  for (std::size_t end = 0; end < 2; ++end)
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Point a = soup.points[4 * end + i], b = soup.points[4 * end + (i + 1) % 4];
      const std::size_t center = soup.points.size();
      soup.points.emplace_back(0.5, 0.5, a.z());
      for (std::size_t k = 0; k <= fan; ++k)
      {
        const double t = static_cast<double>(k) / static_cast<double>(fan);
        soup.points.emplace_back(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y()), a.z());
        if (k == 0) continue;
        soup.polygons.push_back({center, center + 1 + k, center + k});
        if (end == 1) turn_over(soup.polygons.back());
      }
    }
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_face_of_a_damaged_shape_gets_a_label)
{
  const std::vector<std::string> names = {"dumbbell", "hand", "chair"};
  for (unsigned int seed = 0; seed < 24; ++seed)
  {
    std::mt19937 random(seed);
    Soup soup = make_soup(names[seed % names.size()], 1200);
    damage(soup, seed % 9, random);
    if (seed >= 9) damage(soup, random() % 9, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Result result = segment(soup);
      check_result(result, soup.polygons.size(), false);
      BOOST_CHECK(segment(soup).labels == result.labels);
    }
  }
}

BOOST_AUTO_TEST_CASE(labels_do_not_depend_on_order_or_indices)
{
  for (unsigned int seed = 0; seed < 4; ++seed)
  {
    std::mt19937 random(seed);
    const Soup soup = make_soup(seed % 2 == 0 ? "hand" : "dumbbell", 1200);
    const std::vector<int> usual = segment(soup).labels;
    Soup pieces = soup;
    split(pieces);
    BOOST_CHECK(segment(pieces).labels == usual);

    std::vector<std::size_t> order(soup.polygons.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    shuffle(order, random);
    Soup shuffled = soup;
    std::vector<int> expected;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      shuffled.polygons[i] = soup.polygons[order[i]];
      expected.push_back(usual[order[i]]);
    }
    BOOST_CHECK_SMALL(rand_distance(segment(shuffled).labels, expected), 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(faces_at_one_edge_are_linked_in_any_order)
{
  Soup fan; // five triangles at the edge from 0 to 1
  fan.points = {{0., 0., 0.}, {0., 0., 1.}};
  for (std::size_t i = 0; i < 5; ++i)
  {
    const double angle = static_cast<double>(i);
    fan.points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    fan.polygons.push_back({0, 1, i + 2});
  }
  const auto links = [&fan]
  {
    const auto raw =
        WCS::internal::read_soup(fan.points, fan.polygons, CGAL::Identity_property_map<Point>());
    std::set<std::set<Coordinates>> result;
    for (const auto& link : raw.links)
      result.insert({raw.positions[link[0]], raw.positions[link[1]]});
    return result;
  };
  const auto usual = links();
  BOOST_CHECK_EQUAL(usual.size(), 4u);
  std::mt19937 random(4);
  for (int i = 0; i < 5; ++i)
  {
    shuffle(fan.polygons, random);
    BOOST_CHECK(links() == usual);
  }
}

BOOST_AUTO_TEST_CASE(turned_faces_do_not_matter)
{
  for (const char* name : {"hand", "dumbbell"})
  {
    const Soup soup = make_soup(name, 2000);
    const std::vector<int> usual = segment(soup).labels;
    std::mt19937 random(1);
    Soup some = soup, all = soup, most = soup;
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    {
      if (random() % 3 == 0) turn_over(some.polygons[i]);
      if (random() % 3 != 0) turn_over(most.polygons[i]);
      turn_over(all.polygons[i]);
    }
    BOOST_CHECK_LT(rand_distance(segment(some).labels, usual), 1e-3);
    BOOST_CHECK_LT(rand_distance(segment(most).labels, usual), 1e-3);
    BOOST_CHECK_LT(rand_distance(segment(all).labels, usual), 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(inward_normals_of_closed_clouds_are_turned)
{
  for (const char* name : {"hand", "dumbbell"})
  {
    Raw_shape raw = cloud(name, 3000);
    const Result usual = Compiled_core::segment_points(raw, {}, {});
    BOOST_CHECK(!usual.has_flipped_normals);
    for (auto& n : raw.normals) n = {-n[0], -n[1], -n[2]};
    const Result turned = Compiled_core::segment_points(raw, {}, {});
    BOOST_CHECK(turned.has_flipped_normals);
    BOOST_CHECK_LT(rand_distance(turned.labels, usual.labels), 0.02);
  }
  Raw_shape bowl; // seen from within: not closed, stays as it is
  add_sphere(bowl, {0., 0., 0.}, 1., 2000);
  bowl.positions.resize(1000);
  bowl.normals.resize(1000);
  for (auto& n : bowl.normals) n = {-n[0], -n[1], -n[2]};
  BOOST_CHECK(!Compiled_core::segment_points(bowl, {}, {}).has_flipped_normals);
}

BOOST_AUTO_TEST_CASE(normals_that_contradict_each_other_are_turned)
{
  for (const char* name : {"hand", "dumbbell", "chair"})
  {
    const Raw_shape raw = cloud(name, 4000);
    const Result usual = Compiled_core::segment_points(raw, {}, {});
    BOOST_CHECK(!usual.has_flipped_normals);
    std::mt19937 random(1);
    Raw_shape half = raw, some = raw, scan;
    for (std::size_t i = 0; i < raw.positions.size(); ++i)
    {
      const Coordinates n = raw.normals[i];
      if (raw.positions[i][0] < 0.1) half.normals[i] = {-n[0], -n[1], -n[2]};
      if (random() % 3 == 0) some.normals[i] = {-n[0], -n[1], -n[2]};
      if (n[2] > -0.2) add_point(scan, raw.positions[i], n);
    }
    for (const Raw_shape& turned : {half, some})
    {
      const Result result = Compiled_core::segment_points(turned, {}, {});
      BOOST_CHECK(result.has_flipped_normals);
      BOOST_CHECK(!result.has_doubtful_normals);
      BOOST_CHECK_LT(rand_distance(result.labels, usual.labels), 0.01);
    }
    BOOST_CHECK(!Compiled_core::segment_points(scan, {}, {}).has_flipped_normals);
  }
  Raw_shape bowl; // too open to tell
  add_sphere(bowl, {0., 0., 0.}, 1., 2000);
  bowl.positions.resize(1000);
  bowl.normals.resize(1000);
  BOOST_CHECK(!Compiled_core::segment_points(bowl, {}, {}).has_doubtful_normals);
  for (std::size_t i = 0; i < 1000; i += 2)
    bowl.normals[i] = {-bowl.normals[i][0], -bowl.normals[i][1], -bowl.normals[i][2]};
  const Result result = Compiled_core::segment_points(bowl, {}, {});
  BOOST_CHECK(result.has_doubtful_normals);
  BOOST_CHECK(!result.has_flipped_normals);
}

BOOST_AUTO_TEST_CASE(estimated_normals_of_all_pieces_point_outwards)
{
  Raw_shape balls;
  const std::size_t n = 400;
  for (int i = 0; i < 5; ++i) add_sphere(balls, {4. * i, 0.1 * i, 0.2 * i}, 1., n);
  Raw_shape bare = balls;
  bare.normals.clear();
  WCS::internal::estimate_normals(bare, {});
  for (std::size_t i = 0; i < balls.positions.size(); ++i)
  {
    double product = 0.;
    for (std::size_t c = 0; c < 3; ++c) product += balls.normals[i][c] * bare.normals[i][c];
    BOOST_REQUIRE_GT(product, 0.5);
  }
}

BOOST_AUTO_TEST_CASE(thin_plates_without_normals_are_one_part)
{
  for (const double thickness : {0.1, 0.05, 0.03, 0.02, 0.015, 0.01, 0.006}) // .4 to 7 spacings
  {
    std::mt19937 random(1);
    const double wide = 0.6, edge = 1.6 * thickness, area = wide + edge; // of one of each two sides
    Raw_shape plate;
    for (int i = 0; i < 5000; ++i)
    {
      const double x = uniform(random), y = wide * uniform(random), z = thickness * uniform(random);
      const double end = random() % 2 == 0 ? 1. : 0., side = area * uniform(random);
      if (side < wide)
        plate.positions.push_back({x, y, end * thickness});
      else if (side < wide + thickness)
        plate.positions.push_back({x, end * wide, z});
      else
        plate.positions.push_back({end, y, z});
    }
    BOOST_TEST_CONTEXT("thickness " << thickness)
    BOOST_CHECK_EQUAL(Compiled_core::segment_points(plate, {}, {}).number_of_segments(), 1u);
  }
}

BOOST_AUTO_TEST_CASE(long_faces_get_more_points)
{
  const Soup soup = bar(40);
  WCS::internal::Raw_shape raw = WCS::internal::read_soup(soup.points, soup.polygons,
                                                          CGAL::Identity_property_map<Point>()),
                           sampled;
  BOOST_REQUIRE(WCS::internal::sample_faces(raw, Parameters(), sampled));
  BOOST_CHECK_GT(sampled.positions.size(), raw.positions.size() + 200);
  std::vector<std::size_t> points(raw.positions.size(), 0);
  for (const auto f : sampled.element_of) ++points[f];
  for (std::size_t f = 0; f < points.size(); ++f) BOOST_CHECK_EQUAL(points[f] > 1, f < 8);
  check_result(segment(soup), soup.polygons.size(), false);
  Parameters off;
  off.face_sampling_factor = 0.;
  BOOST_CHECK(!WCS::internal::sample_faces(raw, off, sampled));
}

// The nearest neighbors of the points of a long bar all lie in its own ring of points: it is the mesh
// that holds the rings together.
BOOST_AUTO_TEST_CASE(long_bars_are_one_segment)
{
  for (const double length : {3., 10., 30., 100.})
    for (const std::size_t fan : {1u, 5u, 40u, 160u})
      BOOST_TEST_CONTEXT("length " << length << ", fan " << fan)
      {
        const Soup soup = bar(fan, length);
        const Result result = segment(soup);
        check_result(result, soup.polygons.size(), false);
        BOOST_CHECK_EQUAL(result.number_of_segments(), 1u); // a bar is convex
      }
}

BOOST_AUTO_TEST_SUITE_END()
