// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "shapes_for_tests.h"

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// All kinds of input, as a user writes them, and what comes back.

BOOST_AUTO_TEST_SUITE(test_interface)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using CGAL::Weakly_convex_segmentation::Parameters;
using CGAL::Weakly_convex_segmentation::Result;
using Shape_generator::Labeled_cloud;
using Shape_generator::Labeled_mesh;
using Shapes_for_tests::rand_distance;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Point_with_normal = std::pair<Point, Vector>;
using Indices = std::vector<std::size_t>;

const Labeled_mesh& dumbbell()
{
  static const Labeled_mesh mesh = Shape_generator::make_mesh("dumbbell", 3000);
  return mesh;
}

const Labeled_cloud& dumbbell_cloud()
{
  static const Labeled_cloud cloud = Shape_generator::make_cloud("dumbbell", 4000);
  return cloud;
}

std::vector<Point> points_of(const std::vector<std::array<double, 3>>& coordinates)
{
  std::vector<Point> points;
  for (const auto& p : coordinates) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

std::vector<Point_with_normal> points_with_normals(const Labeled_cloud& cloud)
{
  std::vector<Point_with_normal> points;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const auto &p = cloud.points[i], &n = cloud.normals[i];
    points.push_back({Point(p[0], p[1], p[2]), Vector(n[0], n[1], n[2])});
  }
  return points;
}

Mesh surface_mesh(const Labeled_mesh& shape)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point& p : points_of(shape.points)) vertices.push_back(mesh.add_vertex(p));
  for (const auto& f : shape.faces) mesh.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
  return mesh;
}

/// no map at all
boost::dummy_property_map nowhere() { return {}; }

const auto pair_maps =
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
        .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>());

} // namespace

BOOST_AUTO_TEST_CASE(surface_mesh_with_a_property_map)
{
  Mesh mesh = surface_mesh(dumbbell());
  auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label", -7).first;
  const Result result = CGAL::weakly_convex_segmentation(mesh, label);
  check_result(result, dumbbell().faces.size());
  std::size_t i = 0;
  for (const Mesh::Face_index f : mesh.faces()) BOOST_REQUIRE_EQUAL(label[f], result.labels[i++]);
  BOOST_CHECK_GE(result.number_of_segments(), 2u);
  BOOST_CHECK_LE(result.number_of_segments(), // refinement may swallow some
                 result.merge_tree.number_of_patches() -
                     result.merge_tree.number_of_accepted_merges());
  BOOST_CHECK_LT(rand_distance(result.labels, dumbbell().labels), 0.1);
  bool has_diameter = false;
  for (const auto& s : result.segments) has_diameter = has_diameter || s.diameter > 0.05;
  BOOST_CHECK(has_diameter);
}

BOOST_AUTO_TEST_CASE(mesh_with_removed_faces_and_a_vertex_point_map_of_its_own)
{
  Mesh mesh = surface_mesh(dumbbell());
  std::vector<Point> moved(mesh.number_of_vertices());
  for (const auto v : mesh.vertices()) moved[v] = mesh.point(v) + Vector(5., 0., 0.);
  for (const auto v : mesh.vertices()) mesh.point(v) = CGAL::ORIGIN;
  for (const std::size_t f : {11u, 500u})
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(f), mesh), mesh);
  BOOST_REQUIRE(mesh.has_garbage());
  const auto positions = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](const Mesh::Vertex_index v) { return moved[v]; });
  auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label", -7).first;
  const Result result = CGAL::weakly_convex_segmentation(
      mesh, label, Parameters(), CGAL::parameters::vertex_point_map(positions));
  check_result(result, dumbbell().faces.size() - 2);
  std::vector<int> truth;
  for (const Mesh::Face_index f : mesh.faces()) truth.push_back(dumbbell().labels[f]);
  BOOST_CHECK_LT(rand_distance(result.labels, truth), 0.1);
}

BOOST_AUTO_TEST_CASE(polygon_soup_is_as_good_as_the_mesh)
{
  const std::vector<Point> points = points_of(dumbbell().points);
  const Mesh mesh = surface_mesh(dumbbell());
  const Result of_mesh = CGAL::weakly_convex_segmentation(mesh, nowhere());
  const Result of_soup = CGAL::weakly_convex_segmentation_of_soup(points, dumbbell().faces);
  check_result(of_soup, dumbbell().faces.size());
  BOOST_CHECK(of_soup.labels == of_mesh.labels);

  // three points of its own for each triangle
  std::vector<Point> loose;
  std::vector<Indices> triangles;
  for (const auto& f : dumbbell().faces)
  {
    triangles.push_back({loose.size(), loose.size() + 1, loose.size() + 2});
    for (const std::size_t v : f) loose.push_back(points[v]);
  }
  BOOST_CHECK(CGAL::weakly_convex_segmentation_of_soup(loose, triangles).labels == of_mesh.labels);

  triangles[5] = {0, 1};
  BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation_of_soup(loose, triangles),
                    std::invalid_argument);
  triangles[5] = {0, 1, loose.size()};
  BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation_of_soup(loose, triangles),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(pairs_of_points_and_normals)
{
  const auto points = points_with_normals(dumbbell_cloud());
  const Result result =
      CGAL::weakly_convex_segmentation(points, nowhere(), Parameters(), pair_maps);
  check_result(result, points.size());
  BOOST_CHECK_LT(rand_distance(result.labels, dumbbell_cloud().labels), 0.1);
}

BOOST_AUTO_TEST_CASE(indices_into_arrays_of_the_caller)
{
  const Labeled_cloud& cloud = dumbbell_cloud();
  const std::vector<Point> positions = points_of(cloud.points), normals = points_of(cloud.normals);
  const auto position = boost::make_function_property_map<std::size_t>([&](const std::size_t i)
                                                                       { return positions[i]; });
  const auto normal = boost::make_function_property_map<std::size_t>(
      [&](const std::size_t i) { return Vector(CGAL::ORIGIN, normals[i]); });
  const auto maps = CGAL::parameters::point_map(position).normal_map(normal);

  Indices all(positions.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<int> labels(positions.size(), -1);
  const auto label = CGAL::make_property_map(labels);
  const Result result = CGAL::weakly_convex_segmentation(all, label, Parameters(), maps);
  BOOST_CHECK(labels == result.labels);
  const auto pairs = points_with_normals(cloud);
  BOOST_CHECK(CGAL::weakly_convex_segmentation(pairs, nowhere(), Parameters(), pair_maps).labels ==
              result.labels);

  // every other point, from the last to the first: the labels go where the indices say
  Indices some;
  for (std::size_t i = positions.size(); i > 1; i -= 2) some.push_back(i - 1);
  labels.assign(positions.size(), -1);
  const Result of_some = CGAL::weakly_convex_segmentation(some, label, Parameters(), maps);
  check_result(of_some, some.size());
  std::vector<int> truth;
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    BOOST_REQUIRE_EQUAL(labels[some[i]], of_some.labels[i]);
    BOOST_REQUIRE_EQUAL(labels[some[i] - 1], -1); // not in the range, not written
    truth.push_back(cloud.labels[some[i]]);
  }
  BOOST_CHECK_LT(rand_distance(of_some.labels, truth), 0.1);
}

BOOST_AUTO_TEST_CASE(points_without_normals)
{
  const std::vector<Point> points = points_of(dumbbell_cloud().points);
  const Result result = CGAL::weakly_convex_segmentation(points, nowhere());
  check_result(result, points.size());
  BOOST_CHECK_LT(rand_distance(result.labels, dumbbell_cloud().labels), 0.15);
  const std::vector<Point> empty;
  BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation(empty, nowhere()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(point_set_with_and_without_normals)
{
  using Point_set = CGAL::Point_set_3<Point, Vector>;
  Point_set bare, oriented;
  oriented.add_normal_map();
  const auto points = points_with_normals(dumbbell_cloud());
  for (const auto& [p, n] : points) bare.insert(p), oriented.insert(p, n);
  auto label = oriented.add_property_map<int>("label", -1).first;
  const Result result = CGAL::weakly_convex_segmentation(oriented, label);
  check_result(result, points.size());
  BOOST_CHECK(result.labels ==
              CGAL::weakly_convex_segmentation(points, nowhere(), Parameters(), pair_maps).labels);
  std::size_t i = 0;
  for (const auto& index : oriented) BOOST_REQUIRE_EQUAL(label[index], result.labels[i++]);

  const Result of_bare = CGAL::weakly_convex_segmentation(bare, nowhere());
  BOOST_CHECK(
      of_bare.labels ==
      CGAL::weakly_convex_segmentation(points_of(dumbbell_cloud().points), nowhere()).labels);

  // removed points are not read and not written
  auto kept = bare.add_property_map<int>("label", -1).first;
  const Point_set::Index first = *bare.begin();
  bare.remove(bare.begin());
  const Result of_rest = CGAL::weakly_convex_segmentation(bare, kept);
  check_result(of_rest, points.size() - 1);
  BOOST_CHECK_EQUAL(kept[first], -1);
}

BOOST_AUTO_TEST_CASE(a_segmenter_gives_what_the_function_gives)
{
  const Mesh mesh = surface_mesh(dumbbell());
  Parameters coarse;
  coarse.maximum_number_of_segments = 2;
  coarse.refinement = WCS::Refinement_rule::NONE;
  const Result once = CGAL::weakly_convex_segmentation(mesh, nowhere());
  WCS::Segmenter<> segmenter(mesh);
  BOOST_CHECK(segmenter.segment(Parameters()).labels == once.labels);
  const Result in_two = segmenter.segment(coarse);
  check_result(in_two, dumbbell().faces.size());
  BOOST_CHECK_LE(in_two.number_of_segments(), 2u);
  BOOST_CHECK(in_two.labels == CGAL::weakly_convex_segmentation(mesh, nowhere(), coarse).labels);
  // what was seen in between changes nothing
  BOOST_CHECK(segmenter.segment(Parameters()).labels == once.labels);
  BOOST_CHECK_LE(segmenter.number_of_patches(), once.merge_tree.number_of_patches());
}

BOOST_AUTO_TEST_CASE(another_granularity_without_running_again)
{
  const Mesh mesh = surface_mesh(dumbbell());
  WCS::Segmenter<> segmenter(mesh);
  const Result result = segmenter.segment(Parameters());
  const WCS::Merge_tree& tree = result.merge_tree;
  Parameters unrefined;
  unrefined.refinement = WCS::Refinement_rule::NONE;
  for (const std::size_t wanted : {1u, 2u, 3u, 5u, 12u})
  {
    const Result cut = segmenter.refine(result, tree.labels_for(wanted), unrefined);
    check_result(cut, result.labels.size());
    BOOST_CHECK_EQUAL(cut.number_of_segments(), wanted);
    for (std::size_t i = 0; i < cut.labels.size(); ++i) // whole patches
      BOOST_REQUIRE_EQUAL(cut.patches[i], result.patches[i]);
    BOOST_CHECK_EQUAL(
        segmenter.refine(result, tree.labels_for(wanted), Parameters()).number_of_segments(),
        wanted);
  }
  const Result patches = segmenter.refine(result, tree.labels_after(0), unrefined);
  BOOST_CHECK_EQUAL(rand_distance(patches.labels, result.patches), 0.);
  const Result same =
      segmenter.refine(result, tree.labels_after(tree.number_of_accepted_merges()), {});
  BOOST_CHECK(same.labels == result.labels);

  // gaps between the labels do not matter, but there must be one a patch
  std::vector<int> labels = tree.labels_for(2);
  for (int& l : labels) l = l == 0 ? 11 : 7;
  BOOST_CHECK(segmenter.refine(result, labels, unrefined).labels ==
              segmenter.refine(result, tree.labels_for(2), unrefined).labels);
  labels.pop_back();
  BOOST_CHECK_THROW(segmenter.refine(result, labels, {}), std::invalid_argument);
  for (const int bad : {-1, static_cast<int>(tree.number_of_patches())})
  {
    labels.assign(tree.number_of_patches(), bad);
    BOOST_CHECK_THROW(segmenter.refine(result, labels, {}), std::invalid_argument);
  }
  Result of_another_shape = result;
  of_another_shape.patches.pop_back();
  BOOST_CHECK_THROW(segmenter.refine(of_another_shape, tree.labels_for(2), {}),
                    std::invalid_argument);
  Parameters wide;
  wide.band_width = 2.;
  BOOST_CHECK_THROW(segmenter.refine(result, tree.labels_for(2), wide), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(labels_for_a_number_of_segments)
{
  const Result result = CGAL::weakly_convex_segmentation(surface_mesh(dumbbell()), nowhere());
  const auto number = [](const std::vector<int>& labels)
  { return std::set<int>(labels.begin(), labels.end()).size(); };
  const auto pairs = [](const std::vector<int>& fine, const std::vector<int>& coarse)
  {
    std::set<std::pair<int, int>> both;
    for (std::size_t i = 0; i < fine.size(); ++i) both.insert({fine[i], coarse[i]});
    return both.size();
  };
  BOOST_REQUIRE_GT(result.number_of_segments(), 2u);
  BOOST_CHECK(result.labels_for(result.number_of_segments()) == result.labels);
  for (std::size_t wanted = 1; wanted < 20; ++wanted)
  {
    const std::vector<int> labels = result.labels_for(wanted);
    BOOST_REQUIRE_EQUAL(labels.size(), result.labels.size());
    BOOST_CHECK_EQUAL(number(labels), wanted);
    BOOST_CHECK_EQUAL(*std::max_element(labels.begin(), labels.end()) + 1u, wanted);
    // of whole segments, or of whole patches
    const bool is_coarse = wanted <= result.number_of_segments();
    BOOST_CHECK_EQUAL(pairs(is_coarse ? result.labels : result.patches, labels),
                      is_coarse ? result.number_of_segments() : number(result.patches));
  }
  Mesh mesh = surface_mesh(dumbbell());
  const auto map = mesh.add_property_map<Mesh::Face_index, int>("f:two", -1).first;
  WCS::write_labels(mesh, result.labels_for(2), map);
  const std::vector<int> two = result.labels_for(2);
  std::size_t f = 0;
  for (const auto face : mesh.faces()) BOOST_REQUIRE_EQUAL(map[face], two[f++]);
  BOOST_CHECK_THROW(WCS::write_labels(mesh, {0, 1}, map), std::invalid_argument);
  BOOST_CHECK_THROW(result.labels_for(0), std::invalid_argument);
  BOOST_CHECK_THROW(result.labels_for(result.merge_tree.number_of_patches() + 1),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(labels_at_the_three_levels)
{
  const Result result = CGAL::weakly_convex_segmentation(surface_mesh(dumbbell()), nowhere());
  const std::vector<int> patches = result.labels_at(WCS::Level::PATCHES);
  const std::vector<int> components = result.labels_at(WCS::Level::COMPONENTS);
  BOOST_CHECK(result.labels_at(WCS::Level::SEGMENTS) == result.labels);
  BOOST_CHECK_EQUAL(rand_distance(patches, result.patches), 0.);
  const std::set<int> distinct(components.begin(), components.end());
  BOOST_CHECK_EQUAL(distinct.size(), result.number_of_components);
  BOOST_CHECK_EQUAL(*distinct.rbegin() + 1u, result.number_of_components);
  std::set<std::pair<int, int>> pairs; // components are made of whole patches
  for (std::size_t i = 0; i < patches.size(); ++i) pairs.insert({patches[i], components[i]});
  BOOST_CHECK_EQUAL(pairs.size(), result.merge_tree.number_of_patches());
}

BOOST_AUTO_TEST_CASE(convexity_rank_of_subsets)
{
  const Mesh mesh = surface_mesh(dumbbell());
  const WCS::Segmenter<> segmenter(mesh);
  Indices all(mesh.number_of_faces()), ball;
  std::iota(all.begin(), all.end(), std::size_t(0));
  for (const std::size_t f : all)
    if (dumbbell().labels[f] == 1) ball.push_back(f);
  BOOST_CHECK_LT(segmenter.convexity_rank(all), 0.7);
  BOOST_CHECK_GT(segmenter.convexity_rank(ball), 0.9);
  BOOST_CHECK_EQUAL(segmenter.convexity_rank({}), 1.);
  BOOST_CHECK_EQUAL(segmenter.convexity_rank({17}), 1.);
  BOOST_CHECK_THROW(segmenter.convexity_rank({all.size()}), std::invalid_argument);
  BOOST_CHECK_THROW(segmenter.convexity_rank(all, 0), std::invalid_argument);
  BOOST_CHECK_THROW(segmenter.convexity_rank(all, 100, 91.), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
