// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_cost.h>

#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

// The terms of the default's cost on two regions that are laid by hand: a tube that goes on, bends,
// becomes thicker, is split along, or meets a joint.

BOOST_AUTO_TEST_SUITE(test_cost_merging)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

constexpr double pi = 3.14159265358979323846;
constexpr double no_limit = (std::numeric_limits<double>::max)();

/// Points on tubes, with the region of each.
struct Tubes
{
  Raw_shape raw;
  std::vector<int> regions;

  /// adds a straight tube in the plane z = 0 from a point in a direction (degrees), as a region; its
  /// radius may change.
  void add_straight(const double x, const double y, const double direction, const double length,
                    const double radius, const double last_radius, const int region)
  {
    const double c = std::cos(direction * pi / 180.), s = std::sin(direction * pi / 180.);
    const double slope = std::atan2(last_radius - radius, length);
    const int rings = static_cast<int>(std::hypot(length, last_radius - radius) / step + 0.5);
    for (int i = 0; i < rings; ++i)
    {
      const double share = (i + 0.5) / rings;
      add_ring({x + share * length * c, y + share * length * s, 0.}, {c, s}, slope,
               radius + share * (last_radius - radius), region);
    }
  }
  /// adds a tube along an arc about the origin, from 0 to `degrees`; the second half is region 1.
  void add_arc(const double bend_radius, const double degrees, const double radius)
  {
    const double length = bend_radius * degrees * pi / 180.;
    const int rings = static_cast<int>(length / step + 0.5);
    for (int i = 0; i < rings; ++i)
    {
      const double angle = (i + 0.5) / rings * degrees * pi / 180.;
      const double c = std::cos(angle), s = std::sin(angle);
      add_ring({bend_radius * c, bend_radius * s, 0.}, {-s, c}, 0., radius, 2 * i < rings ? 0 : 1);
    }
  }

private:
  static constexpr double step = 0.05;

  /// adds a ring about a center, across an axis in the plane z = 0, where the tube widens by a slope.
  void add_ring(const Coordinates& center, const std::array<double, 2>& axis, const double slope,
                const double radius, const int region)
  {
    const int points = static_cast<int>(2. * pi * radius / step + 0.5);
    for (int k = 0; k < points; ++k)
    {
      const double c = std::cos(2. * pi * k / points), s = std::sin(2. * pi * k / points);
      const Coordinates outwards = {-c * axis[1], c * axis[0], s};
      add_point(raw,
                {center[0] + radius * outwards[0], center[1] + radius * outwards[1], radius * s},
                {std::cos(slope) * outwards[0] - std::sin(slope) * axis[0],
                 std::cos(slope) * outwards[1] - std::sin(slope) * axis[1],
                 std::cos(slope) * outwards[2]});
      regions.push_back(region);
    }
  }
};

/// Two or more regions, ready for a cost.
struct Laid_regions
{
  Parameters parameters;
  Oriented_points points;
  Neighbor_graph graph;
  Patches patches;
  std::unique_ptr<Line_of_sight_query> sight;
  std::unique_ptr<Patch_visibility> visibility;
  std::vector<Diameter_sample> samples;
  Histogram_scale scale;
  std::unique_ptr<Region_graph> regions;

  Laid_regions(const Raw_shape& raw, const std::vector<int>& region_of_element)
    : points(orient_points(raw)), graph(build_neighbor_graph(points, 10, false))
  {
    patches.members.resize(static_cast<std::size_t>(*std::max_element(region_of_element.begin(),
                                                                      region_of_element.end())) +
                           1);
    for (Index i = 0; i < points.size(); ++i)
    {
      patches.of_point.push_back(region_of_element[points.elements[i]]);
      patches.members[static_cast<std::size_t>(patches.of_point.back())].push_back(i);
    }
    sight = std::make_unique<Line_of_sight_query>(points, graph, parameters);
    visibility = std::make_unique<Patch_visibility>(*sight, patches, parameters, false);
    samples = shape_diameters(*sight, parameters, false);
    regions = std::make_unique<Region_graph>(points, graph, patches, *visibility, parameters);
    set_signatures(*regions, patches, samples, scale);
    regions->add_shapes(points, graph, patches, samples);
  }

  double cost(const int a, const int b, const Merging_cost& weights)
  {
    return Region_cost(*regions, patches, samples, scale)(a, b, weights, no_limit);
  }
};

double continuation(Laid_regions shape, const int a = 0, const int b = 1)
{
  Merging_cost weights;
  weights.continuation_weight = 1.;
  const double blindness = shape.cost(a, b, {});
  const double forth = blindness - shape.cost(a, b, weights);
  const double back = blindness - shape.cost(b, a, weights);
  BOOST_CHECK_CLOSE(forth, back, 1e-6);
  BOOST_CHECK_GE(forth, -1e-12);
  BOOST_CHECK_LE(forth, 1.);
  return forth;
}

Laid_regions straight_tube(const double length_a, const double length_b, const double radius_b)
{
  Tubes tubes;
  constexpr double steep = 0.2;
  tubes.add_straight(0., 0., 180., length_a, 0.5, 0.5, 0);
  if (radius_b != 0.5) tubes.add_straight(0., 0., 0., steep, 0.5, radius_b, 1);
  tubes.add_straight(radius_b != 0.5 ? steep : 0., 0., 0., length_b, radius_b, radius_b, 1);
  return Laid_regions(tubes.raw, tubes.regions);
}

Laid_regions arc(const double degrees)
{
  Tubes tubes;
  tubes.add_arc(6. / (degrees * pi / 180.), degrees, 0.5); // the same length for all
  return Laid_regions(tubes.raw, tubes.regions);
}

/// four arms and their joint, region 0
Laid_regions cross_with_joint()
{
  Tubes tubes;
  for (int arm = 0; arm < 4; ++arm)
  {
    const double x = arm == 0 ? 1. : arm == 2 ? -1. : 0., y = arm == 1 ? 1. : arm == 3 ? -1. : 0.;
    tubes.add_straight(0.5 * x, 0.5 * y, 90. * arm, 0.6, 0.5, 0.5, 0);
    tubes.add_straight(1.1 * x, 1.1 * y, 90. * arm, 3., 0.5, 0.5, arm + 1);
  }
  return Laid_regions(tubes.raw, tubes.regions);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_straight_tube_goes_on)
{
  const double usual = continuation(straight_tube(3., 3., 0.5));
  BOOST_CHECK_GT(usual, 0.3);
  BOOST_CHECK_GT(continuation(straight_tube(5., 5., 0.5)), usual); // more slender
  BOOST_CHECK_GT(usual, continuation(straight_tube(1., 1., 0.5)));
  BOOST_CHECK_GT(continuation(straight_tube(1., 5., 0.5)), 0.2);    // however it is cut
  BOOST_CHECK_LT(continuation(straight_tube(0.4, 0.4, 0.5)), 0.05); // a disk
}

BOOST_AUTO_TEST_CASE(a_bend_is_less_of_a_continuation)
{
  double last = continuation(straight_tube(3., 3., 0.5)) + 0.05;
  for (const double degrees : {30., 90., 150., 240.})
  {
    const double bent = continuation(arc(degrees));
    BOOST_CHECK_LT(bent, last);
    last = bent;
  }
  BOOST_CHECK_GT(continuation(arc(60.)), 0.2); // a tail may curl
  BOOST_CHECK_LT(continuation(arc(240.)), 0.1);
}

BOOST_AUTO_TEST_CASE(a_step_in_width_is_no_continuation)
{
  BOOST_CHECK_LT(continuation(straight_tube(3., 3., 1.)),
                 0.5 * continuation(straight_tube(3., 3., 0.5)));
  BOOST_CHECK_LT(continuation(straight_tube(3., 3., 1.5)), 0.1);
}

BOOST_AUTO_TEST_CASE(halves_along_a_tube_are_no_continuation)
{
  Tubes tubes;
  tubes.add_straight(0., 0., 0., 6., 0.5, 0.5, 0);
  for (std::size_t i = 0; i < tubes.regions.size(); ++i)
    tubes.regions[i] = tubes.raw.positions[i][2] > 0. ? 1 : 0;
  BOOST_CHECK_LT(continuation(Laid_regions(tubes.raw, tubes.regions)), 0.05);
}

BOOST_AUTO_TEST_CASE(a_joint_is_no_continuation_of_its_arms)
{
  BOOST_CHECK_LT(continuation(cross_with_joint()), 0.05);
}

BOOST_AUTO_TEST_CASE(terms_have_the_weights_that_are_given)
{
  Laid_regions shape = straight_tube(3., 3., 0.7);
  using Weight = double Merging_cost::*;
  const Parameters usual;
  const double blindness = shape.cost(0, 1, {});
  double sum = blindness;
  for (const Weight weight :
       {&Merging_cost::diameter_weight, &Merging_cost::smaller_closure_weight,
        &Merging_cost::larger_closure_weight, &Merging_cost::seam_extent_weight,
        &Merging_cost::diameter_spread_weight, &Merging_cost::continuation_weight,
        &Merging_cost::concavity_weight})
  {
    Merging_cost one, two;
    one.concavity_saturation = two.concavity_saturation = usual.merging_cost.concavity_saturation;
    one.*weight = usual.merging_cost.*weight;
    two.*weight = 2. * one.*weight;
    const double cost = shape.cost(0, 1, one) - blindness;
    BOOST_CHECK_SMALL(shape.cost(0, 1, two) - blindness - 2. * cost, 1e-9);
    sum += cost;
  }
  BOOST_CHECK_CLOSE(shape.cost(0, 1, usual.merging_cost), sum, 1e-6);
}

BOOST_AUTO_TEST_CASE(no_cost_above_the_threshold)
{
  Laid_regions shape = straight_tube(3., 3., 0.7);
  const Merging_cost weights = Parameters().merging_cost;
  const double cost = shape.cost(0, 1, weights);
  const Region_cost bounded(*shape.regions, shape.patches, shape.samples, shape.scale);
  BOOST_CHECK_EQUAL(bounded(0, 1, weights, cost + 1e-9), cost);
  BOOST_CHECK_EQUAL(bounded(0, 1, weights, cost - 1e-9), std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_SUITE_END()
