// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What segment_shape writes besides the labeled shape: groups, files of single parts, hulls.

#include <boost/test/unit_test.hpp>

#include "io/cut_shape.h"
#include "io/part_hulls.h"
#include "io/separate_parts.h"
#include "io/shape_io.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_outputs)

namespace {

using Shape_io::Point;
using Shape_io::Shape;

std::vector<int> labels_of(const Scratch_folder& folder, const std::string& name)
{
  std::istringstream lines(folder.read(name));
  std::vector<int> labels;
  for (int label; lines >> label;) labels.push_back(label);
  return labels;
}

const Shape_io::Property& property(const std::vector<Shape_io::Property>& all,
                                   const std::string& name)
{
  const auto it = std::find_if(all.begin(), all.end(),
                               [&](const Shape_io::Property& p) { return p.name == name; });
  BOOST_REQUIRE(it != all.end());
  return *it;
}

// The dumbbell's cloud with a property of its own, the number of each point.
std::string numbered_cloud(const Scratch_folder& folder)
{
  BOOST_REQUIRE(run(folder, "make_shapes", {"--cloud", "--points", "3000", "dumbbell"}).exit_code ==
                0);
  const Shape cloud = Shape_io::read_shape(folder.file("dumbbell.ply"));
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat ascii 1.0\nelement vertex " << cloud.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty float normal_x\n"
         "property float normal_y\nproperty float normal_z\nproperty int number\nend_header\n";
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    out << cloud.points[i] << ' ' << cloud.normals[i] << ' ' << i << '\n';
  return folder.write("numbered.ply", out.str());
}

} // namespace

BOOST_AUTO_TEST_CASE(split_loses_no_point_and_no_property)
{
  const Scratch_folder folder;
  numbered_cloud(folder);
  const Shape whole = Shape_io::read_shape(folder.file("numbered.ply"));
  BOOST_TEST(whole.normals.size() == whole.points.size());
  const Outcome outcome = run(folder, "segment_shape",
                              {"numbered.ply", "--quiet", "--split", "parts", "--labels", "l.seg"});
  BOOST_TEST(outcome.exit_code == 0);
  BOOST_TEST(outcome.err == "");
  const std::vector<int> labels = labels_of(folder, "l.seg");
  BOOST_REQUIRE(labels.size() == whole.points.size());
  const int count = 1 + *std::max_element(labels.begin(), labels.end());
  BOOST_TEST(count > 1);
  std::set<std::size_t> seen;
  for (int label = 0; label < count; ++label)
  {
    const Shape part =
        Shape_io::read_shape(folder.file("parts/part_" + std::to_string(label) + ".ply"));
    const auto& numbers = property(part.point_properties, "number").values;
    BOOST_REQUIRE(numbers.size() == part.points.size());
    BOOST_TEST(std::is_sorted(numbers.begin(), numbers.end()));
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      const auto number = static_cast<std::size_t>(numbers[i]);
      BOOST_TEST_REQUIRE(seen.insert(number).second);
      BOOST_TEST_REQUIRE(part.points[i] == whole.points[number]);
      BOOST_TEST_REQUIRE(labels[number] == label);
    }
  }
  BOOST_TEST(seen.size() == whole.points.size());
}

BOOST_AUTO_TEST_CASE(split_of_a_mesh_keeps_each_face)
{
  const Scratch_folder folder;
  BOOST_REQUIRE(
      run(folder, "segment_shape",
          {"--shape", "table", "--quiet", "--split", "a/b", "--labels", "l.seg", "-o", "all.obj"})
          .exit_code == 0);
  const std::vector<int> labels = labels_of(folder, "l.seg");
  const int count = 1 + *std::max_element(labels.begin(), labels.end());
  for (int label = 0; label < count; ++label)
    BOOST_TEST(Shape_io::read_shape(folder.file("a/b/part_" + std::to_string(label) + ".ply"))
                   .polygons.size() ==
               static_cast<std::size_t>(std::count(labels.begin(), labels.end(), label)));
  const std::string obj = folder.read("all.obj");
  for (int label = 0; label < count; ++label)
    BOOST_TEST(obj.find("\ng part_" + std::to_string(label) + "\n") != std::string::npos);
  BOOST_TEST(Shape_io::read_shape(folder.file("all.obj")).polygons.size() == labels.size());
}

BOOST_AUTO_TEST_CASE(split_leaves_no_part_of_an_earlier_run_and_deletes_nothing_else)
{
  const Scratch_folder folder;
  const auto split = [&](const std::string& most)
  {
    return run(folder, "segment_shape",
               {"--shape", "octopus", "--quiet", "--split", "parts", "--max-segments", most});
  };
  const auto exists = [&](const std::string& name)
  { return std::filesystem::exists(folder.file("parts/" + name)); };
  BOOST_REQUIRE(split("5").exit_code == 0);
  BOOST_TEST(exists("part_4.ply"));
  folder.write("parts/notes.txt", "mine");
  folder.write("parts/part_of_mine.ply", "mine");
  folder.write("parts/part_9.txt", "mine");
  BOOST_REQUIRE(split("2").exit_code == 0);
  BOOST_TEST(exists("part_1.ply"));
  for (const char* const stale : {"part_2.ply", "part_3.ply", "part_4.ply"})
    BOOST_TEST(!exists(stale));
  for (const char* const own : {"parts/notes.txt", "parts/part_of_mine.ply", "parts/part_9.txt"})
    BOOST_TEST(folder.read(own) == "mine");

  for (const char* const name : {"part_0.ply", "part_7.ply", "part_none.ply"})
  {
    const std::string own = "ply\nformat ascii 1.0\nelement vertex 0\n";
    folder.write(std::string("parts/") + name, own);
    const Outcome outcome = split("3");
    BOOST_TEST(outcome.exit_code == 1);
    BOOST_TEST(outcome.err.find(name) != std::string::npos);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    BOOST_TEST(exists("part_1.ply"));
    BOOST_TEST(!exists("part_2.ply"));
    BOOST_TEST(folder.read(std::string("parts/") + name) == own);
    std::filesystem::remove(folder.file(std::string("parts/") + name));
  }
}

BOOST_AUTO_TEST_CASE(hulls_enclose_their_parts)
{
  const Scratch_folder folder;
  BOOST_REQUIRE(run(folder, "segment_shape", {"--shape", "dumbbell", "--quiet", "--hulls", "h.ply"})
                    .exit_code == 0);
  const Shape hulls = Shape_io::read_shape(folder.file("h.ply"));
  const auto& labels = property(hulls.face_properties, "label").values;
  BOOST_TEST(*std::max_element(labels.begin(), labels.end()) >= 1.);
  for (std::size_t f = 0; f < hulls.polygons.size(); ++f)
    for (std::size_t g = 0; g < hulls.polygons.size(); ++g)
      if (labels[f] == labels[g])
      {
        const auto& c = hulls.polygons[f];
        BOOST_TEST_REQUIRE(
            (CGAL::orientation(hulls.points[c[0]], hulls.points[c[1]], hulls.points[c[2]],
                               hulls.points[hulls.polygons[g][0]]) != CGAL::POSITIVE));
      }
}

BOOST_AUTO_TEST_CASE(faces_are_cut_along_borders_in_all_outputs)
{
  const Scratch_folder folder;
  const auto segment = [&](const std::string& name, const bool is_cut)
  {
    std::vector<std::string> words = {"--shape",  "figure",      "--quiet", "-o", name + ".ply",
                                      "--labels", name + ".seg", "--split", name};
    if (is_cut) words.push_back("--cut");
    BOOST_REQUIRE(run(folder, "segment_shape", words).exit_code == 0);
    return Shape_io::read_shape(folder.file(name + ".ply"));
  };
  const Shape whole = segment("whole", false), cut = segment("cut", true);
  BOOST_TEST(cut.polygons.size() > whole.polygons.size());
  const std::vector<int> labels = labels_of(folder, "cut.seg");
  BOOST_TEST(labels.size() == cut.polygons.size());
  const auto& sources = property(cut.face_properties, "source_face").values;
  BOOST_TEST_REQUIRE(sources.size() == cut.polygons.size());
  const std::vector<int> labels_of_whole = labels_of(folder, "whole.seg");
  std::size_t other = 0;
  for (std::size_t f = 0; f < labels.size(); ++f)
    other += labels[f] != labels_of_whole[static_cast<std::size_t>(sources[f])] ? 1 : 0;
  BOOST_TEST(other > 0u);
  BOOST_TEST(other < cut.polygons.size() / 20);
  std::size_t faces = 0;
  for (int part = 0; part <= *std::max_element(labels.begin(), labels.end()); ++part)
    faces += Shape_io::read_shape(folder.file("cut/part_" + std::to_string(part) + ".ply"))
                 .polygons.size();
  BOOST_TEST(faces == cut.polygons.size());

  folder.write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Outcome outcome = run(folder, "segment_shape", {"cloud.xyz", "--cut", "-o", "c.ply"});
  BOOST_TEST(outcome.exit_code == 1);
  BOOST_TEST(outcome.err.find("no faces") != std::string::npos);
  BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  BOOST_TEST(!std::filesystem::exists(folder.file("c.ply")));
}

BOOST_AUTO_TEST_CASE(pieces_of_faces_keep_what_is_known_of_them)
{
  constexpr int n = 8; // strips of triangles, of which the border crosses one in the middle
  Shape shape;
  Shape_io::Parts parts;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) shape.points.emplace_back(i, j, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const std::size_t a = i * (n + 1) + j, b = a + n + 1;
      shape.polygons.push_back({a, b, b + 1});
      shape.polygons.push_back({a, b + 1, a + 1});
      for (int half = 0; half < 2; ++half) parts.labels.push_back(i + j / 2 < 5 ? 0 : 1);
    }
  parts.quality.assign(parts.labels.size(), 0.5);
  parts.colors.resize(2);
  shape.normals.assign(shape.points.size(), Shape_io::Vector(0, 0, 2));
  shape.point_properties = {{"height", "float", {}}, {"kind", "uchar", {}}};
  for (const auto& p : shape.points)
  {
    shape.point_properties[0].values.push_back(3. * p.x() + p.y());
    shape.point_properties[1].values.push_back(p.x() > 4 ? 9. : 2.);
  }
  shape.face_properties = {
      {"number", "int", {}}, {"texcoord", "float", {}, "uchar", {0}}, {"source_face", "int", {}}};
  for (std::size_t f = 0; f < shape.polygons.size(); ++f)
  {
    shape.face_properties[0].values.push_back(double(f));
    for (const std::size_t p : shape.polygons[f])
    {
      shape.face_properties[1].values.push_back(shape.points[p].x());
      shape.face_properties[1].values.push_back(shape.points[p].y());
    }
    shape.face_properties[1].first.push_back(shape.face_properties[1].values.size());
    shape.face_properties[2].values.push_back(1000.);
  }
  const Shape_io::Cut_shape cut = Shape_io::cut_shape(shape, parts);
  BOOST_TEST_REQUIRE(cut.shape.points.size() > shape.points.size());
  BOOST_TEST(cut.shape.normals.size() == cut.shape.points.size());
  const auto& heights = property(cut.shape.point_properties, "height").values;
  const auto& kinds = property(cut.shape.point_properties, "kind").values;
  for (std::size_t i = 0; i < cut.shape.points.size(); ++i)
  {
    const auto& p = cut.shape.points[i];
    BOOST_TEST(heights[i] == 3. * p.x() + p.y(), boost::test_tools::tolerance(1e-9));
    BOOST_TEST((kinds[i] == 2. || kinds[i] == 9.));
    BOOST_TEST(cut.shape.normals[i].z() == 2., boost::test_tools::tolerance(1e-9));
  }
  const auto& numbers = property(cut.shape.face_properties, "number").values;
  const auto& texture = property(cut.shape.face_properties, "texcoord");
  for (std::size_t f = 0; f < cut.shape.polygons.size(); ++f)
  {
    BOOST_TEST(numbers[f] == double(cut.source_faces[f]));
    const auto& polygon = cut.shape.polygons[f];
    BOOST_TEST_REQUIRE(texture.first[f + 1] - texture.first[f] == 2 * polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const auto& p = cut.shape.points[polygon[i]];
      BOOST_TEST(std::abs(texture.values[texture.first[f] + 2 * i] - p.x()) < 1e-9);
      BOOST_TEST(std::abs(texture.values[texture.first[f] + 2 * i + 1] - p.y()) < 1e-9);
    }
  }
  BOOST_TEST(property(cut.shape.face_properties, "input_source_face").values.front() == 1000.);
}

BOOST_AUTO_TEST_CASE(flat_and_tiny_parts_have_no_hull)
{
  Shape cloud;
  for (int i = 0; i < 8; ++i) cloud.points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  for (int i = 0; i < 5; ++i) cloud.points.emplace_back(i, i * i, 7);
  for (int i = 0; i < 3; ++i) cloud.points.emplace_back(i, i, i);
  cloud.points.emplace_back(9, 9, 9);
  cloud.points.emplace_back(8, 9, 9);
  cloud.points.emplace_back(8, 9, 9);
  const std::vector<int> labels = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 3, 4, 4};
  const Shape_io::Part_hulls hulls = Shape_io::part_hulls(cloud, labels, 5);
  BOOST_TEST(hulls.flat_parts == (std::vector<int>{1, 2, 3, 4}), boost::test_tools::per_element());
  BOOST_TEST_REQUIRE(hulls.hulls.size() == 1u);
  BOOST_TEST(hulls.hulls[0].points.size() == 8u);
  BOOST_TEST(hulls.hulls[0].label == 0);
}

BOOST_AUTO_TEST_CASE(nothing_is_left_when_an_output_fails)
{
  const Scratch_folder folder;
  folder.write("file", "x");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--shape", "table", "--split", "file/parts"},
        {"--shape", "table", "--split", "new/parts", "-o", "/dev/full"},
        {"--shape", "table", "--split", "parts", "--hulls", "no/folder/h.ply"},
        {"--shape", "table", "-o", "/dev/full", "--ascii"},
        {"--shape", "table", "--labels", "/dev/full"},
        {"--shape", "table", "--stats", "/dev/full"},
        {"--shape", "table", "--hulls", "/dev/full"},
        {"--shape", "table", "--hulls", "h.txt"},
        {"--shape", "table", "--min-segment-size", "2"},
        {"--shape", "table", "--min-segment-size", "nan"}})
  {
    const Outcome outcome = run(folder, "segment_shape", words);
    BOOST_TEST(outcome.exit_code == 1);
    if (words.back() == "/dev/full")
      BOOST_TEST(outcome.err.find("cannot write '/dev/full'") != std::string::npos);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    BOOST_TEST(folder.number_of_files() == 1u);
  }
}

BOOST_AUTO_TEST_CASE(small_segments_are_given_away_and_the_cap_holds)
{
  const Scratch_folder folder;
  const auto number_of_parts = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> words = {"--shape", "octopus", "--quiet", "--labels", "l.seg"};
    words.insert(words.end(), more.begin(), more.end());
    BOOST_REQUIRE(run(folder, "segment_shape", words).exit_code == 0);
    const std::vector<int> labels = labels_of(folder, "l.seg");
    return 1 + *std::max_element(labels.begin(), labels.end());
  };
  const int all = number_of_parts({});
  BOOST_TEST(all > 2);
  BOOST_TEST(number_of_parts({"--min-segment-size", "0.3"}) < all);
  BOOST_TEST(number_of_parts({"--max-segments", "2"}) == 2);
  BOOST_TEST(number_of_parts({"--max-segments", "1"}) == 1);
}

BOOST_AUTO_TEST_CASE(no_output_takes_the_place_of_another_file_of_the_run)
{
  const Scratch_folder folder;
  folder.write("a.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  folder.write("b.xyz", "0 0 0\n");
  std::filesystem::create_directory(folder.path() / "s");
  folder.write("s/part_0.ply", "ply\nformat ascii 1.0\ncomment " +
                                   std::string(Shape_io::comment_of_parts) +
                                   "\nelement vertex 1\nproperty float x\nproperty float y\n"
                                   "property float z\nend_header\n0 0 0\n");
  std::filesystem::create_symlink("a.xyz", folder.path() / "link");
  std::filesystem::create_symlink("later", folder.path() / "other");
  const std::size_t files = folder.number_of_files();
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"a.xyz", "-o", "./p.ply", "--hulls", "p.ply"},
           {"a.xyz", "--labels", "later", "--stats", "other"},
           {"a.xyz", "--labels", "a.xyz"},
           {"a.xyz", "--labels", "s/../a.xyz"},
           {"a.xyz", "--stats", "link"},
           {"a.xyz", "--transfer", "b.xyz", "--labels", "b.xyz"},
           {"a.xyz", "--split", "s", "--labels", "s/part_0.ply"},
           {"a.xyz", "--split", "s", "--labels", "./s/part_none.ply"},
           {"s/part_0.ply", "--split", "s"}})
  {
    const Outcome outcome = run(folder, "segment_shape", words);
    BOOST_TEST(outcome.exit_code == 1, words.back());
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    BOOST_TEST(folder.number_of_files() == files);
    BOOST_TEST(folder.read("a.xyz").size() == 18u);
  }
  const Outcome devices =
      run(folder, "segment_shape", {"a.xyz", "-o", "/dev/null", "--labels", "l"});
  BOOST_TEST(devices.exit_code == 0);
}

BOOST_AUTO_TEST_CASE(links_are_followed_and_kept)
{
  const Scratch_folder folder;
  folder.write("a.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  const auto link = [&](const char* to, const char* name)
  { std::filesystem::create_symlink(to, folder.path() / name); };
  const auto is_link = [&](const char* name)
  { return std::filesystem::is_symlink(folder.path() / name); };
  link("new.seg", "to_new");
  link("none/new.seg", "to_nowhere");
  link("circle", "circle");
  link("none", "folder");
  BOOST_TEST(run(folder, "segment_shape", {"a.xyz", "--labels", "to_new"}).exit_code == 0);
  BOOST_TEST(is_link("to_new"));
  BOOST_TEST(labels_of(folder, "new.seg").size() == 3u);
  for (const char* name : {"to_nowhere", "circle"})
    BOOST_TEST(run(folder, "segment_shape", {"a.xyz", "--labels", name}).exit_code == 1);
  BOOST_TEST(run(folder, "segment_shape", {"a.xyz", "--split", "folder"}).exit_code == 1);
  for (const char* name : {"to_nowhere", "circle", "folder"}) BOOST_TEST(is_link(name), name);
}

// What segment_shape prints is lost, or a file may not become so large.
BOOST_AUTO_TEST_CASE(nothing_is_left_when_the_system_refuses)
{
  const Scratch_folder folder;
  const std::string bin_dir = std::getenv("WCS_BIN_DIR") ? std::getenv("WCS_BIN_DIR") : ".";
  for (const std::string command :
       {"%/segment_shape --shape box -o p.ply --labels l.seg >/dev/full",
        "%/segment_shape --shape box -o p.ply --labels l.seg >&-",
        "ulimit -f 8; %/segment_shape --shape box -o p.ply --labels l.seg >/dev/null",
        "%/make_shapes box nosuch", "%/make_shapes \"no\nsuch\"",
        "%/segment_scene \"no\nsuch.ply\" -o p.ply", "%/scan_shape -o none/p.ply"})
  {
    std::string words = command;
    words.replace(words.find('%'), 1, quoted(bin_dir));
    const Scratch_folder output;
    words = "cd " + quoted(folder.path().string()) + "; exec 2>" + quoted(output.file("err")) +
            "; " + words;
    const int status = std::system(words.c_str());
    BOOST_TEST((WIFEXITED(status) && WEXITSTATUS(status) == 1), command);
    const std::string err = output.read("err");
    BOOST_TEST(std::count(err.begin(), err.end(), '\n') == 1, err);
    BOOST_TEST(folder.number_of_files() == 0u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
