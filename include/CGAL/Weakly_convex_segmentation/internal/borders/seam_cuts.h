// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SEAM_CUTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SEAM_CUTS_H

// The default's border refinement: one binary minimum cut for each pair of adjacent segments, with the costs
// of section 5 (equations 3-5) and a smoothness cost that falls with concavity.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/band.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/max_flow.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the cost of a border where the surface bends by so much: 1, less where it is concave.
inline double border_cost(const float concavity)
{
  constexpr float half_cost = radians(10.); // the concavity that halves the cost
  if (concavity <= 0.f) return 1.;
  const double ratio = concavity / half_cost;
  return 1. / (1. + ratio * ratio);
}

/// The band as what the cuts need: each point in it belongs to one seam, those of other seams and
/// beyond the band keep their label during the cut.
struct Seams
{
  struct Node
  {
    Index seam = static_cast<Index>(-1);
    Index number = 0; ///< within the seam
  };
  std::vector<Band_point> band;
  std::vector<Node> nodes; ///< one a point
  std::vector<std::pair<int, int>> labels;
  std::vector<std::vector<Index>> members;
};

/// returns the seams: the points that are nearer to the border between two labels than to any other.
inline Seams find_seams(const Neighbor_graph& graph, const std::vector<int>& labels,
                        const float width, const bool parallel)
{
  Seams seams;
  seams.band = find_band(graph, labels, width, parallel);
  std::map<std::pair<int, int>, std::vector<Index>> members;
  for (Index i = 0; i < graph.size(); ++i)
    if (seams.band[i].other >= 0) members[std::minmax(labels[i], seams.band[i].other)].push_back(i);
  seams.nodes.resize(graph.size());
  for (auto& [pair, points] : members)
  {
    for (std::size_t n = 0; n < points.size(); ++n)
      seams.nodes[points[n]] = {static_cast<Index>(seams.members.size()), static_cast<Index>(n)};
    seams.labels.push_back(pair);
    seams.members.push_back(std::move(points));
  }
  return seams;
}

/// returns the cost of moving a point that is a band's width from the border (equations 3 and 4). The
/// points in an area number as the square of the edges across a line, so it goes with the spacing: else
/// borders would move less in denser points.
inline double cost_of_move(const Neighbor_graph& graph, const Border_parameters& parameters)
{
  constexpr double data_weight =
      1.5; // against the smoothness cost, at a spacing of the band's width
  const double sum = std::accumulate(graph.spacing.begin(), graph.spacing.end(), 0.);
  return data_weight * sum /
         (static_cast<double>((std::max)(graph.size(), std::size_t(1))) * parameters.band_width);
}

/// cuts one seam; `before` are the labels of all points before any cut, `dearest` is the cost of moving
/// a point at the edge of the band.
inline void cut_seam(const Neighbor_graph& graph, const Seams& seams, const Index seam,
                     const std::vector<int>& before, const double dearest,
                     const Border_parameters& parameters, std::vector<int>& labels)
{
  const auto [a, b] = seams.labels[seam];
  const std::vector<Index>& points = seams.members[seam];
  // a fresh graph each time: MaxFlow::Graph::clear() of CGAL 5.5.1 and 6.0.1 keeps the flow (test_cgal_faults)
  ::MaxFlow::Graph flow;
  std::vector<::MaxFlow::Graph::node_id> ids;
  for (std::size_t n = 0; n < points.size(); ++n) ids.push_back(flow.add_node());
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const Index i = points[n];
    const double move =
        dearest * std::pow(seams.band[i].distance / parameters.band_width, data_exponent);
    double cost_of_a = before[i] == a ? 0. : move, cost_of_b = before[i] == b ? 0. : move;
    for (const Neighbor& edge : graph[i])
    {
      const Seams::Node node = seams.nodes[edge.point];
      if (node.seam != seam)
      {
        if (before[edge.point] == a) cost_of_b += border_cost(edge.concavity);
        if (before[edge.point] == b) cost_of_a += border_cost(edge.concavity);
      }
      else if (node.number > n)
        flow.add_edge(ids[n], ids[node.number], border_cost(edge.concavity),
                      border_cost(edge.concavity));
    }
    flow.add_tweights(ids[n], cost_of_b, cost_of_a); // the source's side is label a
  }
  flow.maxflow();
  for (std::size_t n = 0; n < points.size(); ++n)
    labels[points[n]] = flow.what_segment(ids[n]) == ::MaxFlow::Graph::SOURCE ? a : b;
}

/// moves the border between each two segments on its own, by a minimum cut of the points that are
/// nearer to this border than to any other.
inline void cut_seams(const Neighbor_graph& graph, const Border_parameters& parameters,
                      std::vector<int>& labels, const bool parallel)
{
  const std::vector<int> before = labels;
  const Seams seams =
      find_seams(graph, before, static_cast<float>(parameters.band_width), parallel);
  const double dearest = cost_of_move(graph, parameters);
  parallel_for(
      seams.members.size(), parallel,
      [&](const std::size_t s)
      { cut_seam(graph, seams, static_cast<Index>(s), before, dearest, parameters, labels); },
      1);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SEAM_CUTS_H
