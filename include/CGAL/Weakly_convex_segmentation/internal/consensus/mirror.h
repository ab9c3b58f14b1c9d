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

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Kd_tree.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
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
    const Double3 q = in_double(p) + along_normal * normal;
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
};

/// How well a shape is its own mirror image.
struct Mirror
{
  Mirror_plane plane;
  double residual =
      1.; ///< mean distance of mirrored points from the surface, relative to the extent
  double agreeing = 0.; ///< share of them whose normals agree with it
  /// the point that the mirror image of each point is nearest to; of a point without a counterpart, itself
  std::vector<Index> image;
};

/// Finds planes of reflection of points.
class Mirror_finder
{
public:
  Mirror_finder(const Oriented_points& points, const std::vector<float>& spacing)
    : m_points(points), m_spacing(spacing), m_tree(points.positions), m_near(near_points(points)),
      m_few(sample(100)), m_many(sample(400))
  {}

  /// returns the best plane, with `residual` and `agreeing` but without images.
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
      if (m.residual > hopeless) continue;
      for (int step = 0; step < steps; ++step) m.plane = moved_to_surface(m.plane);
      judge(m, m_many);
    }
    return *std::min_element(candidates.begin(), candidates.end(), is_better);
  }

  /// returns where a reflection takes each point; a point that has no counterpart there is its own image.
  std::vector<Index> images(const Mirror_plane& plane, const bool parallel) const
  {
    std::vector<Index> result(m_points.size());
    parallel_for(
        result.size(), parallel,
        [&](const std::size_t n)
        {
          const auto i = static_cast<Index>(n);
          const Index j = image(plane, i);
          result[n] = are_counterparts(plane, i, j) ? j : i;
        },
        256);
    return result;
  }

private:
  static constexpr float same_direction = 0.7f; ///< cosine from which on normals agree

  static bool is_better(const Mirror& a, const Mirror& b) { return a.residual < b.residual; }

  std::vector<Index> sample(const std::size_t count) const
  {
    const std::size_t n = m_near.size(), wanted = (std::min)(n, count);
    std::vector<Index> result;
    for (std::size_t i = 0; i < wanted; ++i)
      result.push_back(m_near[(2 * i + 1) * n / (2 * wanted)]);
    return result;
  }

  /// returns the point nearest to the image of a point: of the nearest few the first whose normal agrees.
  Index image(const Mirror_plane& plane, const Index i) const
  {
    constexpr std::size_t asked = 6;
    const Vector3 normal = plane.image_of_vector(m_points.normals[i]);
    Index best = i;
    float best_cosine = -2.f;
    m_tree.nearest(plane.image(m_points.positions[i]), asked,
                   [&](const Index j, float)
                   {
                     const float cosine = dot(m_points.normals[j], normal);
                     if (best_cosine > same_direction || cosine <= best_cosine) return;
                     best = j;
                     best_cosine = cosine;
                   });
    return best;
  }

  /// returns how far a mirrored point is from the surface about another one: from the tangent plane, unless that
  /// point is far away.
  float distance(const Mirror_plane& plane, const Index i, const Index j) const
  {
    const Vector3 from_surface = plane.image(m_points.positions[i]) - m_points.positions[j];
    return (std::max)(std::abs(dot(from_surface, m_points.normals[j])),
                      length(from_surface) - m_spacing[j]);
  }

  bool are_counterparts(const Mirror_plane& plane, const Index i, const Index j) const
  {
    constexpr float farthest = 0.025f; // relative to the extent
    return distance(plane, i, j) < farthest &&
           dot(plane.image_of_vector(m_points.normals[i]), m_points.normals[j]) > 0.f;
  }

  void judge(Mirror& m, const std::vector<Index>& sample) const
  {
    double sum = 0., agreeing = 0.;
    for (const Index i : sample)
    {
      const Index j = image(m.plane, i);
      sum += distance(m.plane, i, j);
      if (dot(m.plane.image_of_vector(m_points.normals[i]), m_points.normals[j]) > same_direction)
        agreeing += 1.;
    }
    m.residual = sum / static_cast<double>(sample.size());
    m.agreeing = agreeing / static_cast<double>(sample.size());
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
    for (const Index i : m_many)
    {
      const Vector3& p = m_points.positions[i];
      const Index j = image(plane, i);
      const Double3 m = in_double(m_points.normals[j]);
      const double off = dot(in_double(plane.image(p) - m_points.positions[j]), m);
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
    double sum = 0.;
    Double3 center;
    Symmetric_matrix3 squares;
    for (const Index i : m_near) // by area, as samples may be uneven
    {
      const double area = static_cast<double>(m_spacing[i]) * m_spacing[i];
      const Double3 p = in_double(m_points.positions[i]);
      sum += area;
      center += area * p;
      squares = squares + area * Symmetric_matrix3(p);
    }
    if (!(sum > 0.)) return {Mirror()};
    center = center / sum;
    const Symmetric_matrix3 covariance = squares / sum - Symmetric_matrix3(center);
    const std::array<Double3, 3> axes = eigenvectors(covariance);
    std::vector<Mirror> result;
    for (const Double3& axis : axes) result.push_back(judged(axis, center));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Double3 &a = axes[(k + 1) % 3], &b = axes[(k + 2) % 3];
      const double first = covariance.form(a), second = covariance.form(b);
      constexpr double about_equal = 1.25;
      if ((std::max)(first, second) > about_equal * (std::min)(first, second)) continue;
      constexpr int directions = 16;
      for (int d = 1; d < directions; ++d)
      {
        const double turn = d * 3.14159265358979323846 / directions;
        result.push_back(judged(std::cos(turn) * a + std::sin(turn) * b, center));
      }
    }
    return result;
  }

  Mirror judged(const Double3& normal, const Double3& center) const
  {
    Mirror m;
    m.plane = {normal, dot(normal, center)};
    judge(m, m_few);
    return m;
  }

  const Oriented_points& m_points;
  const std::vector<float>& m_spacing;
  Kd_tree m_tree;
  std::vector<Index> m_near; ///< those that are not far away
  std::vector<Index> m_few, m_many;
};

/// returns the mirror of a shape; without images if there is none within the tolerance: the largest mean distance
/// of mirrored points from the surface, relative to the extent.
///
/// Complexity: O(n log n) for n points.
inline Mirror find_mirror(const Oriented_points& points, const std::vector<float>& spacing,
                          const double tolerance, const bool parallel)
{
  constexpr double least_agreeing = 0.9;
  const Mirror_finder finder(points, spacing);
  Mirror mirror = finder.find();
  if (mirror.residual <= tolerance && mirror.agreeing >= least_agreeing)
    mirror.image = finder.images(mirror.plane, parallel);
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
