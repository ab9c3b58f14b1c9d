// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_DENOISE_POINTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_DENOISE_POINTS_H

// Noise looks like concavity everywhere. Where the surface bends one way, all edges of a point are
// concave or all are convex; noise makes both of every point. That tells it from shape, and a shape
// without noise is left as it is. The paper is silent on noise in the input.
//
// For clouds; of a mesh, denoise_mesh.h has taken the noise before. Labels of 19 meshes as bare points change by
// .050 with noise of a tenth of an edge and by .22 with 1 % of the diagonal, without this by .100 and .32; as
// meshes they do not depend on it (`benchmark_stability DATA --points`).

#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// the roughness, in radians, above which the points of a shape are smoothed
constexpr float noise_tolerance = radians(2.5);

/// returns the value that a quarter is below, 0 for none.
inline float lower_quartile(std::vector<float> values)
{
  const auto quartile = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quartile, values.end());
  return values.empty() ? 0.f : *quartile;
}

/// returns how far the normals of neighbors differ by noise, in radians: the lower quartile over the
/// points of twice the smaller one of the mean convex and the mean concave angle of its edges.
inline float roughness(const Neighbor_graph& graph)
{
  std::vector<float> of_point(graph.size());
  for (Index i = 0; i < graph.size(); ++i)
  {
    constexpr float other_sheet = radians(115.); // edges through a thin wall tell nothing
    float concave = 0.f, convex = 0.f, edges = 0.f;
    for (const Neighbor& edge : graph[i])
      if (std::abs(edge.concavity) < other_sheet)
      {
        (edge.concavity > 0.f ? concave : convex) += std::abs(edge.concavity);
        edges += 1.f;
      }
    of_point[i] = edges > 0.f ? 2.f * (std::min)(concave, convex) / edges : 0.f;
  }
  return lower_quartile(std::move(of_point));
}

/// returns how far positions and normals of neighbors contradict each other, in radians: the lower quartile
/// over the points of the mean sine of the angle between an edge and the plane across the mean normal of its
/// ends. It is 0 on planes, spheres and cylinders, however coarse, also where noise has spared the normals.
/// Edges over creases do not count: a long bar of few points has hardly any others.
inline float normal_position_mismatch(const Neighbor_graph& graph, const Oriented_points& points)
{
  constexpr float crease = radians(60.);
  std::vector<float> of_point(graph.size(), 0.f);
  for (Index i = 0; i < graph.size(); ++i)
  {
    float sum = 0.f, edges = 0.f;
    for (const Neighbor& edge : graph[i])
    {
      if (std::abs(edge.concavity) >= crease) continue;
      const Vector3 along = points.positions[edge.point] - points.positions[i];
      const Vector3 normals = points.normals[i] + points.normals[edge.point];
      if (edge.length > 0.f) sum += 0.5f * std::abs(dot(normals, along)) / edge.length;
      edges += 1.f;
    }
    if (edges > 0.f) of_point[i] = sum / edges;
  }
  return lower_quartile(std::move(of_point));
}

/// moves each point along the mean normal of itself and its neighbors into their mean plane, and gives it
/// that normal, or leaves the normals. Neighbors whose product of normals with the point's is at most
/// `other_side` do not count: they are of the other side of a thin part.
inline void smooth_once(const Neighbor_graph& graph, const float other_side,
                        const bool leave_normals, Oriented_points& points)
{
  std::vector<Vector3> normals(points.size()), positions(points.size());
  for (Index i = 0; i < points.size(); ++i)
  {
    Vector3 normal = points.normals[i], away;
    float count = 1.f;
    for (const Neighbor& edge : graph[i])
      if (dot(points.normals[i], points.normals[edge.point]) > other_side)
      {
        normal = normal + points.normals[edge.point];
        away = away + (points.positions[edge.point] - points.positions[i]);
        count += 1.f;
      }
    normals[i] = normalized(normal, points.normals[i]);
    positions[i] = points.positions[i] + (dot(normals[i], away) / count) * normals[i];
  }
  if (!leave_normals) points.normals = std::move(normals);
  points.positions = std::move(positions);
}

/// smooths the points while the normals are rougher than a tolerance or contradict the
/// positions by more than twice that, and renews the graph's lengths and angles. Normals that are smooth
/// and contradict the positions little, as those of a scanner that knows more than its points tell, stay.
/// Returns how often. Complexity: linear.
inline std::size_t denoise_points(Neighbor_graph& graph, Oriented_points& points)
{
  constexpr std::size_t most = 12;
  constexpr float mixed = radians(18.); // of rougher points, normals do not tell the sides apart
  constexpr float right_angle = 0.1f;   // of walls at one, about, rounding must not decide
  for (std::size_t rounds = 0; rounds < most; ++rounds)
  {
    const float rough = roughness(graph), contradictory = normal_position_mismatch(graph, points);
    if (rough <= noise_tolerance && contradictory <= 2.f * noise_tolerance) return rounds;
    smooth_once(graph, rough > mixed ? -2.f : right_angle,
                rough <= noise_tolerance && contradictory <= 4.f * noise_tolerance, points);
    for (Index i = 0; i < graph.size(); ++i)
      for (Neighbor& edge : graph[i])
      {
        edge.length = length(points.positions[edge.point] - points.positions[i]);
        edge.concavity = signed_concavity(points, i, edge.point);
      }
  }
  return most;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_DENOISE_POINTS_H
