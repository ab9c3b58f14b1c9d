// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "baselines/lines_of_sight_decomposition.h"
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_lines_of_sight_decomposition)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Shape_generator::Labeled_cloud;
using Shapes_for_tests::rand_distance;
using WCS::Lines_of_sight_parameters;
using WCS::Lines_of_sight_result;

/// writes labels to a vector by the index of the element, through the elements of `values`
struct Counting_map
{
  using key_type = Oriented;
  using value_type = int;
  using reference = int;
  using category = boost::writable_property_map_tag;
  std::vector<int>* written;
  friend void put(const Counting_map& map, const Oriented&, const int label)
  {
    map.written->push_back(label);
  }
};

Lines_of_sight_result decompose(const std::vector<Oriented>& points,
                                const Lines_of_sight_parameters& parameters,
                                std::vector<int>& written)
{
  return WCS::lines_of_sight_decomposition(
      points, Counting_map{&written}, parameters,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
}

std::vector<Oriented> oriented(const Labeled_cloud& cloud)
{
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    points.emplace_back(
        Kernel::Point_3(cloud.points[i][0], cloud.points[i][1], cloud.points[i][2]),
        Kernel::Vector_3(cloud.normals[i][0], cloud.normals[i][1], cloud.normals[i][2]));
  return points;
}

Lines_of_sight_result decompose(const std::string& shape, const std::size_t segments)
{
  Lines_of_sight_parameters parameters;
  parameters.number_of_segments = segments;
  parameters.number_of_samples = 300;
  std::vector<int> written;
  const auto points = oriented(Shape_generator::make_cloud(shape, 5000));
  const Lines_of_sight_result result = decompose(points, parameters, written);
  BOOST_TEST(written == result.labels);
  BOOST_TEST(result.labels.size() == points.size());
  std::vector<std::size_t> sizes(result.number_of_segments(), 0);
  for (const int l : result.labels) ++sizes.at(static_cast<std::size_t>(l));
  for (std::size_t s = 0; s < sizes.size(); ++s)
  {
    BOOST_TEST(sizes[s] > 0u);
    BOOST_TEST(sizes[s] == result.segments[s].size);
    BOOST_TEST(result.segments[s].convexity_rank > 0.);
    BOOST_TEST(result.segments[s].convexity_rank <= 1.);
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(convex_shapes_are_one_part)
{
  BOOST_TEST(decompose("sphere", 0).number_of_segments() == 1u);
  BOOST_TEST(decompose("box", 0).number_of_segments() == 1u);
}

BOOST_AUTO_TEST_CASE(two_spheres_with_a_neck_are_two_parts)
{
  const Lines_of_sight_result result = decompose("two_spheres", 0);
  BOOST_TEST(result.number_of_segments() == 2u);
  const auto truth = Shape_generator::make_cloud("two_spheres", 5000).labels;
  BOOST_TEST(rand_distance(result.labels, truth) < 0.05);
  // a part of the two sees more of itself than the whole does of itself
  BOOST_TEST(result.segments[0].convexity_rank > 0.9);
  BOOST_TEST(result.eigenvalues.at(0) < 1e-6);
  BOOST_TEST(result.eigenvalues.at(1) < 0.5);
  BOOST_TEST(std::is_sorted(result.eigenvalues.begin(), result.eigenvalues.end()));
}

BOOST_AUTO_TEST_CASE(balls_of_a_dumbbell_are_told_apart)
{
  const Lines_of_sight_result result = decompose("dumbbell", 0);
  const Labeled_cloud cloud = Shape_generator::make_cloud("dumbbell", 5000);
  std::array<std::set<int>, 3> labels_of_part;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (std::abs(cloud.points[i][0]) > 0.2) // not where the bar and the balls meet
      labels_of_part.at(static_cast<std::size_t>(cloud.labels[i])).insert(result.labels[i]);
  BOOST_TEST(labels_of_part[1].size() == 1u); // left ball
  BOOST_TEST(labels_of_part[2].size() == 1u); // right ball
  BOOST_TEST(*labels_of_part[1].begin() != *labels_of_part[2].begin());
}

BOOST_AUTO_TEST_CASE(given_number_of_parts_is_kept)
{
  for (const std::size_t count : {1u, 2u, 3u, 7u})
    BOOST_TEST(decompose("dumbbell", count).number_of_segments() == count);
  BOOST_TEST(decompose("sphere", 5).number_of_segments() == 5u);
}

BOOST_AUTO_TEST_CASE(separate_shapes_are_separate_parts)
{
  WCS::internal::Raw_shape raw;
  for (const double x : {0., 3., 6.}) Shapes_for_tests::add_sphere(raw, {x, 0., 0.}, 1., 700);
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < raw.positions.size(); ++i)
  {
    const auto &p = raw.positions[i], &v = raw.normals[i];
    points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(v[0], v[1], v[2]));
  }
  std::vector<int> written, truth(points.size());
  for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = static_cast<int>(i / 700);
  const Lines_of_sight_result result = decompose(points, {}, written);
  BOOST_TEST(result.labels == truth);
  BOOST_TEST(result.eigenvalues.at(2) < 0.05); // few lines graze both of two
  BOOST_TEST(result.eigenvalues.at(3) > 0.5);
}

BOOST_AUTO_TEST_CASE(meshes_and_threads_and_seeds)
{
  const auto shape = Shape_generator::make_mesh("two_spheres", 4000);
  Mesh mesh;
  for (const auto& p : shape.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& f : shape.faces)
    mesh.add_face(Mesh::Vertex_index(static_cast<Mesh::size_type>(f[0])),
                  Mesh::Vertex_index(static_cast<Mesh::size_type>(f[1])),
                  Mesh::Vertex_index(static_cast<Mesh::size_type>(f[2])));
  auto labels = mesh.add_property_map<Mesh::Face_index, int>("f:label", -1).first;
  const auto result = WCS::lines_of_sight_decomposition(mesh, labels);
  BOOST_TEST(result.number_of_segments() == 2u);
  BOOST_TEST(rand_distance(result.labels, shape.labels) < 0.05);
  for (const auto f : mesh.faces()) BOOST_TEST(labels[f] == result.labels[f.idx()]);
  const auto parallel =
      WCS::lines_of_sight_decomposition<CGAL::Parallel_if_available_tag>(mesh, labels);
  BOOST_TEST(parallel.labels == result.labels);
  const auto other_seed =
      WCS::lines_of_sight_decomposition(mesh, labels, {}, CGAL::parameters::random_seed(7u));
  BOOST_TEST(rand_distance(other_seed.labels, shape.labels) < 0.05);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused)
{
  std::vector<int> written;
  BOOST_CHECK_THROW(decompose({}, {}, written), std::invalid_argument);
  auto points = oriented(Shape_generator::make_cloud("sphere", 200));
  const auto refused = [&](const auto& change)
  {
    Lines_of_sight_parameters parameters;
    change(parameters);
    BOOST_CHECK_THROW(decompose(points, parameters, written), std::invalid_argument);
  };
  refused([](auto& p) { p.number_of_samples = 1; });
  refused([](auto& p) { p.number_of_samples = 100000; });
  refused([](auto& p) { p.number_of_segments = p.number_of_samples + 1; });
  refused([](auto& p) { p.maximum_number_of_segments = 0; });
  refused([](auto& p) { p.outside_tolerance = -1.; });
  refused([](auto& p) { p.shape.number_of_neighbors = 0; });
  points[50].first = Kernel::Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  BOOST_CHECK_THROW(decompose(points, {}, written), std::invalid_argument);
  BOOST_TEST(written.empty());
}

BOOST_AUTO_TEST_CASE(few_points_and_cancellation)
{
  const std::vector<Oriented> points(3,
                                     {Kernel::Point_3(1., 2., 3.), Kernel::Vector_3(0., 0., 1.)});
  Lines_of_sight_parameters parameters;
  parameters.number_of_segments = 2;
  std::vector<int> written;
  BOOST_TEST(decompose(points, parameters, written).number_of_segments() == 1u); // all the same
  const auto cloud = oriented(Shape_generator::make_cloud("sphere", 500));
  written.clear();
  BOOST_CHECK_THROW(WCS::lines_of_sight_decomposition(
                        cloud, Counting_map{&written}, {},
                        CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                            .callback([](const double done) { return done < 0.4; })),
                    WCS::Canceled);
  BOOST_TEST(written.empty());
}

BOOST_AUTO_TEST_SUITE_END()
