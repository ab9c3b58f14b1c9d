// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the programs as a user does. They are in the folder that the environment variable
// WCS_BIN_DIR names; CTest sets it.

#include <boost/test/unit_test.hpp>

#include "io/shape_io.h"
#include "run_program.h"
#include "scratch_folder.h"
#include "shapes/shape_generator.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_programs)

namespace {

Outcome segment_shape(const Scratch_folder& folder, const Words& words)
{
  return run(folder, "segment_shape", words);
}

void check_success(const Outcome& outcome)
{
  BOOST_TEST(outcome.exit_code == 0);
  BOOST_TEST(outcome.err == "");
}

// A failure is exit code 1 and one line on stderr, and leaves no file behind.
void check_failure(const Scratch_folder& folder, const Words& words)
{
  std::ostringstream command;
  for (const std::string& word : words) command << word << ' ';
  BOOST_TEST_CONTEXT(command.str())
  {
    const std::size_t number_of_files = folder.number_of_files();
    const Outcome outcome = segment_shape(folder, words);
    BOOST_TEST(outcome.exit_code == 1);
    BOOST_TEST(outcome.out == "");
    BOOST_TEST(outcome.err.compare(0, 15, "segment_shape: ") == 0);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    BOOST_TEST(folder.number_of_files() == number_of_files);
  }
}

std::vector<int> labels_in(const std::string& text)
{
  std::istringstream lines(text);
  std::vector<int> labels;
  for (int label; lines >> label;) labels.push_back(label);
  return labels;
}

// Labels are numbered from 0 without gaps.
std::size_t number_of_labels(const std::vector<int>& labels)
{
  const std::set<int> different(labels.begin(), labels.end());
  BOOST_REQUIRE(!different.empty());
  BOOST_TEST(*different.begin() == 0);
  BOOST_TEST(*different.rbegin() + 1 == static_cast<int>(different.size()));
  return different.size();
}

std::vector<int> label_property(const std::vector<Shape_io::Property>& properties)
{
  for (const Shape_io::Property& property : properties)
    if (property.name == "label") return {property.values.begin(), property.values.end()};
  return {};
}

// A small mesh in the formats that are read.
const Shape_generator::Labeled_mesh& small_mesh()
{
  static const Shape_generator::Labeled_mesh mesh = Shape_generator::make_mesh("dumbbell", 2000, 0);
  return mesh;
}

std::string off_or_obj(const bool is_off)
{
  const auto& mesh = small_mesh();
  std::ostringstream text;
  if (is_off) text << "OFF\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const auto& p : mesh.points)
    text << (is_off ? "" : "v ") << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  const std::size_t first = is_off ? 0 : 1;
  for (const auto& f : mesh.faces)
    text << (is_off ? "3 " : "f ") << f[0] + first << ' ' << f[1] + first << ' ' << f[2] + first
         << '\n';
  return text.str();
}

std::string stl()
{
  const auto& mesh = small_mesh();
  std::ostringstream text;
  text << "solid a\n";
  for (const auto& f : mesh.faces)
  {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const std::size_t corner : f)
    {
      const auto& p = mesh.points[corner];
      text << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    text << "endloop\nendfacet\n";
  }
  text << "endsolid a\n";
  return text.str();
}

constexpr std::size_t cloud_size = 2500;

std::string cloud(const std::string& header, const bool with_normals)
{
  const auto shape = Shape_generator::make_cloud("dumbbell", cloud_size, 0);
  std::ostringstream text;
  text << header;
  for (std::size_t i = 0; i < cloud_size; ++i)
  {
    for (const double x : shape.points[i]) text << x << ' ';
    if (with_normals)
      for (const double x : shape.normals[i]) text << x << ' ';
    text << '\n';
  }
  return text.str();
}

// Segments the file and checks that the parts have its elements, in its order.
void check_parts(const Scratch_folder& folder, const std::string& name)
{
  BOOST_TEST_CONTEXT(name)
  {
    check_success(segment_shape(folder, {name, "-o", "p.ply", "--labels", "p.seg"}));
    const Shape_io::Shape input = Shape_io::read_shape(folder.file(name));
    const Shape_io::Shape parts = Shape_io::read_shape(folder.file("p.ply"));
    BOOST_TEST((parts.points == input.points));
    BOOST_TEST((parts.polygons == input.polygons));
    BOOST_TEST((parts.normals == input.normals));
    const std::vector<int> labels = labels_in(folder.read("p.seg"));
    BOOST_TEST(labels.size() == input.number_of_elements());
    BOOST_TEST((label_property(input.is_mesh() ? parts.face_properties : parts.point_properties) ==
                labels));
    BOOST_TEST(label_property(parts.point_properties).size() == input.points.size());
    number_of_labels(labels);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(without_arguments_a_shape_is_segmented)
{
  const Scratch_folder folder;
  const Outcome outcome = segment_shape(folder, {});
  check_success(outcome);
  BOOST_TEST(outcome.out.find("figure") != std::string::npos);
  BOOST_TEST(outcome.out.find("wrote parts.ply") != std::string::npos);
  const Shape_io::Shape parts = Shape_io::read_shape(folder.file("parts.ply"));
  BOOST_TEST(number_of_labels(label_property(parts.face_properties)) >= 5u);
  BOOST_TEST(folder.number_of_files() == 1u);
}

BOOST_AUTO_TEST_CASE(every_format_is_read_and_nothing_is_lost)
{
  const Scratch_folder folder;
  folder.write("a.off", off_or_obj(true));
  folder.write("a.obj", off_or_obj(false));
  folder.write("a.stl", stl());
  folder.write("a.xyz", cloud("", false));
  folder.write("b.pwn", cloud("", true));
  folder.write("c.off", cloud("OFF\n" + std::to_string(cloud_size) + " 0 0\n", true));
  for (const std::string name : {"a.off", "a.obj", "a.stl", "a.xyz", "b.pwn", "c.off"})
    check_parts(folder, name);
  // What it writes it reads: meshes and clouds, as text and binary.
  check_success(segment_shape(folder, {"a.off", "-o", "mesh.ply", "--ascii", "--quiet"}));
  check_success(segment_shape(folder, {"b.pwn", "-o", "a name with \xc3\xa4.ply", "--quiet"}));
  check_parts(folder, "mesh.ply");
  check_parts(folder, "a name with \xc3\xa4.ply");
}

BOOST_AUTO_TEST_CASE(stages_and_limits_change_the_number_of_parts)
{
  const Scratch_folder folder;
  const auto count = [&](const Words& words)
  {
    Words all = {"--shape", "table", "--labels", "a.seg"};
    all.insert(all.end(), words.begin(), words.end());
    check_success(segment_shape(folder, all));
    return number_of_labels(labels_in(folder.read("a.seg")));
  };
  const std::size_t patches = count({"--stage", "patches"});
  const std::size_t components = count({"--stage", "components"});
  const std::size_t segments = count({"--stage", "segments"});
  BOOST_TEST(patches >= components);
  BOOST_TEST(components >= segments);
  BOOST_TEST(patches > segments);
  BOOST_TEST(segments == count({}));
  BOOST_TEST(count({"--max-segments", "2"}) <= 2u);
  BOOST_TEST(count({"--max-segments", "1"}) == 1u);
  BOOST_TEST(count({"--pieces", "whole"}) == 1u);
  BOOST_TEST(count({"--pieces", "joined"}) == segments); // it has one
  BOOST_TEST(segment_shape(folder, {"--pieces", "none"}).exit_code == 1);
  BOOST_TEST(count({"--segments", "4"}) == 4u);
  BOOST_TEST(count({"--segments", "12"}) == 12u);
  BOOST_TEST(count({"--set", "merging_threshold=1", "--set", "maximum_number_of_segments=2"}) <=
             2u);
  BOOST_TEST(count({"--preset", "paper"}) >= 1u);
  BOOST_TEST(count({"--diameters", "cgal"}) >= 2u);
}

BOOST_AUTO_TEST_CASE(the_numbers_agree)
{
  const Scratch_folder folder;
  const Outcome outcome = segment_shape(
      folder, {"--shape", "chair", "--stats", "a.json", "--labels", "a.seg", "--seed", "3"});
  check_success(outcome);
  const auto stats = nlohmann::json::parse(folder.read("a.json"));
  const std::vector<int> labels = labels_in(folder.read("a.seg"));
  BOOST_TEST(stats["kind"] == "mesh");
  BOOST_TEST(stats["has_flipped_normals"] == false);
  BOOST_TEST(stats["has_doubtful_normals"] == false);
  BOOST_TEST(stats["seed"] == 3);
  BOOST_TEST(stats["number_of_faces"] == labels.size());
  BOOST_TEST(stats["number_of_segments"] == number_of_labels(labels));
  BOOST_TEST(stats["segments"].size() == number_of_labels(labels));
  BOOST_TEST(stats["number_of_patches"] >= stats["number_of_components"]);
  BOOST_TEST(stats["seconds"]["stages"].size() == 10u);
  double share = 0.;
  for (const auto& segment : stats["segments"])
  {
    const int label = segment["label"];
    BOOST_TEST(segment["size"] == std::count(labels.begin(), labels.end(), label));
    BOOST_TEST(segment["convexity_rank"] >= 0.);
    BOOST_TEST(segment["convexity_rank"] <= 1.);
    for (const std::size_t neighbor : segment["neighbors"])
    {
      const auto& back = stats["segments"][neighbor]["neighbors"];
      BOOST_TEST(std::count(back.begin(), back.end(), label) == 1);
    }
    share += segment["share"].get<double>();
  }
  BOOST_TEST(share == 1., boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_result_is_the_same_again_and_with_any_number_of_threads)
{
  const Scratch_folder folder;
  for (const std::string threads : {"1", "2"})
    for (const std::string time : {"a", "b"})
      check_success(segment_shape(folder, {"--shape", "octopus", "--threads", threads, "--quiet",
                                           "-o", time + threads + ".ply"}));
  const std::string expected = folder.read("a1.ply");
  BOOST_TEST(!expected.empty());
  for (const std::string name : {"b1.ply", "a2.ply", "b2.ply"})
    BOOST_TEST((folder.read(name) == expected));
}

BOOST_AUTO_TEST_CASE(quiet_prints_nothing)
{
  const Scratch_folder folder;
  const Outcome outcome = segment_shape(folder, {"--shape", "sphere", "--quiet"});
  check_success(outcome);
  BOOST_TEST(outcome.out == "");
  BOOST_TEST(folder.has("parts.ply"));
}

BOOST_AUTO_TEST_CASE(without_an_output_the_parts_are_named_after_the_input)
{
  const Scratch_folder folder;
  folder.write("scan.off", off_or_obj(true));
  check_success(segment_shape(folder, {"scan.off"}));
  BOOST_TEST(folder.has("scan_parts.ply"));
  check_success(segment_shape(folder, {"scan.off"})); // again, over its own
  folder.write("scan_parts.ply", "somebody's own");
  BOOST_TEST(segment_shape(folder, {"scan.off"}).exit_code == 1);
  BOOST_TEST(folder.read("scan_parts.ply") == "somebody's own");
}

BOOST_AUTO_TEST_CASE(what_was_mistyped_is_told)
{
  const Scratch_folder folder;
  const auto error = [&](const std::string& program, const Words& words)
  {
    const Outcome outcome = run(folder, program, words);
    BOOST_TEST(outcome.exit_code == 1);
    return outcome.err;
  };
  const auto has = [](const std::string& text, const std::string& part)
  { return text.find("did you mean '" + part + "'") != std::string::npos; };
  BOOST_TEST(has(error("segment_shape", {"--lables", "a.seg"}), "--labels"));
  BOOST_TEST(has(error("segment_shape", {"--preste=paper"}), "--preset"));
  BOOST_TEST(has(error("segment_shape", {"--set", "merging_treshold=0.4"}), "merging_threshold"));
  BOOST_TEST(has(error("segment_scene", {"a.pcd", "--viewpiont", "0", "0", "1"}), "--viewpoint"));
  BOOST_TEST(has(error("scan_shape", {"--veiws", "3"}), "--views"));
  BOOST_TEST(has(error("make_shapes", {"figrue"}), "figure"));
  BOOST_TEST(error("segment_shape", {"--xyzzy"}).find("did you mean") == std::string::npos);
  for (const std::string program :
       {"segment_shape", "segment_scene", "scan_shape", "make_shapes", "draw_parts"})
    BOOST_TEST(run(folder, program, {"-h"}).out.find("--output") != std::string::npos);
}

// `script` runs it on a terminal, for which alone the line is.
BOOST_AUTO_TEST_CASE(a_terminal_shows_how_far_the_work_is)
{
  const Scratch_folder folder;
  folder.write("a.off", off_or_obj(true));
  const std::string program = std::string(std::getenv("WCS_BIN_DIR")) + "/segment_shape";
  const std::string command = "cd " + quoted(folder.path().string()) + " && script -qec " +
                              quoted(quoted(program) + " a.off -o b.ply --labels b.seg") +
                              " /dev/null </dev/null >shown";
  BOOST_REQUIRE(std::system(command.c_str()) == 0);
  std::vector<std::string> steps;
  int last = 0;
  std::string shown = folder.read("shown");
  const std::string wipe = "\r\033[K";
  for (std::size_t i = 0; (i = shown.find(wipe, i)) != std::string::npos;)
  {
    i += wipe.size();
    const std::string line = shown.substr(i, shown.find(wipe, i) - i);
    const std::size_t unit = line.find(" % ");
    if (unit == std::string::npos || unit > 3) continue; // what comes when it is over
    BOOST_TEST(std::stoi(line) >= last);
    last = std::stoi(line);
    const std::string step = line.substr(unit + 3);
    if (steps.empty() || steps.back() != step) steps.push_back(step);
  }
  BOOST_TEST(last > 90);
  const std::vector<std::string> expected = {
      "reading a.off", "preparation", "sampling",      "neighbors",    "patches",
      "visibility",    "signatures",  "agreement",     "fusion",       "merging",
      "refinement",    "statistics",  "writing b.ply", "writing b.seg"};
  BOOST_TEST(steps == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(help_and_version_are_printed)
{
  const Scratch_folder folder;
  for (const Words& words : {Words{"--help"}, Words{"-h"}, Words{"--version"}})
  {
    const Outcome outcome = segment_shape(folder, words);
    check_success(outcome);
    BOOST_TEST(outcome.out.find("segment_shape") != std::string::npos);
    BOOST_TEST(folder.number_of_files() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused)
{
  const Scratch_folder folder;
  folder.write("a.off", off_or_obj(true));
  const std::vector<Words> commands = {{"--unknown"},
                                       {"-x"},
                                       {"a.off", "b.off"},
                                       {"--seed", "-1"},
                                       {"--seed", "4294967296"},
                                       {"--seed", "x"},
                                       {"--seed"},
                                       {"--threads", "0"},
                                       {"--max-segments", "0"},
                                       {"--segments", "0"},
                                       {"--segments", "3", "--max-segments", "3"},
                                       {"--set", "seed"},
                                       {"--set", "no_such=1"},
                                       {"--set", "merging_threshold=2"},
                                       {"--preset", "best"},
                                       {"--diameters", "other"},
                                       {"--stage", "parts"},
                                       {"--shape", "unknown"},
                                       {""},
                                       {"-o", ""},
                                       {"a.off", "--shape", "cup"},
                                       {"a.off", "-o", "a.xyz"},
                                       {"--seed", "1", "--seed", "2"},
                                       {"a.off", "-o", "b.ply", "--labels", "b.ply"},
                                       {"--quiet=yes"}};
  for (const Words& words : commands) check_failure(folder, words);
}

BOOST_AUTO_TEST_CASE(what_can_not_be_read_or_written_is_refused)
{
  const Scratch_folder folder;
  folder.write("a.off", off_or_obj(true));
  folder.write("cut.off", off_or_obj(true).substr(0, 20000));
  folder.write("empty.ply", "");
  folder.write("garbage.ply", "ply\nthis is none");
  folder.write("garbage.stl", "\x01\x02\x03 and more that is none");
  folder.write("a.doc", "0 0 0\n");
  for (const std::string name : {"missing.off", "missing\nline.off", "cut.off", "empty.ply",
                                 "garbage.ply", "garbage.stl", "a.doc", "."})
    check_failure(folder, {name, "-o", "b.ply", "--labels", "b.seg"});
  folder.write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  check_failure(folder, {"cloud.xyz", "--diameters", "cgal", "-o", "b.ply"});
  check_failure(folder, {"a.off", "-o", "none/b.ply"});
  check_failure(folder, {"a.off", "-o", "b.ply", "--stats", "none/b.json"});
  check_failure(folder, {"a.off", "-o", "b.ply", "--labels", "."});
  check_failure(folder, {"a.off", "-o", "b.ply", "--labels", "/dev/full"});
}

BOOST_AUTO_TEST_CASE(the_small_examples_run)
{
  const Scratch_folder folder;
  for (const std::string name :
       {"segment_mesh", "segment_part_of_mesh", "split_into_meshes", "segment_point_set",
        "segment_custom_container", "components_only", "visitor_and_granularity",
        "decompose_by_lines_of_sight", "own_line_of_sight", "own_merge_cost"})
  {
    BOOST_TEST_CONTEXT(name)
    {
      const Outcome outcome = run(folder, name);
      check_success(outcome);
      BOOST_TEST(outcome.out.find("segments") != std::string::npos);
    }
  }
  BOOST_TEST(folder.number_of_files() == 0u);
  folder.write("a.off", off_or_obj(true));
  check_success(run(folder, "segment_mesh", {"a.off"}));
  BOOST_TEST(run(folder, "segment_mesh", {"missing.off"}).exit_code == 1);
}

BOOST_AUTO_TEST_CASE(shapes_are_made_and_segmented)
{
  const Scratch_folder folder;
  check_success(run(folder, "make_shapes", {"cup"}));
  check_success(run(folder, "make_shapes", {"--cloud", "--points", "3000", "cup"}));
  check_parts(folder, "cup.off");
  check_parts(folder, "cup.ply");
}

BOOST_AUTO_TEST_SUITE_END()
