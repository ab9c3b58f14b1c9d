// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_MIRROR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_MIRROR_H

// The plane by which a shape is its own mirror image, nearly, and where the reflection takes each point. What
// holds on one side of such a shape is to hold on the other: its segments are decided for both sides together.
//
// Candidates are the planes across the principal axes, and where two principal moments are about equal also
// planes around the third axis. The best are moved to where the mirrored points lie on the surface, by
// Gauss-Newton steps on their distances from the tangent planes.

#include <CGAL/Weakly_convex_segmentation/internal/consensus/motion_judge.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/pca_frame.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The plane of the points x with normal . x = offset; the normal is a unit vector.
struct Mirror_plane
{
  Double3 normal = {1., 0., 0.};
  double offset = 0.;

  double height(const Vector3& p) const { return dot(normal, in_double(p)) - offset; }
  /// returns the mirror image of a point.
  Vector3 image(const Vector3& p) const { return moved(p, -2. * height(p)); }
  /// returns the mirror image of a vector.
  Vector3 image_of_vector(const Vector3& v) const
  {
    return moved(v, -2. * dot(normal, in_double(v)));
  }

private:
  Vector3 moved(const Vector3& p, const double along_normal) const
  {
    return in_single(in_double(p) + along_normal * normal);
  }
};

/// How well a shape is its own mirror image.
struct Mirror
{
  Mirror_plane plane;
  Fit_of_motion fit;
  /// the point that the mirror image of each point is nearest to; of a point without a counterpart, itself
  std::vector<Index> image;
};

/// Finds planes of reflection of points.
class Mirror_finder
{
public:
  explicit Mirror_finder(const Motion_judge& judge) : m_judge(judge) {}

  /// returns the best plane, without images.
  Mirror find() const
  {
    std::vector<Mirror> candidates = planes_to_try();
    std::sort(candidates.begin(), candidates.end(), is_better);
    constexpr std::size_t most = 3; // are moved
    candidates.resize((std::min)(candidates.size(), most));
    constexpr double hopeless = 0.08;
    constexpr int steps = 4;
    for (Mirror& m : candidates)
    {
      if (m.fit.residual > hopeless) continue;
      for (int step = 0; step < steps; ++step) m.plane = moved_to_surface(m.plane);
      m.fit = m_judge.fit(m.plane, m_judge.many());
    }
    return *std::min_element(candidates.begin(), candidates.end(), is_better);
  }

private:
  static bool is_better(const Mirror& a, const Mirror& b)
  {
    return a.fit.residual < b.fit.residual;
  }

  /// returns the plane after a Gauss-Newton step; images far from the surface have little weight.
  Mirror_plane moved_to_surface(const Mirror_plane& plane) const
  {
    constexpr double scale = 0.01; // of distances, relative to the extent
    const Double3& n = plane.normal;
    const Double3 not_along = std::abs(n.x) < 0.6 ? Double3{1., 0., 0.} : Double3{0., 1., 0.};
    const Double3 u = unit_vector(cross(n, not_along)), v = cross(n, u);
    Eigen::Matrix3d squares = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const Oriented_points& points = m_judge.points();
    for (const Index i : m_judge.many())
    {
      const Vector3& p = points.positions[i];
      const Index j = m_judge.image(plane, i);
      const Double3 m = in_double(points.normals[j]);
      const double off = dot(in_double(plane.image(p) - points.positions[j]), m);
      const double h = plane.height(p), along = dot(m, n);
      const Eigen::Vector3d slope(-2. * (dot(u, in_double(p)) * along + h * dot(m, u)),
                                  -2. * (dot(v, in_double(p)) * along + h * dot(m, v)), 2. * along);
      const double weight = 1. / (1. + off * off / (scale * scale));
      squares += weight * slope * slope.transpose();
      right -= weight * off * slope;
    }
    const Eigen::Vector3d step = squares.ldlt().solve(right);
    return {unit_vector(n + step[0] * u + step[1] * v), plane.offset + step[2]};
  }

  /// returns the planes across the principal axes, and those around an axis where the other two moments are about
  /// equal.
  std::vector<Mirror> planes_to_try() const
  {
    const Surface_moments surface = m_judge.moments();
    if (!(surface.area > 0.)) return {Mirror()};
    const std::array<Double3, 3> axes = eigenvectors(surface.covariance);
    std::vector<Mirror> result;
    for (const Double3& axis : axes) result.push_back(judged(axis, surface.center));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Double3 &a = axes[(k + 1) % 3], &b = axes[(k + 2) % 3];
      const double first = surface.covariance.form(a), second = surface.covariance.form(b);
      constexpr double about_equal = 1.25;
      if ((std::max)(first, second) > about_equal * (std::min)(first, second)) continue;
      constexpr int directions = 16;
      for (int d = 1; d < directions; ++d)
      {
        const double turn = d * 3.14159265358979323846 / directions;
        result.push_back(judged(std::cos(turn) * a + std::sin(turn) * b, surface.center));
      }
    }
    return result;
  }

  Mirror judged(const Double3& normal, const Double3& center) const
  {
    Mirror m;
    m.plane = {normal, dot(normal, center)};
    m.fit = m_judge.fit(m.plane, m_judge.few());
    return m;
  }

  const Motion_judge& m_judge;
};

/// returns the mirror of a shape; without images if there is none within the tolerance: the largest mean distance
/// of mirrored points from the surface, relative to the extent.
///
/// Complexity: O(n log n) for n points.
inline Mirror find_mirror(const Motion_judge& judge, const double tolerance, const bool parallel)
{
  Mirror mirror = Mirror_finder(judge).find();
  if (mirror.fit.is_within(tolerance)) mirror.image = judge.images(mirror.plane, parallel);
  return mirror;
}

/// returns the label that each label's mirror image has most in common with, as a share of both; for labels that are
/// each other's, if there is a mirror.
inline std::map<int, int> images_of_labels(const std::vector<int>& labels,
                                           const std::vector<Index>& image)
{
  if (image.empty()) return {};
  std::map<int, double> sizes;
  std::map<std::pair<int, int>, double> common;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    ++sizes[labels[i]];
    if (image[i] == i) continue; // it has no counterpart, or is in the plane
    ++common[{labels[i], labels[image[i]]}];
  }
  std::map<int, std::pair<double, int>> best;
  for (const auto& [pair, count] : common)
    best[pair.first] = (std::max)(
        best[pair.first], {count / (sizes[pair.first] + sizes[pair.second] - count), pair.second});
  std::map<int, int> result;
  for (const auto& [label, match] : best)
    if (const auto back = best.find(match.second);
        back != best.end() && back->second.second == label)
      result[label] = match.second;
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_MIRROR_H
