// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/diameters/shape_diameters.h>

#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

// Volumetric signatures (section 5): shape diameters, their histograms, the earth mover's distance.

BOOST_AUTO_TEST_SUITE(test_shape_diameters)

namespace {

using CGAL::Weakly_convex_segmentation::Parameters;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

Histogram_scale linear_scale(const std::size_t bins)
{
  Histogram_scale scale;
  scale.bins = bins;
  scale.logarithmic = false;
  scale.low = 0.;
  return scale;
}

Diameter_histogram histogram(const Histogram_scale& scale, const std::vector<double>& diameters)
{
  Diameter_histogram result;
  for (const double d : diameters) result.add(scale, d);
  return result;
}

struct Scene
{
  Oriented_points points;
  Neighbor_graph graph;
  Line_of_sight_query sight;

  explicit Scene(const Raw_shape& raw)
    : points(orient_points(raw)), graph(build_neighbor_graph(points, 10, false)),
      sight(points, graph, Parameters())
  {}
};

/// the median diameter in units of the input; 0 if no point has one
double median_diameter(const Scene& scene, const std::vector<Diameter_sample>& samples)
{
  std::vector<float> diameters;
  for (const Diameter_sample& s : samples)
    if (s.diameter > 0.f) diameters.push_back(s.diameter);
  if (diameters.empty()) return 0.;
  std::nth_element(diameters.begin(), diameters.begin() + diameters.size() / 2, diameters.end());
  return static_cast<double>(diameters[diameters.size() / 2]) * scene.points.extent;
}

std::vector<Index> all_points(const Scene& scene)
{
  std::vector<Index> result(scene.points.size());
  for (Index i = 0; i < result.size(); ++i) result[i] = i;
  return result;
}

Raw_shape cylinder(const double radius, const double length)
{
  Raw_shape raw;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 200; ++j)
    {
      const double a = 6.283185307179586 * (i + 0.5 * (j % 2)) / 60.;
      const Coordinates out = {std::cos(a), std::sin(a), 0.};
      add_point(raw, plus({0., 0., length * j / 200.}, out, radius), out);
    }
  return raw;
}

Raw_shape sheets(const int n, const std::vector<double>& heights)
{
  Raw_shape raw;
  const double step = 1. / n;
  for (const double z : heights)
    add_rectangle(raw, {0., 0., z}, {step, 0., 0.}, {0., step, 0.}, n, n,
                  {0., 0., z > 0. ? 1. : -1.});
  return raw;
}

} // namespace

BOOST_AUTO_TEST_CASE(earth_movers_distance_by_hand)
{
  const Histogram_scale scale = linear_scale(10);
  const auto in_bins = [&](const std::vector<int>& bins)
  {
    Diameter_histogram result;
    for (const int b : bins) result.add(scale, 0.1 * b + 0.05);
    return result;
  };
  const auto distance = [&](const std::vector<int>& a, const std::vector<int>& b)
  {
    const double d = earth_movers_distance(in_bins(a), in_bins(b), scale);
    BOOST_CHECK_CLOSE(d + 1., 1. + earth_movers_distance(in_bins(b), in_bins(a), scale), 1e-9);
    return d;
  };
  BOOST_CHECK_SMALL(distance({2, 3, 7}, {7, 2, 3}), 1e-12);
  BOOST_CHECK_SMALL(distance({2, 3}, {2, 2, 3, 3}), 1e-12); // shares count, not numbers
  BOOST_CHECK_CLOSE(distance({2}, {5}), 0.3, 1e-6);         // all moves by three bins
  BOOST_CHECK_CLOSE(distance({2, 4, 4}, {5, 7, 7}), 0.3, 1e-6);
  BOOST_CHECK_CLOSE(distance({0, 4}, {2}), 0.2, 1e-6);       // each half by two
  BOOST_CHECK_CLOSE(distance({1, 1, 1, 9}, {1}), 0.2, 1e-6); // a quarter by eight
  BOOST_CHECK_CLOSE(distance({0}, {9}), 0.9, 1e-6);
  BOOST_CHECK_LE(distance({0, 5}, {8}),
                 distance({0, 5}, {3, 3, 9}) + distance({3, 3, 9}, {8}) + 1e-9);
}

BOOST_AUTO_TEST_CASE(on_the_logarithmic_scale_only_the_ratio_counts)
{
  const Histogram_scale scale;
  for (const double d : {0.01, 0.1, 0.3})
    BOOST_CHECK_SMALL(
        earth_movers_distance(histogram(scale, {d}), histogram(scale, {2. * d}), scale) -
            std::log(2.),
        1.01 * scale.bin_width());
  for (const Histogram_scale& s : {scale, linear_scale(64)})
    for (std::size_t b = 0; b < s.bins; ++b) BOOST_CHECK_EQUAL(s.bin(s.center(b)), b);
  BOOST_CHECK_EQUAL(scale.bin(1e-9), 0u);
  BOOST_CHECK_EQUAL(scale.bin(17.), 63u);
}

BOOST_AUTO_TEST_CASE(histograms_add_up)
{
  const Histogram_scale scale;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> first = {0.1, 0.2, 0., nan}, second = {0.2, 0.7, infinity, -1., 0.03};
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  Diameter_histogram sum = histogram(scale, first);
  BOOST_CHECK_EQUAL(sum.measured, 2.);
  BOOST_CHECK_EQUAL(sum.samples, 4.);
  sum += histogram(scale, second);
  const Diameter_histogram expected = histogram(scale, all);
  BOOST_CHECK(sum.counts == expected.counts);
  BOOST_CHECK_EQUAL(sum.measured, expected.measured);
  BOOST_CHECK_EQUAL(sum.samples, 9.);
  BOOST_CHECK(!sum.empty());
  BOOST_CHECK(histogram(scale, {0., nan}).empty());
}

BOOST_AUTO_TEST_CASE(medians)
{
  const Histogram_scale scale = linear_scale(50);
  BOOST_CHECK_SMALL(histogram(scale, {0.9, 0.11, 0.31}).median(scale) - 0.31, 0.02);
  BOOST_CHECK_SMALL(histogram(scale, {0.51, 0.52, 0.9, 0.91, 0.92}).median(scale) - 0.9, 0.02);
  BOOST_CHECK_EQUAL(histogram(scale, {}).median(scale), 0.);
  BOOST_CHECK_EQUAL(histogram(scale, {0., 0.}).median(scale), 0.);

  std::vector<std::pair<float, float>> none, values = {{3.f, 1.f}, {1.f, 1.f}, {2.f, 5.f}};
  BOOST_CHECK_EQUAL(weighted_median(none), 0.f);
  BOOST_CHECK_EQUAL(weighted_median(values), 2.f);
  values = {{3.f, 9.f}, {1.f, 1.f}, {2.f, 5.f}};
  BOOST_CHECK_EQUAL(weighted_median(values), 3.f);
}

BOOST_AUTO_TEST_CASE(rays_fill_their_cone)
{
  for (const Vector3& axis :
       {Vector3{0.f, 0.f, 1.f}, Vector3{-1.f, 0.f, 0.f}, normalized(Vector3{1.f, -2.f, 0.5f})})
  {
    std::vector<Vector3> directions;
    cone_directions(axis, radians(30.), 64, directions);
    BOOST_REQUIRE_EQUAL(directions.size(), 64u);
    Vector3 sum;
    float widest = 0.f;
    for (const Vector3& d : directions)
    {
      BOOST_REQUIRE_SMALL(length(d) - 1.f, 1e-4f);
      widest = (std::max)(widest, angle(d, axis));
      sum = sum + d;
    }
    BOOST_CHECK_LE(widest, radians(30.1));
    BOOST_CHECK_GE(widest, radians(28.));
    BOOST_CHECK_LT(angle(normalized(sum), axis), radians(2.)); // as many on each side
  }
}

BOOST_AUTO_TEST_CASE(diameter_of_a_sphere_through_the_shape)
{
  Raw_shape raw;
  add_sphere(raw, {1., 2., 3.}, 4., 4000);
  const Scene scene(raw);
  Parameters parameters;
  for (const double opening : {20., 60.})
  {
    parameters.diameter_cone_angle = opening;
    const auto samples = shape_diameters(scene.sight, parameters, false);
    BOOST_REQUIRE_EQUAL(samples.size(), number_of_diameters);
    std::set<Index> points;
    for (const Diameter_sample& s : samples)
    {
      points.insert(s.point);
      // a chord at an angle t off the diameter is cos(t) as long
      BOOST_REQUIRE_GE(s.diameter, 0.95 * std::cos(0.5 * static_cast<double>(radians(opening))));
      BOOST_REQUIRE_LE(s.diameter, 1.0001f);
    }
    BOOST_CHECK_EQUAL(points.size(), number_of_diameters);
    BOOST_CHECK_LT(std::abs(median_diameter(scene, samples) - 8.), opening == 20. ? 0.2 : 0.8);
  }
  Raw_shape few; // never more than there are points
  add_sphere(few, {1., 2., 3.}, 4., 900);
  BOOST_CHECK_EQUAL(shape_diameters(Scene(few).sight, parameters, false).size(), 900u);
}

BOOST_AUTO_TEST_CASE(diameter_of_plates_and_cylinders_through_the_shape)
{
  const Scene plate(sheets(60, {0., 0.08}));
  const double thickness =
      median_diameter(plate, shape_diameters(plate.sight, Parameters(), false));
  BOOST_CHECK_GT(thickness, 0.078);
  BOOST_CHECK_LT(thickness, 0.1);
  const Scene tube(cylinder(0.3, 6.));
  const double diameter = median_diameter(tube, shape_diameters(tube.sight, Parameters(), false));
  BOOST_CHECK_GT(diameter, 0.53);
  BOOST_CHECK_LT(diameter, 0.7);
  // an open sheet has none
  const Scene sheet(sheets(40, {0.}));
  BOOST_CHECK_EQUAL(median_diameter(sheet, shape_diameters(sheet.sight, Parameters(), false)), 0.);
}

BOOST_AUTO_TEST_CASE(diameters_of_a_component_from_its_own_points)
{
  const Parameters paper = Parameters::paper();
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 2., 3000);
  const Scene ball(raw);
  const auto samples = own_diameters(ball.points, all_points(ball), paper, false);
  BOOST_CHECK_EQUAL(samples.size(), 300u); // a tenth
  BOOST_CHECK_SMALL(median_diameter(ball, samples) - 4., 0.1);

  // half a ball does not see the other half's points
  std::vector<Index> upper, cap;
  for (const Index i : all_points(ball))
  {
    if (ball.points.positions[i].z > 0.f) upper.push_back(i);
    if (ball.points.positions[i].z > 0.48f) cap.push_back(i);
  }
  const auto of_half = own_diameters(ball.points, upper, paper, false);
  std::size_t measured = 0;
  for (const Diameter_sample& s : of_half) measured += s.diameter > 0.f ? 1 : 0;
  BOOST_CHECK_LT(measured, of_half.size() / 2);
  BOOST_CHECK_GT(measured, 0u);
  const auto of_cap = own_diameters(ball.points, cap, paper, false);
  BOOST_CHECK_EQUAL(of_cap.size(), cap.size()); // fewer than 100: all
  BOOST_CHECK_EQUAL(median_diameter(ball, of_cap), 0.);

  const Scene tube(cylinder(0.3, 6.));
  BOOST_CHECK_SMALL(
      median_diameter(tube, own_diameters(tube.points, all_points(tube), paper, false)) - 0.6,
      0.05);
}

BOOST_AUTO_TEST_SUITE_END()
