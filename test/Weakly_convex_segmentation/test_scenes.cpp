// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// One view of a depth camera, in segment_scene.

#include <boost/test/unit_test.hpp>

#include "io/shape_io.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_scenes)

namespace {

constexpr int width = 200, height = 150;

// Whether nothing is measured in a pixel: a column in 17.
bool is_gap(const int x) { return x % 17 == 0; }

// A ball over a table before a camera at the origin, pixel after pixel; a wall behind it, of twice its size.
std::string ball_on_table(const std::string& gap, const bool has_wall = false)
{
  constexpr double wall = 0.86, half_table = 0.25;
  const auto table = [](const double, const double v) { return 0.6 / (0.7 * v + 0.714); };
  const auto ball = [](const double u, const double v)
  {
    const double a = u * u + v * v + 1., b = 0.75, c = b * b - 0.09 * 0.09;
    return b * b - a * c > 0. ? (b - std::sqrt(b * b - a * c)) / a : 1e9;
  };
  std::ostringstream out;
  out << "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << width << "\nHEIGHT "
      << height << "\nDATA ascii\n";
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      const double u = (x - 0.5 * width) / 190., v = (y - 0.5 * height) / 190.;
      double z = (std::min)(table(u, v), ball(u, v));
      if (has_wall && (z > wall || std::abs(u * z) > half_table)) z = wall;
      if (is_gap(x))
        out << gap << '\n';
      else
        out << u * z << ' ' << v * z << ' ' << z << '\n';
    }
  return out.str();
}

} // namespace

BOOST_AUTO_TEST_CASE(pixels_without_a_measurement_keep_their_place)
{
  const Scratch_folder folder;
  for (const std::string gap : {"nan nan nan", "0 0 0"})
  {
    folder.write("scene.pcd", ball_on_table(gap));
    const Outcome outcome =
        run(folder, "segment_scene", {"scene.pcd", "-o", "parts.ply", "--stats", "s.json"});
    BOOST_TEST(outcome.err == "");
    BOOST_TEST_REQUIRE(outcome.exit_code == 0);
    BOOST_TEST(outcome.out.find("1 objects of ") == 0u);
    BOOST_TEST(folder.read("s.json").find("\"number_of_gaps\": 1800,") != std::string::npos);
    const Shape_io::Shape parts =
        Shape_io::read_shape(folder.file("parts.ply"), Shape_io::Gaps::ALLOWED);
    BOOST_TEST_REQUIRE(parts.points.size() == std::size_t(width * height));
    const auto label = std::find_if(parts.point_properties.begin(), parts.point_properties.end(),
                                    [](const Shape_io::Property& p) { return p.name == "label"; });
    BOOST_TEST_REQUIRE((label != parts.point_properties.end()));
    for (std::size_t i = 0; i < parts.points.size(); ++i)
      BOOST_TEST_REQUIRE((label->values[i] == -1.) == is_gap(static_cast<int>(i % width)));
    BOOST_TEST(label->values[height / 2 * width + width / 2] == 1.); // the ball
    BOOST_TEST(label->values[width - 1] == 0.);                      // the table
  }
}

BOOST_AUTO_TEST_CASE(the_plane_is_that_with_the_most_on_it_or_given)
{
  const Scratch_folder folder;
  folder.write("scene.pcd", ball_on_table("nan nan nan", true));
  const std::vector<std::string> usual = {"scene.pcd", "-o", "parts.ply"};
  for (const std::vector<std::string>& plane :
       {std::vector<std::string>(), {"--plane", "0", "0.7", "0.714", "-0.6"}})
  {
    std::vector<std::string> arguments = usual;
    arguments.insert(arguments.end(), plane.begin(), plane.end());
    const Outcome outcome = run(folder, "segment_scene", arguments);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST_REQUIRE(outcome.exit_code == 0);
    BOOST_TEST(outcome.out.find("1 objects of ") == 0u);
    BOOST_TEST(outcome.out.find("on the plane ") != std::string::npos);
    const Shape_io::Shape parts =
        Shape_io::read_shape(folder.file("parts.ply"), Shape_io::Gaps::ALLOWED);
    const auto label = std::find_if(parts.point_properties.begin(), parts.point_properties.end(),
                                    [](const Shape_io::Property& p) { return p.name == "label"; });
    BOOST_TEST_REQUIRE((label != parts.point_properties.end()));
    BOOST_TEST(label->values[height / 2 * width + width / 2] == 1.);   // the ball
    BOOST_TEST(label->values[width / 2] == 0.);                        // the wall
    BOOST_TEST(label->values[(height - 1) * width + width / 2] == 0.); // the table
  }
  std::vector<std::string> wrong = usual;
  wrong.insert(wrong.end(), {"--plane", "0", "1", "0", "-7"});
  const Outcome nothing = run(folder, "segment_scene", wrong);
  BOOST_TEST(nothing.exit_code == 1);
  BOOST_TEST(nothing.err.find("nothing stands on the plane that was given") != std::string::npos);
  wrong.back() = "x";
  BOOST_TEST(run(folder, "segment_scene", wrong).exit_code == 1);
}

BOOST_AUTO_TEST_CASE(what_is_no_scene_is_refused_in_one_line)
{
  const Scratch_folder folder;
  const std::string far = "0.1 0 1\n0.2 0.1 1\n";
  folder.write("far.xyz", far + "1e300 0 1\n");
  folder.write("few.xyz", far);
  folder.write("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (const auto& [name, cause] : {std::pair("far.xyz", "cells from the origin; scale"),
                                    {"few.xyz", "only 2 points"},
                                    {"mesh.off", "is a mesh"},
                                    {"none.pcd", "no such file"}})
  {
    const Outcome outcome = run(folder, "segment_scene", {name, "-o", "parts.ply"});
    BOOST_TEST(outcome.exit_code == 1);
    BOOST_TEST(outcome.err.find(cause) != std::string::npos);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    BOOST_TEST(folder.number_of_files() == 3u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
