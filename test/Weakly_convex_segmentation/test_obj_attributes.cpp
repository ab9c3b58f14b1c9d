// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What OBJ files have besides points and faces: nothing of it is lost in the outputs.

#include <boost/test/unit_test.hpp>

#include "io/shape_io.h"
#include "run_program.h"
#include "scratch_folder.h"
#include "shapes/shape_generator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_obj_attributes)

namespace {

using Shape_io::Shape;
using Numbers = std::vector<double>;

// A face with all that holds for it; texture coordinates and normals are empty where it has none.
struct Obj_face
{
  std::vector<Numbers> corners; // points, then texture coordinates, then normal of each
  std::string material, names, smoothing;

  friend bool operator<(const Obj_face& a, const Obj_face& b)
  {
    return std::tie(a.corners, a.material, a.names, a.smoothing) <
           std::tie(b.corners, b.material, b.names, b.smoothing);
  }
  friend bool operator==(const Obj_face& a, const Obj_face& b) { return !(a < b) && !(b < a); }
};

struct Obj
{
  std::vector<Numbers> v, vt, vn;
  std::multiset<Obj_face> faces;
  std::vector<std::string> libraries, parts;
};

// A reader for sound files, which has nothing in common with ours.
Obj parsed(const std::string& text)
{
  Obj obj;
  std::string object, group;
  Obj_face face;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string keyword, rest;
    words >> keyword;
    const auto numbers = [&]
    {
      Numbers result;
      for (double d; words >> d;) result.push_back(d);
      return result;
    };
    if (keyword == "v") obj.v.push_back(numbers());
    if (keyword == "vt") obj.vt.push_back(numbers());
    if (keyword == "vn") obj.vn.push_back(numbers());
    if (keyword == "f")
    {
      face.corners.clear();
      for (std::string corner; words >> corner;)
      {
        std::istringstream digits(corner);
        Numbers all;
        for (const auto* table : {&obj.v, &obj.vt, &obj.vn})
        {
          std::string index;
          std::getline(digits, index, '/');
          if (!index.empty())
            all.insert(all.end(), (*table)[std::stoul(index) - 1].begin(),
                       (*table)[std::stoul(index) - 1].end());
        }
        face.corners.push_back(all);
      }
      face.names = object + (object.empty() || group.empty() ? "" : " ") + group;
      obj.faces.insert(face);
    }
    std::getline(words >> std::ws, rest);
    if (keyword == "usemtl") face.material = rest;
    if (keyword == "mtllib") obj.libraries.push_back(rest);
    if (keyword == "s") face.smoothing = rest == "off" || rest == "0" ? "" : rest;
    if (keyword == "o") object = rest;
    if (keyword == "g") group = rest;
    if (keyword == "g" && rest.compare(0, 5, "part_") == 0) // ours
    {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      obj.parts.push_back(rest.substr(0, end));
      group = rest.substr(std::min(end + 1, rest.size()));
    }
  }
  return obj;
}

Shape read(const std::string& text)
{
  const Scratch_folder folder;
  return Shape_io::read_shape(folder.write("a.obj", text));
}

std::string failure(const std::string& text)
{
  try
  {
    read(text);
  }
  catch (const Shape_io::File_error& error)
  {
    return error.what();
  }
  return "";
}

std::string written(const Shape& shape, const std::vector<int>& labels)
{
  std::ostringstream out;
  Shape_io::write_obj_groups(out, shape, labels, 2);
  return out.str();
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\n";

// A mesh with texture coordinates that are x and y of each point, a normal a face, and names by where it is.
std::string textured_mesh()
{
  const auto mesh = Shape_generator::make_mesh("dumbbell");
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "mtllib paint 1.mtl\no thing\n";
  for (const auto& p : mesh.points)
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << " 0.5 0.25 1\nvt " << p[0] << ' ' << p[1]
        << '\n';
  std::size_t number = 0;
  for (const auto& f : mesh.faces)
  {
    ++number;
    out << "vn 0 " << number << " 1\ng " << (number % 3 == 0 ? "third" : "other one") << "\nusemtl "
        << (mesh.points[f[0]][1] > 0. ? "wood" : "Steel #1") << "\ns " << number % 2 << "\nf";
    for (const auto corner : f) out << ' ' << corner + 1 << '/' << corner + 1 << '/' << number;
    out << '\n';
  }
  return out.str();
}

void check_texture_is_the_place(const Obj& obj)
{
  double farthest = 0.;
  for (const Obj_face& face : obj.faces)
    for (const Numbers& corner : face.corners) // 6 of the point, 2, 3
    {
      BOOST_TEST_REQUIRE(corner.size() == 11u);
      farthest =
          std::max({farthest, std::abs(corner[0] - corner[6]), std::abs(corner[1] - corner[7])});
    }
  BOOST_TEST(farthest < 1e-9);
}

} // namespace

BOOST_AUTO_TEST_CASE(nothing_of_a_face_is_lost)
{
  const std::string text =
      "mtllib a b.mtl\nmtllib ..\\c#d.mtl\n" + square +
      "vt 0 0\nvt 0.1 0.30000000000000004\nvt 1 1\nvn 0 0 1\nvn 0.6 0 0.8\n"
      "f 1 2 3\nusemtl wood\ng a b\nf 1/1 2/2 3/3\no box 1\nf 1//1 2//2 3//1 4//2\ns 7\nusemtl "
      "Steel #2\nf 1/1/1 2/2/1 3/3/2\ng\ns off\nusemtl wood\nf 4/3/2 3/3/2 2/3/2\n";
  const Obj before = parsed(text);
  BOOST_TEST_REQUIRE(before.faces.size() == 5u);
  const Shape shape = read(text);
  for (const std::vector<int>& labels : {std::vector<int>{0, 0, 0, 0, 0}, {0, 1, 0, 1, 0}})
  {
    const std::string out = written(shape, labels);
    const Obj after = parsed(out);
    BOOST_TEST((after.v == before.v));
    BOOST_TEST((after.faces == before.faces));
    BOOST_TEST(after.libraries == before.libraries);
    BOOST_TEST(written(read(out), {0, 0, 0, 0, 0}).find("part_0 part_") == std::string::npos);
  }
  BOOST_TEST(shape.notes.empty());
  // a material can't be taken back
  const std::string out = written(shape, {1, 0, 0, 0, 0});
  BOOST_TEST(out.find("usemtl None\nf 1 2 3\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(colors_of_points_are_kept)
{
  const std::string text = "v 0 0 0 0.1 0.2 1\nv 1 0 0\nv 0 1 0 1 1 1 0\nf 1 2 3\n";
  const Shape shape = read(text);
  BOOST_TEST_REQUIRE(shape.point_properties.size() == 3u);
  BOOST_TEST(shape.point_properties[1].name == "green");
  BOOST_TEST(shape.point_properties[1].values[2] == 1.);
  BOOST_TEST(Shape_io::renamed_properties(shape).find("green as input_green") != std::string::npos);
  const Obj after = parsed(written(shape, {0}));
  BOOST_TEST(after.v[0] == (Numbers{0, 0, 0, 0.1, 0.2, 1}));
  BOOST_TEST(after.v[1] == (Numbers{1, 0, 0}));
  BOOST_TEST(after.v[2] ==
             (Numbers{0, 1, 0, 1, 1, 0})); // 1 before it is a weight that says nothing
}

BOOST_AUTO_TEST_CASE(what_has_no_place_is_told)
{
  const Shape shape = read(square + "vt 0 0 0\nl 1 2\nl 2 3\nvp 1\nf 1/1 2 3\nv 0 0 0 0.5\n");
  BOOST_TEST_REQUIRE(shape.notes.size() == 3u);
  BOOST_TEST(shape.notes[0].find("1 points have more numbers") == 0u);
  BOOST_TEST(shape.notes[1].find("1 faces have texture coordinates at some") == 0u);
  BOOST_TEST(shape.notes[2] == "lines that are left out: l (2), vp (1)");
}

BOOST_AUTO_TEST_CASE(stray_indices_are_refused_with_their_line)
{
  const std::string tables = "vt 0 0\nvn 0 0 1\n"; // lines 5 and 6
  BOOST_TEST(failure(square + tables + "f 1/1/1 2/1/1 3/1/1\n") == "");
  BOOST_TEST(failure(square + "f 1/1 2/1 3/1\nvt 0 0\n") == ""); // behind the face
  for (const std::string face : {"1/2 2/1 3/1", "1//2 2 3", "1/0 2/1 3/1", "1/-2 2/1 3/1",
                                 "1/99999999999999999999 2/1 3/1", "1/x 2 3", "1/1/1/1 2 3"})
    BOOST_TEST(failure(square + tables + "f " + face + "\n").find("line 7 has") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(programs_keep_what_an_obj_file_has)
{
  const Scratch_folder folder;
  const std::string text = textured_mesh();
  folder.write("a.obj", text);
  const Obj before = parsed(text);
  const Outcome outcome = run(folder, "segment_shape",
                              {"a.obj", "-o", "p.obj", "--split", "parts", "--max-segments", "2"});
  BOOST_TEST_REQUIRE(outcome.exit_code == 0);
  BOOST_TEST(outcome.out.find("'paint 1.mtl' must lie in") != std::string::npos); // for parts/ only
  BOOST_TEST(outcome.out.find("'paint 1.mtl' must lie in") == outcome.out.rfind("'paint 1.mtl'"));
  const Obj after = parsed(folder.read("p.obj"));
  BOOST_TEST((after.v == before.v));
  BOOST_TEST((after.faces == before.faces));
  BOOST_TEST((std::set<std::string>(after.parts.begin(), after.parts.end()).size()) == 2u);

  std::multiset<Obj_face> faces;
  for (const std::string name : {"parts/part_0.obj", "parts/part_1.obj"})
  {
    const Obj part = parsed(folder.read(name));
    BOOST_TEST(part.libraries == before.libraries);
    BOOST_TEST(part.v.size() < before.v.size());
    faces.insert(part.faces.begin(), part.faces.end());
  }
  BOOST_TEST((faces == before.faces));

  // parts of an earlier run of any kind give way, others do not
  BOOST_TEST(
      run(folder, "segment_shape", {"--shape", "table", "--quiet", "--split", "parts"}).exit_code ==
      0);
  BOOST_TEST(!folder.has("parts/part_0.obj"));
  BOOST_TEST(folder.has("parts/part_0.ply"));
  BOOST_TEST(run(folder, "segment_shape", {"a.obj", "--quiet", "--split", "parts"}).exit_code == 0);
  BOOST_TEST(!folder.has("parts/part_0.ply"));
  folder.write("parts/part_7.obj", "v 0 0 0\n");
  BOOST_TEST(run(folder, "segment_shape", {"a.obj", "--quiet", "--split", "parts"}).exit_code == 1);
  BOOST_TEST(folder.read("parts/part_7.obj") == "v 0 0 0\n");
}

BOOST_AUTO_TEST_CASE(cut_faces_have_texture_coordinates_of_their_place)
{
  const Scratch_folder folder;
  const std::string text = textured_mesh();
  folder.write("a.obj", text);
  const Words words = {"a.obj", "--quiet", "--cut", "--max-segments", "2", "-o"};
  for (const std::string name : {"p.obj", "p.ply"})
  {
    Words all = words;
    all.push_back(name);
    BOOST_TEST_REQUIRE(run(folder, "segment_shape", all).exit_code == 0);
  }
  const Obj before = parsed(text), after = parsed(folder.read("p.obj"));
  BOOST_TEST(after.faces.size() > before.faces.size());
  check_texture_is_the_place(after);
  for (const Obj_face& face : after.faces)
    for (const Numbers& corner : face.corners) // all corners of a face have its normal
      BOOST_TEST_REQUIRE(std::abs(corner[9] - face.corners[0][9]) < 1e-9 * corner[9]);
  const Shape ply = Shape_io::read_shape(folder.file("p.ply"));
  BOOST_TEST(ply.polygons.size() == after.faces.size());
  for (const std::string name : {"texcoord", "corner_normal", "material", "group", "smoothing"})
    BOOST_TEST(std::count_if(ply.face_properties.begin(), ply.face_properties.end(),
                             [&](const auto& p) { return p.name == name; }) == 1);
  const std::string head = folder.read("p.ply").substr(0, 1000);
  BOOST_TEST(head.find("\ncomment mtllib paint 1.mtl\n") != std::string::npos);
  BOOST_TEST(head.find(" Steel #1\n") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
