// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "shapes_for_tests.h"

#include <CGAL/Weakly_convex_segmentation/internal/borders/connected_parts.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/solids.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/strays.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Shapes of many pieces, with strays far away, or with faces twice: what people download and scan.

BOOST_AUTO_TEST_SUITE(test_pieces)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using namespace Shapes_for_tests;
using WCS::Parameters;
using WCS::Result;
using WCS::internal::find_solids;
using WCS::internal::Point_role;
using WCS::internal::Torn_parts;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<int> pieces; ///< of the faces
};

void add_mesh(Soup& soup, const Shape_generator::Labeled_mesh& mesh, const double scale = 1.,
              const Vector& move = Vector(0., 0., 0.))
{
  const std::size_t first = soup.points.size();
  const int piece = soup.pieces.empty() ? 0 : soup.pieces.back() + 1;
  for (const auto& p : mesh.points)
    soup.points.push_back(Point(scale * p[0], scale * p[1], scale * p[2]) + move);
  for (const auto& f : mesh.faces) soup.faces.push_back({first + f[0], first + f[1], first + f[2]});
  soup.pieces.resize(soup.faces.size(), piece);
}

/// a box of twelve triangles, its normals outwards or, as of a cavity, inwards
void add_box(Soup& soup, const Point& center, const Vector& half, const bool is_inwards = false)
{
  const std::size_t first = soup.points.size();
  const int piece = soup.pieces.empty() ? 0 : soup.pieces.back() + 1;
  for (std::size_t corner = 0; corner < 8; ++corner)
    soup.points.emplace_back(center.x() + ((corner & 4) != 0 ? half.x() : -half.x()),
                             center.y() + ((corner & 2) != 0 ? half.y() : -half.y()),
                             center.z() + ((corner & 1) != 0 ? half.z() : -half.z()));
  const std::array<std::array<std::size_t, 4>, 6> sides = {
      {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
  for (const auto& s : sides)
    for (std::array<std::size_t, 3> f : {std::array<std::size_t, 3>{s[0], s[1], s[2]},
                                         std::array<std::size_t, 3>{s[0], s[2], s[3]}})
    {
      if (is_inwards) std::swap(f[0], f[1]);
      soup.faces.push_back({first + f[0], first + f[1], first + f[2]});
    }
  soup.pieces.resize(soup.faces.size(), piece);
}

std::vector<int> labels_of(const Soup& soup, const Parameters& parameters = {})
{
  const Result result =
      CGAL::weakly_convex_segmentation_of_soup(soup.points, soup.faces, parameters);
  check_result(result, soup.faces.size(), false); // faces have several points
  return result.labels;
}

std::vector<int> labels_of(const std::vector<Point>& points, const std::vector<Vector>& normals,
                           const Parameters& parameters = {})
{
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  std::vector<int> labels(points.size(), -1);
  const auto map = CGAL::make_property_map(labels);
  const auto result = normals.empty()
                          ? CGAL::weakly_convex_segmentation(
                                indices, map, parameters,
                                CGAL::parameters::point_map(CGAL::make_property_map(points)))
                          : CGAL::weakly_convex_segmentation(
                                indices, map, parameters,
                                CGAL::parameters::point_map(CGAL::make_property_map(points))
                                    .normal_map(CGAL::make_property_map(normals)));
  check_result(result, points.size());
  return labels;
}

/// how much the labels of the first elements have changed
double change(std::vector<int> labels, const std::vector<int>& before)
{
  labels.resize(before.size());
  return rand_distance(labels, before);
}

std::vector<WCS::internal::Index> solids_of(const Soup& soup)
{
  return find_solids(
      WCS::internal::read_soup(soup.points, soup.faces, CGAL::Identity_property_map<Point>()));
}

const Vector sideways(0.3, 0.8, 0.5); // for shapes of size 1 or so

} // namespace

BOOST_AUTO_TEST_CASE(a_far_triangle_changes_nothing)
{
  for (const Parameters& parameters : {Parameters(), Parameters::training_free()})
    for (const char* name : {"figure", "hand"})
    {
      Soup soup;
      add_mesh(soup, Shape_generator::make_mesh(name, 3000));
      const std::vector<int> usual = labels_of(soup, parameters);
      for (const double distance : {8., 40., 1e4, 1e9})
      {
        Soup with = soup;
        const Point at = soup.points.front() + distance * sideways;
        with.points.insert(with.points.end(),
                           {at, at + Vector(1e-3, 0., 0.), at + Vector(0., 1e-3, 0.)});
        const std::size_t n = soup.points.size();
        with.faces.push_back({n, n + 1, n + 2});
        BOOST_CHECK_EQUAL(change(labels_of(with, parameters), usual), 0.);
      }
    }
}

BOOST_AUTO_TEST_CASE(scattered_points_far_away_hardly_matter)
{
  const auto cloud = Shape_generator::make_cloud("hand", 5000);
  std::vector<Point> points;
  std::vector<Vector> normals;
  for (const auto& p : cloud.points) points.emplace_back(p[0], p[1], p[2]);
  for (const auto& n : cloud.normals) normals.emplace_back(n[0], n[1], n[2]);
  for (const bool has_normals : {true, false})
  {
    if (!has_normals) normals.clear();
    const std::vector<int> usual = labels_of(points, normals);
    for (const double distance : {8., 1e3, 1e9})
    {
      std::vector<Point> more = points;
      std::vector<Vector> their_normals = normals;
      more.push_back(points.front() + distance * sideways);
      if (has_normals) their_normals.emplace_back(0., 0., 1.);
      BOOST_CHECK_EQUAL(change(labels_of(more, their_normals), usual), 0.);
    }
    for (const double width : {10., 30.})
    {
      std::mt19937 random(2);
      std::vector<Point> more = points;
      std::vector<Vector> their_normals = normals;
      for (int i = 0; i < 50; ++i)
      {
        const double x = uniform(random), y = uniform(random), z = uniform(random);
        more.emplace_back(width * (x - 0.5), width * (y - 0.5), width * (z - 0.5));
        if (has_normals) their_normals.emplace_back(1., 0., 0.);
      }
      BOOST_CHECK_LT(change(labels_of(more, their_normals), usual), 0.03);
    }
  }
}

BOOST_AUTO_TEST_CASE(another_object_far_away_hardly_matters)
{
  double sum = 0.;
  for (const char* name : {"figure", "chair", "hand"})
  {
    Soup soup;
    add_mesh(soup, Shape_generator::make_mesh(name, 6000));
    const std::vector<int> usual = labels_of(soup);
    for (const double distance : {8., 50., 1000.})
    {
      Soup with = soup;
      add_mesh(with, Shape_generator::make_mesh("dumbbell", 1000), 0.2, distance * sideways);
      const std::vector<int> labels = labels_of(with);
      sum += change(labels, usual);
      BOOST_CHECK_LT(change(labels, usual), 0.06); // as another seed may make
      const std::set<int> of_shape(labels.begin(), labels.begin() + soup.faces.size());
      for (std::size_t f = soup.faces.size(); f < labels.size(); ++f)
        BOOST_CHECK_EQUAL(of_shape.count(labels[f]), 0u);
    }
  }
  BOOST_CHECK_LT(sum / 9., 0.02);
}

BOOST_AUTO_TEST_CASE(ordinary_shapes_have_no_strays)
{
  for (const std::string& name : Shape_generator::shape_names())
  {
    Soup soup;
    add_mesh(soup, Shape_generator::make_mesh(name, 6000));
    const Raw_shape raw =
        WCS::internal::read_soup(soup.points, soup.faces, CGAL::Identity_property_map<Point>());
    BOOST_CHECK(point_roles(raw).empty());
  }
  Raw_shape
      wire; // a hundred points along a line, and two dense halves with a gap as wide as they are
  for (int i = 0; i < 100; ++i) add_point(wire, {0.01 * i, 0., 0.}, {0., 0., 1.});
  BOOST_CHECK(point_roles(wire).empty());
  for (int i = 0; i < 100; ++i) add_point(wire, {2. + 0.01 * i, 0., 0.}, {0., 0., 1.});
  BOOST_CHECK(point_roles(wire).empty());
}

BOOST_AUTO_TEST_CASE(roles_of_what_is_far_away)
{
  Raw_shape raw;
  add_sphere(raw, {0., 0., 0.}, 1., 2000);
  add_sphere(raw, {4., 0., 0.}, 1., 500); // near
  add_sphere(raw, {40., 0., 0.}, 1., 100);
  add_point(raw, {0., -30., 0.}, {0., 0., 1.});
  add_point(raw, {0., 0., 1.05}, {0., 0., 1.}); // hardly off
  const auto roles = point_roles(raw);
  BOOST_REQUIRE_EQUAL(roles.size(), raw.positions.size());
  for (std::size_t i = 0; i < 2500; ++i) BOOST_CHECK(roles[i] == Point_role::SHAPE);
  for (std::size_t i = 2500; i < 2600; ++i) BOOST_CHECK(roles[i] == Point_role::FAR);
  BOOST_CHECK(roles[2600] == Point_role::STRAY);
  BOOST_CHECK(roles[2601] == Point_role::SHAPE);
}

BOOST_AUTO_TEST_CASE(separate_cubes_are_a_part_each)
{
  for (const Parameters& parameters : {Parameters(), Parameters::training_free()})
    for (const double gap : {0.3, 0.01, 1e-4})
    {
      Soup soup;
      for (int i = 0; i < 343; ++i)
        add_box(soup, Point((2. + gap) * (i % 7), (2. + gap) * (i / 7 % 7), (2. + gap) * (i / 49)),
                Vector(1., 1., 1.));
      BOOST_CHECK_EQUAL(rand_distance(labels_of(soup, parameters), soup.pieces), 0.);
    }
}

BOOST_AUTO_TEST_CASE(boxes_that_touch_are_a_part_each)
{
  Soup table;
  add_box(table, Point(0., 0., 0.), Vector(5., 3., 0.2));
  for (const double x : {-4.75, 4.75})
    for (const double y : {-2.75, 2.75}) add_box(table, Point(x, y, -2.2), Vector(0.25, 0.25, 2.));
  BOOST_CHECK_EQUAL(rand_distance(labels_of(table), table.pieces), 0.);
  Soup row;
  for (int i = 0; i < 6; ++i)
    add_box(row, Point(2. * i, 0.3 * (i % 2), 0.),
            Vector(1., 1., 1.)); // shifted against each other
  BOOST_CHECK_EQUAL(rand_distance(labels_of(row), row.pieces), 0.);
}

BOOST_AUTO_TEST_CASE(no_part_goes_from_one_solid_into_another)
{
  Parameters paper = Parameters::paper();
  paper.pieces = WCS::Piece_rule::SEPARATE; // it joins them
  for (const Parameters& parameters : {Parameters(), Parameters::training_free(), paper})
  {
    Soup soup;
    add_mesh(soup, Shape_generator::make_mesh("figure", 3000));
    add_mesh(soup, Shape_generator::make_mesh("hand", 3000), 1., Vector(0.1, 0.2, 0.));
    const std::vector<int> labels = labels_of(soup, parameters);
    const auto second = labels.begin() + std::count(soup.pieces.begin(), soup.pieces.end(), 0);
    const std::set<int> of_first(labels.begin(), second);
    for (auto l = second; l != labels.end(); ++l) BOOST_CHECK_EQUAL(of_first.count(*l), 0u);
  }
}

BOOST_AUTO_TEST_CASE(boxes_that_share_edges_and_faces_are_a_part_each)
{
  Soup own; // vertices; the walls between the cubes are there twice
  for (int i = 0; i < 27; ++i)
    add_box(own, Point(2. * (i % 3), 2. * (i / 3 % 3), 2. * (i / 9)), Vector(1., 1., 1.));
  BOOST_CHECK_EQUAL(rand_distance(labels_of(own), own.pieces), 0.);
  Soup loose = own, shared = own;
  loose.points.clear();
  shared.points.clear();
  std::map<Point, std::size_t> number;
  for (std::size_t f = 0; f < own.faces.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Point& p = own.points[own.faces[f][c]];
      loose.faces[f][c] = loose.points.size();
      loose.points.push_back(p);
      const auto [vertex, is_new] = number.emplace(p, shared.points.size());
      if (is_new) shared.points.push_back(p);
      shared.faces[f][c] = vertex->second;
    }
  BOOST_CHECK_EQUAL(rand_distance(labels_of(loose), own.pieces), 0.);
  BOOST_CHECK_EQUAL(rand_distance(labels_of(shared), own.pieces), 0.);
}

BOOST_AUTO_TEST_CASE(open_boxes_are_a_part_each)
{
  for (const double gap : {0.05, 0.})
  {
    Soup boards; // of a shelf: without the side that is not seen
    for (int i = 0; i < 5; ++i) add_box(boards, Point(0., 0., (1. + gap) * i), Vector(3., 2., 0.1));
    for (const double x : {-3.1 - gap, 3.1 + gap})
      add_box(boards, Point(x, 0., 2.), Vector(0.1, 2., 2.5));
    Soup open = boards;
    open.faces.clear();
    open.pieces.clear();
    for (std::size_t f = 0; f < boards.faces.size(); ++f)
      if (f % 12 != 4 && f % 12 != 5)
      {
        open.faces.push_back(boards.faces[f]);
        open.pieces.push_back(boards.pieces[f]);
      }
    BOOST_CHECK_EQUAL(rand_distance(labels_of(open), open.pieces), 0.);
  }
}

BOOST_AUTO_TEST_CASE(torn_pieces_are_one_object)
{
  Soup whole;
  add_mesh(whole, Shape_generator::make_mesh("dumbbell", 3000));
  const auto torn = [&whole](const double low, const double high)
  {
    Soup soup = whole;
    soup.faces.clear();
    for (const auto& f : whole.faces)
    {
      const double x =
          (whole.points[f[0]].x() + whole.points[f[1]].x() + whole.points[f[2]].x()) / 3.;
      if (x < low || x > high) soup.faces.push_back(f);
    }
    return soup;
  };
  const auto x = [](const Point& a, const Point& b) { return a.x() < b.x(); };
  const auto [first, last] = std::minmax_element(whole.points.begin(), whole.points.end(), x);
  const double middle = 0.5 * (first->x() + last->x()), length = last->x() - first->x();
  for (const double width : {0.02, 0.1})
    BOOST_CHECK(
        solids_of(torn(middle - width * length / 2., middle + width * length / 2.)).empty());
  // what is far apart are two objects
  BOOST_CHECK(!solids_of(torn(first->x() + 0.1 * length, last->x() - 0.1 * length)).empty());
}

BOOST_AUTO_TEST_CASE(pieces_are_joined_separate_or_whole)
{
  Soup soup; // two balls that penetrate each other, and a dumbbell
  add_mesh(soup, Shape_generator::make_mesh("sphere", 1000));
  add_mesh(soup, Shape_generator::make_mesh("sphere", 1000), 1., Vector(0.2, 0., 0.));
  add_mesh(soup, Shape_generator::make_mesh("dumbbell", 2000), 1., Vector(6., 0., 0.));
  const auto parts_of = [&soup](const std::vector<int>& labels)
  {
    std::map<int, std::set<int>> parts;
    for (std::size_t f = 0; f < labels.size(); ++f) parts[soup.pieces[f]].insert(labels[f]);
    return parts;
  };
  Parameters parameters;
  auto parts = parts_of(labels_of(soup, parameters));
  BOOST_CHECK_EQUAL(parts[0].size(), 1u);
  BOOST_CHECK(parts[0] != parts[1]);
  BOOST_CHECK_EQUAL(parts[2].size(), 3u);
  parameters.pieces = WCS::Piece_rule::WHOLE;
  BOOST_CHECK_EQUAL(rand_distance(labels_of(soup, parameters), soup.pieces), 0.);
  parameters.pieces = WCS::Piece_rule::JOINED;
  parts = parts_of(labels_of(soup, parameters));
  BOOST_CHECK(parts[0] == parts[1]);
  BOOST_CHECK_EQUAL(parts[2].size(), 3u);
}

BOOST_AUTO_TEST_CASE(a_coarse_mesh_is_cut_as_its_fine_version)
{
  for (const int k : {1, 2, 5}) // faces of a cube are of k x k squares
  {
    const std::set<std::array<int, 3>> cubes = {
        {0, 0, 4}, {0, 0, 3}, {0, 0, 2}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0},
        {3, 0, 0}, {4, 0, 0}, {4, 0, 1}, {4, 0, 2}, {4, 0, 3}, {4, 0, 4}};
    Soup soup;
    std::vector<int>
        arm; // 0 and 1 for the ends of the arms of the U, 2 for its middle, -1 elsewhere
    for (const auto& cube : cubes)
      for (std::size_t side = 0; side < 6; ++side)
      {
        const std::size_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        auto beyond = cube;
        beyond[axis] += side % 2 == 0 ? -1 : 1;
        if (cubes.count(beyond) != 0) continue;
        for (int i = 0; i < k * k; ++i)
        {
          std::array<std::size_t, 4> corners;
          for (std::size_t c = 0; c < 4; ++c)
          {
            std::array<double, 3> p = {1. * cube[0], 1. * cube[1], 1. * cube[2]};
            p[axis] += side % 2 == 0 ? 0. : 1.;
            p[u] += (i % k + (c == 1 || c == 2 ? 1. : 0.)) / k;
            p[v] += (i / k + (c >= 2 ? 1. : 0.)) / k;
            corners[side % 2 == 0 ? 3 - c : c] = soup.points.size();
            soup.points.emplace_back(p[0], p[1], p[2]);
          }
          soup.faces.push_back({corners[0], corners[1], corners[2]});
          soup.faces.push_back({corners[0], corners[2], corners[3]});
          const int part = cube[2] > 1                  ? (cube[0] == 0 ? 0 : 1)
                           : cube[0] > 1 && cube[0] < 3 ? 2
                                                        : -1;
          arm.insert(arm.end(), 2, part);
        }
      }
    std::map<int, std::set<int>> labels_of_arm;
    const std::vector<int> labels = labels_of(soup);
    for (std::size_t f = 0; f < labels.size(); ++f) labels_of_arm[arm[f]].insert(labels[f]);
    BOOST_CHECK_EQUAL(std::set<int>(labels.begin(), labels.end()).size(), 3u);
    for (const int a : {0, 1, 2}) BOOST_CHECK_EQUAL(labels_of_arm[a].size(), 1u);
  }
}

BOOST_AUTO_TEST_CASE(solids_are_no_cavities_or_crumbs)
{
  Soup soup;
  add_box(soup, Point(0., 0., 0.), Vector(1., 1., 1.));
  BOOST_CHECK(solids_of(soup).empty()); // there is nothing to keep it from
  add_box(soup, Point(0., 0., 0.), Vector(0.8, 0.8, 0.8), true);
  BOOST_CHECK(solids_of(soup).empty());
  add_box(soup, Point(3., 0., 0.), Vector(1., 1., 1.));
  add_box(soup, Point(0., 3., 0.), Vector(0.1, 0.1, 0.1));
  add_box(soup, Point(0., 0., 3.), Vector(1., 1., 1.));
  soup.faces.pop_back(); // it is open
  const auto solids = solids_of(soup);
  BOOST_REQUIRE_EQUAL(solids.size(), soup.faces.size());
  for (std::size_t f = 0; f < solids.size(); ++f)
  {
    const int piece = soup.pieces[f];
    BOOST_CHECK_EQUAL(solids[f] != 0, piece == 0 || piece == 2 || piece == 4);
    if (piece == 2) BOOST_CHECK_NE(solids[f], solids[0]);
  }
}

BOOST_AUTO_TEST_CASE(faces_from_behind_have_the_labels_of_those_in_front)
{
  for (const char* name : {"figure", "hand"})
  {
    Soup soup;
    add_mesh(soup, Shape_generator::make_mesh(name, 3000));
    const std::vector<int> usual = labels_of(soup);
    Soup doubled = soup;
    for (const auto& f : soup.faces) doubled.faces.push_back({f[1], f[0], f[2]});
    const std::vector<int> labels = labels_of(doubled);
    const auto middle = labels.begin() + static_cast<std::ptrdiff_t>(usual.size());
    BOOST_CHECK_EQUAL(change(labels, usual), 0.);
    BOOST_CHECK(std::equal(labels.begin(), middle, middle));
  }
}

BOOST_AUTO_TEST_CASE(parts_hang_together)
{
  using WCS::internal::Index;
  // a row of points: small pieces go to the neighbor with more links, large ones become parts
  std::vector<std::array<Index, 2>> links;
  for (Index i = 0; i + 1 < 100; ++i) links.push_back({i, i + 1});
  const auto row = [](const std::vector<std::pair<int, int>>& runs)
  {
    std::vector<int> labels;
    for (const auto& [label, length] : runs) labels.insert(labels.end(), length, label);
    return labels;
  };
  const std::vector<int> before = row({{0, 50}, {1, 20}, {0, 2}, {1, 10}, {0, 18}});
  std::vector<int> labels = before;
  Torn_parts(links, labels).join_small(5.);
  BOOST_CHECK(labels == row({{0, 50}, {1, 32}, {0, 18}}));
  Torn_parts(links, labels).join_small(5.);
  BOOST_CHECK(labels == row({{0, 50}, {1, 32}, {0, 18}}));
  Torn_parts(links, labels).divide(7);
  BOOST_CHECK(labels == row({{0, 50}, {1, 32}, {7, 18}}));
  labels = row({{0, 50}, {1, 32}, {0, 18}});
  Torn_parts(links, labels).join_small(19.);
  BOOST_CHECK(labels == row({{0, 50}, {1, 50}}));
  links.erase(links.begin() + 81); // another piece of the mesh, which may have the same label
  labels = row({{0, 50}, {1, 32}, {0, 18}});
  Torn_parts(links, labels).join_small(19.);
  Torn_parts(links, labels).divide(7);
  BOOST_CHECK(labels == row({{0, 50}, {1, 32}, {0, 18}}));
}

BOOST_AUTO_TEST_CASE(parts_of_meshes_hang_together)
{
  for (const std::string& name : Shape_generator::shape_names())
    for (const unsigned int seed : {0u, 1u})
    {
      Soup soup;
      add_mesh(soup, Shape_generator::make_mesh(name, 6000));
      Parameters parameters;
      parameters.seed = seed;
      const Result result =
          CGAL::weakly_convex_segmentation_of_soup(soup.points, soup.faces, parameters);
      const Raw_shape raw =
          WCS::internal::read_soup(soup.points, soup.faces, CGAL::Identity_property_map<Point>());
      const auto pieces = WCS::internal::pieces_of_labels(raw.links, result.labels);
      BOOST_CHECK_EQUAL(std::set<WCS::internal::Index>(pieces.begin(), pieces.end()).size(),
                        result.number_of_segments());
    }
}

BOOST_AUTO_TEST_SUITE_END()
