// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What files of the field look like: tables with columns of their own, PCD, OBJ of every kind, gaps.

#define BOOST_TEST_MODULE Formats
#include <boost/test/included/unit_test.hpp>

#include "pcd_files.h"
#include "scratch_folder.h"
#include "shape_io.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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
  const std::vector<std::pair<std::string, Polygons>> files = {
      {points + "f -4 -3 -2\nf 2 4 3\n", {{0, 1, 2}, {1, 3, 2}}},
      {points + "g a b\ns off\nf 1//1 2/2 4/4/4 3\n", {{0, 1, 3, 2}}},
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
