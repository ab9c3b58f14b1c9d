// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "baselines/lines_of_sight_decomposition.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_lines_of_sight_decomposition)

namespace {

using CGAL::Weakly_convex_segmentation::internal::analyze_shape;
using CGAL::Weakly_convex_segmentation::internal::Raw_shape;
using CGAL::Weakly_convex_segmentation::internal::Shape_analysis;
using Lines_of_sight::decompose;
using Lines_of_sight::Settings;
using Shape_generator::Labeled_cloud;
using Shapes_for_tests::rand_distance;

std::unique_ptr<Shape_analysis> analysis(const Labeled_cloud& cloud)
{
  Raw_shape raw;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    Shapes_for_tests::add_point(raw, cloud.points[i], cloud.normals[i]);
  return analyze_shape(std::move(raw), {}, {});
}

std::size_t number_of_labels(const std::vector<int>& labels)
{
  const std::set<int> distinct(labels.begin(), labels.end());
  BOOST_TEST(*distinct.begin() == 0);
  BOOST_TEST(*distinct.rbegin() + 1 == static_cast<int>(distinct.size()));
  return distinct.size();
}

Settings settings(const std::size_t segments)
{
  Settings result;
  result.number_of_segments = segments;
  result.number_of_samples = 300;
  return result;
}

std::vector<int> decompose(const std::string& shape, const std::size_t segments)
{
  const Labeled_cloud cloud = Shape_generator::make_cloud(shape, 5000);
  const std::vector<int> labels = decompose(*analysis(cloud), settings(segments));
  BOOST_TEST(labels.size() == cloud.points.size());
  return labels;
}

} // namespace

BOOST_AUTO_TEST_CASE(convex_shapes_are_one_part)
{
  BOOST_TEST(number_of_labels(decompose("sphere", 0)) == 1u);
  BOOST_TEST(number_of_labels(decompose("box", 0)) == 1u);
}

BOOST_AUTO_TEST_CASE(two_spheres_with_a_neck_are_two_parts)
{
  const Labeled_cloud cloud = Shape_generator::make_cloud("two_spheres", 5000);
  const auto shape = analysis(cloud);
  const std::vector<int> labels = decompose(*shape, settings(0));
  BOOST_TEST(number_of_labels(labels) == 2u);
  BOOST_TEST(rand_distance(labels, cloud.labels) < 0.05);
  const auto spectrum = Lines_of_sight::laplacian_spectrum(Lines_of_sight::line_of_sight_matrix(
      *shape->sight, Lines_of_sight::farthest_points(shape->points(), 300), 5., false));
  BOOST_TEST(spectrum.values[0] < 1e-6);
  BOOST_TEST(spectrum.values[1] < 0.5);
  BOOST_TEST(std::is_sorted(spectrum.values.begin(), spectrum.values.end()));
}

BOOST_AUTO_TEST_CASE(balls_of_a_dumbbell_are_told_apart)
{
  const std::vector<int> labels = decompose("dumbbell", 0);
  const Labeled_cloud cloud = Shape_generator::make_cloud("dumbbell", 5000);
  std::array<std::set<int>, 3> labels_of_part;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (std::abs(cloud.points[i][0]) > 0.2) // not where the bar and the balls meet
      labels_of_part.at(static_cast<std::size_t>(cloud.labels[i])).insert(labels[i]);
  BOOST_TEST(labels_of_part[1].size() == 1u); // left ball
  BOOST_TEST(labels_of_part[2].size() == 1u); // right ball
  BOOST_TEST(*labels_of_part[1].begin() != *labels_of_part[2].begin());
}

BOOST_AUTO_TEST_CASE(given_number_of_parts_is_kept)
{
  const auto dumbbell = analysis(Shape_generator::make_cloud("dumbbell", 5000));
  for (const std::size_t count : {1u, 2u, 3u, 7u})
    BOOST_TEST(number_of_labels(decompose(*dumbbell, settings(count))) == count);
  BOOST_TEST(number_of_labels(decompose("sphere", 5)) == 5u);
}

BOOST_AUTO_TEST_CASE(separate_shapes_are_separate_parts)
{
  Raw_shape raw;
  for (const double x : {0., 3., 6.}) Shapes_for_tests::add_sphere(raw, {x, 0., 0.}, 1., 700);
  std::vector<int> truth(raw.positions.size());
  for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = static_cast<int>(i / 700);
  const auto shape = analyze_shape(std::move(raw), {}, {});
  BOOST_TEST(decompose(*shape) == truth);
  const auto spectrum = Lines_of_sight::laplacian_spectrum(Lines_of_sight::line_of_sight_matrix(
      *shape->sight, Lines_of_sight::farthest_points(shape->points(), 500), 5., false));
  BOOST_TEST(spectrum.values[2] < 0.05); // few lines graze both of two
  BOOST_TEST(spectrum.values[3] > 0.5);
}

BOOST_AUTO_TEST_CASE(meshes_and_threads_and_seeds)
{
  const auto mesh = Shape_generator::make_mesh("two_spheres", 4000);
  const auto shape = analyze_shape(Shapes_for_tests::faces_of_mesh(mesh), {}, {});
  const std::vector<int> labels = decompose(*shape);
  BOOST_TEST(number_of_labels(labels) == 2u);
  BOOST_TEST(rand_distance(labels, mesh.labels) < 0.05);
  BOOST_TEST(decompose(*shape, {}, 0, true) == labels);
  BOOST_TEST(rand_distance(decompose(*shape, {}, 7), mesh.labels) < 0.05);
}

BOOST_AUTO_TEST_CASE(few_points)
{
  Raw_shape raw;
  for (int i = 0; i < 3; ++i) Shapes_for_tests::add_point(raw, {1., 2., 3.}, {0., 0., 1.});
  const auto shape = analyze_shape(std::move(raw), {}, {});
  BOOST_TEST(number_of_labels(decompose(*shape, settings(2))) == 1u); // all the same
  const auto refused = [&](const auto& change)
  {
    Settings bad;
    change(bad);
    BOOST_CHECK_THROW(decompose(*shape, bad), std::invalid_argument);
  };
  refused([](auto& s) { s.number_of_samples = 1; });
  refused([](auto& s) { s.number_of_segments = s.number_of_samples + 1; });
  refused([](auto& s) { s.maximum_number_of_segments = 0; });
  refused([](auto& s) { s.outside_tolerance = -1.; });
}

BOOST_AUTO_TEST_SUITE_END()
