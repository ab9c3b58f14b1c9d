// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_MIRRORED_BORDERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_MIRRORED_BORDERS_H

// The same borders on both sides of a shape that is its own mirror image: of a border and its mirror image, which
// chance puts at slightly different places, the one that costs less is taken for both. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/refine_borders.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/seam_cuts.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/mirror.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The borders between labels on either side of a plane of reflection.
class Borders_of_sides
{
public:
  Borders_of_sides(const Neighbor_graph& graph, const Oriented_points& points,
                   const Mirror_plane& plane, const std::vector<int>& labels)
  {
    for (Index i = 0; i < graph.size(); ++i)
    {
      m_is_above.push_back(plane.height(points.positions[i]) > 0.);
      for (const Neighbor& edge : graph[i])
        if (labels[edge.point] != labels[i])
          m_costs[key(labels[i], labels[edge.point], m_is_above[i])] +=
              graph.spacing[i] * border_cost(edge.concavity);
    }
  }

  bool is_above(const Index point) const { return m_is_above[point]; }

  /// whether a border costs more than its image on the other side; of two equal ones that below the plane does.
  bool is_dearer(const std::pair<int, int>& border, const std::pair<int, int>& image,
                 const bool is_above) const
  {
    const auto own = m_costs.find(key(border.first, border.second, is_above));
    const auto other = m_costs.find(key(image.first, image.second, !is_above));
    if (own == m_costs.end() || other == m_costs.end()) return false;
    return own->second > other->second || (own->second == other->second && !is_above);
  }

private:
  using Key = std::tuple<int, int, bool>;

  static Key key(const int a, const int b, const bool is_above)
  {
    return {(std::min)(a, b), (std::max)(a, b), is_above};
  }

  std::vector<bool> m_is_above;
  std::map<Key, double> m_costs;
};

/// moves borders to where their mirror images are, where these cost less; not if borders are to stay.
///
/// Complexity: linear in the number of edges of the graph.
inline void match_borders(const Neighbor_graph& graph, const Oriented_points& points,
                          const Mirror& mirror, const Border_parameters& parameters,
                          std::vector<int>& labels)
{
  if (mirror.image.empty() || !has_refinement(parameters)) return;
  const std::map<int, int> images = images_of_labels(labels, mirror.image);
  const Borders_of_sides borders(graph, points, mirror.plane, labels);
  const std::vector<int> before = labels;
  for (Index i = 0; i < graph.size(); ++i)
  {
    if (mirror.image[i] == i) continue;
    const auto own = images.find(before[i]), beyond = images.find(before[mirror.image[i]]);
    if (own == images.end() || beyond == images.end() || beyond->second == before[i]) continue;
    if (borders.is_dearer({before[i], beyond->second}, {own->second, beyond->first},
                          borders.is_above(i)))
      labels[i] = beyond->second;
  }
  remove_islands(graph, labels);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_MIRRORED_BORDERS_H
