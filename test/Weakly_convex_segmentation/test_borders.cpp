// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/borders/refine_borders.h>

#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include <boost/graph/adjacency_list.hpp>

#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

// Border refinement (section 5, equations 3-5) by seam cuts and by alpha expansion.

BOOST_AUTO_TEST_SUITE(test_borders)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

struct Surface
{
  Raw_shape raw;
  Oriented_points points;
  Neighbor_graph graph;

  explicit Surface(const Raw_shape& r, const std::size_t neighbors = 10)
    : raw(r), points(orient_points(raw)), graph(build_neighbor_graph(points, neighbors, false))
  {}
  /// labels of the points from a function of the input's position
  template <typename Label>
  std::vector<int> labels(const Label& label) const
  {
    std::vector<int> result;
    for (const Index e : points.elements) result.push_back(label(raw.positions[e]));
    return result;
  }
};

Surface plane(const int n)
{
  Raw_shape raw;
  add_rectangle(raw, {0., 0., 0.}, {1. / n, 0., 0.}, {0., 1. / n, 0.}, n, n, {0., 0., 1.});
  return Surface(raw);
}

/// two walls at a concave edge, unfolded: along the floor x > 0, up the wall -z < 0
double unfolded(const Coordinates& p) { return p[0] > 0. ? p[0] : -p[2]; }

/// a zigzag about the edge
double zigzag(const Coordinates& p)
{
  const double t = 8. * p[1];
  return 0.3 * std::abs(t - std::floor(t) - 0.5) - 0.09;
}

Parameters rule(const Refinement_rule refinement)
{
  Parameters parameters =
      refinement == Refinement_rule::ALPHA_EXPANSION ? Parameters::paper() : Parameters();
  parameters.refinement = refinement;
  parameters.band_width = 0.08;
  return parameters;
}

const std::vector<Refinement_rule> both_rules = {Refinement_rule::SEAM_CUTS,
                                                 Refinement_rule::ALPHA_EXPANSION};

std::size_t number_of_differences(const std::vector<int>& a, const std::vector<int>& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b.at(i) ? 1 : 0;
  return count;
}

/// a grid of vertices with random costs
Labeling_problem random_problem(const std::size_t columns, const std::size_t rows, const int labels,
                                std::mt19937& random)
{
  Labeling_problem problem;
  for (std::size_t v = 0; v < columns * rows; ++v)
  {
    problem.label_costs.emplace_back();
    for (int l = 0; l < labels; ++l) problem.label_costs.back().push_back(uniform(random));
    if (v % columns + 1 < columns) problem.edges.push_back({v, v + 1, 0.6 * uniform(random)});
    if (v + columns < columns * rows)
      problem.edges.push_back({v + columns, v, 0.6 * uniform(random)});
  }
  return problem;
}

/// the same problem solved by CGAL
std::vector<int> labels_of_cgal(const Labeling_problem& problem, const std::vector<int>& labels)
{
  struct Vertex
  {
    std::size_t label;
    std::vector<double> costs;
  };
  struct Edge
  {
    double cost;
  };
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Vertex, Edge>;
  Graph graph(labels.size());
  for (std::size_t v = 0; v < labels.size(); ++v)
    graph[v] = {static_cast<std::size_t>(labels[v]), problem.label_costs[v]};
  for (const Labeling_problem::Edge& e : problem.edges)
    boost::add_edge(e.first, e.second, Edge{e.cost}, graph);
  CGAL::alpha_expansion_graphcut(
      graph, boost::get(&Edge::cost, graph), boost::get(&Vertex::costs, graph),
      boost::get(&Vertex::label, graph),
      CGAL::parameters::vertex_index_map(boost::get(boost::vertex_index, graph))
          .implementation_tag(CGAL::Alpha_expansion_boost_compressed_sparse_row_tag()));
  std::vector<int> result;
  for (std::size_t v = 0; v < labels.size(); ++v)
    result.push_back(static_cast<int>(graph[v].label));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_band_holds_what_is_near_a_border)
{
  const Surface surface = plane(40);
  const auto labels = surface.labels([](const Coordinates& p) { return p[0] < 0.5 ? 3 : 8; });
  const float width = 0.1f;
  const auto band = find_band(surface.graph, labels, width, false);
  for (Index i = 0; i < surface.graph.size(); ++i)
  {
    const double x = surface.raw.positions[surface.points.elements[i]][0];
    const double from_border = std::abs(x - 0.4875) / surface.points.extent; // between two columns
    if (band[i].other >= 0)
    {
      BOOST_REQUIRE_EQUAL(band[i].other, labels[i] == 3 ? 8 : 3);
      BOOST_REQUIRE_LE(band[i].distance, width);
      // along the graph it is no shorter than straight, and little longer; the border is half an edge on
      BOOST_REQUIRE_LT(from_border, width + 0.02);
    }
    else
      BOOST_REQUIRE_GT(from_border, width - 0.02);
  }
  const auto one = surface.labels([](const Coordinates&) { return 0; });
  for (const Band_point& b : find_band(surface.graph, one, width, false))
    BOOST_REQUIRE_EQUAL(b.other, -1);
}

BOOST_AUTO_TEST_CASE(a_jagged_border_moves_to_the_concave_edge)
{
  const Surface surface(concave_corner(50, 0.02));
  const auto wanted = surface.labels([](const Coordinates& p) { return unfolded(p) > 0. ? 1 : 0; });
  const auto jagged =
      surface.labels([](const Coordinates& p) { return unfolded(p) > zigzag(p) ? 1 : 0; });
  const std::size_t before = number_of_differences(jagged, wanted);
  BOOST_REQUIRE_GT(before, 60u);
  for (const Refinement_rule refinement : both_rules)
  {
    std::vector<int> labels = jagged;
    const Parameters parameters = rule(refinement);
    const std::size_t moved = refine_borders(surface.graph, parameters, labels);
    BOOST_CHECK_EQUAL(moved, number_of_differences(labels, jagged));
    BOOST_CHECK_LT(number_of_differences(labels, wanted), before / 10);
    // what is beyond the band has not moved
    const auto band = find_band(surface.graph, jagged, 1.05f * float(parameters.band_width), false);
    for (Index i = 0; i < surface.graph.size(); ++i)
      if (band[i].other < 0) BOOST_REQUIRE_EQUAL(labels[i], jagged[i]);
  }
}

BOOST_AUTO_TEST_CASE(a_border_out_of_reach_of_the_edge_stays_off_it)
{
  const Surface surface(concave_corner(50, 0.02));
  const auto far = surface.labels([](const Coordinates& p) { return unfolded(p) > 0.5 ? 1 : 0; });
  for (const Refinement_rule refinement : both_rules)
  {
    std::vector<int> labels = far;
    refine_borders(surface.graph, rule(refinement), labels);
    const auto near_edge =
        surface.labels([](const Coordinates& p) { return unfolded(p) < 0.3 ? 1 : 0; });
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (near_edge[i] == 1) BOOST_REQUIRE_EQUAL(labels[i], 0);
  }
}

BOOST_AUTO_TEST_CASE(borders_come_to_a_neck_from_beyond_the_band)
{
  Raw_shape raw; // two cones that meet in a narrow neck
  constexpr int rings = 80;
  for (int i = 0; i < rings; ++i)
  {
    const double z = (2. * i + 1.) / rings - 1., radius = 0.1 + 0.6 * std::abs(z);
    const int around = static_cast<int>(220. * radius); // about equally dense
    for (int k = 0; k < around; ++k)
    {
      const double angle = (k + 0.5 * (i % 2)) * 6.283185307179586 / around;
      add_point(raw, {radius * std::cos(angle), radius * std::sin(angle), z},
                {std::cos(angle), std::sin(angle), z < 0. ? 0.6 : -0.6});
    }
  }
  const Surface surface(raw);
  const auto wanted = surface.labels([](const Coordinates& p) { return p[2] < 0. ? 0 : 1; });
  Parameters parameters = rule(Refinement_rule::SEAM_CUTS);
  for (const double begin : {-0.2, -0.1, 0.1, 0.2}) // the band is 0.16 wide on either side
  {
    auto labels = surface.labels([begin](const Coordinates& p) { return p[2] < begin ? 0 : 1; });
    refine_borders(surface.graph, parameters, labels);
    BOOST_CHECK_LT(number_of_differences(labels, wanted), 10u);
  }
}

BOOST_AUTO_TEST_CASE(a_border_moves_as_far_in_dense_points)
{
  std::vector<double> moved;
  for (const int n : {60, 180})
  {
    const Surface surface(plane(n).raw, 8);
    const auto toothed = surface.labels(
        [](const Coordinates& p) {
          return p[0] > 0.5 + zigzag({0., p[1] / 2., 0.}) ? 1 : 0;
        });
    auto labels = toothed;
    refine_borders(surface.graph, rule(Refinement_rule::SEAM_CUTS), labels);
    moved.push_back(static_cast<double>(number_of_differences(labels, toothed)) / (n * n));
  }
  BOOST_TEST_MESSAGE("share that moves: " << moved[0] << ", " << moved[1]);
  BOOST_CHECK_GT(moved[0], 0.01);
  BOOST_CHECK_CLOSE(moved[1], moved[0], 10.);
}

std::size_t border_edges(const Neighbor_graph& graph, const std::vector<int>& labels)
{
  std::size_t count = 0;
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i]) count += labels[i] != labels[edge.point] ? 1 : 0;
  return count;
}

BOOST_AUTO_TEST_CASE(straight_borders_on_a_plane_stay)
{
  const Surface surface(plane(40).raw, 8); // a tenth would be a choice among equals on a grid
  const auto straight = surface.labels([](const Coordinates& p)
                                       { return (p[0] < 0.5 ? 0 : 1) + (p[1] < 0.5 ? 0 : 2); });
  for (const Refinement_rule refinement : both_rules)
  {
    std::vector<int> labels = straight;
    Parameters parameters = rule(refinement);
    refine_borders(surface.graph, parameters, labels);
    BOOST_CHECK_LE(border_edges(surface.graph, labels), border_edges(surface.graph, straight));
    if (refinement ==
        Refinement_rule::SEAM_CUTS) // by the paper's weights one may move sideways as a whole
      BOOST_CHECK_LT(number_of_differences(labels, straight), 60u); // of 1600: where four meet
    BOOST_CHECK_EQUAL(std::set<int>(labels.begin(), labels.end()).size(), 4u);
  }
}

BOOST_AUTO_TEST_CASE(seams_are_cut_alike_by_any_number_of_threads)
{
  const Surface surface(plane(60).raw, 8);
  // so many small squares with toothed borders that every cut touches others
  const auto jagged = surface.labels(
      [](const Coordinates& p)
      {
        const auto eighth = [](const double t)
        { return (std::max)(0, (std::min)(7, static_cast<int>(8. * t))); };
        return eighth(p[0] + 0.3 * zigzag(p)) +
               8 * eighth(p[1] + 0.3 * zigzag({p[1], 3. * p[0], 0.}));
      });
  std::vector<int> one = jagged, several = jagged;
  BOOST_CHECK_GT(refine_borders(surface.graph, rule(Refinement_rule::SEAM_CUTS), one, false), 20u);
  refine_borders(surface.graph, rule(Refinement_rule::SEAM_CUTS), several, true);
  BOOST_CHECK(one == several);
}

BOOST_AUTO_TEST_CASE(no_refinement_moves_nothing)
{
  const Surface surface(concave_corner(30, 0.02));
  const auto jagged =
      surface.labels([](const Coordinates& p) { return unfolded(p) > zigzag(p) ? 1 : 0; });
  std::vector<int> labels = jagged;
  BOOST_CHECK_EQUAL(refine_borders(surface.graph, rule(Refinement_rule::NONE), labels), 0u);
  BOOST_CHECK(labels == jagged);
  for (const Refinement_rule refinement : both_rules)
  {
    Parameters parameters = rule(refinement);
    parameters.band_width = 0.;
    BOOST_CHECK_EQUAL(refine_borders(surface.graph, parameters, labels), 0u);
    BOOST_CHECK(labels == jagged);
    std::vector<int> one(labels.size(), 0); // a single segment has no border
    BOOST_CHECK_EQUAL(refine_borders(surface.graph, rule(refinement), one), 0u);
  }
}

BOOST_AUTO_TEST_CASE(islands_go_and_isolated_pieces_stay)
{
  Raw_shape raw = plane(60).raw;
  add_rectangle(raw, {9., 0., 0.}, {0.02, 0., 0.}, {0., 0.02, 0.}, 4, 3, {0., 0., 1.}); // apart
  const Surface surface(raw);
  const auto clean =
      surface.labels([](const Coordinates& p) { return p[0] < 0.5 || p[0] > 8. ? 0 : 1; });
  auto labels = clean;
  std::size_t island = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const Coordinates& p = surface.raw.positions[surface.points.elements[i]];
    if (std::abs(p[0] - 0.2) < 0.03 && std::abs(p[1] - 0.5) < 0.03) labels[i] = 1, ++island;
  }
  BOOST_REQUIRE_GE(island, 4u);
  remove_islands(surface.graph, labels);
  BOOST_CHECK(labels == clean);

  // a piece that is all of its segment is no island, however small, nor is one without neighbors
  labels = clean;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const Coordinates& p = surface.raw.positions[surface.points.elements[i]];
    if (std::abs(p[0] - 0.2) < 0.03 && std::abs(p[1] - 0.5) < 0.03) labels[i] = 2;
    if (p[0] > 8.) labels[i] = 1;
  }
  const auto before = labels;
  remove_islands(surface.graph, labels);
  BOOST_CHECK(labels == before);
}

BOOST_AUTO_TEST_CASE(equal_points_on_both_sides_of_a_border_are_no_trouble)
{
  Raw_shape raw = plane(20).raw; // each point twice, one of them on either side
  const std::size_t half = raw.positions.size();
  for (std::size_t i = 0; i < half; ++i) add_point(raw, raw.positions[i], raw.normals[i]);
  const Surface surface(raw);
  std::vector<int> twins(raw.positions.size());
  for (std::size_t i = 0; i < twins.size(); ++i)
    twins[i] = surface.points.elements[i] < half ? 0 : 1;
  for (const Refinement_rule refinement : both_rules)
    for (const double width : {1e-6, 0.05})
    {
      std::vector<int> labels = twins;
      Parameters parameters = rule(refinement);
      parameters.band_width = width;
      const std::size_t moved = refine_borders(surface.graph, parameters, labels);
      BOOST_CHECK_EQUAL(moved, number_of_differences(labels, twins));
      for (const int l : labels) BOOST_REQUIRE(l == 0 || l == 1);
    }
}

BOOST_AUTO_TEST_CASE(an_expansion_move_is_the_best_one)
{
  std::mt19937 random(5);
  for (int trial = 0; trial < 40; ++trial)
  {
    const Labeling_problem problem = random_problem(4, 3, 3, random);
    std::vector<int> labels;
    for (int v = 0; v < 12; ++v) labels.push_back(static_cast<int>(random() % 3));
    const int alpha = trial % 3;
    const std::vector<int> moved = expansion_move(problem, labels, alpha);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t choice = 0; choice < 1u << 12; ++choice)
    {
      std::vector<int> candidate = labels;
      for (std::size_t v = 0; v < 12; ++v)
        if ((choice >> v & 1u) != 0) candidate[v] = alpha;
      least = (std::min)(least, problem.energy(candidate));
    }
    BOOST_CHECK_CLOSE(problem.energy(moved), least, 1e-6);
    for (std::size_t v = 0; v < 12; ++v) BOOST_CHECK(moved[v] == labels[v] || moved[v] == alpha);
  }
}

BOOST_AUTO_TEST_CASE(alpha_expansion_is_as_good_as_that_of_cgal)
{
  std::mt19937 random(6);
  for (const int number_of_labels : {2, 3, 6})
    for (int trial = 0; trial < 3; ++trial)
    {
      const Labeling_problem problem = random_problem(15, 12, number_of_labels, random);
      const std::vector<int> start(180, trial % number_of_labels);
      std::vector<int> labels = start;
      alpha_expansion(problem, number_of_labels, labels);
      const double of_cgal = problem.energy(labels_of_cgal(problem, start));
      BOOST_CHECK_LT(problem.energy(labels), problem.energy(start));
      BOOST_CHECK_LT(std::abs(problem.energy(labels) - of_cgal), 0.01 * of_cgal);
    }
}

BOOST_AUTO_TEST_SUITE_END()
