// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/Disk_line_of_sight.h>
#include <CGAL/Weakly_convex_segmentation/Merge_cost.h>
#include <CGAL/Weakly_convex_segmentation/Mesh_line_of_sight.h>
#include <CGAL/Weakly_convex_segmentation/Patch_clustering.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "shapes_for_tests.h"

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// What a caller can put in the place of our line of sight, patch clustering, merge cost and diameters.

BOOST_AUTO_TEST_SUITE(test_oracles)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace NP = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Point_with_normal = std::pair<Point, Vector>;

const double infinity = std::numeric_limits<double>::infinity();

void add_box(Mesh& mesh, const Point& low, const Point& high)
{
  Mesh box;
  const auto p = [&](const int x, const int y, const int z)
  { return Point(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z()); };
  CGAL::make_hexahedron(p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(0, 0, 1),
                        p(1, 0, 1), p(1, 1, 1), box);
  CGAL::Polygon_mesh_processing::triangulate_faces(box);
  mesh += box;
}

Mesh surface_mesh(const Shape_generator::Labeled_mesh& shape)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const auto& [x, y, z] : shape.points) v.push_back(mesh.add_vertex({x, y, z}));
  for (const auto& f : shape.faces) mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
  return mesh;
}

std::vector<Point_with_normal> sphere(const std::size_t count)
{
  WCS::internal::Raw_shape raw;
  Shapes_for_tests::add_sphere(raw, {5., 0., 0.}, 2., count);
  std::vector<Point_with_normal> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& [x, y, z] = raw.positions[i];
    const auto& [nx, ny, nz] = raw.normals[i];
    points.push_back({Point(x, y, z), Vector(nx, ny, nz)});
  }
  return points;
}

auto maps_of_pairs()
{
  return NP::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
      .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>());
}

/// a mesh, its truth and the labels that named parameters lead to
struct Dumbbell
{
  Shape_generator::Labeled_mesh shape = Shape_generator::make_mesh("dumbbell", 3000);
  Mesh mesh = surface_mesh(shape);

  template <typename NamedParameters>
  std::vector<int> labels(const NamedParameters& np) const
  {
    Mesh copy = mesh;
    const auto map = copy.add_property_map<Mesh::Face_index, int>("f:label").first;
    return CGAL::weakly_convex_segmentation(copy, map, np).labels;
  }
  double error(const std::vector<int>& labels) const
  {
    return Shapes_for_tests::rand_distance(labels, shape.labels);
  }
};

/// a cost that is the same for all
struct Constant_cost
{
  double cost;
  double operator()(const WCS::Region_pair&, double) const { return cost; }
  double fusion_threshold() const { return 1.; }
  double merging_threshold() const { return 1.; }
};

/// a line of sight by which nothing is seen
struct Blind
{
  using Point_3 = Point;
  using Vector_3 = Vector;
  bool sees(const Point&, const Point&) const { return false; }
  double distance_to_exit(const Point&, const Vector&) const { return infinity; }
  double distance_to_entry(const Point&, const Vector&) const { return infinity; }
};

struct Unannounced_cost : Constant_cost
{
  double operator()(const WCS::Region_pair& pair, double) const { return pair.cut_probability(); }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_closed_mesh_is_seen_through_and_left_where_it_ends)
{
  Mesh mesh;
  add_box(mesh, {0., 0., 0.}, {1., 2., 3.});
  const WCS::Mesh_line_of_sight<Mesh> sight(mesh);
  BOOST_CHECK(sight.sees({0., 0.7, 0.8}, {1., 1.1, 2.}));
  BOOST_CHECK(sight.sees({0.3, 0., 0.8}, {0.3, 0., 0.8}));
  BOOST_CHECK_CLOSE(sight.distance_to_exit({0., 0.7, 0.8}, {1., 0., 0.}), 1., 1e-6);
  BOOST_CHECK_CLOSE(sight.distance_to_exit({0.3, 0.7, 0.}, {0., 0., 1.}), 3., 1e-6);
  BOOST_CHECK_EQUAL(sight.distance_to_entry({0., 0.7, 0.8}, {-1., 0., 0.}), infinity);
  BOOST_CHECK_EQUAL(sight.distance_to_exit({0., 0.7, 0.8}, {-1., 0., 0.}), infinity);
}

BOOST_AUTO_TEST_CASE(no_line_leads_out_of_a_mesh_or_through_it)
{
  Mesh mesh; // two towers, face to face
  add_box(mesh, {0., 0., 0.}, {1., 1., 1.});
  add_box(mesh, {2., 0., 0.}, {3., 1., 1.});
  const WCS::Mesh_line_of_sight<Mesh> sight(mesh);
  BOOST_CHECK(!sight.sees({1., 0.4, 0.3}, {2., 0.6, 0.7})); // outside
  BOOST_CHECK(!sight.sees({0., 0.4, 0.3}, {3., 0.6, 0.7})); // through both
  BOOST_CHECK(!sight.sees({0., 0.4, 0.3}, {2., 0.6, 0.7}));
  BOOST_CHECK(sight.sees({2., 0.4, 0.3}, {3., 0.6, 0.7}));
  BOOST_CHECK_CLOSE(sight.distance_to_entry({1., 0.4, 0.3}, {1., 0., 0.}), 1., 1e-6);
  BOOST_CHECK_CLOSE(sight.distance_to_exit({1., 0.4, 0.3}, {1., 0., 0.}), 2., 1e-6);
}

BOOST_AUTO_TEST_CASE(disks_of_a_sphere_let_lines_pass_inside_and_end_rays)
{
  const std::vector<Point_with_normal> points = sphere(2000);
  const WCS::Disk_line_of_sight<Kernel> sight(points, maps_of_pairs());
  const Point left(3., 0., 0.), right(7., 0., 0.), top(5., 0., 2.);
  BOOST_CHECK(sight.sees(left, right));
  BOOST_CHECK(sight.sees(left, top));
  BOOST_CHECK(!sight.sees(Point(1., 0., 0.), right)); // from outside
  const double half =
      std::sqrt(0.5); // a ray reaches as far as the extent: less than through the center
  BOOST_CHECK_CLOSE(sight.distance_to_exit(left, {half, half, 0.}), 4. * half, 2.);
  BOOST_CHECK_CLOSE(sight.distance_to_entry(Point(2., 0., 0.), {1., 0., 0.}), 1., 2.);
  BOOST_CHECK_EQUAL(sight.distance_to_exit(right, {1., 0., 0.}), infinity);
}

BOOST_AUTO_TEST_CASE(exact_lines_of_sight_find_the_parts_that_disks_find)
{
  const Dumbbell dumbbell;
  const auto exact =
      dumbbell.labels(NP::line_of_sight(WCS::Mesh_line_of_sight<Mesh>(dumbbell.mesh)));
  const auto disks =
      dumbbell.labels(NP::line_of_sight(WCS::Disk_line_of_sight<Kernel>(dumbbell.mesh)));
  const auto own = dumbbell.labels(NP::random_seed(0));
  BOOST_CHECK_LT(dumbbell.error(own), 0.05);
  BOOST_CHECK_LT(dumbbell.error(exact), 0.05);
  BOOST_CHECK_LT(dumbbell.error(disks), 0.05);
}

BOOST_AUTO_TEST_CASE(nobody_sees_anybody_where_the_line_of_sight_says_so)
{
  const Dumbbell dumbbell;
  const WCS::Segmenter<> segmenter(dumbbell.mesh, NP::line_of_sight(Blind()));
  std::vector<std::size_t> all(dumbbell.shape.faces.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  BOOST_CHECK_CLOSE(segmenter.convexity_rank(all, 50), 1. / 50., 1e-6); // a point sees itself
}

BOOST_AUTO_TEST_CASE(our_own_clustering_and_costs_by_name_are_those_of_the_presets)
{
  const Dumbbell dumbbell;
  const auto standard = dumbbell.labels(NP::random_seed(3));
  BOOST_CHECK(
      dumbbell.labels(NP::patch_clustering(WCS::Spectral_patch_clustering()).random_seed(3)) ==
      standard);
  BOOST_CHECK(dumbbell.labels(NP::merge_cost(WCS::Weighted_merge_cost()).random_seed(3)) ==
              standard);
  // each set of patches is cut by the learned cost where the preset judges the merges of the default's
  BOOST_CHECK_LT(dumbbell.error(dumbbell.labels(NP::merge_cost(WCS::Learned_merge_cost()))), 0.1);
}

BOOST_AUTO_TEST_CASE(patches_come_from_the_clustering_that_is_given)
{
  const Dumbbell dumbbell;
  const auto voronoi = dumbbell.labels(NP::patch_clustering(WCS::Voronoi_patch_clustering()));
  BOOST_CHECK_LT(dumbbell.error(voronoi), 0.1);
  // all nodes in one cluster, but for the first
  const auto lazy = [](const WCS::Convexity_graph& graph, const std::size_t wanted)
  {
    BOOST_CHECK_GT(graph.number_of_nodes, wanted);
    return [n = graph.number_of_nodes](unsigned int)
    {
      std::vector<std::uint32_t> cluster(n, 1);
      cluster.front() = 0;
      return cluster;
    };
  };
  const WCS::Segmenter<> segmenter(dumbbell.mesh, NP::patch_clustering(lazy));
  BOOST_CHECK_LE(segmenter.number_of_patches(), 2u);
}

BOOST_AUTO_TEST_CASE(a_merge_cost_decides_what_is_merged)
{
  const Dumbbell dumbbell;
  const auto all = dumbbell.labels(NP::merge_cost(Constant_cost{0.5}));
  BOOST_CHECK_EQUAL(std::set<int>(all.begin(), all.end()).size(), 1u);
  WCS::Segmenter<> segmenter(dumbbell.mesh,
                             NP::merge_cost(Constant_cost{2.}).minimum_segment_share(0.));
  WCS::Parameters one_set;
  one_set.minimum_segment_share = 0.;
  BOOST_CHECK_GT(segmenter.segment(one_set).number_of_segments(), 50u);
  BOOST_CHECK_EQUAL(segmenter.segment(NP::merge_cost(Constant_cost{1.})).number_of_segments(), 1u);
}

BOOST_AUTO_TEST_CASE(measures_of_pairs_are_within_their_ranges)
{
  struct Checked_cost : Constant_cost
  {
    double operator()(const WCS::Region_pair& pair, const double limit) const
    {
      const auto is_share = [](const double x) { return x >= 0. && x <= 1.; };
      BOOST_REQUIRE(is_share(pair.size_of_smaller()));
      BOOST_REQUIRE_LE(pair.size_of_smaller(), pair.size_of_larger());
      BOOST_REQUIRE(is_share(pair.visibility()));
      BOOST_REQUIRE(is_share(pair.concave_share()));
      BOOST_REQUIRE(is_share(pair.closure_of_smaller()));
      BOOST_REQUIRE(is_share(pair.closure_of_larger()));
      BOOST_REQUIRE(is_share(pair.continuation()));
      BOOST_REQUIRE_GE(pair.diameter_distance(), 0.);
      BOOST_REQUIRE_GE(pair.diameter_spread_of_smaller(), 0.);
      BOOST_REQUIRE_GE(pair.seam_extent(), 0.);
      BOOST_REQUIRE(is_share(pair.diameter_of_smaller()));
      BOOST_REQUIRE(is_share(pair.diameter_of_larger()));
      return pair.weighted_cost(WCS::Parameters().merging_cost, limit);
    }
  };
  const Dumbbell dumbbell;
  const auto labels = dumbbell.labels(NP::merge_cost(Checked_cost{{0.}}));
  BOOST_CHECK_EQUAL(labels.size(), dumbbell.shape.faces.size());
}

BOOST_AUTO_TEST_CASE(a_cost_has_to_say_that_it_asks_for_what_was_learned)
{
  const Dumbbell dumbbell;
  BOOST_CHECK_THROW(dumbbell.labels(NP::merge_cost(Unannounced_cost())), std::logic_error);
}

BOOST_AUTO_TEST_CASE(diameters_come_from_the_map_that_is_given)
{
  const Dumbbell dumbbell;
  const auto number = [](const double value)
  {
    return boost::make_function_property_map<Mesh::Face_index, double>([=](Mesh::Face_index)
                                                                       { return value; });
  };
  Mesh mesh = dumbbell.mesh;
  const auto map = mesh.add_property_map<Mesh::Face_index, int>("f:label").first;
  for (const double diameter : {0.1, 0.7})
  {
    const auto result =
        CGAL::weakly_convex_segmentation(mesh, map, NP::diameter_map(number(diameter)));
    for (const WCS::Segment& segment : result.segments)
      BOOST_CHECK_CLOSE(segment.diameter, diameter, 4.); // that of a bin of the histogram
  }
  const auto none = CGAL::weakly_convex_segmentation(mesh, map, NP::diameter_map(number(-1.)));
  for (const WCS::Segment& segment : none.segments) BOOST_CHECK_EQUAL(segment.diameter, 0.);
}

BOOST_AUTO_TEST_SUITE_END()
