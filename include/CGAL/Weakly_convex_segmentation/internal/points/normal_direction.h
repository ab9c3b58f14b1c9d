// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_DIRECTION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_DIRECTION_H

// Normals that all point inwards turn convex into concave. On a closed surface this can be decided.

#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns whether the surface is closed and inside out.
///
/// The normals of a closed surface add up to zero, weighted by area, and their products with the
/// positions to three times the volume, which is negative if they point inwards. Open surfaces, such as
/// a view from one side into a bowl, give no answer; what is far away has no say. `points` should lie about
/// equally dense.
inline bool is_inside_out(const Oriented_points& points)
{
  constexpr double largest_opening = 0.1, least_volume = 0.1;
  double volume = 0., lengths = 0., sum[3] = {0., 0., 0.}, center[3] = {0., 0., 0.};
  const std::vector<Index> near = near_points(points);
  const double n = static_cast<double>(near.size());
  for (const Index i : near)
    for (int c = 0; c < 3; ++c) center[c] += static_cast<double>(points.positions[i][c]) / n;
  for (const Index i : near)
  {
    double square = 0.;
    for (int c = 0; c < 3; ++c)
    {
      const double x = static_cast<double>(points.positions[i][c]) - center[c];
      volume += x * static_cast<double>(points.normals[i][c]);
      sum[c] += static_cast<double>(points.normals[i][c]);
      square += x * x;
    }
    lengths += std::sqrt(square);
  }
  const double opening = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / n;
  return volume < -least_volume * lengths && opening < largest_opening;
}

inline void flip_normals(Oriented_points& points)
{
  for (Vector3& v : points.normals) v = -1.f * v;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_DIRECTION_H
