// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/points/denoise_points.h>

#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Smoothing of what has too much noise, and of nothing else.

BOOST_AUTO_TEST_SUITE(test_denoise_points)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

/// points as the method sees them, and their graph
struct Surface
{
  Oriented_points points;
  Neighbor_graph graph;

  explicit Surface(const Raw_shape& raw)
    : points(orient_points(raw)), graph(build_neighbor_graph(points, 10, false))
  {}
  std::size_t smooth() { return denoise_points(graph, points); }
};

/// `positions` and `normals`: largest change of a coordinate
Raw_shape with_noise(Raw_shape raw, const double positions, const double normals,
                     const unsigned int seed)
{
  std::mt19937 random(seed);
  const auto number = [&](const double size) { return size * (2. * uniform(random) - 1.); };
  for (auto& p : raw.positions)
    p = {p[0] + number(positions), p[1] + number(positions), p[2] + number(positions)};
  for (auto& n : raw.normals)
    n = {n[0] + number(normals), n[1] + number(normals), n[2] + number(normals)};
  return raw;
}

/// mean angle in degrees to the normals of a sphere about the origin, and mean distance to it
std::pair<double, double> errors_on_sphere(const Oriented_points& points, const float radius)
{
  double turn = 0., away = 0.;
  for (Index i = 0; i < points.size(); ++i)
  {
    turn += angle(points.normals[i], normalized(points.positions[i])) / radians(1.);
    away += std::abs(length(points.positions[i]) - radius);
  }
  const auto n = static_cast<double>(points.size());
  return {turn / n, away / n};
}

} // namespace

BOOST_AUTO_TEST_CASE(shapes_without_noise_are_left_as_they_are)
{
  for (const std::string& name : Shape_generator::shape_names())
  {
    BOOST_TEST_CONTEXT(name)
    {
      Surface surface(points_of_mesh(Shape_generator::make_mesh(name, 6000)));
      const auto before = surface.points.positions;
      BOOST_CHECK_LT(roughness(surface.graph), 0.7f * noise_tolerance);
      BOOST_CHECK_EQUAL(surface.smooth(), 0u);
      for (std::size_t i = 0; i < before.size(); ++i)
        BOOST_REQUIRE_EQUAL(length(before[i] - surface.points.positions[i]), 0.f);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_rough_sphere_becomes_a_smooth_one)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 4000); // points are about 0.056 apart
  Surface surface(with_noise(raw, 0.015, 0.4, 1));
  const float radius = static_cast<float>(1. / surface.points.extent);
  const auto [turn, away] = errors_on_sphere(surface.points, radius);
  BOOST_CHECK_GT(turn, 10.);
  BOOST_CHECK_GT(surface.smooth(), 0u);
  const auto [turn_after, away_after] = errors_on_sphere(surface.points, radius);
  BOOST_CHECK_LT(turn_after, 0.4 * turn);
  BOOST_CHECK_LT(away_after, 0.7 * away);
  BOOST_CHECK_LT(roughness(surface.graph), noise_tolerance);
  for (Index i = 0; i < surface.points.size(); ++i) // the graph is that of the smoothed points
    for (const Neighbor& edge : surface.graph[i])
    {
      BOOST_REQUIRE_EQUAL(edge.concavity, signed_concavity(surface.points, i, edge.point));
      BOOST_REQUIRE_EQUAL(
          edge.length, length(surface.points.positions[edge.point] - surface.points.positions[i]));
    }
}

BOOST_AUTO_TEST_CASE(noise_shows_in_positions_where_it_spares_the_normals)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 4000);
  Surface clean(raw);
  BOOST_CHECK_LT(normal_position_mismatch(clean.graph, clean.points), 0.1f * noise_tolerance);
  {
    // little noise leaves the normals as they are
    Surface surface(with_noise(raw, 0.018, 0., 4));
    const std::vector<Vector3> normals = surface.points.normals;
    BOOST_CHECK_GT(surface.smooth(), 0u);
    for (std::size_t i = 0; i < normals.size(); ++i)
      BOOST_REQUIRE_EQUAL(length(normals[i] - surface.points.normals[i]), 0.f);
  }
  Surface surface(with_noise(raw, 0.03, 0., 3));
  const float radius = static_cast<float>(1. / surface.points.extent);
  const double away = errors_on_sphere(surface.points, radius).second;
  BOOST_CHECK_LT(roughness(surface.graph), noise_tolerance);
  BOOST_CHECK_GT(normal_position_mismatch(surface.graph, surface.points), 4.f * noise_tolerance);
  BOOST_CHECK_GT(surface.smooth(), 0u);
  BOOST_CHECK_LT(errors_on_sphere(surface.points, radius).second, 0.6 * away);
  BOOST_CHECK_LT(normal_position_mismatch(surface.graph, surface.points), 2.f * noise_tolerance);
}

BOOST_AUTO_TEST_CASE(points_of_mixed_orientations_are_thinned_to_two_sides)
{
  // the two sides of a plate, mixed by noise; normals that are wrong by 45 degrees and often more
  Raw_shape raw;
  const int n = 170;
  const double step = 1. / n;
  add_rectangle(raw, {0., 0., 0.}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., -1.});
  add_rectangle(raw, {0., 0., 0.01}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., 1.});
  const std::vector<Coordinates> given = raw.normals;
  const Oriented_points points = orient_points(with_noise(raw, 0.01, 1., 5));
  const auto counted = [&points](const Representatives& chosen)
  {
    std::map<std::uint64_t, std::set<Index>> in_voxel;
    const float side = voxel_side(points, 4000);
    std::size_t most = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      auto& of_voxel = in_voxel[voxel_key(points.positions[i], side)];
      of_voxel.insert(chosen.of_point[i]);
      most = (std::max)(most, of_voxel.size());
    }
    return most;
  };
  BOOST_CHECK_GT(counted(downsample(points, 4000)), 3u);
  const Representatives chosen = downsample(points, 4000, false, true);
  BOOST_CHECK_EQUAL(counted(chosen), 2u);
  std::size_t right = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float z = static_cast<float>(given[points.elements[i]][2]);
    right += z * chosen.points.normals[chosen.of_point[i]].z > 0.5f ? 1 : 0;
  }
  BOOST_CHECK_GT(right, points.size() * 9 / 10);

  // a shape without noise is thinned as ever
  const Oriented_points smooth =
      orient_points(points_of_mesh(Shape_generator::make_mesh("hand", 12000)));
  BOOST_CHECK(downsample(smooth, 3000, false, true).of_point == downsample(smooth, 3000).of_point);
}

BOOST_AUTO_TEST_CASE(the_sides_of_a_thin_plate_stay_apart)
{
  Raw_shape raw;
  const int n = 60;
  const double step = 1. / n, thickness = 0.7 * step;
  add_rectangle(raw, {0., 0., 0.}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., -1.});
  add_rectangle(raw, {0., 0., thickness}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., 1.});
  const std::vector<Coordinates> given = raw.normals;
  Surface surface(with_noise(raw, 0.1 * step, 0.25, 2));
  BOOST_CHECK_GT(surface.smooth(), 0u);
  double gap = 0.;
  for (Index i = 0; i < surface.points.size(); ++i)
  {
    const float side = static_cast<float>(given[surface.points.elements[i]][2]);
    BOOST_REQUIRE_GT(side * surface.points.normals[i].z, 0.9f);
    gap += 2. * side * surface.points.positions[i].z / static_cast<double>(surface.points.size());
  }
  BOOST_CHECK_CLOSE(gap * surface.points.extent, thickness, 10.);
}

BOOST_AUTO_TEST_CASE(parts_of_a_rough_mesh_are_those_of_the_smooth_one)
{
  double sum = 0.; // of what moves by the default without denoising
  for (const std::string name : {"box", "torus", "thin_plate", "table", "chair", "airplane"})
  {
    BOOST_TEST_CONTEXT(name)
    {
      const auto smooth = points_of_mesh(Shape_generator::make_mesh(name, 6000));
      const auto rough = points_of_mesh(shaken(Shape_generator::make_mesh(name, 6000), 0.006, 4));
      const auto moved = [&](const Parameters& parameters, const bool denoise)
      {
        Parameters for_rough = parameters;
        for_rough.denoise = denoise;
        return rand_distance(Compiled_core::segment_points(rough, for_rough, {}).labels,
                             Compiled_core::segment_points(smooth, parameters, {}).labels);
      };
      for (const Parameters& preset : {Parameters(), Parameters::training_free()})
        BOOST_CHECK_LT(moved(preset, true), 0.06);
      sum += moved(Parameters(), false);
      BOOST_CHECK_GT(moved(Parameters::training_free(), false),
                     0.2); // the default bears some noise
    }
  }
  BOOST_CHECK_GT(sum / 6., 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
