// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What files of the field look like: tables with columns of their own, PCD, OBJ of every kind, gaps.

#include <boost/test/unit_test.hpp>

#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_pcd.h"
#include "io/read_ply.h"
#include "io/read_stl.h"
#include "io/read_xyz.h"
#include "io/shape_io.h"
#include "pcd_files.h"
#include "scratch_folder.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_formats)

namespace {

using Shape_io::Gaps;
using Shape_io::Shape;
using Polygons = std::vector<std::vector<std::size_t>>;

Shape read(const std::string& name, const std::string& bytes, const Gaps gaps = Gaps::REFUSED)
{
  const Scratch_folder folder;
  return Shape_io::read_shape(folder.write(name, bytes), gaps);
}

std::string failure(const std::string& name, const std::string& bytes,
                    const Gaps gaps = Gaps::REFUSED)
{
  try
  {
    read(name, bytes, gaps);
  }
  catch (const Shape_io::File_error& error)
  {
    return error.what();
  }
  BOOST_ERROR(name + " was read");
  return "";
}

std::vector<std::string> names(const Shape& shape)
{
  std::vector<std::string> result;
  for (const auto& property : shape.point_properties) result.push_back(property.name);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(tables_have_columns_of_many_kinds)
{
  struct Table
  {
    std::string name, text;
    bool has_normals;
    std::vector<std::string> columns;
  };
  const std::vector<Table> tables = {
      {"a.xyz", "0 0 0 255 0 0\n1 2 3 0 255 7\n", false, {"column_4", "column_5", "column_6"}},
      {"a.xyz", "0 0 0 0 0 1\n1 2 3 0 1 0\n", true, {}},
      {"a.pwn", "2\n0 0 0 0 0 100\n1 2 3 0.5 1 0\n", true, {}},
      {"a.txt", "0 0 0 0 0 1 7\n1 2 3 0 1 0 8\n", true, {"column_7"}},
      {"a.xyz", "0 0 0 12.5\n1 2 3 3\n", false, {"column_4"}},
      {"a.csv",
       "x,y,z,Intensity(dB),label\n0,0,0,1,2\n1,2,3,4,5\n",
       false,
       {"intensitydb", "label"}},
      {"a.csv", "x,y,z,sky view\n0,0,0,1\n1,2,3,4\n", false, {"column_4"}},
      {"a.csv", "x;y;z;nx;ny;nz\r\n0;0;0;0;0;1\r\n1;2;3;0;1;0\r\n", true, {}},
      {"a.asc",
       "//X Y Z R G B\n2\n0 0 0 1 2 3\n1 2 3 4 5 6\n",
       false,
       {"column_4", "column_5", "column_6"}},
      {"a.PTS",
       "2\n0 0 0 -12 1 2 3\n1 2 3 5 1 2 3\n",
       false,
       {"column_4", "column_5", "column_6", "column_7"}}};
  for (const Table& table : tables) BOOST_TEST_CONTEXT(table.text)
    {
      const Shape shape = read(table.name, table.text);
      BOOST_REQUIRE_EQUAL(shape.points.size(), 2u);
      BOOST_TEST((shape.points[1] == Shape_io::Point(1, 2, 3)));
      BOOST_TEST(shape.normals.empty() != table.has_normals);
      BOOST_TEST(names(shape) == table.columns, boost::test_tools::per_element());
    }
  BOOST_TEST(failure("a.xyz", "0 0 0\n1 2\n").find("line 2") != std::string::npos);
  BOOST_TEST(failure("a.xyz", "1 2\n3 4\n").find("three numbers") != std::string::npos);
  BOOST_TEST(failure("a.xyz", "0 0 0\n1 x 3\n").find("line 2") != std::string::npos);
  BOOST_TEST(failure("a.csv", "x,y\n0,0\n").find("three numbers") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(obj_files_of_every_kind)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\n";
  const std::string tables =
      "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 1\n";
  const std::vector<std::pair<std::string, Polygons>> files = {
      {points + "f -4 -3 -2\nf 2 4 3\n", {{0, 1, 2}, {1, 3, 2}}},
      {points + tables + "g a b\ns off\nf 1//1 2/2 4/4/4 3\n", {{0, 1, 3, 2}}},
      {points + "f 1 2 \\\r\n 4 3\r\n", {{0, 1, 3, 2}}},
      {"v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nf 1 2 3\nv 0 1 0\nv 1 1 .5\nl 1 2\np 1\n", {{0, 1, 2}}},
      {points, {}}};
  for (const auto& [text, polygons] : files) BOOST_TEST_CONTEXT(text)
    {
      const Shape shape = read("a.obj", text);
      BOOST_TEST(shape.points.size() == 4u);
      BOOST_TEST((shape.polygons == polygons));
    }
  BOOST_TEST(read("a.obj", points + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n").normals.size() ==
             4u);
  BOOST_TEST(failure("a.obj", points + "f 1 x 3\n").find("line 5") != std::string::npos);
  for (const std::string face : {"0 1 2", "-5 1 2", "1 2 9", "1 2 99999999999999999999"})
    BOOST_TEST(failure("a.obj", points + "f " + face + "\n").find("corner") != std::string::npos);
  BOOST_TEST(failure("a.obj", "v 1 2\n").find("line 1") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(pcd_files_of_every_encoding)
{
  for (const std::string encoding : {"ascii", "binary", "binary_compressed"})
    BOOST_TEST_CONTEXT(encoding)
    {
      const Shape shape = read("a.pcd", pcd_file(encoding), Gaps::ALLOWED);
      BOOST_REQUIRE_EQUAL(shape.points.size(), 6u);
      BOOST_TEST(static_cast<float>(shape.points[5].x()) == 0.1f);
      BOOST_TEST(shape.normals.size() == 6u);
      BOOST_TEST(Shape_io::is_gap(shape.points[2]));
      BOOST_TEST(names(shape) == (std::vector<std::string>{"rgb", "label"}),
                 boost::test_tools::per_element());
      BOOST_TEST(shape.point_properties[0].values[1] == 4281541137.); // bits that are no number
      BOOST_TEST(shape.point_properties[1].values[1] == 65535.);
      // without leave, the first gap is named
      BOOST_TEST(failure("a.pcd", pcd_file(encoding)).find("point 2") != std::string::npos);
      // cut or damaged
      const std::string whole = pcd_file(encoding);
      for (const std::size_t left : {whole.size() - 5, whole.size() - 20, std::size_t(100)})
        failure("a.pcd", whole.substr(0, left), Gaps::ALLOWED);
    }
  const std::string head = "FIELDS x y z\nPOINTS 1\n";
  for (const std::string& text :
       {head + "DATA ascii\n1 2\n", head + "DATA zip\n1 2 3\n", head, std::string("DATA ascii\n"),
        head + "SIZE 4 4\nDATA ascii\n1 2 3\n", head + "SIZE 4 4 3\nDATA ascii\n1 2 3\n",
        head + "COUNT 9999 9999 9999\nDATA ascii\n1 2 3\n",
        std::string("FIELDS x y\nPOINTS 1\nDATA ascii\n1 2\n"),
        std::string("FIELDS x y z\nPOINTS 9e9\nDATA binary\n"),
        head + "DATA binary_compressed\n\xff\xff\xff\x7f\xff\xff\xff\x7f"})
    failure("a.pcd", text);
  BOOST_TEST(read("a.pcd", head + "DATA ascii\n1 2 3\n").points.size() == 1u);
}

BOOST_AUTO_TEST_CASE(gaps_are_kept_only_where_nothing_was_measured)
{
  const std::string text = "0 0 0\nnan nan nan\n1 0 0\n";
  const Shape shape = read("a.xyz", text, Gaps::ALLOWED);
  BOOST_TEST(shape.points.size() == 3u);
  BOOST_TEST(Shape_io::is_gap(shape.points[1]));
  BOOST_TEST(failure("a.xyz", text).find("point 1") != std::string::npos);
  for (const std::string point :
       {"nan nan 0", "0 nan 0", "inf inf inf", "nan nan inf", "1e999 0 0"})
    BOOST_TEST(failure("a.xyz", "0 0 0\n" + point + "\n", Gaps::ALLOWED).find("point 1") !=
               std::string::npos);
  BOOST_TEST(failure("a.xyz", "nan nan nan\n", Gaps::ALLOWED).find("none") != std::string::npos);
  BOOST_TEST(failure("a.obj", "v nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", Gaps::ALLOWED)
                 .find("point 0") != std::string::npos); // of a mesh
}

BOOST_AUTO_TEST_CASE(formats_are_known_by_their_first_bytes)
{
  using namespace Shape_io::internal;
  const std::vector<std::pair<std::string, Reader>> files = {{"ply\nformat", read_ply},
                                                             {"# .PCD v0.7\n", read_pcd},
                                                             {"VERSION .7\n", read_pcd},
                                                             {"solid a\n", read_stl},
                                                             {std::string("\1\0\0", 3), read_stl},
                                                             {"# c\nCOFF\n", read_off},
                                                             {"OFF 3 1 0\n", read_off},
                                                             {"# c\nv 0 0 0\n", read_obj},
                                                             {"mtllib a.mtl\nv 0 0 0\n", read_obj},
                                                             {"vn 0 0 1\n", read_obj},
                                                             {"o thing\n", read_obj},
                                                             {"1 2 3\n", read_xyz},
                                                             {"1,2,3\n", read_xyz},
                                                             {"//X Y Z\n1 2 3\n", read_xyz},
                                                             {"x y z\n1 2 3\n", read_xyz}};
  for (const auto& [bytes, reader] : files) BOOST_TEST((reader_for_bytes(bytes) == reader), bytes);
}

// A number that is misread loses points without a word.
BOOST_AUTO_TEST_CASE(counts_and_indices_are_whole_numbers)
{
  const auto cloud = [](const std::string& count)
  {
    return "ply\nformat ascii 1.0\nelement vertex " + count +
           "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n";
  };
  BOOST_TEST(read("a.ply", cloud("2")).points.size() == 2u);
  for (const char* count : {"2e0", "0x2", "2.0", "2 2", "-2", "1e3", "two", ""})
    BOOST_TEST(failure("a.ply", cloud(count)).find("number of elements") != std::string::npos);

  const auto mesh = [](const std::string& face)
  {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nelement face 1\nproperty list float float vertex_indices\n"
           "end_header\n0 0 0\n1 0 0\n0 1 0\n" +
           face + "\n";
  };
  BOOST_TEST(read("a.ply", mesh("3 0 1 2")).polygons.size() == 1u);
  BOOST_TEST(failure("a.ply", mesh("3.5 0 1 2")).find("list") != std::string::npos);
  BOOST_TEST(failure("a.ply", mesh("3 0 1.5 2")).find("face 0") != std::string::npos);
  BOOST_TEST(failure("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n").find("face 0") !=
             std::string::npos);
}

// More than the header tells, or lines with more columns: then elements are lost or misread.
BOOST_AUTO_TEST_CASE(nothing_in_a_text_is_left_over)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property float y\nproperty float z\nend_header\n";
  BOOST_TEST(read("a.ply", header + "0 0 0\n1 0 0\n\n \t\r\n").points.size() == 2u);
  failure("a.ply", header + "0 0 0\n1 0 0\n0 1 0\n");
  failure("a.ply", header + "0 0 0 255\n1 0 0 255\n");
  const std::string pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA ascii\n";
  BOOST_TEST(read("a.pcd", pcd + "0 0 0\n1 0 0\n").points.size() == 2u);
  failure("a.pcd", pcd + "0 0 0\n1 0 0\n0 1 0\n");
  BOOST_TEST(read("a.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n# end\n").points.size() == 2u);
  failure("a.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n0 1 0\n");
}

BOOST_AUTO_TEST_CASE(tables_are_not_millions_of_columns_wide)
{
  std::string line;
  for (int i = 0; i < 10000; ++i) line += "1 ";
  BOOST_TEST(read("a.xyz", line + "\n" + line).points.size() == 2u);
  BOOST_TEST(failure("a.xyz", line + "1\n").find("10000") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(stl_texts_of_every_kind)
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\n";
  const std::string two = "solid a b\n" + facet + facet + "endsolid a b\n";
  std::string capitals = two, mac = two, one_line = facet;
  for (char& c : capitals) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  for (char& c : mac) c = c == '\n' ? '\r' : c;
  for (char& c : one_line) c = c == '\n' ? ' ' : c;
  for (const std::string& text :
       {two, capitals, mac, two + two, "solid\n" + one_line + "\nendsolid\n",
        "solid\nfacet normal nan x -nan(ind)" + facet.substr(18) + "endsolid"})
  {
    const Shape shape = read("a.stl", text);
    BOOST_TEST(shape.points.size() == 3u);
    BOOST_TEST((shape.polygons[0] == std::vector<std::size_t>{0, 1, 2}));
  }
  for (std::size_t size = 0; size + 5 < two.size(); ++size) // cut anywhere
    failure("a.stl", two.substr(0, size));
  const auto replaced = [&](const std::string& what, const std::string& by)
  { return std::string(two).replace(two.find(what), what.size(), by); };
  failure("a.stl", replaced("vertex 1 0 0\n", ""));
  failure("a.stl", replaced("endloop", "vertex 1 1 0\nendloop"));
  failure("a.stl", replaced("1 0 0", "x 0 0"));
  BOOST_TEST(failure("a.stl", replaced("1 0 0", "nan 0 0")).find("point 1") != std::string::npos);
  failure("a.stl", "solid a\nendsolid a\n");
}

BOOST_AUTO_TEST_CASE(binary_stl_holds_what_it_tells)
{
  const auto file = [](const std::size_t told, const std::size_t held)
  {
    std::string bytes(80, 's');
    Pcd_files::append(bytes, static_cast<unsigned int>(told));
    for (std::size_t i = 0; i < held; ++i)
    {
      for (int k = 0; k < 12; ++k) Pcd_files::append(bytes, static_cast<float>(k * (k + 1)));
      bytes += std::string(2, '\0');
    }
    return bytes;
  };
  BOOST_TEST(read("a.stl", file(5, 5)).polygons.size() == 5u);
  BOOST_TEST(read("a.stl", file(5, 5) + "padding").polygons.size() == 5u);
  BOOST_TEST(read("a.stl", "solid" + file(5, 5).substr(5)).polygons.size() == 5u);
  for (const std::size_t told : {0u, 4u, 6u, 4294967295u}) failure("a.stl", file(told, 5));
  failure("a.stl", file(0, 0));
  failure("a.stl", std::string(83, 'x'));
}

BOOST_AUTO_TEST_SUITE_END()
