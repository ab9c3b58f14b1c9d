// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_MOTION_JUDGE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_MOTION_JUDGE_H

// How well a motion, a reflection or a rotation, takes a shape to itself. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Kd_tree.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/pca_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns a vector in single precision.
inline Vector3 in_single(const Double3& v)
{
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// How well a motion takes a shape to itself.
struct Fit_of_motion
{
  double residual = 1.; ///< mean distance of moved points from the surface, relative to the extent
  double agreeing = 0.; ///< share of them whose normals agree with it

  bool is_within(const double tolerance) const
  {
    constexpr double least_agreeing = 0.9;
    return residual <= tolerance && agreeing >= least_agreeing;
  }
};

/// Where the surface of a shape is, and how far it spreads.
struct Surface_moments
{
  double area = 0.;
  Double3 center;
  Symmetric_matrix3 covariance;
};

/// Tells how well motions take points to themselves. A `Motion` has `image()` of a point and `image_of_vector()`.
class Motion_judge
{
public:
  Motion_judge(const Oriented_points& points, const std::vector<float>& spacing)
    : m_points(points), m_spacing(spacing), m_tree(points.positions), m_near(near_points(points)),
      m_few(sample(100)), m_many(sample(400))
  {}

  const Oriented_points& points() const { return m_points; }
  const std::vector<Index>& few() const { return m_few; }   ///< points for a first look
  const std::vector<Index>& many() const { return m_many; } ///< points to decide by

  /// returns where a motion takes each point; a point that has no counterpart there is its own image.
  template <typename Motion>
  std::vector<Index> images(const Motion& motion, const bool parallel) const
  {
    std::vector<Index> result(m_points.size());
    parallel_for(
        result.size(), parallel,
        [&](const std::size_t n)
        {
          const auto i = static_cast<Index>(n);
          const Index j = image(motion, i);
          result[n] = are_counterparts(motion, i, j) ? j : i;
        },
        256);
    return result;
  }

  /// returns the point nearest to the image of a point: of the nearest few the first whose normal agrees.
  template <typename Motion>
  Index image(const Motion& motion, const Index i) const
  {
    constexpr std::size_t asked = 6;
    const Vector3 normal = motion.image_of_vector(m_points.normals[i]);
    Index best = i;
    float best_cosine = -2.f;
    m_tree.nearest(motion.image(m_points.positions[i]), asked,
                   [&](const Index j, float)
                   {
                     const float cosine = dot(m_points.normals[j], normal);
                     if (best_cosine > same_direction || cosine <= best_cosine) return;
                     best = j;
                     best_cosine = cosine;
                   });
    return best;
  }

  /// returns how well a motion takes some points to the surface.
  template <typename Motion>
  Fit_of_motion fit(const Motion& motion, const std::vector<Index>& sample) const
  {
    double sum = 0., agreeing = 0.;
    for (const Index i : sample)
    {
      const Index j = image(motion, i);
      sum += distance(motion, i, j);
      if (dot(motion.image_of_vector(m_points.normals[i]), m_points.normals[j]) > same_direction)
        agreeing += 1.;
    }
    const auto count = static_cast<double>(sample.size());
    return {sum / count, agreeing / count};
  }

  /// returns where the surface is, by area, as samples may be uneven.
  Surface_moments moments() const
  {
    double sum = 0.;
    Double3 center;
    Symmetric_matrix3 squares;
    for (const Index i : m_near)
    {
      const double area = static_cast<double>(m_spacing[i]) * m_spacing[i];
      const Double3 p = in_double(m_points.positions[i]);
      sum += area;
      center += area * p;
      squares = squares + area * Symmetric_matrix3(p);
    }
    if (!(sum > 0.)) return {};
    center = center / sum;
    return {sum, center, squares / sum - Symmetric_matrix3(center)};
  }

private:
  static constexpr float same_direction = 0.7f; ///< cosine from which on normals agree

  std::vector<Index> sample(const std::size_t count) const
  {
    const std::size_t n = m_near.size(), wanted = (std::min)(n, count);
    std::vector<Index> result;
    for (std::size_t i = 0; i < wanted; ++i)
      result.push_back(m_near[(2 * i + 1) * n / (2 * wanted)]);
    return result;
  }

  /// returns how far a moved point is from the surface about another one: from the tangent plane, unless that
  /// point is far away.
  template <typename Motion>
  float distance(const Motion& motion, const Index i, const Index j) const
  {
    const Vector3 from_surface = motion.image(m_points.positions[i]) - m_points.positions[j];
    return (std::max)(std::abs(dot(from_surface, m_points.normals[j])),
                      length(from_surface) - m_spacing[j]);
  }

  template <typename Motion>
  bool are_counterparts(const Motion& motion, const Index i, const Index j) const
  {
    constexpr float farthest = 0.025f; // relative to the extent
    return distance(motion, i, j) < farthest &&
           dot(motion.image_of_vector(m_points.normals[i]), m_points.normals[j]) > 0.f;
  }

  const Oriented_points& m_points;
  const std::vector<float>& m_spacing;
  Kd_tree m_tree;
  std::vector<Index> m_near; ///< those that are not far away
  std::vector<Index> m_few, m_many;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_MOTION_JUDGE_H
