// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/cut_along_borders.h>
#include <CGAL/property_map.h>

#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// Meshes whose faces are split along the smoothed borders of labels.

BOOST_AUTO_TEST_SUITE(test_cut_along_borders)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Polygons = std::vector<std::vector<std::size_t>>;

struct Soup
{
  std::vector<Point> points;
  Polygons polygons;
  std::vector<int> labels;
};

/// a grid of unit squares over the x-y plane, at a height; each a polygon or two triangles, labeled by their centers
template <typename Height, typename Label>
Soup grid(const std::size_t n, const bool of_triangles, const Height& height, const Label& label)
{
  Soup soup;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      soup.points.emplace_back(double(i), double(j), height(double(i), double(j)));
  const auto at = [n](const std::size_t i, const std::size_t j) { return i * (n + 1) + j; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (of_triangles && (i * 7 + j * 3) % 5 < 2)
        soup.polygons.insert(soup.polygons.end(), {{a, b, d}, {b, c, d}});
      else if (of_triangles)
        soup.polygons.insert(soup.polygons.end(), {{a, b, c}, {a, c, d}});
      else
        soup.polygons.push_back({a, b, c, d});
    }
  for (const auto& polygon : soup.polygons)
  {
    double x = 0., y = 0.;
    for (const std::size_t p : polygon)
    {
      x += soup.points[p].x() / double(polygon.size());
      y += soup.points[p].y() / double(polygon.size());
    }
    soup.labels.push_back(label(x, y));
  }
  return soup;
}

double flat(double, double) { return 0.; }

Cut_mesh<Point> cut(const Soup& soup)
{
  return cut_soup_along_borders(soup.points, soup.polygons, soup.labels);
}

/// the length of the edges between different labels
double border_length(const std::vector<Point>& points, const Polygons& polygons,
                     const std::vector<int>& labels)
{
  std::map<std::pair<std::size_t, std::size_t>, int> label_at;
  double sum = 0.;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (std::size_t i = 0; i < polygons[f].size(); ++i)
    {
      const std::size_t a = polygons[f][i], b = polygons[f][(i + 1) % polygons[f].size()];
      const auto [at, is_new] = label_at.emplace(std::minmax(a, b), labels[f]);
      if (!is_new && at->second != labels[f])
        sum += std::sqrt(CGAL::squared_distance(points[a], points[b]));
    }
  return sum;
}

double area(const std::vector<Point>& points, const std::vector<std::size_t>& polygon)
{
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + CGAL::cross_product(points[polygon[i - 1]] - points[polygon[0]],
                                    points[polygon[i]] - points[polygon[0]]);
  return 0.5 * std::sqrt(sum.squared_length());
}

std::map<int, double> areas(const std::vector<Point>& points, const Polygons& polygons,
                            const std::vector<int>& labels)
{
  std::map<int, double> sums;
  for (std::size_t f = 0; f < polygons.size(); ++f) sums[labels[f]] += area(points, polygons[f]);
  return sums;
}

/// what holds for every cut: the pieces of each face cover it, and the rest is as it was
void check_cut(const Soup& soup, const Cut_mesh<Point>& result)
{
  BOOST_TEST_REQUIRE(result.labels.size() == result.polygons.size());
  BOOST_TEST_REQUIRE(result.source_faces.size() == result.polygons.size());
  BOOST_TEST(std::is_sorted(result.source_faces.begin(), result.source_faces.end()));
  BOOST_TEST_REQUIRE(result.points.size() == soup.points.size() + result.origins.size());
  BOOST_TEST(std::equal(soup.points.begin(), soup.points.end(), result.points.begin()));
  std::vector<double> area_of_pieces(soup.polygons.size(), 0.);
  std::vector<std::size_t> pieces(soup.polygons.size(), 0);
  for (std::size_t i = 0; i < result.polygons.size(); ++i)
  {
    BOOST_TEST_REQUIRE(result.source_faces[i] < soup.polygons.size());
    const auto& face = soup.polygons[result.source_faces[i]];
    ++pieces[result.source_faces[i]];
    area_of_pieces[result.source_faces[i]] += area(result.points, result.polygons[i]);
    BOOST_TEST(area(result.points, result.polygons[i]) > 0.);
    for (const std::size_t p : result.polygons[i])
    {
      if (p < soup.points.size())
      {
        BOOST_TEST(std::count(face.begin(), face.end(), p) == 1);
        continue;
      }
      const auto& origin = result.origins[p - soup.points.size()];
      for (int c = 0; c < 3; ++c)
        if (origin.weights[c] > 0.)
          BOOST_TEST(std::count(face.begin(), face.end(), origin.points[c]) == 1);
    }
  }
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    BOOST_TEST(pieces[f] >= 1u);
    BOOST_TEST(area_of_pieces[f] == area(soup.points, soup.polygons[f]),
               boost::test_tools::tolerance(1e-9));
  }
  const std::set<int> before(soup.labels.begin(), soup.labels.end());
  const std::set<int> after(result.labels.begin(), result.labels.end());
  BOOST_TEST(before == after, boost::test_tools::per_element());
}

/// whether each edge has one face on either side, in opposite directions
bool is_closed(const Polygons& polygons)
{
  std::set<std::pair<std::size_t, std::size_t>> sides;
  std::size_t count = 0;
  for (const auto& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i, ++count)
      sides.emplace(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sides.size() == count && std::all_of(sides.begin(), sides.end(),
                                              [&](const auto& side) {
                                                return sides.count({side.second, side.first}) == 1;
                                              });
}

Soup soup_of(const Shape_generator::Labeled_mesh& mesh)
{
  Soup soup;
  for (const auto& p : mesh.points) soup.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : mesh.faces) soup.polygons.emplace_back(f.begin(), f.end());
  soup.labels = mesh.labels;
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(slanted_borders_become_straight)
{
  for (const bool of_triangles : {true, false})
    for (const double slope : {0.3, 0.7, -0.45})
    {
      const auto label = [slope](const double x, const double y)
      { return y - 10. > slope * (x - 10.) ? 7 : -2; };
      const Soup soup = grid(20, of_triangles, flat, label);
      const Cut_mesh<Point> result = cut(soup);
      check_cut(soup, result);
      const double straight = 20. * std::hypot(1., slope);
      BOOST_TEST(border_length(soup.points, soup.polygons, soup.labels) > 1.1 * straight);
      BOOST_TEST(border_length(result.points, result.polygons, result.labels) < 1.04 * straight);
      const auto before = areas(soup.points, soup.polygons, soup.labels);
      for (const auto& [l, a] : areas(result.points, result.polygons, result.labels))
        BOOST_TEST(std::abs(a - before.at(l)) < 2.); // of 400
    }
}

BOOST_AUTO_TEST_CASE(three_labels_meet_in_a_point)
{
  const auto label = [](const double x, const double y)
  { return x < 10.3 ? 0 : (y - 10. > 0.4 * (x - 10.) ? 1 : 2); };
  const Soup soup = grid(20, true, flat, label);
  const Cut_mesh<Point> result = cut(soup);
  check_cut(soup, result);
  std::map<std::size_t, std::set<int>> labels_at;
  for (std::size_t i = 0; i < result.polygons.size(); ++i)
    for (const std::size_t p : result.polygons[i]) labels_at[p].insert(result.labels[i]);
  std::size_t meetings = 0;
  for (const auto& [p, labels] : labels_at)
    if (labels.size() == 3)
    {
      ++meetings;
      BOOST_TEST(CGAL::squared_distance(result.points[p], Point(10.2, 10., 0.)) < 2.);
    }
  BOOST_TEST(meetings == 1u);
}

BOOST_AUTO_TEST_CASE(borders_in_creases_stay)
{
  const auto roof = [](const double x, double) { return std::abs(x - 8.); };
  const auto label = [](const double x, double) { return x < 8. ? 0 : 1; };
  for (const bool of_triangles : {true, false})
  {
    const Soup soup = grid(16, of_triangles, roof, label);
    const Cut_mesh<Point> result = cut(soup);
    BOOST_TEST(result.origins.empty());
    BOOST_TEST(result.polygons == soup.polygons);
    BOOST_TEST(result.labels == soup.labels, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(labels_of_few_faces_keep_their_borders)
{
  Soup soup = grid(12, true, flat, [](const double x, double) { return x < 6. ? 0 : 1; });
  soup.labels[40] = 2;                     // one face
  soup.labels[100] = soup.labels[101] = 3; // a square
  const Cut_mesh<Point> result = cut(soup);
  check_cut(soup, result);
  const auto before = areas(soup.points, soup.polygons, soup.labels);
  const auto after = areas(result.points, result.polygons, result.labels);
  for (const int l : {2, 3})
    BOOST_TEST(after.at(l) == before.at(l), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(closed_meshes_stay_closed)
{
  for (const char* const name : {"figure", "octopus", "ant", "cup"})
  {
    const Soup soup = soup_of(Shape_generator::make_mesh(name));
    BOOST_TEST_REQUIRE(is_closed(soup.polygons));
    const Cut_mesh<Point> result = cut(soup);
    check_cut(soup, result);
    BOOST_TEST(!result.origins.empty());
    BOOST_TEST(is_closed(result.polygons));
    BOOST_TEST(border_length(result.points, result.polygons, result.labels) <
               border_length(soup.points, soup.polygons, soup.labels));
  }
}

BOOST_AUTO_TEST_CASE(labels_at_random_leave_no_gap)
{
  std::mt19937 random(3);
  for (const std::size_t share : {1, 5, 50})
  {
    Soup soup = soup_of(Shape_generator::make_mesh("dumbbell"));
    for (std::size_t f = 0; f < soup.labels.size(); ++f)
      if (random() % share == 0) soup.labels[f] = static_cast<int>(random() % 4);
    const Cut_mesh<Point> result = cut(soup);
    check_cut(soup, result);
    BOOST_TEST(is_closed(result.polygons));
  }
}

BOOST_AUTO_TEST_CASE(corners_at_one_position_are_cut_alike)
{
  const Soup welded = soup_of(Shape_generator::make_mesh("figure"));
  Soup apart;
  for (std::size_t f = 0; f < welded.polygons.size(); ++f)
  {
    apart.polygons.emplace_back();
    for (const std::size_t p : welded.polygons[f])
    {
      apart.polygons.back().push_back(apart.points.size());
      apart.points.push_back(welded.points[p]);
    }
  }
  apart.labels = welded.labels;
  const Cut_mesh<Point> result = cut(apart), of_welded = cut(welded);
  BOOST_TEST(result.polygons.size() == of_welded.polygons.size());
  const std::set<Point> places(result.points.begin(), result.points.end());
  const std::set<Point> welded_places(of_welded.points.begin(), of_welded.points.end());
  BOOST_TEST((places == welded_places)); // to the last bit: no gap opens
}

BOOST_AUTO_TEST_CASE(cuts_depend_on_neither_order_nor_size)
{
  const Soup soup = soup_of(Shape_generator::make_mesh("octopus"));
  const Cut_mesh<Point> result = cut(soup);
  Soup turned = soup;
  std::reverse(turned.points.begin(), turned.points.end());
  std::reverse(turned.polygons.begin(), turned.polygons.end());
  std::reverse(turned.labels.begin(), turned.labels.end());
  for (auto& polygon : turned.polygons)
    for (std::size_t& p : polygon) p = soup.points.size() - 1 - p;
  const Cut_mesh<Point> of_turned = cut(turned);
  BOOST_TEST(of_turned.polygons.size() == result.polygons.size());
  BOOST_TEST(border_length(of_turned.points, of_turned.polygons, of_turned.labels) ==
                 border_length(result.points, result.polygons, result.labels),
             boost::test_tools::tolerance(1e-9));
  const double factor = std::ldexp(1., 600);
  Soup huge = soup;
  for (Point& p : huge.points) p = Point(factor * p.x(), factor * p.y(), factor * p.z());
  const Cut_mesh<Point> of_huge = cut(huge);
  BOOST_TEST((of_huge.polygons == result.polygons));
  for (std::size_t i = 0; i < result.points.size(); ++i)
    BOOST_TEST_REQUIRE(of_huge.points[i].x() == factor * result.points[i].x());
}

BOOST_AUTO_TEST_CASE(odd_faces_are_no_trouble)
{
  Soup soup =
      grid(10, true, flat, [](const double x, const double y) { return x + 0.3 * y < 6. ? 0 : 1; });
  const std::size_t p = soup.polygons[90][0], q = soup.polygons[90][1];
  soup.points.push_back(soup.points[p]);                 // named by none
  soup.polygons.push_back({p, p, q});                    // without area
  soup.polygons.push_back({p, q, soup.polygons[90][2]}); // twice
  soup.polygons.push_back({q, p, 3});                    // the third at an edge
  soup.labels.insert(soup.labels.end(), {0, 1, 0});
  const Cut_mesh<Point> result = cut(soup);
  BOOST_TEST(std::set<std::size_t>(result.source_faces.begin(), result.source_faces.end()).size() +
                 1 >=
             soup.polygons.size());
  const Soup none;
  BOOST_TEST(cut(none).polygons.empty());
  Soup one = {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}, {5}};
  BOOST_TEST(cut(one).labels == std::vector<int>{5}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(surface_meshes_are_cut_into_surface_meshes)
{
  const Soup soup = soup_of(Shape_generator::make_mesh("figure"));
  CGAL::Surface_mesh<Point> mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  auto label = mesh.add_property_map<CGAL::Surface_mesh<Point>::Face_index, int>("f:label").first;
  for (const auto f : mesh.faces()) label[f] = soup.labels[f];
  const auto result = cut_along_borders(mesh, label);
  check_cut(soup, result);
  BOOST_TEST((result.polygons == cut(soup).polygons));
  namespace PMP = CGAL::Polygon_mesh_processing;
  BOOST_TEST_REQUIRE(PMP::is_polygon_soup_a_polygon_mesh(result.polygons));
  CGAL::Surface_mesh<Point> cut_mesh;
  PMP::polygon_soup_to_polygon_mesh(result.points, result.polygons, cut_mesh);
  BOOST_TEST(CGAL::is_closed(cut_mesh));
  BOOST_TEST(CGAL::is_triangle_mesh(cut_mesh));
}

BOOST_AUTO_TEST_CASE(a_polyhedron_is_cut)
{
  const Soup soup = soup_of(Shape_generator::make_mesh("figure"));
  CGAL::Polyhedron_3<Kernel> mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  std::map<CGAL::Polyhedron_3<Kernel>::Facet_handle, int> label;
  std::size_t i = 0;
  for (const auto f : faces(mesh)) label[f] = soup.labels[i++];
  check_cut(soup, cut_along_borders(mesh, boost::make_assoc_property_map(label)));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused)
{
  const Soup good = grid(3, true, flat, [](const double x, double) { return x < 1.5 ? 0 : 1; });
  Soup bad = good;
  bad.labels.pop_back();
  BOOST_CHECK_THROW(cut(bad), std::invalid_argument);
  bad = good;
  bad.polygons[2][1] = bad.points.size();
  BOOST_CHECK_THROW(cut(bad), std::invalid_argument);
  bad = good;
  bad.polygons[2].resize(2);
  BOOST_CHECK_THROW(cut(bad), std::invalid_argument);
  bad = good;
  bad.points[1] = Point(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  BOOST_CHECK_THROW(cut(bad), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
