// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/points/estimate_normals.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// Normals of clouds that have none: their lines, and which of both ways they point.

BOOST_AUTO_TEST_SUITE(test_estimated_normals)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

const std::array<Normal_orientation, 2> orientations = {Normal_orientation::PROPAGATION,
                                                        Normal_orientation::MST};

Raw_shape cloud(const std::string& name, const std::size_t size)
{
  const auto made = Shape_generator::make_cloud(name, size, 1);
  Raw_shape raw;
  for (std::size_t i = 0; i < size; ++i)
    add_point(raw, {made.points[i][0], made.points[i][1], made.points[i][2]},
              {made.normals[i][0], made.normals[i][1], made.normals[i][2]});
  return raw;
}

std::vector<Coordinates>
estimated(const Raw_shape& raw, const Run_control& control = {},
          const Normal_orientation orientation = Normal_orientation::PROPAGATION)
{
  Raw_shape bare;
  bare.positions = raw.positions;
  estimate_normals(bare, control, orientation);
  BOOST_REQUIRE(bare.normals.size() == raw.positions.size());
  return bare.normals;
}

double product(const Coordinates& a, const Coordinates& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// the share of the normals that point to the side that they should
double share_of_right(const Raw_shape& raw,
                      const Normal_orientation orientation = Normal_orientation::PROPAGATION)
{
  const std::vector<Coordinates> normals = estimated(raw, {}, orientation);
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (product(normals[i], raw.normals[i]) > 0.) ++right;
  return static_cast<double>(right) / static_cast<double>(normals.size());
}

/// `size`: of the largest change of a coordinate
Raw_shape with_noise(Raw_shape raw, const double size)
{
  std::mt19937 random(2);
  for (auto& p : raw.positions)
    for (double& c : p) c += size * (2. * uniform(random) - 1.);
  return raw;
}

double extent(const Raw_shape& raw)
{
  const Bounding_cube cube = bounding_cube(raw.positions);
  return cube.side;
}

/// without what lies in balls about some points
Raw_shape with_holes(const Raw_shape& raw)
{
  const double radius = 0.1 * extent(raw);
  Raw_shape result;
  for (std::size_t i = 0; i < raw.positions.size(); ++i)
  {
    bool is_in_hole = false;
    for (std::size_t j = 7; j < raw.positions.size(); j += raw.positions.size() / 8)
    {
      const Coordinates d = plus(raw.positions[i], raw.positions[j], -1.);
      is_in_hole = is_in_hole || product(d, d) < radius * radius;
    }
    if (!is_in_hole) add_point(result, raw.positions[i], raw.normals[i]);
  }
  return result;
}

Raw_shape permuted(const Raw_shape& raw, const std::vector<std::size_t>& order)
{
  Raw_shape result;
  for (const std::size_t i : order) add_point(result, raw.positions[i], raw.normals[i]);
  return result;
}

void check_order_and_threads(const Normal_orientation orientation)
{
  const Raw_shape raw = cloud("figure", 5000);
  const std::vector<Coordinates> usual = estimated(raw, {}, orientation);
  std::vector<std::size_t> order(raw.positions.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937 random(5);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  const std::vector<Coordinates> other = estimated(permuted(raw, order), {}, orientation);
  for (std::size_t i = 0; i < order.size(); ++i) BOOST_REQUIRE(other[i] == usual[order[i]]);
  Run_control parallel; // and one of the threads asks, all the time
  parallel.parallel = true;
  std::size_t questions = 0;
  parallel.callback = [&](double)
  {
    parallel.asked_time = Run_control::Clock::time_point();
    return ++questions > 0;
  };
  parallel.progress(0.);
  BOOST_CHECK(estimated(raw, parallel, orientation) == usual);
  BOOST_CHECK_GT(questions, 1u);
}

void check_few_and_degenerate(const Normal_orientation orientation)
{
  for (std::size_t n = 0; n < 20; ++n)
  {
    Raw_shape line, place;
    for (std::size_t i = 0; i < n; ++i)
    {
      add_point(line, {static_cast<double>(i * i), 0., 0.}, {});
      add_point(place, {1., 2., 3.}, {});
    }
    for (const Coordinates& normal : estimated(line, {}, orientation))
    {
      BOOST_CHECK_SMALL(normal[0], 1e-4); // across the line
      BOOST_CHECK_CLOSE(product(normal, normal), 1., 1e-3);
    }
    if (n >= 4)
      for (const Coordinates& normal : estimated(place, {}, orientation))
        BOOST_CHECK_EQUAL(normal[2], 0.);
  }
}

} // namespace

// CGAL's propagation has a third to two thirds of them right on those with walls and thin parts.
BOOST_AUTO_TEST_CASE(normals_of_made_shapes_point_outwards)
{
  for (const char* name : {"figure", "cup", "table", "chair", "thin_plate", "airplane", "hand",
                           "box", "torus", "pliers"})
    BOOST_TEST_CONTEXT(name)
    {
      const Raw_shape raw = cloud(name, 4000);
      BOOST_CHECK_GT(share_of_right(raw), 0.99);
      BOOST_CHECK_GT(share_of_right(with_holes(raw)), 0.95);
      BOOST_CHECK_GT(share_of_right(with_noise(raw, 0.003 * extent(raw))), 0.97);
    }
}

BOOST_AUTO_TEST_CASE(each_piece_has_its_own_outside)
{
  Raw_shape raw = cloud("chair", 4000);
  const double step = 2. * extent(raw);
  const Raw_shape other = cloud("torus", 3000);
  for (std::size_t i = 0; i < other.positions.size(); ++i)
    add_point(raw, plus(other.positions[i], {1., 0.3, -0.2}, step), other.normals[i]);
  BOOST_CHECK_GT(share_of_right(raw), 0.99);
}

BOOST_AUTO_TEST_CASE(what_has_no_inside_looks_upwards)
{
  Raw_shape sheet;
  add_rectangle(sheet, {0., 0., 0.}, {1., 0., 0.2}, {0., 1., 0.1}, 20, 20, {-0.2, -0.1, 1.});
  BOOST_CHECK_EQUAL(share_of_right(sheet), 1.);
}

BOOST_AUTO_TEST_CASE(a_view_of_one_side_points_to_it)
{
  const Coordinates to_camera = {0.48, -0.6, 0.64};
  for (const char* name : {"figure", "dumbbell", "hand", "pliers", "glasses"})
    BOOST_TEST_CONTEXT(name)
    {
      const Raw_shape raw = cloud(name, 4000);
      Raw_shape seen;
      for (std::size_t i = 0; i < raw.positions.size(); ++i)
        if (product(raw.normals[i], to_camera) > 0.1)
          add_point(seen, raw.positions[i], raw.normals[i]);
      BOOST_CHECK_GT(share_of_right(seen), 0.99);
    }
}

BOOST_AUTO_TEST_CASE(the_order_and_threads_change_nothing)
{
  for (const Normal_orientation orientation : orientations) check_order_and_threads(orientation);
}

// It is the quality of the fit that is tested: within 5 degrees on a sphere.
BOOST_AUTO_TEST_CASE(planes_fit)
{
  Raw_shape raw;
  add_sphere(raw, {3., 2., 1.}, 2., 3000);
  const std::vector<Coordinates> normals = estimated(raw);
  for (std::size_t i = 0; i < normals.size(); ++i)
    BOOST_REQUIRE_GT(product(normals[i], raw.normals[i]), std::cos(5. * 3.14159 / 180.));
}

// The plane through the corners of a unit square and the point above its middle: the normal is that of the
// square, the mean height 0.1 above it.
BOOST_AUTO_TEST_CASE(the_normal_and_roughness_of_five_points_are_known)
{
  Oriented_points points;
  for (const double shift : {0., 1000.}) // far away from the origin, with as many digits
  {
    const auto at = [shift](const double x, const double y, const double z)
    {
      return Vector3{static_cast<float>(x + shift), static_cast<float>(y),
                     static_cast<float>(z - shift)};
    };
    points.positions = {at(0., 0., 0.), at(1., 0., 0.), at(0., 1., 0.), at(1., 1., 0.),
                        at(0.5, 0.5, 0.5)};
    points.normals.resize(5);
    Unoriented_points shape{points, std::vector<float>(5, -1.f), {1, 2, 3, 4}, 4};
    fit_plane(shape, 0);
    BOOST_CHECK_SMALL(points.normals[0].x, 1e-5f);
    BOOST_CHECK_SMALL(points.normals[0].y, 1e-5f);
    BOOST_CHECK_CLOSE(std::abs(points.normals[0].z), 1.f, 1e-4f);
    BOOST_CHECK_CLOSE(shape.roughness[0], 0.05f - 0.01f, 1e-3f); // mean square less squared mean
  }
}

BOOST_AUTO_TEST_CASE(both_sides_of_a_thin_wall_look_outwards)
{
  constexpr std::size_t size = 6000;
  const double spacing =
      std::sqrt(2. / static_cast<double>(size));     // of a plate of 1 x 1 with two sides
  for (const double thickness : {0.7, 1., 1.5, 2.5}) // in spacings
  {
    std::mt19937 random(3);
    Raw_shape plate;
    for (std::size_t i = 0; i < size; ++i)
    {
      const double x = uniform(random), y = uniform(random);
      const bool is_above = random() % 2 == 0;
      add_point(plate, {x, y, is_above ? thickness * spacing : 0.}, {0., 0., is_above ? 1. : -1.});
    }
    BOOST_CHECK_GT(share_of_right(plate), 0.93);
  }
}

BOOST_AUTO_TEST_CASE(what_is_flat_has_no_roughness)
{
  Raw_shape sheet;
  add_rectangle(sheet, {7., 0., 0.}, {1., 0., 0.2}, {0., 1., 0.1}, 20, 20, {-0.2, -0.1, 1.});
  const std::vector<Coordinates> normals = estimated(sheet);
  for (const Coordinates& n : normals)
    BOOST_REQUIRE_GT(product(n, sheet.normals[0]), std::sqrt(1.05) * (1. - 1e-6));
}

// As the public functions of CGAL have it, in the order of the input, where walls are thick. Thin ones come
// out otherwise when a point's last digit changes.
BOOST_AUTO_TEST_CASE(orientation_by_a_spanning_tree_is_that_of_cgal)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  for (const char* name : {"torus", "figure"}) BOOST_TEST_CONTEXT(name)
    {
      const Raw_shape raw = cloud(name, 4000);
      const std::vector<Coordinates> ours = estimated(raw, {}, Normal_orientation::MST);
      std::map<Coordinates, std::size_t> index;
      std::vector<Oriented> theirs;
      for (std::size_t i = 0; i < ours.size(); ++i)
      {
        const Coordinates& p = raw.positions[i];
        index[p] = i;
        theirs.push_back({{p[0], p[1], p[2]}, {0., 0., 1.}});
      }
      const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                          .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
      CGAL::pca_estimate_normals<CGAL::Sequential_tag>(theirs, 12, np);
      BOOST_REQUIRE(CGAL::mst_orient_normals(theirs, 12, np) == theirs.end());
      std::size_t same = 0;
      for (const auto& [p, n] : theirs)
        if (product(ours[index.at({p.x(), p.y(), p.z()})], {n.x(), n.y(), n.z()}) > 0.999) ++same;
      BOOST_CHECK_GT(same, 3990u);
    }
  BOOST_CHECK_GT(share_of_right(cloud("torus", 4000), Normal_orientation::MST), 0.999);
  BOOST_CHECK_LT(share_of_right(cloud("chair", 4000), Normal_orientation::MST), 0.9);
}

// CGAL does not reach the second piece; it has its own outside nonetheless.
BOOST_AUTO_TEST_CASE(what_a_spanning_tree_does_not_reach_is_propagated)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 1000);
  add_sphere(raw, {0., 0., 5.}, 1., 1000);
  add_sphere(raw, {0., 0., -5.}, 0.5, 1000);
  BOOST_CHECK_EQUAL(share_of_right(raw, Normal_orientation::MST), 1.);
}

BOOST_AUTO_TEST_CASE(few_and_degenerate_points)
{
  for (const Normal_orientation orientation : orientations) check_few_and_degenerate(orientation);
}

// More points in one place than neighbors are looked at: they are a piece of their own, without normals.
BOOST_AUTO_TEST_CASE(heaps_of_equal_points_harm_nobody)
{
  Raw_shape raw = cloud("dumbbell", 2000);
  for (int i = 0; i < 100; ++i) add_point(raw, raw.positions[0], raw.normals[0]);
  const std::vector<Coordinates> normals = estimated(raw);
  std::size_t right = 0;
  for (std::size_t i = 1; i < 2000; ++i)
    if (product(normals[i], raw.normals[i]) > 0.) ++right;
  BOOST_CHECK_GT(right, 1980u);
  for (const Coordinates& n : normals) BOOST_REQUIRE(std::isfinite(n[0] + n[1] + n[2]));
}

// As if a tenth of a second had passed at each question: all steps ask, and each can be the last.
BOOST_AUTO_TEST_CASE(every_step_can_be_interrupted)
{
  const Raw_shape raw = cloud("box", 6000);
  std::size_t questions = 0, last = 0;
  Run_control control;
  control.callback = [&](double)
  {
    control.asked_time = Run_control::Clock::time_point();
    return ++questions != last;
  };
  const auto run = [&]
  {
    questions = 0;
    control.asking_thread = std::this_thread::get_id();
    control.asked_time = Run_control::Clock::time_point();
    estimated(raw, control);
  };
  run();
  const std::size_t all = questions;
  BOOST_CHECK_GE(all, 5u * 6000u / 1024u);
  for (last = 1; last <= all; ++last) BOOST_REQUIRE_THROW(run(), Canceled);
}

BOOST_AUTO_TEST_SUITE_END()
