// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts as closed solids, and as nearly convex ones.

#include <boost/test/unit_test.hpp>

#include "io/closed_parts.h"
#include "io/convex_division.h"
#include "io/part_hulls.h"
#include "io/shape_io.h"
#include "run_program.h"
#include "scratch_folder.h"
#include "shapes/shape_generator.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_solids)

namespace {

using Shape_io::Closed_part;
using Shape_io::Point;
using Shape_io::Shape;

Shape shape_of(const Shape_generator::Labeled_mesh& mesh)
{
  Shape shape;
  for (const auto& p : mesh.points) shape.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : mesh.faces) shape.polygons.emplace_back(f.begin(), f.end());
  return shape;
}

double volume(const Shape& shape)
{
  double sum = 0.;
  for (const auto& polygon : shape.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum += CGAL::volume(shape.points[0], shape.points[polygon[0]], shape.points[polygon[i - 1]],
                          shape.points[polygon[i]]);
  return sum;
}

std::size_t number_of(const std::vector<int>& labels)
{
  return static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end())) + 1;
}

// What CGAL says of a solid: closed, with one orientation, not crossing itself.
bool is_solid(const Shape& shape)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Point> points = shape.points;
  auto polygons = shape.polygons;
  if (!PMP::orient_polygon_soup(points, polygons) || polygons != shape.polygons ||
      !PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return false;
  CGAL::Surface_mesh<Point> mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return CGAL::is_closed(mesh) && !PMP::does_self_intersect(mesh);
}

// The labels of the faces, by where they are.
template <typename Label_at>
std::vector<int> labels_by(const Shape& shape, const Label_at& label_at)
{
  std::vector<int> labels;
  for (const auto& f : shape.polygons)
    labels.push_back(
        label_at(CGAL::centroid(shape.points[f[0]], shape.points[f[1]], shape.points[f[2]])));
  return labels;
}

void check_solids(const Shape& shape, const std::vector<int>& labels)
{
  const std::vector<Closed_part> parts = Shape_io::closed_parts(shape, labels, number_of(labels));
  BOOST_TEST_REQUIRE(parts.size() == number_of(labels));
  double sum = 0.;
  for (std::size_t i = 0; i < parts.size(); ++i) BOOST_TEST_CONTEXT("part " << i)
    {
      BOOST_TEST(parts[i].fault == "");
      BOOST_TEST(is_solid(parts[i].shape));
      BOOST_TEST(volume(parts[i].shape) > 0.);
      BOOST_TEST(std::is_sorted(parts[i].source_faces.begin(), parts[i].source_faces.end()));
      sum += volume(parts[i].shape);
    }
  BOOST_TEST(sum == volume(shape), boost::test_tools::tolerance(1e-6));
}

} // namespace

BOOST_AUTO_TEST_CASE(parts_of_made_shapes_are_closed_and_their_volumes_add_up)
{
  for (const std::string& name : Shape_generator::shape_names()) BOOST_TEST_CONTEXT(name)
    {
      const auto mesh = Shape_generator::make_mesh(name, 6000);
      check_solids(shape_of(mesh), mesh.labels);
    }
}

BOOST_AUTO_TEST_CASE(parts_meet_inside_where_three_or_more_meet_outside)
{
  const Shape ball = shape_of(Shape_generator::make_mesh("sphere", 4000));
  const auto part_of_three = [](const Point& p)
  { return static_cast<int>((std::atan2(p.y(), p.x()) / CGAL_PI + 1.) * 1.4999); };
  check_solids(ball, labels_by(ball, part_of_three));
  // four meet in the middle
  const auto part_of_four = [](const Point& p)
  {
    const double at[] = {p.x() + p.y() + p.z(), p.x() - p.y() - p.z(), p.y() - p.x() - p.z(),
                         p.z() - p.x() - p.y()};
    return static_cast<int>(std::max_element(at, at + 4) - at);
  };
  const std::vector<int> four = labels_by(ball, part_of_four);
  check_solids(ball, four);
  for (const Closed_part& part : Shape_io::closed_parts(ball, four, 4))
    BOOST_TEST(volume(part.shape) == volume(ball) / 4., boost::test_tools::tolerance(.05));
}

BOOST_AUTO_TEST_CASE(a_cut_through_a_hollow_shape_is_a_ring)
{
  const Shape torus = shape_of(Shape_generator::make_mesh("torus", 6000));
  // across the axis: two rings, one in the other
  const std::vector<int> halves =
      labels_by(torus, [](const Point& p) { return p.z() + 1e-3 > 0. ? 0 : 1; });
  check_solids(torus, halves);
  for (const Closed_part& part : Shape_io::closed_parts(torus, halves, 2))
    BOOST_TEST(volume(part.shape) == volume(torus) / 2., boost::test_tools::tolerance(.1));
}

BOOST_AUTO_TEST_CASE(what_can_not_be_closed_is_said)
{
  Shape open = shape_of(Shape_generator::make_mesh("dumbbell", 4000));
  std::vector<int> labels = labels_by(open, [](const Point& p) { return p.x() > 0. ? 0 : 1; });
  const auto first =
      static_cast<std::size_t>(std::find(labels.begin(), labels.end(), 1) - labels.begin());
  open.polygons.erase(open.polygons.begin() + static_cast<std::ptrdiff_t>(first));
  labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(first));
  const auto parts = Shape_io::closed_parts(open, labels, 2);
  BOOST_TEST(parts[0].fault == "");
  BOOST_TEST(parts[1].fault == "INPUT is open there");
  open.polygons.push_back({0, 0, 1});
  labels.push_back(2);
  BOOST_TEST(Shape_io::closed_parts(open, labels, 3)[2].fault == "its faces have no area");
  // two balls, of which the smaller one is turned inside out
  Shape balls = shape_of(Shape_generator::make_mesh("sphere", 1000));
  const std::size_t points = balls.points.size(), faces = balls.polygons.size();
  for (std::size_t i = 0; i < points; ++i)
    balls.points.push_back(CGAL::ORIGIN + .5 * (balls.points[i] - CGAL::ORIGIN) +
                           Shape_io::Vector(5., 0., 0.));
  for (std::size_t f = 0; f < faces; ++f)
  {
    const auto polygon = balls.polygons[f];
    balls.polygons.push_back({polygon[2] + points, polygon[1] + points, polygon[0] + points});
  }
  labels.assign(faces, 0);
  labels.resize(2 * faces, 1);
  const auto turned = Shape_io::closed_parts(balls, labels, 2);
  BOOST_TEST(turned[0].fault == "");
  BOOST_TEST(turned[1].fault != "");
}

BOOST_AUTO_TEST_CASE(split_writes_closed_solids)
{
  const Scratch_folder folder;
  const Outcome outcome =
      run(folder, "segment_shape", {"--shape", "four_leg", "--split", "parts", "--close"});
  BOOST_TEST_REQUIRE(outcome.exit_code == 0);
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("parts")))
  {
    BOOST_TEST(is_solid(Shape_io::read_shape(entry.path().string())));
    ++count;
  }
  BOOST_TEST(count > 4u);
  const std::string n = std::to_string(count);
  BOOST_TEST(outcome.out.find(n + " of " + n + " parts are closed solids") != std::string::npos);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--shape", "table", "--close"},
        {"a.xyz", "--split", "a", "--close"}})
  {
    folder.write("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n");
    const Outcome refused = run(folder, "segment_shape", words);
    BOOST_TEST(refused.exit_code == 1);
    BOOST_TEST(refused.err.find("--close") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(hulls_come_as_near_as_asked_for)
{
  const auto mesh = Shape_generator::make_mesh("torus", 4000);
  const Shape ring = shape_of(mesh);
  const std::vector<int> one(ring.polygons.size(), 0);
  Shape_io::Hull_options options;
  options.largest_error = 1.; // measured, but never too large
  const auto whole = Shape_io::part_hulls(ring, one, 1, options);
  BOOST_TEST(whole.hulls.size() == 1u);
  BOOST_TEST(whole.hulls[0].error > .1); // the hole is closed
  options.largest_error = .03;
  const auto near = Shape_io::part_hulls(ring, one, 1, options);
  BOOST_TEST(near.hulls.size() > 4u);
  BOOST_TEST(near.hulls.size() < 40u);
  double sum = 0.;
  for (const auto& hull : near.hulls)
  {
    BOOST_TEST(hull.error <= .03);
    sum += volume(Shape_io::mesh_of_hulls({hull}));
  }
  BOOST_TEST(sum > volume(ring)); // nothing of it is left out
  BOOST_TEST(sum < 1.3 * volume(ring));
  options.most_hulls = 3;
  options.most_corners = 12;
  const auto few = Shape_io::part_hulls(ring, one, 1, options);
  BOOST_TEST(few.hulls.size() == 3u);
  for (const auto& hull : few.hulls) BOOST_TEST(hull.points.size() <= 12u);
}

BOOST_AUTO_TEST_CASE(hulls_are_written_a_file_each)
{
  const Scratch_folder folder;
  const auto count = [&]
  {
    std::size_t result = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("hulls")))
    {
      const Shape hull = Shape_io::read_shape(entry.path().string());
      BOOST_TEST(is_solid(hull));
      BOOST_TEST(hull.points.size() <= 20u);
      ++result;
    }
    return result;
  };
  const auto write = [&](const std::string& most)
  {
    return run(folder, "segment_shape",
               {"--shape", "chair", "--hulls", "hulls", "--hull-error", "0.02", "--max-hulls", most,
                "--hull-vertices", "20"});
  };
  BOOST_TEST(write("12").exit_code == 0);
  BOOST_TEST(count() == 12u);
  BOOST_TEST(write("1").exit_code == 0); // those of the earlier run are gone
  BOOST_TEST(count() == 1u);
  folder.write("hulls/hull_1.obj", "v 0 0 0\n");
  BOOST_TEST(write("1").exit_code == 1);
  folder.write("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--shape", "table", "--max-hulls", "3"},
        {"--shape", "table", "--hulls", "h", "--max-hulls", "0"},
        {"--shape", "table", "--hulls", "h", "--hull-vertices", "3"},
        {"--shape", "table", "--hulls", "h", "--hull-error", "0"},
        {"a.xyz", "--hulls", "h", "--hull-error", "0.1"}})
  {
    const Outcome refused = run(folder, "segment_shape", words);
    BOOST_TEST(refused.exit_code == 1);
    BOOST_TEST(refused.err.find("hull") != std::string::npos);
    BOOST_TEST(!folder.has("h"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
