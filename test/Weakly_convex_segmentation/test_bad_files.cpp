// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What all programs and examples answer to what is no shape.

#include <boost/test/unit_test.hpp>

#include "run_program.h"
#include "scratch_folder.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bad_files)

namespace {

const std::vector<std::string> programs = {"segment_shape", "segment_scene", "scan_shape",
                                           "draw_parts", "make_shapes"};
const std::vector<std::string> examples_of_meshes = {
    "components_only",      "own_line_of_sight", "segment_mesh",
    "segment_part_of_mesh", "split_into_meshes", "visitor_and_granularity"};
const std::vector<std::string> examples_of_points = {"own_merge_cost", "segment_custom_container",
                                                     "segment_point_set"};

// What makes no shape, of any kind.
std::vector<std::string> bad_files(const Scratch_folder& folder)
{
  std::filesystem::create_directory(folder.path() / "folder");
  std::filesystem::create_directory(folder.path() / "folder.ply");
  folder.write("empty.off", "");
  folder.write("empty.ply", "");
  for (const std::string ending : {"off", "ply", "xyz"}) folder.write("text." + ending, "hello\n");
  std::string bytes = "\x01\x02";
  for (unsigned i = 0; i < 3000; ++i) bytes += static_cast<char>(i * i * 7919u >> 5);
  folder.write("bytes.off", bytes);
  folder.write("bytes.ply", bytes);
  return {"missing.off", "missing",  "folder",   "folder.ply", "empty.off", "empty.ply",
          "text.off",    "text.ply", "text.xyz", "bytes.off",  "bytes.ply"};
}

// One line, by the program, that names the file; the readers of CGAL print one of their own before.
void check_refusal(const Scratch_folder& folder, const std::string& program, const Words& words,
                   const std::string& named, const std::ptrdiff_t most_lines = 1)
{
  BOOST_TEST_CONTEXT(program + " " + (words.empty() ? "" : words.front()))
  {
    const std::size_t number_of_files = folder.number_of_files();
    const Outcome outcome = run(folder, program, words);
    BOOST_TEST(outcome.exit_code == 1);
    BOOST_TEST(outcome.out == "");
    const auto lines = std::count(outcome.err.begin(), outcome.err.end(), '\n');
    BOOST_TEST(lines >= 1);
    BOOST_TEST(lines <= most_lines);
    const std::size_t last = outcome.err.rfind(program + ": ");
    BOOST_REQUIRE(last != std::string::npos);
    BOOST_TEST((last == 0 || outcome.err[last - 1] == '\n'));
    BOOST_TEST(outcome.err.find(named, last) != std::string::npos, outcome.err);
    BOOST_TEST(folder.number_of_files() == number_of_files);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(programs_refuse_what_is_no_shape_in_one_line)
{
  const Scratch_folder folder;
  for (const std::string& file : bad_files(folder))
    for (const std::string& program : programs)
      if (program == "make_shapes")
        check_refusal(folder, program, {file}, file);
      else
        check_refusal(folder, program,
                      {file, "-o", program == "draw_parts" ? "out.png" : "out.ply"}, file);
  check_refusal(folder, "segment_shape", {"folder", "-o", "out.ply"}, "it is a folder");
  check_refusal(folder, "segment_shape", {"missing", "-o", "out.ply"}, "there is no such file");
}

BOOST_AUTO_TEST_CASE(examples_refuse_what_is_no_shape)
{
  const Scratch_folder folder;
  for (const std::string& file : bad_files(folder))
    for (const auto& examples : {examples_of_meshes, examples_of_points})
      for (const std::string& example : examples) check_refusal(folder, example, {file}, file, 2);
}

BOOST_AUTO_TEST_CASE(three_points_are_one_part_or_are_refused)
{
  const Scratch_folder folder;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  folder.write("three.off", "OFF\n3 0 0\n" + points);
  for (const std::string& example : examples_of_meshes)
    check_refusal(folder, example, {"three.off"}, "three.off");
  for (const std::string& example : examples_of_points)
  {
    const Outcome outcome = run(folder, example, {"three.off"});
    BOOST_TEST(outcome.exit_code == 0);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(outcome.out.find("1 segments") != std::string::npos);
  }
  check_refusal(folder, "segment_scene", {"three.off", "-o", "out.ply"}, "--cell");
  check_refusal(folder, "scan_shape", {"three.off", "-o", "out.ply"}, "give a mesh");
  check_refusal(folder, "draw_parts", {"three.off", "-o", "out.png"}, "segment it first");
  BOOST_TEST(run(folder, "segment_shape", {"three.off", "-o", "out.ply"}).exit_code == 0);
  BOOST_TEST(run(folder, "draw_parts", {"out.ply", "-o", "out.png"}).exit_code == 0);
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_named)
{
  const Scratch_folder folder;
  check_refusal(folder, "segment_scene", {}, "give SCENE.ply");
  check_refusal(folder, "scan_shape", {}, "give -o CLOUD.ply");
  check_refusal(folder, "draw_parts", {}, "give PARTS.ply");
  check_refusal(folder, "draw_parts", {"parts.ply"}, "give -o PICTURE.png");
  // the one of several shapes that is too fine
  check_refusal(folder, "make_shapes", {"cup", "--faces", "4000"}, "shape cup");
}

BOOST_AUTO_TEST_SUITE_END()
