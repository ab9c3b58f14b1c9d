// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_ALPHA_EXPANSION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_ALPHA_EXPANSION_H

// Border refinement as the paper has it (section 5, equations 3-5): alpha expansion over the labels of
// all segments, in a narrow band.
//
// The maximum of equation 3 is, for each label, over the points of the band, outside of which no label moves. How
// narrow it is the paper does not say: with a half width of 0.015, 0.01 or 0.03 the `paper` preset has a 1 - RI of
// 0.140, 0.141 and 0.140, with borders as they are 0.142.
//
// The angle beta of equation 5 is read as the exterior one between the tangent planes, pi for a flat
// border and less for a concave one: the paper wants a smaller cost where the surface is concave, and
// the plain angle between the normals would make flat cuts free and concave ones dear.
//
// The moves are those of Boykov, Veksler and Zabih 2001 over CGAL's max-flow. CGAL's own
// alpha_expansion_graphcut() is what the tests compare with: with its max-flow tag, that of 5.5.1 and 6.0.1
// makes the move of the first label only (MaxFlow::Graph::clear() keeps the flow, so that none of the others
// seems to be an improvement; test_cgal_faults). Its Boost tags find the same labels, but take four to twenty
// times as long on grids of 900 and 3600 vertices with 6 labels.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/band.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/max_flow.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Search_front.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A labeling problem: costs of vertices by label and of edges between different labels (Potts).
struct Labeling_problem
{
  struct Edge
  {
    std::size_t first, second;
    double cost;
  };
  std::vector<std::vector<double>> label_costs; ///< of each vertex
  std::vector<Edge> edges;

  double energy(const std::vector<int>& labels) const
  {
    double sum = 0.;
    for (std::size_t v = 0; v < labels.size(); ++v) sum += label_costs[v][labels[v]];
    for (const Edge& e : edges)
      if (labels[e.first] != labels[e.second]) sum += e.cost;
    return sum;
  }
};

/// returns the best labeling in which each vertex keeps its label or takes `alpha`.
inline std::vector<int> expansion_move(const Labeling_problem& problem,
                                       const std::vector<int>& labels, const int alpha)
{
  ::MaxFlow::Graph flow; // vertices on the source's side keep their label
  std::vector<::MaxFlow::Graph::node_id> nodes;
  constexpr double fixed = 1e9;
  for (std::size_t v = 0; v < labels.size(); ++v)
  {
    nodes.push_back(flow.add_node());
    const double keep = labels[v] == alpha ? fixed : problem.label_costs[v][labels[v]];
    flow.add_tweights(nodes[v], problem.label_costs[v][alpha], keep);
  }
  for (const Labeling_problem::Edge& e : problem.edges)
  {
    const bool first_is_alpha = labels[e.first] == alpha,
               second_is_alpha = labels[e.second] == alpha;
    if (labels[e.first] == labels[e.second])
    {
      if (!first_is_alpha) flow.add_edge(nodes[e.first], nodes[e.second], e.cost, e.cost);
      continue;
    }
    // different labels cost the same whether one or none of them becomes alpha
    const auto between = flow.add_node();
    flow.add_tweights(between, 0., e.cost);
    flow.add_edge(between, nodes[e.first], first_is_alpha ? 0. : e.cost,
                  first_is_alpha ? 0. : e.cost);
    flow.add_edge(between, nodes[e.second], second_is_alpha ? 0. : e.cost,
                  second_is_alpha ? 0. : e.cost);
  }
  flow.maxflow();
  std::vector<int> moved = labels;
  for (std::size_t v = 0; v < labels.size(); ++v)
    if (flow.what_segment(nodes[v]) == ::MaxFlow::Graph::SINK) moved[v] = alpha;
  return moved;
}

/// lowers the energy by expansion moves until none helps.
inline void alpha_expansion(const Labeling_problem& problem, const int number_of_labels,
                            std::vector<int>& labels)
{
  double least = problem.energy(labels);
  for (bool improved = true; improved;)
  {
    improved = false;
    for (int alpha = 0; alpha < number_of_labels; ++alpha)
    {
      std::vector<int> moved = expansion_move(problem, labels, alpha);
      const double energy = problem.energy(moved);
      if (!(energy < least - 1e-9 * (1. + least))) continue;
      least = energy;
      labels = std::move(moved);
      improved = true;
    }
  }
}

/// returns beta / pi of equation 5, in [0, 2].
inline double exterior_angle_cost(const Neighbor& edge)
{
  return 1. - static_cast<double>(edge.concavity) / 3.14159265358979323846;
}

/// returns the distance of the points to the segment of each label where it is at most `width`:
/// for each point a row of (label, distance). Equation 4's dist_Bl(u): whoever is not in the segment
/// reaches it at its boundary.
inline std::vector<std::vector<std::pair<int, float>>>
label_distances(const Neighbor_graph& graph, const std::vector<int>& labels,
                const int number_of_labels, const float width)
{
  std::vector<std::vector<Index>> border(static_cast<std::size_t>(number_of_labels));
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
      if (labels[edge.point] != labels[i] &&
          (border[labels[i]].empty() || border[labels[i]].back() != i))
        border[labels[i]].push_back(i);

  std::vector<std::vector<std::pair<int, float>>> rows(graph.size());
  std::vector<float> distance(graph.size(), std::numeric_limits<float>::infinity());
  for (int label = 0; label < number_of_labels; ++label)
  {
    Search_front front;
    std::vector<Index> reached;
    for (const Index i : border[label]) front.push(i, distance[i] = 0.f);
    front.search([&distance](const Index i) { return distance[i]; },
                 [&](const Index i, const float d)
                 {
                   for (const Neighbor& edge : graph[i])
                   {
                     const float through = d + edge.length;
                     float& known = distance[edge.point];
                     if (labels[edge.point] == label || through > width || through >= known)
                       continue;
                     if (known == std::numeric_limits<float>::infinity())
                       reached.push_back(edge.point);
                     known = through;
                     front.push(edge.point, through);
                   }
                 });
    for (const Index i : reached) rows[i].push_back({label, distance[i]});
    for (const Index i : reached) distance[i] = std::numeric_limits<float>::infinity();
    for (const Index i : border[label]) distance[i] = std::numeric_limits<float>::infinity();
  }
  return rows;
}

/// returns the points of the band and their neighbors, whose labels stay.
inline std::vector<Index>
points_near_borders(const Neighbor_graph& graph,
                    const std::vector<std::vector<std::pair<int, float>>>& near_labels)
{
  std::vector<char> inside(graph.size(), 0);
  for (Index i = 0; i < graph.size(); ++i)
    if (!near_labels[i].empty())
    {
      inside[i] = 1;
      for (const Neighbor& edge : graph[i]) inside[edge.point] = 1;
    }
  std::vector<Index> points;
  for (Index i = 0; i < graph.size(); ++i)
    if (inside[i] != 0) points.push_back(i);
  return points;
}

/// returns the costs of equations 3 to 5 for the given points.
inline Labeling_problem
band_problem(const Neighbor_graph& graph, const std::vector<int>& labels,
             const std::vector<std::vector<std::pair<int, float>>>& near_labels,
             const std::vector<Index>& points, const int number_of_labels)
{
  constexpr std::size_t outside = static_cast<std::size_t>(-1);
  constexpr double fixed = 1e4; // labels that are out of reach
  std::vector<float> farthest(static_cast<std::size_t>(number_of_labels), 1e-20f); // of equation 3
  for (const auto& row : near_labels)
    for (const auto& [label, distance] : row)
      farthest[label] = (std::max)(farthest[label], distance);
  std::vector<std::size_t> vertex_of(graph.size(), outside);
  for (std::size_t v = 0; v < points.size(); ++v) vertex_of[points[v]] = v;
  constexpr double data_weight = 0.1; // against the smoothness cost (equation 3)
  Labeling_problem problem;
  for (const Index i : points)
  {
    std::vector<double> costs(static_cast<std::size_t>(number_of_labels), fixed);
    costs[labels[i]] = 0.;
    for (const auto& [label, distance] : near_labels[i])
      costs[label] = data_weight * std::pow(distance / farthest[label], data_exponent);
    problem.label_costs.push_back(std::move(costs));
    for (const Neighbor& edge : graph[i])
      if (edge.point > i && vertex_of[edge.point] != outside)
        problem.edges.push_back({vertex_of[i], vertex_of[edge.point], exterior_angle_cost(edge)});
  }
  return problem;
}

/// moves all borders at once by alpha expansion.
inline void expand_labels(const Neighbor_graph& graph, const Border_parameters& parameters,
                          std::vector<int>& labels)
{
  const int number_of_labels = 1 + *std::max_element(labels.begin(), labels.end());
  const auto near_labels =
      label_distances(graph, labels, number_of_labels, static_cast<float>(parameters.band_width));
  const std::vector<Index> points = points_near_borders(graph, near_labels);
  const Labeling_problem problem =
      band_problem(graph, labels, near_labels, points, number_of_labels);
  std::vector<int> band_labels;
  for (const Index i : points) band_labels.push_back(labels[i]);
  alpha_expansion(problem, number_of_labels, band_labels);
  for (std::size_t v = 0; v < points.size(); ++v) labels[points[v]] = band_labels[v];
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_ALPHA_EXPANSION_H
