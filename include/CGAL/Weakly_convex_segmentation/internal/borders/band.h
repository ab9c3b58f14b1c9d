// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_BAND_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_BAND_H

// The narrow band along the borders in which they may move (section 5).

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Search_front.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// exponent of the distance in the data cost (equation 4)
constexpr double data_exponent = 1.5;

/// Where a point lies in the band along the borders.
struct Band_point
{
  float distance = std::numeric_limits<float>::infinity(); ///< to the nearest border
  int other = -1; ///< label beyond that border; -1 outside of the band
};

/// fills the band within one segment, whose points are `members`, ascending.
inline void grow_band(const Neighbor_graph& graph, const std::vector<int>& labels,
                      const std::vector<Index>& members, const float width,
                      std::vector<Band_point>& band)
{
  Search_front front;
  for (const Index i : members)
    for (const Neighbor& edge : graph[i])
      if (labels[edge.point] != labels[i] && 0.5f * edge.length < band[i].distance)
      {
        band[i] = {0.5f * edge.length, labels[edge.point]};
        if (band[i].distance <= width) front.push(i, band[i].distance);
      }
  front.search([&band](const Index i) { return band[i].distance; },
               [&](const Index i, const float d)
               {
                 for (const Neighbor& edge : graph[i])
                 {
                   const float through = d + edge.length;
                   if (labels[edge.point] != labels[i] || through >= band[edge.point].distance ||
                       through > width)
                     continue;
                   band[edge.point] = {through, band[i].other};
                   front.push(edge.point, through);
                 }
               });
  for (const Index i : members)
    if (band[i].distance > width) band[i].other = -1;
}

/// returns for each point within `width` of a border, along the graph, the distance and the label
/// beyond it. Labels are numbered from 0.
inline std::vector<Band_point> find_band(const Neighbor_graph& graph,
                                         const std::vector<int>& labels, const float width,
                                         const bool parallel)
{
  std::vector<std::vector<Index>> members; // no way leads from one segment into another
  for (Index i = 0; i < graph.size(); ++i)
  {
    const auto label = static_cast<std::size_t>(labels[i]);
    if (label >= members.size()) members.resize(label + 1);
    members[label].push_back(i);
  }
  std::vector<Band_point> band(graph.size());
  parallel_for(
      members.size(), parallel,
      [&](const std::size_t l) { grow_band(graph, labels, members[l], width, band); }, 1);
  return band;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_BAND_H
