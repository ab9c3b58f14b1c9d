// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_CONSISTENCY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_CONSISTENCY_H

// Given normals of a cloud that contradict each other, as where a tool has turned each to one side of a plane: the
// winding number tells, and that of normals made consistent, which are right.
//
// At the points of a closed surface with its normals outwards it is a half. Of 22 meshes of the benchmark's dev half
// as clouds of 8,000 points it is .54 to .59, of made shapes of 2,000 to 20,000 points .49 to .61; with a tenth of the
// normals turned at random .40 to .45; with those of one half, or every other one, turned -.05 to .31; seen from
// one side .18 to .45, and made consistent up to .47.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/estimate_normals.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/normal_propagation.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the areas that the points stand for, by the neighbors that lie about in the plane of each.
inline std::vector<float> areas_of(const Oriented_points& points, const Neighbor_graph& graph)
{
  constexpr float two_pi =
      6.283185f; // the mean square of the distances in a disk is half of that of its radius
  constexpr float steepest = 0.25f; // squared sine of the angle to the plane
  std::vector<float> areas(points.size(), 0.f);
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    float count = 0.f, squares = 0.f;
    for (const Neighbor& neighbor : graph[i])
    {
      const Vector3 along = points.positions[neighbor.point] - points.positions[i];
      const float square = squared_length(along), height = dot(along, points.normals[i]);
      if (height * height >= steepest * square) continue;
      count += 1.f;
      squares += square;
    }
    if (count > 0.f) areas[i] = two_pi * squares / (count * count);
  }
  return areas;
}

/// returns the mean of the winding number of the surface at some of the points, about a half where it is closed and its
/// normals point outwards.
inline double mean_winding(const Oriented_points& points, const Neighbor_graph& graph,
                           const bool parallel)
{
  constexpr std::size_t samples = 200;
  constexpr float pi = 3.141593f;
  const std::vector<float> areas = areas_of(points, graph);
  const std::size_t n = points.size();
  const std::size_t step = (std::max)(n / samples, std::size_t(1));
  std::vector<double> winding((n + step - 1) / step, 0.);
  const auto measure = [&](const std::size_t sample)
  {
    const std::size_t i = sample * step;
    for (std::size_t j = 0; j < n; ++j)
    {
      const Vector3 d = points.positions[j] - points.positions[i];
      const float square = squared_length(d);
      if (j == i || pi * square < areas[j]) continue; // what is that near says nothing
      winding[sample] += static_cast<double>(areas[j] * dot(d, points.normals[j]) /
                                             (4.f * pi * square * std::sqrt(square)));
    }
  };
  parallel_for(winding.size(), parallel, measure, 16);
  double sum = 0.;
  for (const double w : winding) sum += w;
  return sum / static_cast<double>((std::max)(winding.size(), std::size_t(1)));
}

/// turns normals so that neighbors agree and pieces look outwards; returns the share that was turned.
inline double make_consistent(Oriented_points& points, const Run_control& control)
{
  constexpr std::size_t neighbors = 12;
  const std::size_t n = points.size();
  std::vector<float> spacing;
  std::vector<Index> nearest = nearest_neighbors(points, Kd_tree(points.positions), neighbors,
                                                 spacing, control.parallel, control);
  const std::vector<Vector3> given = points.normals;
  Unoriented_points shape{points, std::vector<float>(n, 0.f), std::move(nearest), neighbors};
  parallel_for(
      n, control.parallel,
      [&](const std::size_t i)
      {
        const Index* const row = &shape.nearest[i * neighbors];
        const Known_neighbors near(points.positions, static_cast<Index>(i), {row, row + neighbors});
        shape.roughness[i] = Roughness(near, given[i]).all;
      });
  control.check();
  orient_outwards(points, propagate_orientation(shape, control.parallel, control), control);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (dot(points.normals[i], given[i]) < 0.f) ++turned;
  return static_cast<double>(turned) / static_cast<double>(n);
}

/// What is found about given normals.
enum class Normals_found
{
  CONSISTENT,
  TURNED,  ///< to be consistent
  DOUBTFUL ///< they contradict each other, but the surface is too open to tell which are right
};

/// decides between normals as they are given and made consistent, by mean windings and the share that was turned.
inline Normals_found judge_normals(const double given, const double consistent, const double turned)
{
  constexpr double closed = 0.48, much = 0.1, few = 0.02;
  if ((std::min)(turned, 1. - turned) <= few) return Normals_found::CONSISTENT;
  if (std::abs(consistent) >= closed) return Normals_found::TURNED;
  const bool is_better = std::abs(consistent) > std::abs(given) + much;
  return is_better && (std::min)(turned, 1. - turned) > much ? Normals_found::DOUBTFUL
                                                             : Normals_found::CONSISTENT;
}

/// whether normals of this mean winding contradict each other nowhere
inline bool has_closed_winding(const double winding) { return std::abs(winding) >= 0.47; }

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_CONSISTENCY_H
