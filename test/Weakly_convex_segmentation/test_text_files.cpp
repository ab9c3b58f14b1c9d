// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "io/shape_io.h"
#include "scratch_folder.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_text_files)

namespace {

const std::string off = "OFF\n# comment\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string obj = "# comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n";
const std::string xyz = "0 0 0\n1 0 0\n0 1 0\n";

template <typename Change>
void check_all(const Change& change)
{
  const Scratch_folder folder;
  for (const auto& [name, text] : {std::make_pair("t.off", off), {"t.obj", obj}, {"t.xyz", xyz}})
  {
    const auto shape = Shape_io::read_shape(folder.write(name, change(text)));
    BOOST_REQUIRE_EQUAL(shape.points.size(), 3u);
    BOOST_TEST(shape.points[1].x() == 1);
    BOOST_TEST(shape.points[2].y() == 1);
    BOOST_TEST(shape.is_mesh() == (text != xyz));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(byte_order_mark)
{
  check_all([](const std::string& text) { return "\xEF\xBB\xBF" + text; });
}

BOOST_AUTO_TEST_CASE(old_mac_line_ends)
{
  check_all(
      [](std::string text)
      {
        std::replace(text.begin(), text.end(), '\n', '\r');
        return text;
      });
}

namespace {

/// reads a file of a name and content.
Shape_io::Shape read(const std::string& name, const std::string& text)
{
  const Scratch_folder folder;
  return Shape_io::read_shape(folder.write(name, text));
}

std::string refusal(const std::string& name, const std::string& text)
{
  try
  {
    read(name, text);
  }
  catch (const Shape_io::File_error& error)
  {
    return error.what();
  }
  return "";
}

void check_points(const Shape_io::Shape& shape)
{
  BOOST_TEST_REQUIRE(shape.points.size() == 3u);
  BOOST_TEST(shape.points[0] == Shape_io::Point(-0.5, 1.25, 2.));
  BOOST_TEST(shape.points[2] == Shape_io::Point(4., 5.5, -6.));
}

std::vector<std::string> names(const Shape_io::Shape& shape)
{
  std::vector<std::string> result;
  for (const Shape_io::Property& p : shape.point_properties) result.push_back(p.name);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(columns_are_what_they_are_called)
{
  for (const std::string head :
       {"id,intensity,z,y,x", "id,intensity,Z,Y,X", "id,intensity,pos_z,pos_y,pos_x",
        "id,intensity,\"Points:2\",\"Points:1\",\"Points:0\"", "id;intensity;z[m];y[m];x[m]"})
  {
    const auto shape = read("t.csv", head + "\n7,0.5,2,1.25,-0.5\n8,0.5,0,0,1\n9,0.5,-6,5.5,4\n");
    check_points(shape);
    BOOST_TEST(names(shape) == (std::vector<std::string>{"id", "intensity"}));
    BOOST_TEST(shape.point_properties[0].values[1] == 8.);
    BOOST_TEST(shape.notes.empty());
    BOOST_TEST(shape.normals.empty());
  }
  const auto with_normals =
      read("t.txt", "ny x y z nz nx\n0 -0.5 1.25 2 0 3\n0 1 0 0 0 3\n0 4 5.5 -6 0 3\n");
  check_points(with_normals);
  BOOST_TEST_REQUIRE(with_normals.normals.size() == 3u);
  BOOST_TEST(with_normals.normals[1] == Shape_io::Vector(3., 0., 0.));
  const auto unknown = read("t.csv", "a,b,c\n-0.5,1.25,2\n1,0,0\n4,5.5,-6\n");
  check_points(unknown);
  BOOST_TEST_REQUIRE(unknown.notes.size() == 1u);
  BOOST_TEST(unknown.notes[0].find("no columns are called x, y and z") == 0u);
}

BOOST_AUTO_TEST_CASE(columns_of_text_are_left_out_with_a_note)
{
  for (const std::string head : {"name,x,y,z\n", ""})
  {
    const auto shape = read("t.csv", head + "a,-0.5,1.25,2\nb,1,0,0\n3,4,5.5,-6\n");
    check_points(shape);
    BOOST_TEST(shape.point_properties.empty());
    BOOST_TEST_REQUIRE(shape.notes.size() == 1u);
    BOOST_TEST(shape.notes[0].find(head.empty() ? "the column 1," : "the column name,") == 0u);
  }
  BOOST_TEST(refusal("t.csv", "a,0,1,2\nb,1,c,0\n").find("line 2 has 'c' where") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_with_a_decimal_comma)
{
  for (const std::string text :
       {"X;Y;Z\n-0,5;1,25;2\n1;0;0\n4;5,5;-6\n", "-0,5 1,25 2,0\n1,0 0,0 0,0\n4,0 5,5 -6,0\n",
        "-0,5\t1,25\t2e0\n1\t0\t0\n4\t5,5\t-6\n"})
    check_points(read("t.csv", text));
  for (const std::string text :
       {"-0.5,1.25,2\n1,0,0\n4,5.5,-6\n", "-0.5, 1.25, 2\n1, 0, 0\n4, 5.5, -6\n",
        "-0.5;1.25;2\n1;0;0\n4;5.5;-6\n"})
    check_points(read("t.csv", text));
  const auto whole = read("t.xyz", "1,2,3\n4,5,6\n"); // parted by commas
  BOOST_TEST_REQUIRE(whole.points.size() == 2u);
  BOOST_TEST(whole.points[1] == Shape_io::Point(4., 5., 6.));
}

BOOST_AUTO_TEST_CASE(normals_without_a_name_are_unit_vectors)
{
  const auto text = [](const std::string& second)
  { return "-0.5 1.25 2 0.6 0.8 0\n1 0 0 " + second + "\n4 5.5 -6 0 0 -1\n"; };
  for (const std::string unit : {"0 1 0", "0 0.7071 0.7071", "0 0 0"})
    BOOST_TEST(read("t.xyz", text(unit)).normals.size() == 3u);
  {
    const Scratch_folder folder; // of an organized cloud
    const std::string gap = "nan nan nan nan nan nan\n";
    const auto scan = Shape_io::read_shape(folder.write("t.xyz", text("0 1 0") + gap + gap),
                                           Shape_io::Gaps::ALLOWED);
    BOOST_TEST(scan.normals.size() == 5u);
  }
  for (const std::string other : {"0.2 0.4 0.3", "-1576 142 90", "2 0 0"})
  {
    const auto shape = read("t.xyz", text(other));
    check_points(shape);
    BOOST_TEST(shape.normals.empty());
    BOOST_TEST(names(shape) == (std::vector<std::string>{"column_4", "column_5", "column_6"}));
    BOOST_TEST(read("t.pwn", text(other)).normals.size() == 3u); // of any length there
    BOOST_TEST(read("t.xyz", "3\n" + text(other)).normals.size() == 3u);
  }
}

BOOST_AUTO_TEST_CASE(a_head_with_returns_or_without_blanks)
{
  std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\n"
                    "property uchar y\nproperty uchar z\nend_header\n";
  for (const std::string end : {"\n", "\r", "\r\n"})
  {
    std::string head;
    for (const char c : ply) head += c == '\n' ? end : std::string(1, c);
    const auto shape = read("t.ply", head + "\n\r\n456\n\n\n");
    BOOST_TEST_REQUIRE(shape.points.size() == 3u);
    BOOST_TEST(shape.points[0] == Shape_io::Point(10., 13., 10.));
    BOOST_TEST(shape.points[2] == Shape_io::Point(10., 10., 10.));
  }
  const auto glued = read("t.off", "OFF3 1 0\n-0.5 1.25 2\n1 0 0\n4 5.5 -6\n3 0 1 2\n");
  check_points(glued);
  BOOST_TEST(glued.polygons.size() == 1u);
}

// A number too many or too few is found far behind its line.
BOOST_AUTO_TEST_CASE(lines_of_ply_files_are_named)
{
  const auto ply = [](const std::string& second, const std::string& face)
  {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n" +
           second + "\n0 1 0\n" + face + "\n";
  };
  BOOST_TEST(refusal("t.ply", ply("1 0 0", "3 0 1 2")) == "");
  for (const std::string second : {"1 0 0 7", "1 0"})
    BOOST_TEST(refusal("t.ply", ply(second, "3 0 1 2")).find("line 11 has ") != std::string::npos);
  for (const std::string face : {"3 0 1 2 7", "3 0 1"})
    BOOST_TEST(refusal("t.ply", ply("1 0 0", face)).find("line 13 has ") != std::string::npos);
  BOOST_TEST(refusal("t.ply", ply("1 x 0", "3 0 1 2")).find("line 11: 'x'") != std::string::npos);
  BOOST_TEST(refusal("t.ply", ply("1 0 0", "3 0 1.5 2")).find("line 13: 1.5") != std::string::npos);
  BOOST_TEST(refusal("t.ply", "ply and no line end").find("no end") != std::string::npos);
  BOOST_TEST(refusal("t.ply", ply("1 0\n0", "3 0\n1 2")) == ""); // no reader relies on lines
}

BOOST_AUTO_TEST_CASE(messages_are_of_plain_text)
{
  for (const std::string text : {"ply\nformat \xff\xfe\x80 1.0\n", "ply\n\xdb\xbd\x01\n"})
  {
    const std::string message = refusal("t.ply", text);
    BOOST_TEST(!message.empty());
    for (const char c : message) BOOST_TEST((c >= ' ' && c <= '~'));
  }
  BOOST_TEST(refusal("t.xxx", "a").find(".csv or .pts") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
