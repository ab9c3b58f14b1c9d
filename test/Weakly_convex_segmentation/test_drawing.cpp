// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures of parts.

#include <boost/test/unit_test.hpp>

#include "draw/draw_parts.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_drawing)

BOOST_AUTO_TEST_CASE(a_picture_shows_what_is_in_front)
{
  // two squares, one behind the other
  Draw_parts::Scene scene;
  for (const double z : {0., 1.})
    for (const auto& [x, y] : {std::pair(0., 0.), {1., 0.}, {1., 1.}, {0., 1.}})
      scene.points.push_back({x, y, z});
  scene.faces = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const std::vector<int> labels = {0, 0, 1, 1};
  const auto seen = [&](const Draw_parts::View& view)
  {
    std::set<int> found;
    for (const std::size_t e : view.element)
      if (e != Draw_parts::View::none) found.insert(labels[e]);
    return found;
  };
  const Draw_parts::View above = Draw_parts::look(scene, Draw_parts::Camera::Identity(), 100);
  BOOST_TEST(seen(above) == std::set<int>{1});
  const Draw_parts::Camera camera = Draw_parts::best_camera(scene, labels);
  BOOST_TEST((camera * camera.transpose()).isIdentity(1e-9));
  BOOST_TEST(seen(Draw_parts::look(scene, camera, 100)).size() == 2u);

  const auto picture = Draw_parts::make_picture(above, labels, {{255, 0, 0}, {0, 0, 255}});
  BOOST_TEST(picture.width == 100);
  BOOST_TEST(picture.pixels.size() == 100u * 100u);
  // blue, of which colors in pictures are 84 %, and of white the rest
  BOOST_TEST((picture.at(50, 50) == Draw_parts::Color{41, 41, 255}));
  BOOST_TEST((picture.at(0, 0) == Draw_parts::paper));
}

BOOST_AUTO_TEST_CASE(a_sheet_has_all_pictures_without_the_paper_around_them)
{
  Draw_parts::Picture dot(30, 30);
  dot.at(12, 7) = {1, 2, 3};
  BOOST_TEST(Draw_parts::trimmed(dot).width == 1);
  BOOST_TEST(Draw_parts::trimmed(dot).height == 1);
  const Draw_parts::Picture sheet = Draw_parts::sheet({dot, dot, dot}, 5); // two rows
  BOOST_TEST(sheet.width == 17);
  BOOST_TEST(sheet.height == 17);
  std::set<std::pair<int, int>> found;
  for (int y = 0; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x)
      if (sheet.at(x, y) != Draw_parts::paper) found.insert({x, y});
  BOOST_TEST((found == std::set<std::pair<int, int>>{{5, 5}, {11, 5}, {8, 11}}));
}

BOOST_AUTO_TEST_CASE(parts_of_meshes_and_clouds_are_drawn)
{
  const Scratch_folder folder;
  const auto succeeds = [&](const std::string& program, const Words& words)
  {
    const Outcome outcome = run(folder, program, words);
    BOOST_TEST(outcome.exit_code == 0, outcome.err);
  };
  succeeds("segment_shape", {"--shape", "dumbbell", "-o", "mesh.ply"});
  succeeds("make_shapes", {"--cloud", "--points", "3000", "dumbbell"});
  succeeds("segment_shape", {"dumbbell.ply", "-o", "cloud.ply"});
  succeeds("draw_parts", {"mesh.ply", "-o", "mesh.png"});
  succeeds("draw_parts", {"mesh.ply", "cloud.ply", "-o", "both.png", "--size", "64"});
  for (const std::string name : {"mesh.png", "both.png"})
    BOOST_TEST(folder.read(name).compare(0, 4, "\x89PNG") == 0);
  succeeds("draw_parts", {"mesh.ply", "-o", "again.png"});
  BOOST_TEST((folder.read("again.png") == folder.read("mesh.png")));
  for (const Words& wrong : {Words{"mesh.ply", "-o", "a.png", "--up", "w"},
                             {"mesh.ply", "-o", "a.png", "--size", "5"},
                             {"mesh.ply", "-o", "mesh.ply"},
                             {"dumbbell.seg", "-o", "a.png"}})
    BOOST_TEST(run(folder, "draw_parts", wrong).exit_code == 1);
  BOOST_TEST(!folder.has("a.png"));
}

BOOST_AUTO_TEST_SUITE_END()
