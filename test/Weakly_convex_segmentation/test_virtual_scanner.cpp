// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "scanner/virtual_scanner.h"
#include "scenes/scene_scores.h"
#include "shapes/shape_generator.h"

#include <cmath>
#include <set>

BOOST_AUTO_TEST_SUITE(test_virtual_scanner)

namespace VS = Virtual_scanner;

namespace {

double dot(const VS::Point& a, const VS::Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const VS::Point& a) { return std::sqrt(dot(a, a)); }

const Shape_generator::Labeled_mesh& sphere()
{
  static const auto mesh = Shape_generator::make_mesh("sphere", 6000);
  return mesh;
}

VS::Point radial(const VS::Point& p)
{
  const VS::Point c = VS::bounding_sphere(sphere()).center;
  const VS::Point d = {p[0] - c[0], p[1] - c[1], p[2] - c[2]};
  const double l = length(d);
  return {d[0] / l, d[1] / l, d[2] / l};
}

} // namespace

BOOST_AUTO_TEST_CASE(one_view_of_a_sphere_is_less_than_half_of_it_and_faces_the_camera)
{
  const VS::Scan scan = VS::scan_mesh(sphere(), 1, {}, 3);
  const VS::Point eye = VS::view_directions(1, 3).front();
  BOOST_TEST_REQUIRE(scan.points.size() > 1000);
  BOOST_TEST(scan.normals.size() == scan.points.size());
  BOOST_TEST(scan.faces.size() == scan.points.size());
  BOOST_TEST(scan.views.size() == scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    BOOST_REQUIRE_GT(dot(radial(scan.points[i]), eye), 0.);
    BOOST_REQUIRE_CLOSE(length(scan.normals[i]), 1., 1e-6);
    BOOST_REQUIRE_GT(dot(scan.normals[i], radial(scan.points[i])), 0.9);
  }
}

BOOST_AUTO_TEST_CASE(points_lie_on_the_faces_that_they_name)
{
  const auto mesh = Shape_generator::make_mesh("cup", 6000);
  const VS::Scan scan = VS::scan_mesh(mesh, 3, {}, 1);
  const double diameter = VS::bounding_sphere(mesh).diameter;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const VS::Point n = VS::internal::face_normal(mesh, scan.faces[i]);
    const VS::Point& corner = mesh.points[mesh.faces[scan.faces[i]][0]];
    const VS::Point d = {scan.points[i][0] - corner[0], scan.points[i][1] - corner[1],
                         scan.points[i][2] - corner[2]};
    BOOST_REQUIRE_SMALL(dot(n, d) / diameter, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(more_views_see_more_faces)
{
  std::size_t before = 0;
  for (const std::size_t views : {1, 4, 16})
  {
    const VS::Scan scan = VS::scan_mesh(sphere(), views, {}, 0);
    const std::set<std::size_t> seen(scan.faces.begin(), scan.faces.end());
    BOOST_TEST(seen.size() > before);
    before = seen.size();
    BOOST_TEST(std::set<int>(scan.views.begin(), scan.views.end()).size() == views);
  }
  BOOST_TEST(before > sphere().faces.size() * 9 / 10);
}

BOOST_AUTO_TEST_CASE(noise_has_its_size_and_moves_points_along_the_ray)
{
  VS::Camera camera;
  camera.noise = 0.005;
  const VS::Scan scan = VS::scan_mesh(sphere(), 1, camera, 0);
  const VS::Bounding_sphere ball = VS::bounding_sphere(sphere());
  const VS::Point direction = VS::view_directions(1, 0).front();
  double sum = 0., count = 0.;
  for (const VS::Point& p : scan.points)
  {
    if (dot(radial(p), direction) < 0.9) continue; // where the ray is nearly normal to the sphere
    const VS::Point d = {p[0] - ball.center[0], p[1] - ball.center[1], p[2] - ball.center[2]};
    sum += std::pow(length(d) / ball.diameter - 0.5, 2);
    count += 1.;
  }
  const double deviation = std::sqrt(sum / count);
  BOOST_TEST(deviation > 0.004);
  BOOST_TEST(deviation < 0.006);
}

BOOST_AUTO_TEST_CASE(grazed_surface_returns_nothing)
{
  VS::Camera camera;
  camera.grazing_angle = 30.;
  const VS::Scan scan = VS::scan_mesh(sphere(), 1, camera, 0);
  const std::size_t all = VS::scan_mesh(sphere(), 1, {}, 0).points.size();
  BOOST_TEST(scan.points.size() < all / 2);
  BOOST_TEST(scan.points.size() > 0u);
}

BOOST_AUTO_TEST_CASE(the_seed_decides_all)
{
  const VS::Camera camera = VS::realistic_camera();
  BOOST_TEST((VS::scan_mesh(sphere(), 2, camera, 5).points ==
              VS::scan_mesh(sphere(), 2, camera, 5).points));
  BOOST_TEST((VS::scan_mesh(sphere(), 2, camera, 5).points !=
              VS::scan_mesh(sphere(), 2, camera, 6).points));
}

BOOST_AUTO_TEST_CASE(bad_cameras_and_meshes_are_refused)
{
  VS::Camera inside;
  inside.distance = 0.2;
  BOOST_CHECK_THROW(VS::scan_mesh(sphere(), 1, inside, 0), std::invalid_argument);
  VS::Camera blind;
  blind.resolution = 0;
  BOOST_CHECK_THROW(VS::scan_mesh(sphere(), 1, blind, 0), std::invalid_argument);
  BOOST_CHECK_THROW(VS::scan_mesh(Shape_generator::Labeled_mesh(), 1, {}, 0),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(scene_scores_of_known_segments)
{
  // object 2 whole, object 3 halved; one table point is wrongly in segment 1
  const std::vector<int> objects = {-1, -1, 2, 2, 2, 2, 3, 3, 3, 3};
  const std::vector<int> segments = {-1, 1, 1, 1, 1, 1, 4, 4, 5, 5};
  const Scene_scores::Scores s = Scene_scores::score(objects, segments);
  BOOST_TEST(s.over_segmentation == 2. / 8., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(s.under_segmentation == 1. / 8., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(s.weighted_overlap == (4. * 0.8 + 4. * 0.5) / 8., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(s.unweighted_overlap == 0.65, boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_THROW(Scene_scores::score({-1}, {0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
