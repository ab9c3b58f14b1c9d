// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ALPHA_EXPANSION_REFINEMENT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ALPHA_EXPANSION_REFINEMENT_H

#include <CGAL/Weakly_convex_segmentation/internal/border_refinement.h>

#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Border refinement as the paper has it (section 5, equations 3-5): alpha expansion over the labels of
// all segments, in a narrow band.
//
// The angle beta of equation 5 is read as the exterior one between the tangent planes, pi for a flat
// border and less for a concave one: the paper wants a smaller cost where the surface is concave, and
// the plain angle between the normals would make flat cuts free and concave ones dear.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

struct Expansion_vertex
{
  std::size_t label = 0;
  std::vector<double> label_costs;
};
struct Expansion_edge
{
  double cost = 0.;
};
using Expansion_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                              Expansion_vertex, Expansion_edge>;

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
  using Entry = std::pair<float, Index>;
  for (int label = 0; label < number_of_labels; ++label)
  {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
    std::vector<Index> reached;
    for (const Index i : border[label]) front.push({0.f, i});
    for (const Index i : border[label]) distance[i] = 0.f;
    while (!front.empty())
    {
      const auto [d, i] = front.top();
      front.pop();
      if (d > distance[i]) continue;
      for (const Neighbor& edge : graph[i])
      {
        const float through = d + edge.length;
        if (labels[edge.point] == label || through > width || through >= distance[edge.point])
          continue;
        if (distance[edge.point] == std::numeric_limits<float>::infinity())
          reached.push_back(edge.point);
        distance[edge.point] = through;
        front.push({through, edge.point});
      }
    }
    for (const Index i : reached) rows[i].push_back({label, distance[i]});
    for (const Index i : reached) distance[i] = std::numeric_limits<float>::infinity();
    for (const Index i : border[label]) distance[i] = std::numeric_limits<float>::infinity();
  }
  return rows;
}

/// returns the band with its labels, costs and edges; `vertices` holds the point of each vertex.
/// Neighbors of the band belong to the graph with their label fixed.
inline Expansion_graph band_graph(const Neighbor_graph& graph, const std::vector<int>& labels,
                                  const int number_of_labels, const Parameters& parameters,
                                  std::vector<Index>& vertices)
{
  const auto near_labels = label_distances(graph, labels, number_of_labels,
                                           static_cast<float>(parameters.band_width));
  std::vector<char> inside(graph.size(), 0);
  for (Index i = 0; i < graph.size(); ++i)
    if (!near_labels[i].empty())
    {
      inside[i] = 1;
      for (const Neighbor& edge : graph[i]) inside[edge.point] = 1;
    }
  std::vector<std::size_t> vertex_of(graph.size(), 0);
  for (Index i = 0; i < graph.size(); ++i)
    if (inside[i])
    {
      vertex_of[i] = vertices.size();
      vertices.push_back(i);
    }
  double largest = 0.; // the denominator of equation 3
  for (const auto& row : near_labels)
    for (const auto& entry : row) largest = (std::max)(largest, static_cast<double>(entry.second));
  constexpr double fixed = 1e4;
  Expansion_graph result(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
  {
    const Index i = vertices[v];
    result[v].label = static_cast<std::size_t>(labels[i]);
    result[v].label_costs.assign(static_cast<std::size_t>(number_of_labels), fixed);
    result[v].label_costs[labels[i]] = 0.;
    for (const auto& [label, distance] : near_labels[i])
      result[v].label_costs[label] =
          parameters.data_weight * std::pow(distance / largest, parameters.data_exponent);
    for (const Neighbor& edge : graph[i])
      if (inside[edge.point] && edge.point > i)
        boost::add_edge(v, vertex_of[edge.point], Expansion_edge{exterior_angle_cost(edge)},
                        result);
  }
  return result;
}

/// moves all borders at once by alpha expansion.
inline void expand_labels(const Neighbor_graph& graph, const Parameters& parameters,
                          std::vector<int>& labels)
{
  const int number_of_labels = 1 + *std::max_element(labels.begin(), labels.end());
  if (number_of_labels < 2) return;
  std::vector<Index> vertices;
  Expansion_graph band = band_graph(graph, labels, number_of_labels, parameters, vertices);
  if (vertices.empty()) return;
  // not the MaxFlow tag: CGAL 5.5's stops after the first label, as its clear() keeps the flow
  CGAL::alpha_expansion_graphcut(
      band, boost::get(&Expansion_edge::cost, band), boost::get(&Expansion_vertex::label_costs, band),
      boost::get(&Expansion_vertex::label, band),
      CGAL::parameters::vertex_index_map(boost::get(boost::vertex_index, band))
          .implementation_tag(CGAL::Alpha_expansion_boost_compressed_sparse_row_tag()));
  for (std::size_t v = 0; v < vertices.size(); ++v)
    labels[vertices[v]] = static_cast<int>(band[v].label);
}

/// refines the borders by the rule that is asked for; returns the number of points that changed.
inline std::size_t refine_borders(const Neighbor_graph& graph, const Parameters& parameters,
                                  std::vector<int>& labels)
{
  if (parameters.refinement == Refinement_rule::NONE || parameters.band_width == 0.) return 0;
  const std::vector<int> before = labels;
  if (parameters.refinement == Refinement_rule::SEAM_CUTS)
    cut_seams(graph, parameters, labels);
  else
    expand_labels(graph, parameters, labels);
  remove_islands(graph, labels);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) moved += labels[i] != before[i] ? 1 : 0;
  return moved;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ALPHA_EXPANSION_REFINEMENT_H
