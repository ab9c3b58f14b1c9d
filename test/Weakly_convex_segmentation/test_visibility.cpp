// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/visibility/Patch_visibility.h>

#include "patches_for_tests.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Lines of sight against oriented disks (sections 3 and 4) and the convexity rank (equation 1).

BOOST_AUTO_TEST_SUITE(test_visibility)

namespace {

using CGAL::Weakly_convex_segmentation::Parameters;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

constexpr float pi = 3.14159265f;

struct Scene
{
  Oriented_points points;
  Neighbor_graph graph;
  Parameters parameters;
  std::unique_ptr<Line_of_sight_query> sight;

  explicit Scene(const Raw_shape& raw, const Parameters& p = {})
    : points(orient_points(raw)), graph(build_neighbor_graph(points, 10, false)), parameters(p)
  {
    sight = std::make_unique<Line_of_sight_query>(points, graph, parameters);
    m_rank.resize(points.size());
    for (Index i = 0; i < points.size(); ++i) m_rank[points.elements[i]] = i;
    m_raw = raw;
  }

  /// the point nearest to a position of the input whose normal is within 60 degrees of `normal`
  Index at(const Coordinates& position, const Coordinates& normal) const
  {
    double best = std::numeric_limits<double>::infinity();
    Index result = 0;
    for (std::size_t i = 0; i < m_rank.size(); ++i)
    {
      const Coordinates d = plus(m_raw.positions[i], position, -1.);
      const double distance = std::hypot(d[0], d[1], d[2]);
      const Vector3 n = {float(normal[0]), float(normal[1]), float(normal[2])};
      if (distance >= best || dot(points.normals[m_rank[i]], n) < 0.5f) continue;
      best = distance;
      result = m_rank[i];
    }
    return result;
  }
  bool sees(const Index i, const Index j) const
  {
    BOOST_CHECK_EQUAL(sight->sees(i, j), sight->sees(j, i));
    return sight->sees(i, j);
  }
  std::vector<Index> all() const
  {
    std::vector<Index> result(points.size());
    for (Index i = 0; i < result.size(); ++i) result[i] = i;
    return result;
  }
  double rank() const { return convexity_rank(*sight, all(), 150, 5.); }

private:
  std::vector<Index> m_rank;
  Raw_shape m_raw;
};

Raw_shape mesh_points(const std::string& name, const std::size_t faces = 6000)
{
  return points_of_mesh(Shape_generator::make_mesh(name, faces));
}

Vector3 random_vector(std::mt19937& random, const float size)
{
  const auto number = [&] { return size * static_cast<float>(2. * uniform(random) - 1.); };
  const float x = number(), y = number();
  return {x, y, number()};
}

/// disks whose normals are all across the first axis, but for a share of `unevenness`
std::vector<Disk> random_disks(const std::size_t count, const float unevenness,
                               std::mt19937& random)
{
  std::vector<Disk> disks;
  for (std::size_t i = 0; i < count; ++i)
  {
    Vector3 normal = random_vector(random, 1.f);
    normal.x *= unevenness;
    disks.push_back({random_vector(random, 0.5f), normalized(normal),
                     0.06f * static_cast<float>(uniform(random))});
  }
  return disks;
}

/// returns where the line crosses the disk, as a factor of its direction; infinity if it does not, or
/// if the disk's center is within `clearance` radii of an end: the ends lie on the surface, and disks
/// there would hide every point behind its own neighborhood. Nor does a line count that grazes the
/// disk: the sine of the angle between them is under `least_sine`.
float crossing(const Line_of_sight& line, const Disk& disk, const float clearance,
               const float least_sine = 0.f)
{
  constexpr float none = (std::numeric_limits<float>::max)();
  const float slope = dot(disk.normal, line.direction);
  if (slope == 0.f) return none;
  if (slope * slope < least_sine * least_sine * squared_length(line.direction)) return none;
  const Vector3 to_center = disk.center - line.source;
  const float t = dot(disk.normal, to_center) / slope;
  if (!(t > 0.f && t < line.limit)) return none;
  const float r2 = disk.radius * disk.radius;
  if (squared_length(t * line.direction - to_center) > r2) return none;
  const float cleared = clearance * clearance * r2;
  if (squared_length(to_center) < cleared) return none;
  if (squared_length(to_center - line.direction) < cleared) return none;
  return t;
}

/// the definition in double precision; the last argument receives how near the decision was
bool occludes(const Disk& disk, const Vector3& p, const Vector3& q, const double clearance,
              const double least_sine, double& margin)
{
  const auto product = [](const Vector3& a, const Vector3& b)
  { return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z; };
  const Vector3 direction = q - p, to_center = disk.center - p;
  const double t = product(disk.normal, to_center) / product(disk.normal, direction);
  const Vector3 miss = static_cast<float>(t) * direction - to_center;
  const double from_center = std::sqrt(product(miss, miss)) - disk.radius;
  const double from_p = length(disk.center - p) - clearance * disk.radius;
  const double from_q = length(disk.center - q) - clearance * disk.radius;
  const double sine =
      std::abs(product(disk.normal, direction)) / std::sqrt(product(direction, direction));
  margin = (std::min)({std::abs(t), std::abs(1. - t), std::abs(from_center), std::abs(from_p),
                       std::abs(from_q), least_sine > 0. ? std::abs(sine - least_sine) : 1.});
  return t > 0. && t < 1. && from_center < 0. && from_p > 0. && from_q > 0. && sine >= least_sine;
}

/// a pipe along z from 0 to 1: an outer wall of radius 1 and an inner one of radius 0.8
Raw_shape pipe()
{
  Raw_shape raw;
  for (int i = 0; i < 150; ++i)
    for (int j = 0; j < 26; ++j)
    {
      const double a = 2. * static_cast<double>(pi) * i / 150., z = j / 25.;
      const Coordinates out = {std::cos(a), std::sin(a), 0.};
      add_point(raw, plus({0., 0., z}, out), out);
      add_point(raw, plus({0., 0., z}, out, 0.8), {-out[0], -out[1], 0.});
    }
  return raw;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_line_crosses_a_disk)
{
  const Disk disk = {{0.f, 0.f, 0.5f}, {0.f, 0.f, 1.f}, 0.1f};
  const auto where = [&](const Vector3& p, const Vector3& q, const float clearance)
  { return crossing(Line_of_sight(p, q), disk, clearance); };
  constexpr float none = (std::numeric_limits<float>::max)();
  const Vector3 below = {0.05f, 0.f, 0.f}, above = {0.05f, 0.f, 2.f};
  BOOST_CHECK_CLOSE(where(below, above, 2.f), 0.25f, 1e-3);
  BOOST_CHECK_CLOSE(where(above, below, 2.f), 0.75f, 1e-3);
  BOOST_CHECK_EQUAL(where({0.2f, 0.f, 0.f}, {0.2f, 0.f, 1.f}, 2.f), none);  // beside
  BOOST_CHECK_EQUAL(where({0.f, 0.f, 0.f}, {0.f, 0.f, 0.4f}, 0.f), none);   // ends before
  BOOST_CHECK_EQUAL(where({-1.f, 0.f, 0.5f}, {1.f, 0.f, 0.5f}, 0.f), none); // in its plane
  BOOST_CHECK_EQUAL(where(below, below, 2.f), none);                        // no line at all
  // an end nearer than the clearance
  BOOST_CHECK_EQUAL(where(below, above, 6.f), none);
  BOOST_CHECK_NE(where(below, above, 5.f), none);
  BOOST_CHECK_EQUAL(where(above, below, 6.f), none);
}

/// compares lines and rays through a tree with all disks
struct Tree_check
{
  std::size_t hits = 0, misses = 0, exits = 0, unclear = 0, grazing = 0;

  void line(const Disk_tree& tree, const std::vector<Disk>& disks, const float clearance,
            const float least_sine, const Vector3& p, const Vector3& q)
  {
    bool hit = false, steep_or_not = false, clear = true;
    for (const Disk& disk : disks)
    {
      double margin = 0.;
      hit = occludes(disk, p, q, clearance, least_sine, margin) || hit;
      clear = clear && margin > 1e-5;
      BOOST_REQUIRE(margin < 1e-5 ||
                    occludes(disk, p, q, clearance, least_sine, margin) ==
                        (crossing(Line_of_sight(p, q), disk, clearance, least_sine) < 1.f));
      steep_or_not = steep_or_not || occludes(disk, p, q, clearance, 0., margin);
    }
    const bool found = !tree.unoccluded(p, q);
    if (clear) BOOST_REQUIRE_EQUAL(found, hit);
    unclear += clear ? 0 : 1;
    (hit ? hits : misses) += 1;
    grazing += steep_or_not && !hit ? 1 : 0;
  }
  void ray(const Disk_tree& tree, const std::vector<Disk>& disks, const float clearance,
           const Vector3& p, const Vector3& direction)
  {
    float first = std::numeric_limits<float>::infinity();
    const Line_of_sight line(p, p + 2.f * direction); // no clearance at the end of a ray
    for (const Disk& disk : disks)
      if (dot(disk.normal, direction) > 0.f)
      {
        const float t = crossing(line, disk, clearance);
        if (t < 0.5f) first = (std::min)(first, 2.f * t);
      }
    const auto exit = tree.first_exit(p, direction, 1.f);
    BOOST_REQUIRE_EQUAL(std::isfinite(exit.distance), std::isfinite(first));
    if (!std::isfinite(first)) return;
    ++exits;
    BOOST_REQUIRE_CLOSE(exit.distance, first, 1e-3);
  }
};

BOOST_AUTO_TEST_CASE(the_tree_finds_what_brute_force_finds)
{
  std::mt19937 random(1);
  Tree_check check;
  const float clearance = 2.f;
  for (const std::size_t count : {1u, 2u, 3u, 40u, 700u})
    for (const float unevenness : {1.f, 0.02f})
      for (const float least_sine : {0.f, 0.3f})
      {
        const std::vector<Disk> disks = random_disks(count, unevenness, random);
        const Disk_tree tree(disks, clearance, least_sine);
        BOOST_CHECK_EQUAL(tree.size(), count);
        for (int line = 0; line < 400; ++line)
        {
          const Vector3 p = random_vector(random, 0.6f);
          Vector3 q = random_vector(random, 0.6f);
          if (line % 2 == 0)
            q = {q.x, p.y + 0.05f * q.y, p.z + 0.05f * q.z}; // along the first axis
          check.line(tree, disks, clearance, least_sine, p, q);
          check.ray(tree, disks, clearance, p, normalized(q - p));
        }
      }
  BOOST_CHECK_GT(check.hits, 300u);
  BOOST_CHECK_GT(check.misses, 300u);
  BOOST_CHECK_GT(check.exits, 300u);
  BOOST_CHECK_GT(check.grazing, 10u);
  BOOST_CHECK_LT(check.unclear, (check.hits + check.misses) / 10);
}

BOOST_AUTO_TEST_CASE(the_bound_of_normals_holds_and_is_tight_along_a_wire)
{
  std::mt19937 random(2);
  for (const float unevenness : {1.f, 0.1f, 0.001f, 0.f})
  {
    const std::vector<Disk> disks = random_disks(300, unevenness, random);
    std::vector<Vector3> normals;
    for (const Disk& disk : disks) normals.push_back(disk.normal);
    const Slope_bound bound(normals);
    for (int line = 0; line < 300; ++line)
    {
      const Vector3 direction = random_vector(random, 1.f);
      float steepest = 0.f;
      for (const Disk& disk : disks)
        steepest = (std::max)(steepest, std::abs(dot(disk.normal, direction)));
      BOOST_REQUIRE_GE(bound.squared_slope(direction), steepest * steepest);
      BOOST_REQUIRE_LE(bound.least_squared_slope() * squared_length(direction),
                       1.0001 * bound.squared_slope(direction));
    }
    const double along = bound.squared_slope({1.f, 0.f, 0.f});
    BOOST_CHECK_GE(along, bound.least_squared_slope());
    if (unevenness < 0.01f) BOOST_CHECK_LT(along, 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(first_exit_stops_at_its_reach)
{
  const std::vector<Disk> disks = {{{0.f, 0.f, 0.5f}, {0.f, 0.f, 1.f}, 0.1f},
                                   {{0.f, 0.f, 0.8f}, {0.f, 0.f, 1.f}, 0.1f},
                                   {{0.f, 0.f, 0.3f}, {0.f, 0.f, -1.f}, 0.1f}};
  const Disk_tree tree(disks, 1.f);
  const Vector3 up = {0.f, 0.f, 1.f};
  BOOST_CHECK_CLOSE(tree.first_exit({0.f, 0.f, 0.f}, up, 1.f).distance, 0.5f, 1e-3); // not 0.3
  BOOST_CHECK(std::isinf(tree.first_exit({0.f, 0.f, 0.f}, up, 0.49f).distance));
  BOOST_CHECK_CLOSE(tree.first_exit({0.f, 0.f, 0.f}, up, 0.51f).distance, 0.5f,
                    1e-3); // near the end
  BOOST_CHECK_CLOSE(tree.first_exit({0.f, 0.f, 0.f}, up, 10.f).distance, 0.5f, 1e-3);
  BOOST_CHECK(std::isinf(tree.first_exit({0.f, 0.5f, 0.f}, up, 10.f).distance));
}

BOOST_AUTO_TEST_CASE(all_points_of_a_sphere_see_each_other)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 3000);
  const Scene scene(raw);
  std::size_t blind = 0;
  for (Index i = 0; i < 3000; i += 17)
    for (Index j = 0; j < i; j += 13) blind += scene.sees(i, j) ? 0 : 1;
  BOOST_CHECK_EQUAL(blind, 0u);
}

BOOST_AUTO_TEST_CASE(walls_occlude_and_a_cavity_counts_as_far_as_is_tolerated)
{
  const Scene scene(pipe());
  const Coordinates left = {-1., 0., 0.}, right = {1., 0., 0.};
  const Index outer_left = scene.at({-1., 0., 0.5}, left),
              outer_right = scene.at({1., 0., 0.5}, right);
  const Index inner_left = scene.at({-0.8, 0., 0.5}, right);
  const Index inner_right = scene.at({0.8, 0., 0.5}, left);
  BOOST_CHECK(!scene.sees(outer_left, outer_right)); // two walls between them
  BOOST_CHECK(!scene.sees(outer_left, inner_right)); // one
  BOOST_CHECK(scene.sees(outer_left, inner_left));   // through the material
  BOOST_CHECK(scene.sees(inner_left, inner_right));  // across the cavity: tolerated by 90 degrees
  BOOST_CHECK(!scene.sight->sees_inside(inner_left, inner_right, 5.));
  BOOST_CHECK(scene.sight->sees_inside(outer_left, inner_left, 5.));
}

BOOST_AUTO_TEST_CASE(a_line_round_the_corner_of_an_l_is_occluded)
{
  const Scene scene(mesh_points("l_shape"));
  const Index foot = scene.at({0.5, 0., 0.15}, {1., 0., 0.});
  const Index top = scene.at({-0.25, 0., 1.}, {0., 0., 1.});
  const Index heel = scene.at({-0.4, 0., 0.15}, {-1., 0., 0.});
  BOOST_CHECK(!scene.sees(foot, top));
  BOOST_CHECK(scene.sees(foot, heel));
  BOOST_CHECK(scene.sees(top, heel));
}

BOOST_AUTO_TEST_CASE(a_rough_flat_surface_does_not_blind_its_points_where_grazing_lines_pass)
{
  std::mt19937 random(3);
  Raw_shape raw; // a square with bumps of a fiftieth of the distance between points
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j)
      add_point(raw, {i / 60., j / 60., uniform(random) / 3000.}, {0., 0., 1.});
  const auto share_seen = [&](const double tolerance)
  {
    Parameters parameters;
    parameters.grazing_tolerance = tolerance;
    const Scene scene(raw, parameters);
    std::size_t seen = 0, all = 0;
    for (Index i = 0; i < 3600; i += 37)
      for (Index j = 0; j < i; j += 41, ++all) seen += scene.sees(i, j) ? 1 : 0;
    return static_cast<double>(seen) / static_cast<double>(all);
  };
  BOOST_CHECK_LT(share_seen(0.), 0.5);
  BOOST_CHECK_GT(share_seen(2.), 0.95);
}

BOOST_AUTO_TEST_CASE(visibility_of_patches_is_symmetric_and_kept)
{
  Parameters parameters;
  const Scene scene(mesh_points("l_shape"), parameters);
  const Patches patches = one_patch_set(scene.points, scene.graph, parameters);
  parameters.maximum_rays_per_pair = 0;
  Patch_visibility full(*scene.sight, patches, parameters, false);
  Patch_visibility mirrored(*scene.sight, patches, parameters, false);
  parameters.maximum_rays_per_pair = 100;
  Patch_visibility early(*scene.sight, patches, parameters, false);
  BOOST_REQUIRE_EQUAL(full.number_of_patches(), patches.size());
  const int n = static_cast<int>(patches.size());
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) pairs.push_back({a, b});
  mirrored.prepare(pairs);
  double difference = 0.;
  std::size_t blind = 0;
  for (const auto& [a, b] : pairs)
  {
    const double ratio = full(a, b);
    BOOST_REQUIRE(ratio >= 0. && ratio <= 1.);
    BOOST_REQUIRE_EQUAL(full(b, a), ratio);
    BOOST_REQUIRE_EQUAL(mirrored(b, a), ratio);
    if (ratio == 0. || ratio == 1.) BOOST_REQUIRE_EQUAL(early(a, b), ratio);
    difference += std::abs(early(a, b) - ratio);
    blind += ratio == 0. ? 1 : 0;
  }
  BOOST_CHECK_LT(difference / static_cast<double>(pairs.size()), 0.03); // two rays decide most
  BOOST_CHECK_GT(blind, pairs.size() / 20);                             // round the corner
}

BOOST_AUTO_TEST_CASE(lines_are_cast_when_asked_for_and_once)
{
  const Parameters parameters;
  const Scene scene(mesh_points("l_shape"), parameters);
  const Patches patches = one_patch_set(scene.points, scene.graph, parameters);
  std::size_t lines = 0;
  Line_of_sight_functions counting;
  counting.sees = [&lines](const Coordinates&, const Coordinates&)
  {
    ++lines;
    return true;
  };
  const Line_of_sight_query sight(scene.points, scene.graph, parameters, counting);
  Patch_visibility visibility(sight, patches, parameters, false);
  BOOST_CHECK_EQUAL(lines, 0u);
  visibility(1, 0);
  const std::size_t of_pair = lines;
  BOOST_CHECK_GT(of_pair, 0u);
  visibility(0, 1);
  visibility.prepare({{0, 1}});
  BOOST_CHECK_EQUAL(lines, of_pair);
}

BOOST_AUTO_TEST_CASE(samples_are_spread_over_a_patch)
{
  const std::vector<Index> members = {3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  BOOST_CHECK(spread_sample(members, 10) == members);
  BOOST_CHECK(spread_sample(members, 99) == members);
  BOOST_CHECK((spread_sample(members, 2) == std::vector<Index>{5, 10}));
  BOOST_CHECK((spread_sample(members, 1) == std::vector<Index>{8}));
}

BOOST_AUTO_TEST_CASE(convexity_rank_of_known_shapes)
{
  BOOST_CHECK_GT(Scene(mesh_points("sphere")).rank(), 0.99);
  BOOST_CHECK_GT(Scene(mesh_points("box")).rank(), 0.99);
  const double l_shape = Scene(mesh_points("l_shape")).rank();
  BOOST_CHECK_GT(l_shape, 0.4);
  BOOST_CHECK_LT(l_shape, 0.85);
  BOOST_CHECK_LT(Scene(mesh_points("torus")).rank(), 0.75);
  BOOST_CHECK_LT(Scene(mesh_points("cup")).rank(), 0.5);
}

BOOST_AUTO_TEST_CASE(convexity_rank_of_a_subset_is_its_own)
{
  const Raw_shape raw = mesh_points("l_shape");
  const Scene scene(raw);
  std::vector<Index> foot;
  for (Index i = 0; i < scene.points.size(); ++i)
    if (raw.positions[scene.points.elements[i]][2] < 0.3) foot.push_back(i);
  BOOST_CHECK_GT(convexity_rank(*scene.sight, foot, 100, 5.), 0.95);
  BOOST_CHECK_EQUAL(convexity_rank(*scene.sight, {}, 100, 5.), 1.);
  BOOST_CHECK_EQUAL(convexity_rank(*scene.sight, {7}, 100, 5.), 1.);
}

BOOST_AUTO_TEST_CASE(equation_1_by_hand)
{
  // A and B on one side of a wall, C on the other; each is a heap of equal points, whose disks have
  // no size, and all lie in the plane of their normals' tangents
  Raw_shape raw;
  const Coordinates y = {0., 1., 0.};
  for (int i = 0; i < 12; ++i) add_point(raw, {-1., 0., 0.}, y);
  for (int i = 0; i < 12; ++i) add_point(raw, {-1., 0., 1.}, y);
  for (int i = 0; i < 12; ++i) add_point(raw, {1., 0., 0.5}, y);
  add_rectangle(raw, {0., -0.5, -0.5}, {0., 0.05, 0.}, {0., 0., 0.05}, 20, 40, {1., 0., 0.});
  const Scene scene(raw);
  const Index a = scene.at({-1., 0., 0.}, y), b = scene.at({-1., 0., 1.}, y);
  const Index c = scene.at({1., 0., 0.5}, y);
  BOOST_CHECK(scene.sees(a, b));
  BOOST_CHECK(!scene.sees(a, c));
  BOOST_CHECK_CLOSE(convexity_rank(*scene.sight, {a, b, c}, 10, 5.), 5. / 9., 1e-6);
  BOOST_CHECK_CLOSE(convexity_rank(*scene.sight, {a, c}, 10, 5.), 0.5, 1e-6);
  BOOST_CHECK_EQUAL(convexity_rank(*scene.sight, {a, b}, 10, 5.), 1.);
}

BOOST_AUTO_TEST_SUITE_END()
