// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Scenes (glTF, GLB, 3MF, DAE, FBX) and files that gzip has compressed, all made here.

#include <boost/test/unit_test.hpp>

#include "io/gunzip.h"
#include "io/read_scene.h"
#include "io/shape_io.h"
#include "scene_files.h"
#include "scratch_folder.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_more_formats)

namespace {

using namespace Scene_files;
using Shape_io::Point;
using Shape_io::Shape;

// Tests of what is not built in pass with a word.
bool is_built_in(const bool can, const std::string& what)
{
  if (!can) BOOST_TEST_MESSAGE("skipped: this build has no " + what);
  return can;
}

bool has_scenes() { return is_built_in(Shape_io::internal::can_read_scenes(), "assimp"); }
bool has_gzip() { return is_built_in(Shape_io::internal::can_gunzip(), "Boost.Iostreams"); }

Shape read(const std::string& name, const std::string& bytes)
{
  const Scratch_folder folder;
  return Shape_io::read_shape(folder.write(name, bytes));
}

// One line of plain text that names the file, the cause and what to do.
std::string failure(const std::string& name, const std::string& bytes)
{
  std::string message;
  try
  {
    read(name, bytes);
  }
  catch (const Shape_io::File_error& error)
  {
    message = error.what();
  }
  BOOST_TEST(message.find(name) != std::string::npos);
  BOOST_TEST(message.find("; ") != std::string::npos);
  BOOST_TEST(std::all_of(message.begin(), message.end(),
                         [](const char c) { return c >= ' ' && c <= '~'; }));
  return message;
}

std::vector<Point> sorted(std::vector<Point> points)
{
  std::sort(points.begin(), points.end());
  return points;
}

// Six times the volume that the faces enclose, counted negative if they look inwards.
double volume(const Shape& shape)
{
  double sum = 0.;
  for (const auto& f : shape.polygons)
    sum += CGAL::determinant(shape.points[f[0]] - CGAL::ORIGIN, shape.points[f[1]] - CGAL::ORIGIN,
                             shape.points[f[2]] - CGAL::ORIGIN);
  return sum;
}

void check_tetrahedron(const Shape& shape)
{
  BOOST_TEST((sorted(shape.points) == sorted(corners)));
  BOOST_TEST(shape.polygons.size() == 4u);
  BOOST_TEST(volume(shape) == 2.);
}

bool has_note(const Shape& shape, const std::string& words)
{
  return std::any_of(shape.notes.begin(), shape.notes.end(),
                     [&](const std::string& note)
                     { return note.find(words) != std::string::npos; });
}

} // namespace

BOOST_AUTO_TEST_CASE(scenes_of_one_mesh_are_that_mesh)
{
  if (!has_scenes()) return;
  const std::string item = "<item objectid=\"1\"/>";
  for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"a.gltf", gltf(embedded())},
           {"a.GLB", glb()},
           {"a.3mf", file_3mf(object_3mf(1, mesh_3mf()), item)},
           {"z.dae", dae("<up_axis>Z_UP</up_axis>")},
           {"x.dae", dae("<up_axis>X_UP</up_axis>")},
           {"y.dae", dae("")},
           {"a.fbx", fbx()}})
  {
    BOOST_TEST_CONTEXT(name)
    {
      const Shape shape = read(name, bytes);
      check_tetrahedron(shape);
      BOOST_TEST(shape.notes.empty());
    }
  }
  const Shape centimeters = read("a.dae", dae("<unit name=\"cm\" meter=\"0.5\"/>"));
  BOOST_TEST(volume(centimeters) == 0.25);
  BOOST_TEST(has_note(centimeters, "0.5 m"));
}

BOOST_AUTO_TEST_CASE(each_instance_has_its_place)
{
  if (!has_scenes()) return;
  const std::string nodes =
      "[{\"mesh\":0,\"name\":\"first\",\"translation\":[10,0,0],\"children\":[1]},"
      "{\"mesh\":0,\"name\":\"second\",\"scale\":[-1,1,2],\"translation\":[0,5,0]}]";
  const Shape shape = read("a.gltf", gltf(embedded(), nodes));
  BOOST_TEST_REQUIRE(shape.points.size() == 8u);
  BOOST_TEST((shape.points[1] == Point(12, 0, 0)));
  BOOST_TEST((shape.points[5] == Point(8, 5, 0)));
  BOOST_TEST((shape.points[7] == Point(10, 5, 2)));
  BOOST_TEST(volume(shape) == 2. + 4.); // mirrored faces look outwards, too
  BOOST_TEST_REQUIRE(shape.face_words.size() == 1u);
  BOOST_TEST(shape.face_words[0].name == "object");
  BOOST_TEST(shape.face_words[0].words == (std::vector<std::string>{"first", "second"}));
  BOOST_TEST(shape.face_properties[0].values == (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
}

BOOST_AUTO_TEST_CASE(attributes_of_scenes_are_kept)
{
  if (!has_scenes()) return;
  const Shape shape = read("a.gltf", textured_gltf());
  BOOST_TEST_REQUIRE(shape.points.size() == 6u);
  BOOST_TEST_REQUIRE(shape.normals.size() == 6u);
  BOOST_TEST((shape.normals[5] == Shape_io::Vector(0, 0, 1)));
  BOOST_TEST_REQUIRE(shape.point_properties.size() == 3u);
  BOOST_TEST(shape.point_properties[1].values == (std::vector<double>{0, 1, 0, 0, 1, 0}));
  BOOST_TEST_REQUIRE(shape.face_properties.size() == 3u);
  BOOST_TEST(shape.face_properties[0].name == "texcoord");
  BOOST_TEST(shape.face_properties[0].values == // glTF counts v downwards
             (std::vector<double>{0, 1, 1, 1, 0.5, 0.75, 0, 1, 1, 1, 0.5, 0.75}));
  BOOST_TEST(shape.face_properties[1].name == "material");
  BOOST_TEST_REQUIRE(shape.face_words.size() == 2u);
  BOOST_TEST(shape.face_words[0].words.size() == 2u);
  for (std::size_t i = 0; i < 2; ++i)
    BOOST_TEST(shape.face_words[0].words[std::size_t(shape.face_properties[1].values[i])] ==
               (i == 0 ? "steel" : "wood"));
  BOOST_TEST(has_note(shape, "of its materials only the names"));
}

BOOST_AUTO_TEST_CASE(items_and_components_of_3mf)
{
  if (!has_scenes()) return;
  const std::string both =
      "<components><component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 100 0 0\"/>"
      "<component objectid=\"2\"/></components>";
  const Shape shape = read(
      "a.3mf",
      file_3mf(
          object_3mf(1, mesh_3mf()) + object_3mf(2, mesh_3mf()) + object_3mf(3, both),
          "<item objectid=\"1\"/><item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 0 50 0\"/>"));
  BOOST_TEST_REQUIRE(shape.points.size() == 12u);
  BOOST_TEST(volume(shape) == 6.);
  for (const Point& p : {Point(2, 0, 0), Point(98, 50, 0), Point(2, 50, 0)})
    BOOST_TEST(std::count(shape.points.begin(), shape.points.end(), p) == 1);

  const std::string itself = "<components><component objectid=\"1\"/></components>";
  BOOST_TEST(
      failure("a.3mf", file_3mf(object_3mf(1, itself), "<item objectid=\"1\"/>")).find("crashes") !=
      std::string::npos);
  BOOST_TEST(failure("a.3mf", file_3mf(object_3mf(1, mesh_3mf()), "<item objectid=\"1\"/>",
                                       "3D/Objects/a.model"))
                 .find("production extension") != std::string::npos);
  failure("a.3mf", file_3mf(object_3mf(1, mesh_3mf()), ""));
}

BOOST_AUTO_TEST_CASE(points_of_gltf_are_a_cloud)
{
  if (!has_scenes()) return;
  const Shape cloud = read("a.gltf", gltf(embedded(), "[{\"mesh\":0}]", "\"mode\":0"));
  BOOST_TEST(!cloud.is_mesh());
  BOOST_TEST((cloud.points == corners));
}

BOOST_AUTO_TEST_CASE(buffers_beside_a_gltf_file)
{
  if (!has_scenes()) return;
  const Scratch_folder folder;
  folder.write("my data.bin", gltf_buffer());
  for (const std::string name : {"my data.bin", "my%20data.bin"})
    check_tetrahedron(
        Shape_io::read_shape(folder.write("a.gltf", gltf(",\"uri\":\"" + name + '"'))));
  BOOST_TEST(failure("a.gltf", gltf(",\"uri\":\"my data.bin\"")).find("my data.bin") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(compressed_files_are_what_they_hold)
{
  if (!has_gzip()) return;
  std::ostringstream off, ply, xyz;
  off << "OFF\n4 4 0\n";
  ply << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
         "float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& p : corners)
  {
    for (std::ostringstream* const out : {&off, &ply}) *out << p << '\n';
    xyz << p << '\n';
  }
  for (const auto& f : faces)
    for (std::ostringstream* const out : {&off, &ply})
      *out << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  check_tetrahedron(read("a.off.gz", gzip(off.str())));
  check_tetrahedron(read("a.PLY.GZ", gzip(ply.str())));
  BOOST_TEST((read("a.xyz.gz", gzip(xyz.str())).points == corners));
  BOOST_TEST(read("two.xyz.gz", gzip(xyz.str()) + gzip(xyz.str())).points.size() == 8u);
  if (Shape_io::internal::can_read_scenes()) check_tetrahedron(read("a.glb.gz", gzip(glb())));

  const std::string whole = gzip(ply.str());
  for (std::size_t size = 2; size < whole.size(); ++size)
    BOOST_TEST(failure("a.ply.gz", whole.substr(0, size)).find("damaged or cut off") !=
               std::string::npos);
  std::string damaged = whole;
  damaged[40] ^= 1; // the checksum tells
  failure("a.ply.gz", damaged);
  BOOST_TEST(failure("a.ply.gz", ply.str()).find("not compressed") != std::string::npos);
  BOOST_TEST(failure("a.xyz.gz", gzip("")).find("empty") != std::string::npos);
  BOOST_TEST(failure("a.gz", whole).find("extension") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_not_read_is_told)
{
  for (const std::string name : {"a.las", "a.laz", "a.e57", "a.LAS.gz"})
    BOOST_TEST(failure(name, "x").find("CloudCompare") != std::string::npos);
  const std::string message = failure("a.stp", "x");
  for (const std::string extension : {".gltf", ".glb", ".3mf", ".dae", ".fbx", ".gz", ".pts"})
    BOOST_TEST(message.find(extension) != std::string::npos);
  if (!Shape_io::internal::can_read_scenes())
    BOOST_TEST(failure("a.glb", glb()).find("libassimp-dev") != std::string::npos);
  if (!Shape_io::internal::can_gunzip())
    BOOST_TEST(failure("a.ply.gz", gzip("ply\n")).find("libboost-iostreams-dev") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(formats_of_scenes_show_in_their_first_bytes)
{
  BOOST_TEST((Shape_io::internal::reader_for_bytes(glb()) == Shape_io::internal::read_glb));
  BOOST_TEST(
      (Shape_io::internal::reader_for_bytes(file_3mf("", "")) == Shape_io::internal::read_3mf));
}

// A bounded run, as assimp is not ours: each file is read or refused.
BOOST_AUTO_TEST_CASE(damaged_scenes_are_read_or_refused)
{
  const std::vector<std::pair<std::string, std::string>> sound = {
      {"a.gltf", gltf(embedded())},
      {"a.glb", glb()},
      {"a.3mf", file_3mf(object_3mf(1, mesh_3mf()), "<item objectid=\"1\"/>")},
      {"a.dae", dae("")},
      {"a.fbx", fbx()},
      {"a.ply.gz",
       gzip("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n0 0 0\n")}};
  const char* const more = std::getenv("WCS_SCENE_RUNS");
  const unsigned int runs = more ? static_cast<unsigned int>(std::atoi(more)) : 300;
  std::size_t answers = 0;
  const Scratch_folder folder;
  for (unsigned int seed = 0; seed < runs; ++seed)
  {
    std::mt19937 random(seed);
    auto [name, bytes] = sound[seed % sound.size()];
    if (seed < 2 * sound.size()) // garbage
      for (char& c : bytes) c = static_cast<char>(random() % 256);
    for (unsigned int i = 0; i <= seed % 3; ++i)
    {
      const std::size_t at = random() % bytes.size();
      if (random() % 4 == 0)
        bytes.resize(at + 1);
      else
        bytes[at] = static_cast<char>(random() % 2 == 0 ? random() % 256
                                                        : "0123456789-[]{}<>"[random() % 17]);
    }
    try
    {
      Shape_io::read_shape(folder.write(name, bytes));
      ++answers;
    }
    catch (const Shape_io::File_error&)
    {}
  }
  BOOST_TEST_MESSAGE(answers << " of " << runs << " were read");
  if (has_scenes() && has_gzip()) BOOST_TEST(answers > 0u);
  BOOST_TEST(answers < runs);
}

BOOST_AUTO_TEST_SUITE_END()
