// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// segment_shape on standard input and output, with gaps, with labels carried over, and interrupted.

#include <boost/test/unit_test.hpp>

#include "io/shape_io.h"
#include "pcd_files.h"
#include "run_program.h"
#include "scratch_folder.h"
#include "shapes/shape_generator.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

BOOST_AUTO_TEST_SUITE(test_streams)

namespace {

using Shape_io::Shape;

std::vector<int> labels_in(const std::string& text)
{
  std::istringstream lines(text);
  std::vector<int> labels;
  for (int label; lines >> label;) labels.push_back(label);
  return labels;
}

Outcome segment_shape(const Scratch_folder& folder, const Words& words,
                      const std::string& input = "/dev/null")
{
  return run(folder, "segment_shape", words, input);
}

void make_shape(const Scratch_folder& folder, const Words& words)
{
  BOOST_REQUIRE(run(folder, "make_shapes", words).exit_code == 0);
}

// Starts a program in the folder and sends it the signal when wait() returns.
template <typename Wait>
int interrupted_status(const Scratch_folder& folder, const int signal, const Wait& wait,
                       const std::string& name, const std::vector<std::string>& words)
{
  const std::string program = std::string(std::getenv("WCS_BIN_DIR")) + "/" + name;
  const pid_t child = fork();
  if (child == 0)
  {
    if (chdir(folder.path().c_str()) != 0 || std::freopen("/dev/null", "w", stderr) == nullptr)
      _exit(99);
    std::vector<char*> arguments = {const_cast<char*>(program.c_str())};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
    _exit(99);
  }
  wait();
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

// Writes a scene of a million points, in meters: a box on a table, seen from the origin.
void write_table_with_box(const Scratch_folder& folder, const std::string& name)
{
  std::ofstream out(folder.path() / name);
  for (int i = 0; i < 1000; ++i)
    for (int j = 0; j < 1000; ++j)
    {
      const bool is_box = std::abs(i - 500) < 80 && std::abs(j - 500) < 80;
      out << 0.0008 * (i - 500) << ' ' << 0.0008 * (j - 500) << ' ' << (is_box ? 0.7 : 0.8) << '\n';
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(standard_input_and_output_are_files_too)
{
  const Scratch_folder folder;
  make_shape(folder, {"dumbbell"});
  const Outcome usual = segment_shape(folder, {"dumbbell.off", "-o", "a.ply", "--labels", "a.seg"});
  BOOST_REQUIRE(usual.exit_code == 0);
  const Outcome labels = segment_shape(folder, {"-", "--labels", "-"}, "dumbbell.off");
  BOOST_TEST(labels.exit_code == 0);
  BOOST_TEST(labels.out == folder.read("a.seg"));
  BOOST_TEST(labels.err.find("standard input: ") != std::string::npos); // the summary moves there
  const Outcome ply = segment_shape(folder, {"-", "-o", "-", "--quiet"}, "dumbbell.off");
  BOOST_TEST((ply.out == folder.read("a.ply")));
  BOOST_TEST(ply.err == "");
  const Outcome again = segment_shape(folder, {"-", "--labels", "-", "--quiet"}, "a.ply");
  BOOST_TEST(again.out == folder.read("a.seg"));
  const Outcome stats = segment_shape(folder, {"-", "--stats", "-", "--quiet"}, "dumbbell.off");
  BOOST_TEST(stats.out.find("\"input\": \"standard input\"") != std::string::npos);
  for (const Words& words :
       {Words{"-"}, Words{"-", "-o", "-", "--labels", "-"}, Words{"-", "--transfer", "-"}})
  {
    const Outcome refused = segment_shape(folder, words);
    BOOST_TEST(refused.exit_code == 1);
    BOOST_TEST(std::count(refused.err.begin(), refused.err.end(), '\n') == 1);
    BOOST_TEST(refused.out == "");
  }
}

BOOST_AUTO_TEST_CASE(pixels_without_a_measurement_keep_their_place)
{
  const Scratch_folder folder;
  make_shape(folder, {"--cloud", "--points", "3000", "dumbbell"});
  const Shape cloud = Shape_io::read_shape(folder.file("dumbbell.ply"));
  std::ostringstream out;
  out.precision(17);
  out << "# .PCD v0.7\nFIELDS x y z normal_x normal_y normal_z number\nSIZE 8 8 8 8 8 8 4\n"
         "TYPE F F F F F F I\nWIDTH "
      << 2 * cloud.points.size() << "\nHEIGHT 1\nDATA ascii\n";
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    out << "nan nan nan nan nan nan " << 2 * i << '\n';
    out << cloud.points[i] << ' ';
    if (i % 10 == 0) // what normal estimation says of points with too few neighbors
      out << "nan nan nan";
    else
      out << cloud.normals[i];
    out << ' ' << 2 * i + 1 << '\n';
  }
  folder.write("gaps.pcd", out.str());
  const Outcome outcome = segment_shape(folder, {"gaps.pcd", "-o", "a.ply", "--labels", "a.seg",
                                                 "--split", "parts", "--stats", "a.json"});
  BOOST_REQUIRE_EQUAL(outcome.exit_code, 0);
  BOOST_TEST(outcome.out.find(std::to_string(cloud.points.size()) + " of them without") !=
             std::string::npos);
  BOOST_TEST(folder.read("a.json").find("\"number_of_gaps\": " +
                                        std::to_string(cloud.points.size())) != std::string::npos);
  const std::vector<int> labels = labels_in(folder.read("a.seg"));
  const Shape parts = Shape_io::read_shape(folder.file("a.ply"), Shape_io::Gaps::ALLOWED);
  BOOST_REQUIRE(labels.size() == 2 * cloud.points.size());
  BOOST_REQUIRE(parts.points.size() == labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    BOOST_TEST_REQUIRE((labels[i] == -1) == (i % 2 == 0));
    BOOST_TEST_REQUIRE(parts.point_properties[0].values[i] == static_cast<double>(i));
    BOOST_TEST_REQUIRE(Shape_io::is_gap(parts.points[i]) == (i % 2 == 0));
    if (i % 2 == 1) BOOST_TEST_REQUIRE((parts.points[i] == cloud.points[i / 2]));
  }
  BOOST_TEST(*std::max_element(labels.begin(), labels.end()) >= 1);
  std::size_t split_points = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("parts")))
    if (entry.path().filename() != "part_none.ply")
      split_points +=
          Shape_io::read_shape(entry.path().string(), Shape_io::Gaps::ALLOWED).points.size();
  BOOST_TEST(split_points == cloud.points.size());
  BOOST_TEST(std::filesystem::exists(folder.file("parts/part_none.ply")));
  folder.write("tiny.pcd", pcd_file("binary_compressed"));
  BOOST_TEST(segment_shape(folder, {"tiny.pcd", "--labels", "-", "--quiet"}).out ==
             "0\n0\n-1\n0\n0\n0\n");
  BOOST_TEST(segment_shape(folder, {"tiny.pcd", "--stage", "patches", "-o", "b.obj"}).exit_code ==
             0);
}

BOOST_AUTO_TEST_CASE(zeros_in_a_depth_image_are_no_points)
{
  const Scratch_folder folder;
  const auto cloud = Shape_generator::make_cloud("dumbbell", 2000);
  const auto write =
      [&](const std::string& name, const std::string& header, const std::vector<std::string>& first)
  {
    std::ostringstream out;
    out << header;
    for (const std::string& pixel : first) out << pixel << '\n';
    for (const auto& p : cloud.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    folder.write(name, out.str());
  };
  const auto gaps = [&](const std::string& name)
  {
    BOOST_REQUIRE_EQUAL(segment_shape(folder, {name, "--quiet", "--labels", "a.seg"}).exit_code, 0);
    const std::vector<int> labels = labels_in(folder.read("a.seg"));
    const auto count = std::count(labels.begin(), labels.end(), -1);
    BOOST_TEST(std::count(labels.begin(), labels.begin() + count, -1) == count); // the first ones
    return count;
  };
  const std::string size = std::to_string(cloud.points.size() / 2 + 1);
  const auto pcd = [&](const std::string& width, const std::string& height)
  {
    return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + width + "\nHEIGHT " +
           height + "\nDATA ascii\n";
  };
  const std::string all = std::to_string(cloud.points.size() + 2);
  write("image.pcd", pcd(size, "2"), {"0 0 0", "0 -0 0"});
  BOOST_TEST(gaps("image.pcd") == 2);
  write("one.pcd", pcd(size, "2"), {"0 0 0", "0 0 1e-9"}); // may have been measured
  BOOST_TEST(gaps("one.pcd") == 0);
  write("nan.pcd", pcd(size, "2"), {"nan nan nan", "0 0 0"}); // others are written as NaN
  BOOST_TEST(gaps("nan.pcd") == 1);
  write("cloud.pcd", pcd(all, "1"), {"0 0 0", "0 0 0"}); // no image
  BOOST_TEST(gaps("cloud.pcd") == 0);
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex " + all +
                          "\nproperty float x\nproperty float y\nproperty float z\n";
  write("cloud.ply", ply + "end_header\n", {"0 0 0", "0 0 0"});
  BOOST_TEST(gaps("cloud.ply") == 0);
  write("camera.ply",
        ply + "element camera 1\nproperty int viewportx\nproperty int viewporty\nend_header\n",
        {"0 0 0", "0 0 0"});
  folder.write("camera.ply", folder.read("camera.ply") + size + " 2\n");
  BOOST_TEST(gaps("camera.ply") == 2);
  BOOST_REQUIRE_EQUAL(
      segment_shape(folder, {"image.pcd", "--quiet", "-o", "a.ply", "--ascii"}).exit_code, 0);
  const Shape parts = Shape_io::read_shape(folder.file("a.ply"));
  BOOST_TEST((parts.points[0] == CGAL::ORIGIN && parts.points[1] == CGAL::ORIGIN));
  BOOST_TEST(parts.points.size() == cloud.points.size() + 2);
  folder.write("empty.pcd", pcd("2", "2") + "0 0 0\n0 0 0\n0 0 0\n0 0 0\n");
  BOOST_TEST(segment_shape(folder, {"empty.pcd", "--labels", "a.seg"})
                 .err.find("none of its points has coordinates") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(labels_are_carried_to_points_that_were_not_in_the_run)
{
  const Scratch_folder folder;
  make_shape(folder, {"dumbbell"});
  make_shape(folder, {"--cloud", "--points", "20000", "dumbbell"});
  BOOST_REQUIRE(segment_shape(folder, {"dumbbell.off", "-o", "a.ply"}).exit_code == 0);
  const Outcome outcome = segment_shape(
      folder, {"dumbbell.off", "--transfer", "dumbbell.ply", "--quiet", "-o", "dense.ply",
               "--labels", "dense.seg", "--split", "parts", "--hulls", "h.ply"});
  BOOST_REQUIRE_EQUAL(outcome.err, "");
  const Shape cloud = Shape_io::read_shape(folder.file("dumbbell.ply"));
  const Shape dense = Shape_io::read_shape(folder.file("dense.ply"));
  BOOST_TEST((dense.points == cloud.points));
  const std::vector<int> labels = labels_in(folder.read("dense.seg"));
  BOOST_REQUIRE(labels.size() == cloud.points.size());
  // the nearest by hand, for some
  const Shape mesh = Shape_io::read_shape(folder.file("a.ply"));
  const auto& of_faces = std::find_if(mesh.face_properties.begin(), mesh.face_properties.end(),
                                      [](const auto& p) { return p.name == "label"; })
                             ->values;
  std::size_t tested = 0, equal = 0;
  for (std::size_t i = 0; i < labels.size(); i += 200, ++tested)
  {
    double least = 1e300, label = -2.;
    for (std::size_t f = 0; f < mesh.polygons.size(); ++f)
    {
      const auto& c = mesh.polygons[f];
      const double d = CGAL::squared_distance(
          cloud.points[i], CGAL::centroid(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]));
      if (d < least) least = d, label = of_faces[f];
    }
    if (static_cast<int>(label) == labels[i]) ++equal;
  }
  BOOST_TEST(equal * 100 >= tested * 97); // by centroids, which differs at borders
  // onto itself nothing changes, mesh or cloud
  for (const std::string name : {"dumbbell.off", "dumbbell.ply"})
  {
    const std::string usual = segment_shape(folder, {name, "--labels", "-", "--quiet"}).out;
    const std::string carried =
        segment_shape(folder, {name, "--transfer", name, "--labels", "-", "--quiet"}).out;
    BOOST_TEST((usual == carried), name);
  }
}

BOOST_AUTO_TEST_CASE(an_interruption_leaves_nothing)
{
  const Scratch_folder folder;
  make_shape(folder, {"--cloud", "--points", "600000", "figure"});
  const std::size_t files = folder.number_of_files();
  std::size_t in_time = 0;
  for (const auto& [signal, milliseconds] : std::vector<std::pair<int, int>>{
           {SIGINT, 5}, {SIGINT, 200}, {SIGINT, 600}, {SIGTERM, 300}, {SIGHUP, 300}})
  {
    const auto wait = [&, milliseconds = milliseconds]
    { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); };
    const int status = interrupted_status(
        folder, signal, wait, "segment_shape",
        {"figure.ply", "-o", "a.ply", "--labels", "a.seg", "--split", "parts/of/it", "--quiet"});
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) // a fast machine: it was done before
    {
      for (const char* output : {"a.ply", "a.seg", "parts"})
        std::filesystem::remove_all(folder.path() / output);
      continue;
    }
    ++in_time;
    // before the first output is begun the signal ends the program at once
    BOOST_TEST(((WIFEXITED(status) && WEXITSTATUS(status) == 1) ||
                (WIFSIGNALED(status) && WTERMSIG(status) == signal)));
    BOOST_TEST(folder.number_of_files() == files);
  }
  BOOST_TEST(in_time >= 3u);
}

BOOST_AUTO_TEST_CASE(an_interruption_while_writing_leaves_nothing)
{
  const Scratch_folder folder;
  write_table_with_box(folder, "scene.xyz");
  const auto is_writing = [&] // whether there is a file that is begun
  {
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    {
      std::error_code gone;
      if (entry.path().extension() == ".tmp" && entry.file_size(gone) > 0 && !gone) return true;
    }
    return false;
  };
  const auto wait = [&] // for half a minute at most
  {
    for (int i = 0; i < 30000 && !is_writing(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    BOOST_TEST(is_writing());
  };
  for (const auto& [name, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"make_shapes", {"--cloud", "--points", "1000000", "box"}},
           {"scan_shape", {"-o", "scan.ply", "--views", "8", "--resolution", "700"}},
           {"segment_scene", {"scene.xyz", "-o", "parts.ply"}}})
  {
    const int status = interrupted_status(folder, SIGTERM, wait, name, words);
    BOOST_TEST(WIFEXITED(status), name);
    BOOST_TEST(WEXITSTATUS(status) == 1, name);
    BOOST_TEST(folder.number_of_files() == 1u, name);
  }
}

BOOST_AUTO_TEST_CASE(a_reader_that_goes_away_leaves_nothing)
{
  const Scratch_folder folder;
  make_shape(folder, {"figure"});
  const std::size_t files = folder.number_of_files();
  const std::string command =
      "cd " + quoted(folder.path().string()) + " && " +
      quoted(std::string(std::getenv("WCS_BIN_DIR")) + "/segment_shape") +
      " figure.off -o - --labels a.seg --quiet 2>/dev/null | head -c 10 >/dev/null";
  BOOST_TEST(std::system(command.c_str()) == 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  BOOST_TEST(folder.number_of_files() == files);
}

BOOST_AUTO_TEST_CASE(bad_input_is_answered_within_a_second)
{
  const Scratch_folder folder;
  folder.write("a b.xyz", "0 0 0\n0 0 inf\n");
  folder.write("\xc3\xa4\xe4\xb8\xad\xf0\x9f\x98\x80.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n");
  make_shape(folder, {"figure"});
  const std::size_t files = folder.number_of_files();
  for (const Words& words :
       {Words{"a b.xyz", "-o", "x.ply"},
        Words{"\xc3\xa4\xe4\xb8\xad\xf0\x9f\x98\x80.off", "-o", "x.ply"},
        Words{"none.ply", "-o", "x.ply"}, Words{"figure.off", "-o", "no/x.ply"},
        Words{"figure.off", "--transfer", "none.ply", "-o", "x.ply"},
        Words{"figure.off", "-o", "x.ply", "--split", "figure.off"}})
  {
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = segment_shape(folder, words);
    // a second, and another one for a busy machine
    BOOST_TEST((std::chrono::steady_clock::now() - start < std::chrono::seconds(2)));
    BOOST_TEST(outcome.exit_code == 1);
    BOOST_TEST(outcome.out == "");
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    BOOST_TEST(folder.number_of_files() == files);
  }
}

BOOST_AUTO_TEST_SUITE_END()
