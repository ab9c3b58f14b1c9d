// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "shapes/shape_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_shape_generator)

namespace {

using Shape_generator::Labeled_cloud;
using Shape_generator::Labeled_mesh;
using Vector = std::array<double, 3>;
using Edge = std::pair<std::size_t, std::size_t>;

Vector difference(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double inner_product(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector outer_product(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double norm(const Vector& a) { return std::sqrt(inner_product(a, a)); }

// The face to the left of each directed edge; an edge that two faces claim counts as a failure.
std::map<Edge, std::size_t> faces_of_edges(const Labeled_mesh& mesh)
{
  std::map<Edge, std::size_t> result;
  std::size_t claimed_twice = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      if (!result.insert({{mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]}, f}).second)
        ++claimed_twice;
  BOOST_TEST(claimed_twice == 0u);
  return result;
}

void check_closed(const std::map<Edge, std::size_t>& faces)
{
  std::size_t open = 0;
  for (const auto& entry : faces) open += faces.count({entry.first.second, entry.first.first}) == 0;
  BOOST_TEST(open == 0u);
}

// Walking around each vertex from face to face has to meet all faces of the vertex, and each vertex
// has to have faces.
void check_vertices(const Labeled_mesh& mesh, const std::map<Edge, std::size_t>& faces)
{
  std::vector<std::size_t> degree(mesh.points.size(), 0), start(mesh.points.size(), 0);
  for (const auto& entry : faces)
  {
    ++degree[entry.first.first];
    start[entry.first.first] = entry.first.second;
  }
  std::size_t bad = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    std::size_t walked = 0, w = start[v];
    do
    {
      const std::array<std::size_t, 3>& f = mesh.faces[faces.at({v, w})];
      const auto at = std::find(f.begin(), f.end(), v) - f.begin();
      w = f[static_cast<std::size_t>(at + 2) % 3];
      ++walked;
    }
    while (w != start[v] && walked <= degree[v]);
    bad += walked != degree[v] || degree[v] < 3;
  }
  BOOST_TEST(bad == 0u);
}

// Number of pieces that faces with the same value of label(face) form.
template <class Label>
std::size_t number_of_pieces(const Labeled_mesh& mesh, const std::map<Edge, std::size_t>& faces,
                             const Label& label)
{
  std::vector<bool> seen(mesh.faces.size(), false);
  std::size_t pieces = 0;
  for (std::size_t seed = 0; seed < mesh.faces.size(); ++seed)
  {
    if (seen[seed]) continue;
    ++pieces;
    std::vector<std::size_t> stack = {seed};
    seen[seed] = true;
    while (!stack.empty())
    {
      const std::size_t f = stack.back();
      stack.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t next = faces.at({mesh.faces[f][(i + 1) % 3], mesh.faces[f][i]});
        if (!seen[next] && label(next) == label(f))
        {
          seen[next] = true;
          stack.push_back(next);
        }
      }
    }
  }
  return pieces;
}

double volume(const Labeled_mesh& mesh)
{
  double result = 0;
  for (const auto& f : mesh.faces)
    result +=
        inner_product(mesh.points[f[0]], outer_product(mesh.points[f[1]], mesh.points[f[2]])) / 6;
  return result;
}

// The sine of the smallest angle of the mesh, about.
double worst_shape(const Labeled_mesh& mesh)
{
  double result = 1;
  for (const auto& f : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector& a = mesh.points[f[i]];
      const Vector u = difference(mesh.points[f[(i + 1) % 3]], a);
      const Vector v = difference(mesh.points[f[(i + 2) % 3]], a);
      const double lengths = norm(u) * norm(v);
      result = lengths > 0 ? (std::min)(result, norm(outer_product(u, v)) / lengths) : 0;
    }
  return result;
}

void check_mesh(const std::string& name, std::size_t number_of_faces, unsigned seed)
{
  BOOST_TEST_CONTEXT(name << ", " << number_of_faces << " faces, seed " << seed)
  {
    const Labeled_mesh mesh = Shape_generator::make_mesh(name, number_of_faces, seed);
    BOOST_TEST(double(mesh.faces.size()) > 0.75 * double(number_of_faces));
    BOOST_TEST(double(mesh.faces.size()) < 1.25 * double(number_of_faces));
    const std::map<Edge, std::size_t> faces = faces_of_edges(mesh);
    check_closed(faces);
    check_vertices(mesh, faces);
    BOOST_TEST(volume(mesh) > 0.);
    BOOST_TEST(worst_shape(mesh) > 0.02);
    BOOST_REQUIRE_EQUAL(mesh.labels.size(), mesh.faces.size());
    const std::set<int> labels(mesh.labels.begin(), mesh.labels.end());
    BOOST_TEST(*labels.begin() == 0);
    BOOST_TEST(labels.size() == mesh.part_names.size());
    BOOST_TEST(std::size_t(*labels.rbegin()) + 1 == mesh.part_names.size());
    BOOST_TEST(number_of_pieces(mesh, faces, [](std::size_t) { return 0; }) == 1u);
    // In this catalogue each part is in one piece.
    BOOST_TEST(number_of_pieces(mesh, faces, [&](std::size_t f) { return mesh.labels[f]; }) ==
               mesh.part_names.size());
  }
}

std::size_t number_of_handles(const Labeled_mesh& mesh)
{
  // Euler: V - E + F = 2 - 2 * handles, and a closed mesh has 3/2 F edges.
  return (2 + mesh.faces.size() / 2 - mesh.points.size()) / 2;
}

} // namespace

BOOST_AUTO_TEST_CASE(names_are_distinct_and_complete)
{
  const std::vector<std::string> names = Shape_generator::shape_names();
  const std::set<std::string> distinct(names.begin(), names.end());
  BOOST_TEST(distinct.size() == names.size());
  for (const char* name :
       {"two_spheres", "l_shape", "dumbbell", "cup", "table", "figure", "chair", "four_leg",
        "airplane", "octopus", "sphere", "box", "torus", "thin_plate"})
    BOOST_TEST(distinct.count(name) == 1u, name);
}

BOOST_AUTO_TEST_CASE(meshes_of_default_size)
{
  for (const std::string& name : Shape_generator::shape_names()) check_mesh(name, 12000, 0);
}

BOOST_AUTO_TEST_CASE(small_meshes_and_other_grids)
{
  for (const std::string& name : Shape_generator::shape_names()) check_mesh(name, 6000, 1);
  for (const char* name : {"dumbbell", "two_spheres", "l_shape", "table", "airplane", "torus"})
    check_mesh(name, 2000, 2);
}

BOOST_AUTO_TEST_CASE(large_mesh) { check_mesh("two_spheres", 60000, 0); }

BOOST_AUTO_TEST_CASE(topology)
{
  const std::map<std::string, std::size_t> handles = {{"sphere", 0}, {"torus", 1}, {"cup", 1},
                                                      {"figure", 0}, {"table", 0}, {"glasses", 2}};
  for (const auto& entry : handles)
    BOOST_TEST(number_of_handles(Shape_generator::make_mesh(entry.first)) == entry.second,
               entry.first);
}

BOOST_AUTO_TEST_CASE(geometry_is_exact)
{
  const double pi = std::acos(-1.);
  BOOST_TEST(volume(Shape_generator::make_mesh("sphere")) == pi / 6,
             boost::test_tools::tolerance(0.005));
  BOOST_TEST(volume(Shape_generator::make_mesh("torus")) == 2 * pi * pi * 0.36 * 0.14 * 0.14,
             boost::test_tools::tolerance(0.005));
  // Edges and corners are sharp, so that the volume of the box is not only nearly right.
  BOOST_TEST(volume(Shape_generator::make_mesh("box")) == 0.35, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(volume(Shape_generator::make_mesh("l_shape")) == 0.9 * 0.3 * 0.3 + 0.3 * 0.3 * 0.7,
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(part_areas)
{
  const Labeled_mesh mesh = Shape_generator::make_mesh("dumbbell");
  const auto part = [&](const std::string& name)
  {
    return int(std::find(mesh.part_names.begin(), mesh.part_names.end(), name) -
               mesh.part_names.begin());
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const double x = mesh.points[mesh.faces[f][0]][0];
    if (std::abs(x) < 0.1) BOOST_REQUIRE_EQUAL(mesh.labels[f], part("bar"));
    if (x < -0.3) BOOST_REQUIRE_EQUAL(mesh.labels[f], part("left ball"));
    if (x > 0.3) BOOST_REQUIRE_EQUAL(mesh.labels[f], part("right ball"));
  }
}

BOOST_AUTO_TEST_CASE(output_is_reproducible)
{
  for (const char* name : {"airplane", "chair"})
  {
    const Labeled_mesh a = Shape_generator::make_mesh(name, 8000, 3);
    const Labeled_mesh b = Shape_generator::make_mesh(name, 8000, 3);
    BOOST_TEST((a.points == b.points && a.faces == b.faces && a.labels == b.labels));
    BOOST_TEST((Shape_generator::make_mesh(name, 8000, 4).points != a.points));
    const Labeled_cloud c = Shape_generator::make_cloud(name, 500, 3);
    const Labeled_cloud d = Shape_generator::make_cloud(name, 500, 3);
    BOOST_TEST((c.points == d.points && c.normals == d.normals && c.labels == d.labels));
    BOOST_TEST((Shape_generator::make_cloud(name, 500, 4).points != c.points));
  }
}

BOOST_AUTO_TEST_CASE(clouds)
{
  for (const std::string& name : Shape_generator::shape_names()) BOOST_TEST_CONTEXT(name)
    {
      const Labeled_cloud cloud = Shape_generator::make_cloud(name, 2000, 1);
      BOOST_REQUIRE_EQUAL(cloud.points.size(), 2000u);
      BOOST_REQUIRE_EQUAL(cloud.normals.size(), 2000u);
      BOOST_REQUIRE_EQUAL(cloud.labels.size(), 2000u);
      const auto shape = Shape_generator::internal::implicit_shape(name);
      std::size_t off_surface = 0, not_unit = 0, not_outwards = 0;
      for (std::size_t i = 0; i < 2000; ++i)
      {
        Vector out = cloud.points[i], in = cloud.points[i];
        for (std::size_t a = 0; a < 3; ++a)
        {
          out[a] += 2e-3 * cloud.normals[i][a];
          in[a] -= 2e-3 * cloud.normals[i][a];
        }
        off_surface += std::abs(shape.distance(cloud.points[i])) > 1e-4;
        not_unit += std::abs(norm(cloud.normals[i]) - 1) > 1e-9;
        not_outwards += !(shape.distance(out) > 0 && shape.distance(in) < 0);
      }
      BOOST_TEST(off_surface == 0u);
      BOOST_TEST(not_unit == 0u);
      BOOST_TEST(not_outwards == 0u);
      BOOST_TEST(std::set<int>(cloud.labels.begin(), cloud.labels.end()).size() ==
                 cloud.part_names.size());
    }
}

BOOST_AUTO_TEST_CASE(cloud_is_uniform)
{
  // On the sphere, equal slices have equal areas.
  const Labeled_cloud cloud = Shape_generator::make_cloud("sphere", 20000, 5);
  std::array<int, 10> slices = {};
  for (const auto& p : cloud.points)
    ++slices[std::size_t((std::min)(9., (std::max)(0., (p[2] + 0.5) * 10)))];
  for (int count : slices) BOOST_TEST(std::abs(count - 2000) < 250);
  BOOST_TEST(Shape_generator::make_cloud("sphere", 0).points.empty());
}

BOOST_AUTO_TEST_CASE(errors_name_cause_and_remedy)
{
  const auto lists_names = [](const std::invalid_argument& e)
  {
    const std::string what = e.what();
    return what.find("unicorn") != std::string::npos && what.find("figure") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(Shape_generator::make_mesh("unicorn"), std::invalid_argument, lists_names);
  BOOST_CHECK_EXCEPTION(Shape_generator::make_cloud("unicorn", 10), std::invalid_argument,
                        lists_names);
  BOOST_CHECK_THROW(Shape_generator::make_mesh("sphere", 10), std::invalid_argument);
  // The legs would fall between the points of so coarse a grid.
  BOOST_CHECK_THROW(Shape_generator::make_mesh("ant", 1000), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
