// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of Chen et al. 2009 on segmentations worked out by hand and against their
// definitions, spelled out face by face. test_princeton_benchmark.cpp checks printed values.

#include <boost/test/unit_test.hpp>

#include "metrics/segmentation_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_segmentation_metrics)

namespace {

using namespace Segmentation_metrics;

constexpr double tolerance = 1e-12;

bool is_near(double a, double b, double epsilon = tolerance) { return std::abs(a - b) <= epsilon; }

// Two rectangles side by side, 3 x 1 and 1 x 1, each of two triangles:
//   3-----------4--5
//   |  1   /    |3/|   areas: 1.5, 1.5, 0.5, 0.5
//   | /      0  |/2|
//   0-----------1--2
Mesh make_strip()
{
  return {{{0, 0, 0}, {3, 0, 0}, {4, 0, 0}, {0, 1, 0}, {3, 1, 0}, {4, 1, 0}},
          {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
}

// The surface of the unit cube; faces 2 k and 2 k + 1 are side k: x = 0, 1, y = 0, 1, z = 0, 1.
// Vertex v has the bits of v as coordinates.
Mesh make_cube()
{
  Mesh mesh;
  for (int v = 0; v < 8; ++v)
    mesh.points.push_back({double(v & 1), double((v >> 1) & 1), double((v >> 2) & 1)});
  mesh.faces = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

// A bumpy n x n height field, so that no two triangles are alike.
Mesh make_terrain(std::size_t n)
{
  Mesh mesh;
  for (std::size_t y = 0; y <= n; ++y)
    for (std::size_t x = 0; x <= n; ++x)
      mesh.points.push_back({double(x), double(y), std::sin(1.3 * double(x * x + 2 * y))});
  for (std::size_t y = 0; y < n; ++y)
    for (std::size_t x = 0; x < n; ++x)
    {
      const std::size_t v = y * (n + 1) + x;
      mesh.faces.push_back({v, v + 1, v + n + 2});
      mesh.faces.push_back({v, v + n + 2, v + n + 1});
    }
  return mesh;
}

Segmentation make_random_segmentation(std::size_t n, int number_of_labels, std::mt19937& random)
{
  Segmentation segmentation(n);
  for (int& label : segmentation)
    label = static_cast<int>(random() % static_cast<unsigned>(number_of_labels)) * 7 - 5;
  return segmentation;
}

Scores score_labels(const Mesh& mesh, const Segmentation& candidate, const Segmentation& reference)
{
  const Mesh_geometry geometry = compute_mesh_geometry(mesh);
  return score(geometry, prepare(geometry, candidate), prepare(geometry, reference));
}

void check_zero(const Scores& scores)
{
  BOOST_TEST(scores.rand_error == 0.);
  BOOST_TEST(scores.hamming == 0.);
  BOOST_TEST(scores.gce == 0.);
  BOOST_TEST(scores.lce == 0.);
  BOOST_TEST(scores.gce_area == 0.);
  BOOST_TEST(scores.lce_area == 0.);
}

// The Rand index by its definition: every pair of faces.
double rand_error_by_pairs(const Segmentation& a, const Segmentation& b)
{
  double disagreements = 0., pairs = 0.;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t g = 0; g < f; ++g)
    {
      pairs += 1.;
      disagreements += (a[f] == a[g]) != (b[f] == b[g]) ? 1. : 0.;
    }
  return disagreements / pairs;
}

// The share of the segment of `face` in `a` that is outside its segment in `b`.
double refinement_error(const Segmentation& a, const Segmentation& b, std::size_t face,
                        const std::vector<double>& weights)
{
  double segment = 0., difference = 0.;
  for (std::size_t f = 0; f < a.size(); ++f)
    if (a[f] == a[face])
    {
      segment += weights[f];
      difference += b[f] == b[face] ? 0. : weights[f];
    }
  return difference / segment;
}

// Global and local consistency error by their definition.
std::array<double, 2> consistency_by_faces(const Segmentation& a, const Segmentation& b,
                                           const std::vector<double>& weights)
{
  double sum_a = 0., sum_b = 0., sum_lesser = 0.;
  for (std::size_t f = 0; f < a.size(); ++f)
  {
    const double error_a = refinement_error(a, b, f, weights);
    const double error_b = refinement_error(b, a, f, weights);
    sum_a += error_a;
    sum_b += error_b;
    sum_lesser += std::min(error_a, error_b);
  }
  return {std::min(sum_a, sum_b) / double(a.size()), sum_lesser / double(a.size())};
}

} // namespace

BOOST_AUTO_TEST_SUITE(by_hand)

BOOST_AUTO_TEST_CASE(geometry_of_the_strip)
{
  const Mesh_geometry geometry = compute_mesh_geometry(make_strip());
  const std::vector<double> areas{1.5, 1.5, 0.5, 0.5};
  BOOST_TEST(geometry.face_areas == areas, boost::test_tools::per_element());
  BOOST_TEST(geometry.adjacencies.size() == 3u);
  BOOST_TEST(geometry.neighbors.size() == 2u * 9u);
  // The centroid is (2, 1/2), those of the faces (2, 1/3), (1, 2/3), (11/3, 1/3), (10/3, 2/3).
  const double radius = (3. + 3. * std::sqrt(37.) + std::sqrt(101.) + std::sqrt(65.)) / 48.;
  BOOST_TEST(is_near(geometry.mean_radius, radius));
}

BOOST_AUTO_TEST_CASE(scores_on_the_strip)
{
  // Face 0 against the rest, and face 3 against the rest: overlaps {0}, {1, 2} and {3}, of areas
  // 1.5, 2 and 0.5.
  const Mesh_geometry geometry = compute_mesh_geometry(make_strip());
  const Prepared_segmentation candidate = prepare(geometry, {0, 1, 1, 1});
  const Prepared_segmentation reference = prepare(geometry, {0, 0, 0, 1});
  const Scores scores = score(geometry, candidate, reference);
  BOOST_TEST(is_near(scores.rand_error, 4. / 6.)); // agreed are the pairs 1 2 and 0 3 only
  BOOST_TEST(is_near(scores.missing_rate, 1.5 / 4.));
  BOOST_TEST(is_near(scores.false_alarm_rate, 0.5 / 4.));
  BOOST_TEST(is_near(scores.hamming, 1. / 4.));
  // Errors of the candidate's side: 0, 1/3, 1/3, 2/3, by area 0, 1/5, 1/5, 4/5; of the other
  // side: 2/3, 1/3, 1/3, 0, by area 4/7, 3/7, 3/7, 0.
  BOOST_TEST(is_near(scores.gce, 1. / 3.));
  BOOST_TEST(is_near(scores.lce, 1. / 6.));
  BOOST_TEST(is_near(scores.gce_area, 0.3));
  BOOST_TEST(is_near(scores.lce_area, 0.1));
  // Cut vertices 0, 1, 4 and 1, 4, 5: vertex 0 is 3 away from the other cut, vertex 5 is 1 away.
  BOOST_TEST(is_near(scores.cut_discrepancy.value(), 4. / 6. / geometry.mean_radius));
  BOOST_TEST(scores.number_of_segments == 2.);
}

BOOST_AUTO_TEST_CASE(pair_count_of_the_evaluator)
{
  // 4 faces have 6 pairs, the evaluator counts 4 * (3 / 2) = 4.
  const Mesh_geometry geometry = compute_mesh_geometry(make_strip());
  const Contingency_table table = make_contingency_table(geometry, prepare(geometry, {0, 0, 1, 1}),
                                                         prepare(geometry, {0, 1, 1, 1}));
  BOOST_TEST(is_near(rand_error(table), 3. / 6.));
  BOOST_TEST(is_near(rand_error(table, Pair_count::as_evaluator), 3. / 4.));
}

BOOST_AUTO_TEST_CASE(evaluator_pair_count_is_exact_for_odd_numbers)
{
  Mesh mesh = make_strip();
  mesh.faces.pop_back();
  const Mesh_geometry geometry = compute_mesh_geometry(mesh);
  const Contingency_table table =
      make_contingency_table(geometry, prepare(geometry, {0, 1, 1}), prepare(geometry, {0, 0, 1}));
  BOOST_TEST(is_near(rand_error(table), 2. / 3.));
  BOOST_TEST(rand_error(table) == rand_error(table, Pair_count::as_evaluator));
}

BOOST_AUTO_TEST_CASE(cube_sides_against_one_segment)
{
  const Segmentation sides{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  const Scores scores = score_labels(make_cube(), Segmentation(12, 9), sides);
  BOOST_TEST(is_near(scores.rand_error, 60. / 66.));
  BOOST_TEST(scores.missing_rate == 0.);
  BOOST_TEST(is_near(scores.false_alarm_rate, 5. / 6.));
  BOOST_TEST(scores.gce == 0.);
  BOOST_TEST(scores.lce_area == 0.);
  BOOST_TEST(!scores.cut_discrepancy.has_value());
}

BOOST_AUTO_TEST_CASE(cube_sides_against_lids_and_ring)
{
  const Segmentation sides{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  const Segmentation ring{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2};
  const Scores scores = score_labels(make_cube(), sides, ring);
  BOOST_TEST(is_near(scores.rand_error, 24. / 66.)); // 6 and 30 pairs together, 6 in both
  BOOST_TEST(is_near(scores.missing_rate, 3. / 6.));
  BOOST_TEST(scores.false_alarm_rate == 0.);
  BOOST_TEST(scores.gce == 0.);
  BOOST_TEST(scores.gce_area == 0.);
  BOOST_TEST(scores.cut_discrepancy.value() == 0.); // all 8 vertices are on both cuts
}

BOOST_AUTO_TEST_CASE(cut_field_of_a_lid)
{
  // Only side z = 1 is cut off: its 4 vertices are at 0, those of side z = 0 one edge away.
  const Mesh_geometry geometry = compute_mesh_geometry(make_cube());
  const Cut_field field = prepare(geometry, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1}).cuts;
  const std::vector<std::size_t> vertices{4, 5, 6, 7};
  const std::vector<double> distances{1., 1., 1., 1., 0., 0., 0., 0.};
  BOOST_TEST(field.cut_vertices == vertices, boost::test_tools::per_element());
  BOOST_TEST(field.distances == distances, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(cuts_that_cannot_reach_each_other)
{
  // Two strips without a common vertex, each cut on one side only.
  Mesh mesh = make_strip();
  const Mesh strip = mesh;
  for (const Point& p : strip.points) mesh.points.push_back({p[0], p[1], 5.});
  for (const auto& [a, b, c] : strip.faces) mesh.faces.push_back({a + 6, b + 6, c + 6});
  const Segmentation first{0, 0, 1, 1, 0, 0, 0, 0};
  const Segmentation second{0, 0, 0, 0, 0, 0, 1, 1};
  BOOST_TEST(!score_labels(mesh, first, second).cut_discrepancy.has_value());
  BOOST_TEST(score_labels(mesh, first, first).cut_discrepancy.value() == 0.);
}

BOOST_AUTO_TEST_CASE(edge_of_three_faces)
{
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                  {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const Mesh_geometry geometry = compute_mesh_geometry(mesh);
  const std::vector<std::size_t> edge{0, 1};
  for (const Segmentation& labels : {Segmentation{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
    BOOST_TEST(prepare(geometry, labels).cuts.cut_vertices == edge,
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(invariants)

BOOST_AUTO_TEST_CASE(definitions_face_by_face)
{
  std::mt19937 random(1);
  const Mesh mesh = make_terrain(6);
  const Mesh_geometry geometry = compute_mesh_geometry(mesh);
  const std::vector<double> ones(mesh.faces.size(), 1.);
  for (const int number_of_labels : {1, 2, 5, 60})
  {
    const Segmentation a = make_random_segmentation(mesh.faces.size(), number_of_labels, random);
    const Segmentation b = make_random_segmentation(mesh.faces.size(), 4, random);
    const Scores scores = score_labels(mesh, a, b);
    const auto by_count = consistency_by_faces(a, b, ones);
    const auto by_area = consistency_by_faces(a, b, geometry.face_areas);
    BOOST_TEST(is_near(scores.rand_error, rand_error_by_pairs(a, b)));
    BOOST_TEST(is_near(scores.gce, by_count[0]));
    BOOST_TEST(is_near(scores.lce, by_count[1]));
    BOOST_TEST(is_near(scores.gce_area, by_area[0]));
    BOOST_TEST(is_near(scores.lce_area, by_area[1]));
  }
}

BOOST_AUTO_TEST_CASE(exchanging_the_sides)
{
  std::mt19937 random(2);
  const Mesh mesh = make_terrain(8);
  const Segmentation a = make_random_segmentation(mesh.faces.size(), 3, random);
  const Segmentation b = make_random_segmentation(mesh.faces.size(), 9, random);
  const Scores forth = score_labels(mesh, a, b);
  const Scores back = score_labels(mesh, b, a);
  BOOST_TEST(forth.rand_error == back.rand_error);
  BOOST_TEST(is_near(forth.missing_rate, back.false_alarm_rate));
  BOOST_TEST(is_near(forth.false_alarm_rate, back.missing_rate));
  BOOST_TEST(is_near(forth.gce, back.gce));
  BOOST_TEST(is_near(forth.lce_area, back.lce_area));
  BOOST_TEST(is_near(*forth.cut_discrepancy, *back.cut_discrepancy));
}

BOOST_AUTO_TEST_CASE(other_names_of_the_same_segments)
{
  std::mt19937 random(3);
  const Mesh mesh = make_terrain(8);
  const Segmentation labels = make_random_segmentation(mesh.faces.size(), 6, random);
  Segmentation renamed = labels;
  for (int& label : renamed) label = 1000 - 3 * label;
  const Scores scores = score_labels(mesh, labels, renamed);
  check_zero(scores);
  BOOST_TEST(scores.cut_discrepancy.value() == 0.);
}

BOOST_AUTO_TEST_CASE(scale_does_not_matter)
{
  std::mt19937 random(4);
  const Mesh mesh = make_terrain(8);
  Mesh large = mesh;
  for (Point& point : large.points)
    for (double& coordinate : point) coordinate = 1000. * coordinate + 50.;
  Segmentation a(mesh.faces.size(), 0);
  std::fill_n(a.begin(), 40, 1);
  const Segmentation b = make_random_segmentation(mesh.faces.size(), 2, random);
  const Scores small_scores = score_labels(mesh, a, b);
  const Scores large_scores = score_labels(large, a, b);
  BOOST_TEST(is_near(small_scores.hamming, large_scores.hamming, 1e-9));
  BOOST_TEST(is_near(small_scores.gce_area, large_scores.gce_area, 1e-9));
  BOOST_TEST(is_near(*small_scores.cut_discrepancy, *large_scores.cut_discrepancy, 1e-9));
}

BOOST_AUTO_TEST_CASE(a_segment_a_face_refines_everything)
{
  const Mesh mesh = make_terrain(5);
  Segmentation singles(mesh.faces.size());
  for (std::size_t f = 0; f < singles.size(); ++f) singles[f] = static_cast<int>(f);
  std::mt19937 random(5);
  const Segmentation other = make_random_segmentation(mesh.faces.size(), 4, random);
  const Scores scores = score_labels(mesh, singles, other);
  BOOST_TEST(scores.gce == 0.);
  BOOST_TEST(scores.lce_area == 0.);
  BOOST_TEST(scores.false_alarm_rate == 0.);
  BOOST_TEST(scores.number_of_segments == double(mesh.faces.size()));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bad_input)

BOOST_AUTO_TEST_CASE(meshes_and_segmentations)
{
  Mesh mesh = make_strip();
  const Mesh_geometry geometry = compute_mesh_geometry(mesh);
  BOOST_CHECK_THROW(prepare(geometry, {0, 1}), std::invalid_argument);
  BOOST_CHECK_THROW(compute_cut_field(geometry, Segmentation{0, 1}), std::invalid_argument);
  BOOST_CHECK_THROW(make_contingency_table(geometry, {}, {}), std::invalid_argument);
  BOOST_CHECK_THROW(compute_mesh_geometry({}), std::invalid_argument);
  mesh.faces[0][1] = 6;
  BOOST_CHECK_THROW(compute_mesh_geometry(mesh), std::invalid_argument);
  mesh.faces = {{0, 0, 1}};
  BOOST_CHECK_THROW(compute_mesh_geometry(mesh), std::invalid_argument); // no area
}

BOOST_AUTO_TEST_CASE(few_faces)
{
  Mesh mesh = make_strip();
  mesh.faces.resize(1);
  check_zero(score_labels(mesh, {0}, {1}));
  const Mesh_geometry geometry = compute_mesh_geometry(mesh);
  const Prepared_segmentation labels = prepare(geometry, {3});
  BOOST_CHECK_THROW(score(geometry, labels, labels, Pair_count::as_evaluator),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(degenerate_face)
{
  // A face without area, alone in its segment, must not make the errors undefined.
  Mesh mesh = make_strip();
  mesh.faces.push_back({1, 1, 4});
  const Scores scores = score_labels(mesh, {0, 0, 1, 1, 2}, {0, 0, 1, 1, 1});
  BOOST_TEST(std::isfinite(scores.gce_area));
  BOOST_TEST(scores.hamming == 0.);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
