// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_SCANLINE_LINKS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_SCANLINE_LINKS_H

// Laser scanners measure along lines, and the faces of a turned part lie in rings: all nearest neighbors
// of a point can be on its own line or stripe, and the shape falls apart into lines. Such a point is
// linked to what lies beside its line too. The paper's scans have no such lines.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Kd_tree.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the direction of the line that a point and its neighbors lie on, or zero if they spread out in
/// the tangent plane.
inline Vector3 line_direction(const Oriented_points& points, const Index i, const Index* neighbors,
                              const std::size_t k)
{
  constexpr float thin = 0.25f; // variance across over that along: also stripes of several lines
  const Vector3& normal = points.normals[i];
  if (!(squared_length(normal) > 0.f)) return {};
  const Vector3 axis = std::abs(normal.x) < 0.6f ? Vector3{1.f, 0.f, 0.f} : Vector3{0.f, 1.f, 0.f};
  const Vector3 u = normalized(cross(normal, axis)), v = cross(normal, u);
  float uu = 0.f, uv = 0.f, vv = 0.f;
  for (std::size_t j = 0; j < k; ++j)
  {
    const Vector3 d = points.positions[neighbors[j]] - points.positions[i];
    const float x = dot(u, d), y = dot(v, d);
    uu += x * x, uv += x * y, vv += y * y;
  }
  const float mean = 0.5f * (uu + vv), half = 0.5f * (uu - vv);
  const float radius = std::sqrt(half * half + uv * uv);
  if (!(mean - radius < thin * (mean + radius))) return {};
  const float turn = 0.5f * std::atan2(uv, half);
  return std::cos(turn) * u + std::sin(turn) * v;
}

/// returns on which side of the line through `i` point `j` is, -1 or 1; 0 if it is not beside it: at more
/// than 45 degrees to the line and to both normals, and not of another wall.
inline int side_of_line(const Oriented_points& points, const Index i, const Vector3& line,
                        const Index j)
{
  const Vector3 &n = points.normals[i], &m = points.normals[j];
  const Vector3 d = points.positions[j] - points.positions[i];
  const float side = dot(cross(n, line), d);
  const float most = (std::max)({std::abs(dot(line, d)), std::abs(dot(n, d)), std::abs(dot(m, d))});
  if (!(std::abs(side) > most) || !(dot(n, m) > 0.5f)) return 0;
  return side > 0.f ? 1 : -1;
}

/// calls `link(j)` for the nearest point on a side of the line through `i` where none of its neighbors is,
/// if it is among the next hundred or so and nearer than a twentieth of the extent: patches are wider.
template <typename Link>
void link_across(const Oriented_points& points, const Kd_tree& tree, const Index i,
                 const Index* neighbors, const std::size_t k, const Vector3& line, const Link& link)
{
  constexpr std::size_t most = 127;
  constexpr float farthest = 0.05f;
  std::array<bool, 3> has_one = {false, true, false};
  for (std::size_t j = 0; j < k; ++j)
    if (neighbors[j] != i) has_one[1 + side_of_line(points, i, line, neighbors[j])] = true;
  if (has_one[0] && has_one[2]) return;
  tree.nearest(points.positions[i], most,
               [&](const Index j, const float squared)
               {
                 if (j == i || squared > farthest * farthest) return;
                 if (!std::exchange(has_one[1 + side_of_line(points, i, line, j)], true)) link(j);
               });
}

/// returns links from the points on lines to the lines beside them. `nearest`: the `k` nearest of each
/// point. Complexity: O(n log n), with more work only for points on lines.
inline std::vector<std::array<Index, 2>> scanline_links(const Oriented_points& points,
                                                        const Kd_tree& tree,
                                                        const std::vector<Index>& nearest,
                                                        const std::size_t k, const bool parallel)
{
  using Links = std::vector<std::array<Index, 2>>;
  Links links;
  for (const Links& of_block :
       map_blocks(points.size(), parallel,
                  [&](const std::size_t begin, const std::size_t end)
                  {
                    Links own;
                    for (std::size_t i = begin; i < end; ++i)
                    {
                      const Index p = static_cast<Index>(i);
                      const Vector3 line = line_direction(points, p, &nearest[i * k], k);
                      if (squared_length(line) > 0.f)
                        link_across(points, tree, p, &nearest[i * k], k, line,
                                    [&](const Index q) {
                                      own.push_back({(std::min)(p, q), (std::max)(p, q)});
                                    });
                    }
                    return own;
                  }))
    links.insert(links.end(), of_block.begin(), of_block.end());
  return links;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_SCANLINE_LINKS_H
