// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Alpha_expansion_MaxFlow_tag.h>
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>
#include <CGAL/version.h>

#include "child_process.h"
#include "counted_memory.h"
#include "io/read_shape.h"
#include "scratch_folder.h"

#include <cstddef>
#include <functional>
#include <iomanip>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The faults of CGAL that code of our own stands in for, each shown by the least input. A test fails where a
// known version of CGAL no longer has one, or has one more: then look whether CGAL's own part will do.
// What no test knows is only told: of other versions, the table is what this program is for.
//
// A fault may be a crash, so each is shown in a process of its own.

BOOST_AUTO_TEST_SUITE(test_cgal_faults)

namespace {

using Faces = std::vector<std::vector<std::size_t>>;

/// in which of the versions that were looked at the fault is
enum class Seen
{
  NOWHERE,
  IN_5_5, ///< 5.5.1, no longer in 6.0.1
  IN_ALL  ///< 5.5.1 and 6.0.1
};

/// returns whether this version of CGAL was looked at
bool is_known_version() { return CGAL_VERSION_NR == 1050511000 || CGAL_VERSION_NR == 1060011000; }

bool is_expected(const Seen seen)
{
  return seen == Seen::IN_ALL || (seen == Seen::IN_5_5 && CGAL_VERSION_NR < 1060000000);
}

/// prints a line of the table, and compares with what is known
void tell(const std::string& name, const std::string& what, const std::string& right,
          const Seen seen)
{
  const bool has_fault = what != right;
  std::cout << "  " << std::left << std::setw(52) << name
            << (has_fault ? "fault: " + what : "right") << '\n';
  if (is_known_version())
    BOOST_TEST(has_fault == is_expected(seen), name << ": CGAL " << CGAL_VERSION_NR << " gives '"
                                                    << what << "'; right is '" << right << "'");
}

// --- readers -----------------------------------------------------------------------------------

struct Input
{
  const char* name;
  const char* extension;
  std::string bytes;
  std::string right; ///< as `text_of` has it
  Seen seen;
};

const std::string refused = "refused";

/// returns "0 0 0, 1 0 0, 0 1 0; 0 1 2"
template <typename Point>
std::string text_of(const std::vector<Point>& points, const Faces& faces)
{
  std::ostringstream text;
  for (const Point& p : points)
    text << (&p == points.data() ? "" : ", ") << p.x() << ' ' << p.y() << ' ' << p.z();
  for (const std::vector<std::size_t>& face : faces)
  {
    text << ';';
    for (const std::size_t corner : face) text << ' ' << static_cast<long long>(corner);
  }
  return text.str();
}

/// returns what CGAL makes of the input
std::string read_by_cgal(const Input& input)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  Faces faces;
  std::istringstream stream(input.bytes);
  const std::string extension = input.extension;
  const bool is_read = extension == ".ply"   ? CGAL::IO::read_PLY(stream, points, faces)
                       : extension == ".off" ? CGAL::IO::read_OFF(stream, points, faces)
                       : extension == ".obj" ? CGAL::IO::read_OBJ(stream, points, faces)
                                             : CGAL::IO::read_STL(stream, points, faces);
  return is_read ? text_of(points, faces) : refused;
}

/// returns what our reader makes of the input
std::string read_by_us(const Input& input)
{
  const Scratch_folder folder;
  try
  {
    const Shape_io::Shape shape =
        Shape_io::read_shape(folder.write(std::string("shape") + input.extension, input.bytes));
    return text_of(shape.points, shape.polygons);
  }
  catch (const Shape_io::File_error&)
  {
    return refused;
  }
}

const std::string triangle = "0 0 0, 1 0 0, 0 1 0; 0 1 2";

std::string ply(const std::string& coordinates, const std::string& list, const std::string& body,
                const std::string& z = "z")
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n";
  for (const std::string& name : {std::string("x"), std::string("y"), z})
    text += "property " + coordinates + ' ' + name + '\n';
  return text + "element face 1\nproperty list " + list + " vertex_indices\nend_header\n" + body;
}

const std::string ply_points = "0 0 0\n1 0 0\n0 1 0\n";
const std::string off_points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
const std::string obj_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string stl_facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\n";

std::string in_capitals(std::string text)
{
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

const std::vector<Input>& inputs()
{
  static const std::vector<Input> all = {
      {"PLY", ".ply", ply("float", "uchar int", ply_points + "3 0 1 2\n"), triangle, Seen::NOWHERE},
      {"PLY with integer coordinates", ".ply", ply("int", "uchar int", ply_points + "3 0 1 2\n"),
       triangle, Seen::IN_ALL},
      {"PLY without a coordinate", ".ply",
       ply("float", "uchar int", ply_points + "3 0 1 2\n", "quality"), refused, Seen::IN_ALL},
      {"PLY with 16-bit corners", ".ply", ply("float", "uchar ushort", ply_points + "3 0 1 2\n"),
       triangle, Seen::IN_ALL},
      {"PLY with a list longer than the file", ".ply",
       ply("float", "uint int", ply_points + "4000000000 0 1 2\n"), refused, Seen::IN_ALL},
      {"OFF", ".off", off_points + "3 0 1 2\n", triangle, Seen::NOWHERE},
      {"OFF with a color below 0", ".off", "C" + off_points + "3 0 1 2 -1000000000\n", triangle,
       Seen::IN_ALL},
      {"OFF with a negative number of corners", ".off", off_points + "-2 0 1 2\n", refused,
       Seen::IN_ALL},
      {"OFF with more points than the file can hold", ".off", "OFF\n1000000000 0 0\n0 0 0\n",
       refused, Seen::IN_ALL},
      {"OBJ", ".obj", obj_points + "f 1 2 3\n", triangle, Seen::NOWHERE},
      {"OBJ without faces", ".obj", obj_points, "0 0 0, 1 0 0, 0 1 0", Seen::IN_ALL},
      {"OBJ with a corner beyond the last point", ".obj", obj_points + "f 1 2 4\n", refused,
       Seen::IN_ALL},
      {"OBJ with tabs between corners", ".obj", obj_points + "f 1\t2\t3\n", triangle, Seen::IN_5_5},
      {"OBJ with a line that goes on in the next", ".obj", obj_points + "f 1 2 \\\n3\n", triangle,
       Seen::IN_5_5},
      {"STL", ".stl", "solid a\n" + stl_facet + "endsolid a\n", triangle, Seen::NOWHERE},
      {"STL in capitals", ".stl", in_capitals("solid a\n" + stl_facet + "endsolid a\n"), triangle,
       Seen::IN_ALL},
      {"STL cut within its first triangle", ".stl", "solid a\n" + stl_facet.substr(0, 56), refused,
       Seen::IN_ALL}};
  return all;
}

// --- minimum cuts ------------------------------------------------------------------------------

/// returns the flow through source - a - sink, twice over the same graph, cleared in between
std::string flows_of_cleared_graph(const bool clears)
{
  std::ostringstream text;
  MaxFlow::Graph used;
  for (int i = 0; i < 2; ++i)
  {
    MaxFlow::Graph fresh;
    MaxFlow::Graph& graph = clears ? used : fresh;
    graph.clear();
    graph.add_tweights(graph.add_node(), 2., 3.);
    text << graph.maxflow() << ' ';
  }
  return text.str();
}

/// returns the labels of three vertices that each want one of their own, and cost nothing to part
template <typename Tag>
std::string expanded_labels()
{
  const std::vector<std::vector<double>> costs = {{0., 1., 1.}, {1., 0., 1.}, {1., 1., 0.}};
  std::vector<std::size_t> labels = {0, 0, 0};
  CGAL::alpha_expansion_graphcut({{0, 1}, {1, 2}}, {0.125, 0.125}, costs, labels, Tag());
  std::ostringstream text;
  for (const std::size_t label : labels) text << label << ' ';
  return text.str();
}

// --- memory ------------------------------------------------------------------------------------

/// returns how often memory is lost if the 0th, 1st, ... allocation fails, until none does
std::string losses(const std::function<void()>& action)
{
  int count = 0;
  for (long failing = 0;; ++failing)
  {
    const long before = Counted_memory::live();
    bool failed = false;
    try
    {
      const Counted_memory::Failure failure(failing);
      action();
    }
    catch (const std::bad_alloc&)
    {
      failed = true;
    }
    count += Counted_memory::live() != before ? 1 : 0;
    if (!failed) return std::to_string(count) + " losses";
  }
}

void cut_one_node()
{
  MaxFlow::Graph graph;
  graph.add_tweights(graph.add_node(), 2., 3.);
  graph.maxflow();
}

void build_search_tree()
{
  using Traits = CGAL::Search_traits_3<CGAL::Simple_cartesian<double>>;
  std::vector<Traits::Point_d> points;
  for (int i = 0; i < 100; ++i) points.emplace_back(i, i * i % 7, i % 3);
  CGAL::Kd_tree<Traits> tree(points.begin(), points.end());
  tree.build();
}

} // namespace

BOOST_AUTO_TEST_CASE(readers)
{
  std::cout << "CGAL " << CGAL_VERSION_NR << (is_known_version() ? "" : " (not looked at so far)")
            << '\n';
  for (const Input& input : inputs())
  {
    BOOST_TEST(read_by_us(input) == input.right, input.name);
    tell(input.name, in_child([&] { return read_by_cgal(input); }), input.right, input.seen);
  }
}

BOOST_AUTO_TEST_CASE(minimum_cuts)
{
  tell("flow", in_child([] { return flows_of_cleared_graph(false); }), "2 2 ", Seen::NOWHERE);
  tell("flow after MaxFlow::Graph::clear()", in_child([] { return flows_of_cleared_graph(true); }),
       "2 2 ", Seen::IN_ALL);
  tell("alpha expansion by Boost's flow",
       in_child(&expanded_labels<CGAL::Alpha_expansion_boost_compressed_sparse_row_tag>), "0 1 2 ",
       Seen::NOWHERE);
  tell("alpha expansion by MaxFlow", in_child(&expanded_labels<CGAL::Alpha_expansion_MaxFlow_tag>),
       "0 1 2 ", Seen::IN_ALL);
}

BOOST_AUTO_TEST_CASE(memory)
{
  tell("MaxFlow::Graph where memory runs out", in_child([] { return losses(&cut_one_node); }),
       "0 losses", Seen::IN_ALL);
  tell("Kd_tree where memory runs out", in_child([] { return losses(&build_search_tree); }),
       "0 losses", Seen::IN_ALL);
}

BOOST_AUTO_TEST_SUITE_END()
