// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ESTIMATE_NORMALS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ESTIMATE_NORMALS_H

#include <CGAL/Weakly_convex_segmentation/internal/Second_moments.h>
#include <CGAL/Weakly_convex_segmentation/internal/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/normal_propagation.h>
#include <CGAL/Weakly_convex_segmentation/internal/oriented_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/run_control.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// Normals for points that have none: across the plane that fits the neighbors best, then made consistent.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// fits a plane to a point and its neighbors: sets the normal to a unit vector across it, of either sign,
/// or to zero if they are all in one place, and the roughness.
inline void fit_plane(Unoriented_points& shape, const Index i)
{
  const std::vector<Vector3>& positions = shape.points.positions;
  Double3 sum;
  Second_moments squares;
  double n = 1.;
  for (std::size_t e = i * shape.k; e < (i + 1) * shape.k; ++e)
  {
    if (shape.nearest[e] == i) continue; // there are no more neighbors
    const Vector3 p = positions[shape.nearest[e]] - positions[i];
    n += 1.;
    const Double3 d{p.x, p.y, p.z};
    sum += d;
    squares += Second_moments(d);
  }
  const Second_moments covariance = (squares - Second_moments(sum) / n) / n;
  const Double3& variances = covariance.diagonal;
  const double size = variances.x + (variances.y + variances.z);
  shape.points.normals[i] = {};
  if (!(size > 0.)) return;
  const Principal_axes axes(covariance / size);
  const Double3 across = axes.shortest();
  shape.points.normals[i] = normalized(
      {static_cast<float>(across.x), static_cast<float>(across.y), static_cast<float>(across.z)});
  shape.roughness[i] = static_cast<float>((std::max)(0., axes.values().x * size));
}

/// fills `raw.normals`, the same for any order of the points. The normal is zero where points are in one
/// place and have no other neighbors.
inline void estimate_normals(Raw_points& raw, const Run_control& control)
{
  constexpr std::size_t neighbors = 12, fewest = 4; // three have a plane, but no inside
  const bool parallel = control.parallel;
  raw.normals.assign(raw.positions.size(), {0., 0., 1.});
  if (raw.positions.size() < fewest) return;
  Oriented_points points = orient_points(raw, parallel, control);
  const std::size_t n = points.size();
  std::vector<float> spacing;
  std::vector<Index> nearest = nearest_neighbors(points, Nearest_points(points.positions),
                                                 neighbors, spacing, parallel, control);
  control.check();
  Unoriented_points shape{points, std::vector<float>(n, 0.f), std::move(nearest), neighbors};
  parallel_for(n, parallel,
               [&](const std::size_t i)
               {
                 control.check_sometimes();
                 fit_plane(shape, static_cast<Index>(i));
               });
  control.check();
  orient_outwards(points, propagate_orientation(shape, parallel, control), control);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector3& v = points.normals[i];
    raw.normals[points.elements[i]] = {v.x, v.y, v.z};
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ESTIMATE_NORMALS_H
