// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What no shape should be, but inputs are: everything gets a label, or the input is refused.

BOOST_AUTO_TEST_SUITE(test_hostile_input)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using namespace Shapes_for_tests;
using WCS::Parameters;
using WCS::Result;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

const std::vector<Parameters> presets = {Parameters(), Parameters::paper(),
                                         Parameters::training_free()};

/// segments with all presets; all points get a label
void check_all_labeled(const Raw_shape& raw, const std::string& what)
{
  BOOST_TEST_CONTEXT(what)
  {
    for (const Parameters& preset : presets)
      check_result(Compiled_core::segment_points(raw, preset, {}), raw.positions.size());
  }
}

void check_refused(const Raw_shape& raw)
{
  for (const Parameters& preset : presets)
    BOOST_CHECK_THROW(Compiled_core::segment_points(raw, preset, {}), std::invalid_argument);
}

/// random points in a box with random normals
Raw_shape random_points(const std::size_t count, const Coordinates& size, const unsigned int seed)
{
  std::mt19937 random(seed);
  Raw_shape raw;
  const auto number = [&] { return 2. * uniform(random) - 1.; };
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = size[0] * number(), y = size[1] * number(), z = size[2] * number();
    const double u = number(), v = number();
    add_point(raw, {x, y, z}, {u, v, number()});
  }
  return raw;
}

Raw_shape repeated(const Raw_shape& few, const std::size_t count)
{
  Raw_shape raw;
  for (std::size_t i = 0; i < count; ++i)
    add_point(raw, few.positions[i % few.positions.size()], few.normals[i % few.normals.size()]);
  return raw;
}

/// two balls that grow into each other
Raw_shape two_balls(const double scale, const double offset)
{
  Raw_shape balls, raw;
  add_sphere(balls, {-0.9, 0., 0.}, 1., 900);
  add_sphere(balls, {0.9, 0., 0.}, 1., 900);
  for (std::size_t i = 0; i < balls.positions.size(); ++i)
  {
    const Coordinates& p = balls.positions[i];
    if ((p[0] < 0.) != (i < 900)) continue; // inside of the other ball
    add_point(raw, {scale * p[0] + offset, scale * p[1] + offset, scale * p[2] - offset},
              balls.normals[i]);
  }
  return raw;
}

std::vector<Point> points_of(const Raw_shape& raw)
{
  std::vector<Point> points;
  for (const auto& p : raw.positions) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Result segment_soup(const std::vector<Point>& points, const std::vector<Polygon>& polygons,
                    const Parameters& parameters = {})
{
  const Result result = CGAL::weakly_convex_segmentation_of_soup(points, polygons, parameters);
  check_result(result, polygons.size(), false);
  return result;
}

struct No_map
{
  using key_type = void; // any
  using value_type = int;
  using reference = void;
  using category = boost::writable_property_map_tag;
  template <typename Key>
  friend void put(const No_map&, const Key&, int)
  {}
};

} // namespace

BOOST_AUTO_TEST_CASE(few_points)
{
  check_refused(Raw_shape());
  for (const std::size_t n : {1u, 2u, 3u, 4u, 5u, 10u, 11u, 12u, 30u})
  {
    check_all_labeled(random_points(n, {1., 1., 1.}, 1), std::to_string(n) + " points");
    const auto points = points_of(random_points(n, {1., 1., 1.}, 1)); // without normals too
    check_result(CGAL::weakly_convex_segmentation(points, No_map()), n);
  }
}

BOOST_AUTO_TEST_CASE(equal_points)
{
  const Raw_shape one = random_points(1, {1., 1., 1.}, 2),
                  seven = random_points(7, {1., 1., 1.}, 2);
  for (const std::size_t n : {2u, 15u, 500u})
  {
    check_all_labeled(repeated(one, n), "equal points");
    check_all_labeled(repeated(seven, n), "points at seven places");
    check_result(CGAL::weakly_convex_segmentation(points_of(repeated(one, n)), No_map()), n);
    check_result(CGAL::weakly_convex_segmentation(points_of(repeated(seven, n)), No_map()), n);
  }
  const Raw_shape many = repeated(seven, 30000); // these are thinned
  const Result result = Compiled_core::segment_points(many, Parameters(), {});
  check_result(result, 30000);
  for (std::size_t i = 7; i < 30000; ++i)
    BOOST_REQUIRE_EQUAL(result.labels[i], result.labels[i % 7]);
}

BOOST_AUTO_TEST_CASE(lines_planes_and_noise)
{
  for (const Coordinates& size :
       {Coordinates{1., 0., 0.}, {1., 1., 0.}, {1., 1., 1.}, {1., 1e-9, 1e-9}})
  {
    const Raw_shape raw = random_points(600, size, 3);
    check_all_labeled(raw, "random normals");
    check_result(CGAL::weakly_convex_segmentation(points_of(raw), No_map()), 600);
    Raw_shape up = raw;
    for (auto& n : up.normals) n = {0., 0., 1.};
    check_all_labeled(up, "equal normals");
    for (auto& n : up.normals) n = {0., 0., 0.};
    check_all_labeled(up, "no normals");
  }
}

BOOST_AUTO_TEST_CASE(flipped_normals)
{
  Raw_shape raw = two_balls(1., 0.);
  for (auto& n : raw.normals) n = {-n[0], -n[1], -n[2]};
  check_all_labeled(raw, "all flipped");
  for (std::size_t i = 0; i < raw.normals.size(); i += 2)
    raw.normals[i] = {-raw.normals[i][0], -raw.normals[i][1], -raw.normals[i][2]};
  check_all_labeled(raw, "half flipped");
}

BOOST_AUTO_TEST_CASE(extreme_coordinates)
{
  const Result usual = Compiled_core::segment_points(two_balls(1., 0.), Parameters(), {});
  BOOST_CHECK_EQUAL(usual.number_of_segments(), 2u);
  for (const double scale : {1e-9, 1e9, 1e-150, 1e150})
  {
    const Result result = Compiled_core::segment_points(two_balls(scale, 0.), Parameters(), {});
    BOOST_CHECK_LT(rand_distance(result.labels, usual.labels), 0.03);
  }
  const Result far = Compiled_core::segment_points(two_balls(1., 1e7), Parameters(), {});
  BOOST_CHECK_LT(rand_distance(far.labels, usual.labels), 0.03);
  check_all_labeled(two_balls(1., 1e16), "offset beyond the precision");
  check_all_labeled(two_balls(1e-310, 0.), "denormal numbers");
  check_all_labeled(two_balls(1e-320, 0.), "hardly any bits");
  check_refused(two_balls(1e308, 0.)); // its extent overflows
  Raw_shape outlier = two_balls(1., 0.);
  add_point(outlier, {1e6, 0., 0.}, {1., 0., 0.});
  check_all_labeled(outlier, "an outlier");
}

BOOST_AUTO_TEST_CASE(units_of_any_magnitude)
{
  const auto dumbbell = Shape_generator::make_mesh("dumbbell", 2000);
  const std::vector<Polygon> polygons = [&]
  {
    std::vector<Polygon> result;
    for (const auto& f : dumbbell.faces) result.push_back({f[0], f[1], f[2]});
    return result;
  }();
  const auto corners = [&](const int exponent)
  {
    std::vector<Point> points;
    for (const auto& p : dumbbell.points)
      points.emplace_back(std::ldexp(p[0], exponent), std::ldexp(p[1], exponent),
                          std::ldexp(p[2], exponent));
    return points;
  };
  const auto cloud = [](const int exponent)
  { return points_of(two_balls(std::ldexp(1., exponent), 0.)); };
  const auto segment_mesh = [&](const int exponent)
  {
    CGAL::Surface_mesh<Point> mesh;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(corners(exponent), polygons, mesh);
    return CGAL::weakly_convex_segmentation(mesh, No_map());
  };
  const Result soup = segment_soup(corners(0), polygons), mesh = segment_mesh(0),
               points = CGAL::weakly_convex_segmentation(cloud(0), No_map());
  BOOST_CHECK_GE(soup.number_of_segments(), 2u);
  // 2^997 is 1.3e300: areas, volumes and squared lengths overflow, or vanish
  for (const int exponent : {-997, -800, -101, 101, 400, 997})
    BOOST_TEST_CONTEXT("2 to the power of " << exponent)
    {
      const Result same = segment_soup(corners(exponent), polygons);
      BOOST_CHECK(same.labels == soup.labels);
      BOOST_CHECK_EQUAL(same.segments[0].diameter, std::ldexp(soup.segments[0].diameter, exponent));
      BOOST_CHECK(segment_mesh(exponent).labels == mesh.labels);
      BOOST_CHECK(CGAL::weakly_convex_segmentation(cloud(exponent), No_map()).labels ==
                  points.labels);
    }
  const auto names_cause = [](const std::invalid_argument& error)
  {
    return std::string(error.what()).find("extent of the shape overflows; scale") !=
           std::string::npos;
  };
  const std::vector<Point> far_corners = {
      {-1.7e308, 0., 0.}, {1.7e308, 0., 0.}, {0., 1e308, 0.}, {0., 0., 0.}, {0., -1e308, 0.}};
  BOOST_CHECK_EXCEPTION(segment_soup(far_corners, {{0, 3, 2}, {0, 4, 3}, {1, 3, 4}, {1, 2, 3}}),
                        std::invalid_argument, names_cause);
  BOOST_CHECK_EXCEPTION(CGAL::weakly_convex_segmentation(cloud(1023), No_map()),
                        std::invalid_argument, names_cause);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
  {
    Raw_shape raw = two_balls(1., 0.);
    raw.positions[3][0] = bad;
    check_refused(raw);
    BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation(points_of(raw), No_map()),
                      std::invalid_argument);
    BOOST_CHECK_THROW(segment_soup(points_of(raw), {{3, 4, 5}}), std::invalid_argument);
    raw = two_balls(1., 0.);
    raw.normals[3][0] = bad;
    check_refused(raw);
  }
}

BOOST_AUTO_TEST_CASE(soups_that_are_no_surface)
{
  const auto mesh = Shape_generator::make_mesh("dumbbell", 2000);
  std::vector<Point> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<Polygon> polygons;
  for (const auto& f : mesh.faces) polygons.push_back({f[0], f[1], f[2]});
  const std::size_t n = polygons.size();

  std::vector<Polygon> soup = polygons; // every third face turned over
  for (std::size_t i = 0; i < n; i += 3) std::swap(soup[i][0], soup[i][1]);
  segment_soup(points, soup);
  soup = polygons; // every face twice, and fans of faces at one edge
  soup.insert(soup.end(), polygons.begin(), polygons.end());
  for (std::size_t i = 0; i < 50; ++i) soup.push_back({0, 1, 10 * i + 2});
  segment_soup(points, soup);
  soup = polygons; // degenerate faces: repeated corners, no area
  for (std::size_t i = 0; i < 200; ++i) soup.push_back({i, i, i + 1});
  for (std::size_t i = 0; i < 200; ++i) soup.push_back({i, i, i, i});
  segment_soup(points, soup);
  segment_soup(points, std::vector<Polygon>(soup.end() - 300, soup.end())); // nothing else
  soup = polygons;                                                          // faces of more corners
  for (std::size_t i = 0; i < 100; ++i) soup[i].push_back(soup[i + 1][0]);
  segment_soup(points, soup);

  BOOST_CHECK_THROW(segment_soup(points, {}), std::invalid_argument);
  BOOST_CHECK_THROW(segment_soup({}, {}), std::invalid_argument);
  BOOST_CHECK_THROW(segment_soup({}, {{0, 1, 2}}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(meshes_with_no_or_one_face)
{
  CGAL::Surface_mesh<Point> mesh;
  BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation(mesh, No_map()), std::invalid_argument);
  const auto a = mesh.add_vertex({0., 0., 0.}), b = mesh.add_vertex({1., 0., 0.});
  const auto c = mesh.add_vertex({0., 1., 0.});
  BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation(mesh, No_map()), std::invalid_argument);
  mesh.add_face(a, b, c);
  for (const Parameters& preset : presets)
  {
    const Result result = CGAL::weakly_convex_segmentation(mesh, No_map(), preset);
    check_result(result, 1, false);
    BOOST_CHECK_EQUAL(result.number_of_segments(), 1u);
    BOOST_CHECK_EQUAL(result.segments[0].convexity_rank, 1.);
  }
}

BOOST_AUTO_TEST_CASE(thousands_of_pieces)
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < 2000; ++i)
  {
    const double x = 1. * (i % 13), y = 1. * (i / 13 % 13), z = 1. * (i / 169);
    const std::size_t v = points.size();
    points.insert(points.end(), {{x, y, z}, {x + 0.1, y, z}, {x, y + 0.1, z}, {x, y, z + 0.1}});
    polygons.insert(
        polygons.end(),
        {{v, v + 2, v + 1}, {v, v + 1, v + 3}, {v, v + 3, v + 2}, {v + 1, v + 2, v + 3}});
  }
  segment_soup(points, polygons);
  Raw_shape spheres; // of more points than a point has neighbors
  for (int i = 0; i < 1500; ++i)
    add_sphere(spheres, {1. * (i % 12), 1. * (i / 12 % 12), 1. * (i / 144)}, 0.02, 12);
  for (Parameters preset : presets)
  {
    preset.maximum_number_of_segments = 3;    // whatever the distance
    preset.number_of_representatives = 20000; // fewer would run the pieces together
    const Result result = Compiled_core::segment_points(spheres, preset, {});
    check_result(result, spheres.positions.size());
    BOOST_CHECK_GE(result.merge_tree.number_of_patches(), 1500u);
    BOOST_CHECK_LE(result.number_of_segments(), 3u);
  }
}

BOOST_AUTO_TEST_CASE(extreme_parameters)
{
  const Raw_shape raw = two_balls(1., 0.);
  std::mt19937 random(4);
  const auto pick = [&](const std::vector<double>& values)
  { return values[random() % values.size()]; };
  const auto count = [&](const std::vector<double>& values)
  { return static_cast<std::size_t>(pick(values)); };
  for (int trial = 0; trial < 40; ++trial)
  {
    Parameters p = presets[random() % 3];
    p.number_of_neighbors = count({3, 4, 10, 100});
    p.number_of_representatives = count({100, 500, 1e9});
    p.number_of_patches = count({1, 2, 50, 400});
    p.number_of_supervoxels = count({1, 2, 100, 20000});
    p.spectral_dimensions = pick({0.01, 0.5, 1.});
    p.patch_concavity_tolerance = pick({0., 5., 180.});
    p.maximum_rays_per_pair = count({0, 1, 25});
    p.diameter_cone_angle = pick({1e-3, 60., 179.});
    p.merging_cost.larger_closure_weight = pick({0., 0.5, 1e6});
    p.merging_cost.seam_extent_weight = pick({0., 0.4, 1e6});
    p.fusion_threshold = pick({0., 1., p.merging == WCS::Merging_rule::COST ? 1e6 : 0.5});
    p.minimum_segment_share = pick({0., 0.01, 1.});
    p.maximum_number_of_segments = count({0, 1, 4});
    p.band_width = pick({0., 1e-6, 0.015, 1.});
    const Result result = Compiled_core::segment_points(raw, p, {});
    check_result(result, raw.positions.size());
    if (p.maximum_number_of_segments > 0)
      BOOST_CHECK_LE(result.number_of_segments(), p.maximum_number_of_segments);
  }
}

BOOST_AUTO_TEST_SUITE_END()
