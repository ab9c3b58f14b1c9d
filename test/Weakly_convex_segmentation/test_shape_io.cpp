// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "io/separate_parts.h"
#include "io/shape_io.h"
#include "scratch_folder.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_shape_io)

namespace {

using Shape_io::Encoding;
using Shape_io::Parts;
using Shape_io::Point;
using Shape_io::Property;
using Shape_io::Shape;
using Polygons = std::vector<std::vector<std::size_t>>;

const std::vector<Point> square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
const std::string square_off_points = "0 0 0\n1 0 0\n0 1 0\n1 1 0.5\n";
const Polygons two_triangles = {{0, 1, 2}, {1, 3, 2}};

template <typename Number>
void append(std::string& bytes, const Number number, const bool big_endian = false)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  if (big_endian) std::reverse(raw, raw + sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

// All kinds of numbers, extra properties of points and faces, a list, a further element.
std::string binary_ply(const bool big_endian)
{
  std::string bytes = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                      "_endian 1.0\ncomment of a test\nelement vertex 4\nproperty double x\n"
                      "property float y\nproperty double z\nproperty short heat\n"
                      "element edge 1\nproperty list uchar int ends\nelement face 2\n"
                      "property uchar kind\nproperty list uint ushort vertex_index\nend_header\n";
  for (std::size_t i = 0; i < square.size(); ++i)
  {
    append(bytes, square[i].x(), big_endian);
    append(bytes, static_cast<float>(square[i].y()), big_endian);
    append(bytes, square[i].z(), big_endian);
    append(bytes, static_cast<std::int16_t>(-300 - int(i)), big_endian);
  }
  append(bytes, std::uint8_t(2));
  append(bytes, std::int32_t(0), big_endian);
  append(bytes, std::int32_t(1), big_endian);
  for (const auto& triangle : two_triangles)
  {
    append(bytes, std::uint8_t(7));
    append(bytes, std::uint32_t(3), big_endian);
    for (const std::size_t corner : triangle) append(bytes, std::uint16_t(corner), big_endian);
  }
  return bytes;
}

std::string binary_stl(const std::string& header, const float last_coordinate = 0.5f)
{
  std::string bytes = header + std::string(80 - header.size(), ' ');
  append(bytes, std::uint32_t(2));
  for (const auto& triangle : two_triangles)
  {
    bytes.append(12, '\0');
    for (const std::size_t corner : triangle)
    {
      append(bytes, static_cast<float>(square[corner].x()));
      append(bytes, static_cast<float>(square[corner].y()));
      append(bytes, corner == 3 ? last_coordinate : static_cast<float>(square[corner].z()));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ascii_stl()
{
  std::ostringstream text;
  text << "solid square\n";
  for (const auto& triangle : two_triangles)
  {
    text << "facet normal 0 0 1\nouter loop\n";
    for (const std::size_t corner : triangle) text << "vertex " << square[corner] << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid square\n";
  return text.str();
}

std::string ply_header(const std::string& point_type, const std::size_t points)
{
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) + "\nproperty " +
         point_type + " x\nproperty " + point_type + " y\nproperty " + point_type + " z\n";
}

// Returns the message of the failure, and checks that it was silent and is of one line.
std::string failure(const std::string& path)
{
  std::ostringstream printed;
  std::streambuf* const saved = std::cerr.rdbuf(printed.rdbuf());
  std::string message;
  try
  {
    Shape_io::read_shape(path);
  }
  catch (const Shape_io::File_error& error)
  {
    message = error.what();
  }
  std::cerr.rdbuf(saved);
  BOOST_TEST(!message.empty());
  BOOST_TEST(printed.str().empty());
  BOOST_TEST(std::count(message.begin(), message.end(), '\n') == 0);
  BOOST_TEST(message.find(path) != std::string::npos);
  BOOST_TEST(message.find("; ") != std::string::npos); // what to do
  return message;
}

const Property& property(const std::vector<Property>& properties, const std::string& name)
{
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const Property& p) { return p.name == name; });
  BOOST_REQUIRE(found != properties.end());
  return *found;
}

} // namespace

BOOST_AUTO_TEST_CASE(meshes_are_read_as_they_are)
{
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.off", "OFF\n4 2 0\n" + square_off_points + "3 0 1 2\n3 1 3 2"},
      {"crlf.OFF",
       "OFF 4 2 0\r\n# a\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n1 1 .5\r\n3 0 1 2\r\n3 1 3 2\r\n"},
      {"color.off", "COFF\n4 2 0\n0 0 0 9 9 9 9\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n1 1 .5 9 9 9 9\n"
                    "3 0 1 2 9 9 9\n3 1 3 2 9 9 9\n"},
      {"a.obj", "# a\no a\nv 0 0 0\nv 1 0 0\nvt 0 0\nvn 0 0 1\nv 0 1 0\nv 1 1 0.5\ng b\n"
                "usemtl c\nf 1/1/1 2/1/1 3//1\r\nf -3\t-1\t-2\n"},
      {"ascii.ply", ply_header("float", 4) +
                        "element face 2\nproperty list uchar int "
                        "vertex_indices\nend_header\n" +
                        square_off_points + "3 0 1 2\n3 1 3 2\n"},
      {"bytes.ply", ply_header("double", 4) +
                        "element face 2\nproperty list char uchar "
                        "vertex_index\nend_header\n" +
                        square_off_points + "3 0 1 2\n3 1 3 2\n"},
      {"little.ply", binary_ply(false)},
      {"big.PLY", binary_ply(true)},
      {"ascii.stl", ascii_stl()},
      {"binary.stl", binary_stl("x")},
      {"solid.Stl", binary_stl("solid but binary")},
      {"with a space and \xc3\xa4.off", "OFF\n4 2 0\n" + square_off_points + "3 0 1 2\n3 1 3 2\n"}};
  const Scratch_folder folder;
  for (const auto& [name, content] : files)
  {
    BOOST_TEST_CONTEXT(name)
    {
      const Shape shape = Shape_io::read_shape(folder.write(name, content));
      BOOST_TEST(
          (shape.polygons == two_triangles || shape.polygons == Polygons({{0, 1, 2}, {1, 3, 2}})));
      BOOST_TEST((shape.points == square));
      BOOST_TEST(shape.is_mesh());
    }
  }
}

BOOST_AUTO_TEST_CASE(clouds_are_read_as_they_are)
{
  const Scratch_folder folder;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.xyz", "# a\n0 0 0\r\n1\t0\t0\n\n0 1 0\n1 1 0.5"},
      {"a.off", "OFF\n4 0 0\n" + square_off_points},
      {"a.ply", ply_header("double", 4) + "end_header\n" + square_off_points},
      {"color.off", "COFF\n4 0 0\n0 0 0 9 9 9 9\n1 0 0\n0 1 0 9 9 9 9\n1 1 .5 9 9 9\n"},
      {"integers.ply", ply_header("int", 3) + "end_header\n0 0 0\n1 0 0\n0 1 0\n"}};
  for (const auto& [name, content] : files)
  {
    const Shape shape = Shape_io::read_shape(folder.write(name, content));
    BOOST_TEST(!shape.is_mesh());
    BOOST_TEST(shape.normals.empty());
    BOOST_TEST(std::equal(shape.points.begin(), shape.points.end(), square.begin()));
    BOOST_TEST(shape.points.size() == (name == "integers.ply" ? 3u : 4u));
  }
  for (const std::string name : {"n.pwn", "n.xyz", "c.xyz", "n.off", "nn.off"})
  {
    const std::string header = name == "n.off"    ? "OFF\n2 0 0\n"
                               : name == "nn.off" ? "NOFF\n2 0 0\n"
                               : name == "c.xyz"  ? "2\n"
                                                  : "";
    const Shape shape =
        Shape_io::read_shape(folder.write(name, header + "0 0 0 0 0 1\n1 0 0 0 1 0\n"));
    BOOST_REQUIRE(shape.normals.size() == 2);
    BOOST_TEST((shape.normals[1] == Shape_io::Vector(0, 1, 0)));
  }
}

BOOST_AUTO_TEST_CASE(bad_files_are_refused_in_one_line)
{
  const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string ply_faces = "element face 1\nproperty list uint int vertex_indices\n";
  std::string cut = binary_ply(false), list_too_long = binary_ply(false);
  cut.resize(cut.size() - 9);
  list_too_long[list_too_long.size() - 7] = '\x70'; // the last length becomes huge
  const std::vector<std::vector<std::string>> files = {
      {"empty.off", "", "empty"},
      {"a.abc", "x", "extension"},
      {"a", "x", "extension"},
      {"range.off", "OFF\n3 1 0\n" + triangle + "3 0 1 3\n", "face 0"},
      {"less.off", "OFF\n3 1 0\n" + triangle + "-3 0 1 2\n", "'-3'"},
      {"half.off", "OFF\n3 1 0\n" + triangle + "2.5 0 1 2\n", "'2.5'"},
      {"few.off", "OFF\n3 1 0\n" + triangle + "3 0 1\n", "line 6"},
      {"word.off", "OFF\n3 1 0\n" + triangle + "3 0 1 x\n", "'x'"},
      {"control.off", "OFF\n3 1 0\n" + triangle + "3 0 1 \x1b[2J\n", "'?[2J'"},
      {"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "corner"},
      {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "corner"},
      {"range.ply", ply_header("float", 3) + ply_faces + "end_header\n" + triangle + "3 0 1 -1\n",
       "face 0"},
      {"none.obj", "vn 0 0 0\n", "OBJ"},
      {"two.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "3 corners"},
      {"none.off", "OFF\n0 0 0\n", "no points"},
      {"none.xyz", "# only this\n", "no points"},
      {"cut.off", "OFF\n3 1 0\n" + triangle, "OFF"},
      {"cut.stl", ascii_stl().substr(0, 99), "endsolid"},
      {"cut2.stl", binary_stl("x").substr(0, 150), "triangles"},
      {"cut.ply", cut, "ends before"},
      {"many.off", "OFF\n999999999 1 0\n" + triangle, "999999999"},
      {"many.ply", ply_header("float", 999999) + "end_header\n", "number of elements"},
      {"face.off", "OFF\n3 1 0\n" + triangle + "999999999 0 1 2\n", "999999999"},
      {"list.ply", list_too_long, ""},
      {"nan.xyz", "0 0 1\n0 0 nan\n", "point 1"},
      {"first.xyz", "0 0 nan\n0 0 0\n", "point 0"},
      {"count.xyz", "3\n0 0 0\n", "first line"},
      {"nan.stl", binary_stl("x", std::nanf("")), "finite"},
      {"nan.ply", ply_header("float", 1) + "end_header\n0 nan 0\n", "point 0"},
      {"huge.ply", ply_header("double", 1) + "end_header\n0 1e999 0\n", "finite"},
      {"word.ply", ply_header("float", 1) + "end_header\n0 x 0\n", "'x'"},
      {"half.ply", ply_header("int", 1) + "end_header\n0 0.5 0\n", "int"},
      {"noz.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
       "end_header\n0 0\n",
       "x, y or z"},
      {"type.ply", ply_header("quad", 1) + "end_header\n0 0 0\n", "quad"},
      {"twice.ply", ply_header("float", 0) + "element vertex 0\nend_header\n", "twice"},
      {"noindices.ply",
       ply_header("float", 1) + "element face 1\nproperty int a\nend_header\n0 0 "
                                "0\n1\n",
       "vertex_indices"},
      {"noend.ply", ply_header("float", 1), "no end"},
      {"two.xyz", "0 0\n0 1\n", "XYZ"}};
  const Scratch_folder folder;
  for (const auto& file : files)
  {
    BOOST_TEST_CONTEXT(file[0])
    BOOST_TEST(failure(folder.write(file[0], file[1])).find(file[2]) != std::string::npos);
  }
  failure(folder.file("missing.off"));
  std::filesystem::create_directory(folder.file("folder.off"));
  failure(folder.file("folder.off"));
}

BOOST_AUTO_TEST_CASE(garbage_is_refused)
{
  const Scratch_folder folder;
  std::mt19937 random(1);
  for (const std::string extension : {"off", "ply", "obj", "stl", "xyz", "pwn", "pcd"})
    for (const std::string start : {"", "ply\n", "FIELDS x y z\nPOINTS 9\nDATA ascii\n",
                                    "OFF\n3 1 0\n", "solid ", "v 0 0 0\n"})
    {
      std::string bytes = start;
      for (int i = 0; i < 3000; ++i) bytes += static_cast<char>(random() % 256);
      failure(folder.write("garbage." + extension, bytes));
    }
}

BOOST_AUTO_TEST_CASE(nothing_is_lost_by_writing)
{
  Shape mesh, cloud;
  mesh.points = square;
  mesh.points.emplace_back(0.1, 1. / 3., 1e-9); // no floats, and without a face
  mesh.polygons = {{0, 1, 3, 2}, {0, 1, 2}, {1, 3, 2}};
  mesh.face_properties = {{"kind", "uchar", {1, 2, 255}},
                          {"label", "float", {9, 9, 9}},
                          {"texcoord", "float", {0.5, 0.25, 1}, "uchar", {0, 2, 2, 3}}};
  cloud.points = square;
  for (const Point& p : square) cloud.normals.emplace_back(p.y() / 3., 0.25, p.x());
  cloud.point_properties = {{"heat", "short", {-300, 1, 2, 3}}, {"t", "double", {0.1, 1, 2, 3}}};

  const Scratch_folder folder;
  for (const Shape& shape : {mesh, cloud})
    for (const Encoding encoding : {Encoding::BINARY, Encoding::ASCII})
    {
      Parts parts;
      parts.labels = {1, 0, 1};
      parts.quality = {0.5, 1., 0.5};
      if (!shape.is_mesh()) parts.labels.push_back(0), parts.quality.push_back(1.);
      parts.colors = {{10, 20, 30}, {200, 100, 255}};
      std::ostringstream out;
      Shape_io::write_parts(out, shape, parts, encoding);
      const Shape read = Shape_io::read_shape(folder.write("a.ply", out.str()));
      BOOST_TEST((read.points == shape.points));
      BOOST_TEST((read.normals == shape.normals));
      BOOST_TEST((read.polygons == shape.polygons));
      const std::vector<Property>& of_elements =
          shape.is_mesh() ? read.face_properties : read.point_properties;
      const std::vector<double> labels(parts.labels.begin(), parts.labels.end());
      BOOST_TEST(property(of_elements, "label").values == labels);
      BOOST_TEST(property(of_elements, "label").type == "int");
      BOOST_TEST(property(of_elements, "quality").values == parts.quality);
      BOOST_TEST(property(of_elements, "green").values[0] == 100.);
      if (shape.is_mesh())
      {
        BOOST_TEST(property(of_elements, "kind").values == shape.face_properties[0].values);
        BOOST_TEST(property(of_elements, "texcoord").values == shape.face_properties[2].values);
        BOOST_TEST(property(of_elements, "texcoord").first == shape.face_properties[2].first);
        BOOST_TEST(property(of_elements, "input_label").values == shape.face_properties[1].values);
        BOOST_TEST(Shape_io::renamed_properties(shape) == "label as input_label");
        std::ostringstream again; // what an earlier run has written is no longer needed
        Shape_io::write_parts(again, read, parts, encoding);
        BOOST_TEST(again.str() == out.str());
        const Shape part = Shape_io::shape_of_elements(shape, {0, 2});
        BOOST_TEST(part.face_properties[2].first == (std::vector<std::size_t>{0, 2, 3}));
        // the majority, the first of equals, and none
        const std::vector<double> expected = {1, 1, 1, 1, -1};
        BOOST_TEST(property(read.point_properties, "label").values == expected);
      }
      else
      {
        BOOST_TEST(property(of_elements, "heat").values == shape.point_properties[0].values);
        BOOST_TEST(property(of_elements, "t").values == shape.point_properties[1].values);
      }
    }
}

BOOST_AUTO_TEST_CASE(polygons_may_have_more_corners_than_a_byte_counts)
{
  Shape shape;
  shape.polygons.resize(1);
  for (std::size_t i = 0; i < 300; ++i)
  {
    shape.points.emplace_back(double(i), double(i * i), 0.);
    shape.polygons[0].push_back(i);
  }
  std::ostringstream out;
  Shape_io::write_parts(out, shape, {{0}, {1.}, {{1, 2, 3}}});
  const Scratch_folder folder;
  BOOST_TEST((Shape_io::read_shape(folder.write("a.ply", out.str())).polygons == shape.polygons));
}

// How far apart two colors look, 0 to about 765, by weighted channels: another measure than the one that colors are
// chosen by.
double weighted_difference(const Shape_io::Color& a, const Shape_io::Color& b)
{
  const double mean_red = (double(a[0]) + double(b[0])) / 2.;
  const double red = double(a[0]) - double(b[0]), green = double(a[1]) - double(b[1]);
  const double blue = double(a[2]) - double(b[2]);
  return std::sqrt((2. + mean_red / 256.) * red * red + 4. * green * green +
                   (2. + (255. - mean_red) / 256.) * blue * blue);
}

BOOST_AUTO_TEST_CASE(neighbors_have_clearly_different_colors)
{
  std::mt19937 random(1);
  Shape_io::Neighbors neighbors(200);
  for (int i = 0; i < 600; ++i) // each part has about 6
  {
    const std::size_t a = random() % neighbors.size(), b = random() % neighbors.size();
    if (a == b) continue;
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  const std::vector<Shape_io::Color> colors = Shape_io::part_colors(neighbors);
  for (std::size_t a = 0; a < neighbors.size(); ++a)
    for (const std::size_t b : neighbors[a])
    {
      BOOST_TEST(weighted_difference(colors[a], colors[b]) > 100.);
      BOOST_TEST(Shape_io::internal::color_difference(colors[a], colors[b]) > .1); // any two: .07
    }
  BOOST_TEST((colors == Shape_io::part_colors(neighbors)));
}

BOOST_AUTO_TEST_CASE(no_color_comes_twice_while_there_are_enough)
{
  using Shape_io::internal::color_difference;
  // to all eyes each differs from each, and from white and dark grounds
  for (const Shape_io::Color& a : Shape_io::internal::palette)
  {
    for (const Shape_io::Color& b : Shape_io::internal::palette)
      BOOST_TEST((a == b || color_difference(a, b) > .07));
    BOOST_TEST(color_difference(a, {255, 255, 255}) > .09);
    BOOST_TEST(color_difference(a, {30, 30, 30}) > .2);
  }
  for (std::size_t n = 1; n <= 20; ++n)
  {
    Shape_io::Neighbors ring(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      if (n > 1) ring[i].push_back((i + 1) % n);
      if (n > 2) ring[i].push_back((i + n - 1) % n);
    }
    const std::vector<Shape_io::Color> colors = Shape_io::part_colors(ring);
    BOOST_TEST(std::set<Shape_io::Color>(colors.begin(), colors.end()).size() == n);
    for (std::size_t i = 0; i < n; ++i) // neighbors more than any two have to
      for (const std::size_t j : ring[i]) BOOST_TEST(color_difference(colors[i], colors[j]) > .15);
  }
}

BOOST_AUTO_TEST_CASE(neighbors_are_found_on_meshes_and_clouds)
{
  Shape shape;
  shape.points = square;
  shape.polygons = two_triangles;
  const Shape_io::Neighbors expected = {{1}, {0}};
  BOOST_TEST((Shape_io::part_neighbors(shape, {0, 1}, 2) == expected));
  shape = Shape();
  for (int i = 0; i < 1000; ++i) shape.points.emplace_back(i, 0, 0);
  std::vector<int> labels(1000, 0);
  std::fill(labels.begin() + 500, labels.end(), 1);
  BOOST_TEST((Shape_io::part_neighbors(shape, labels, 2) == expected));
}

BOOST_AUTO_TEST_CASE(files_are_written_as_a_whole_or_not_at_all)
{
  const Scratch_folder folder;
  folder.write("a", "old");
  {
    Shape_io::Atomic_file file(folder.file("a"));
    file.stream() << "new";
  }
  BOOST_TEST(folder.read("a") == "old");
  std::filesystem::create_symlink(folder.file("a"), folder.file("link"));
  {
    Shape_io::Atomic_file file(folder.file("link"));
    file.stream() << "new";
    BOOST_TEST(folder.read("a") == "old");
    file.commit();
  }
  BOOST_TEST(folder.read("a") == "new");
  BOOST_TEST(std::filesystem::is_symlink(folder.file("link")));
  BOOST_TEST(folder.number_of_files() == 2u);
  BOOST_CHECK_THROW(Shape_io::Atomic_file(folder.path().string()), Shape_io::File_error);
  BOOST_CHECK_THROW(Shape_io::Atomic_file(folder.file("none/a")), Shape_io::File_error);
}

BOOST_AUTO_TEST_SUITE_END()
