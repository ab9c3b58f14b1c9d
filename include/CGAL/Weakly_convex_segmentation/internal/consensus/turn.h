// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TURN_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TURN_H

// The smallest turn that takes a shape to itself, nearly, as that of a gear by one tooth, and where it takes each
// point. Axes are those of the principal axes about which the shape spreads evenly. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/internal/consensus/motion_judge.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/pca_frame.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The rotation about an axis through a point by some of `order` equal turns; the axis is a unit vector.
class Rotation
{
public:
  Rotation(const Double3& axis, const Double3& center, const int turns, const int order)
    : m_axis(axis), m_center(center), m_cosine(std::cos(2. * pi * turns / order)),
      m_sine(std::sin(2. * pi * turns / order))
  {}

  Vector3 image(const Vector3& p) const
  {
    return in_single(m_center + turned(in_double(p) - m_center));
  }
  Vector3 image_of_vector(const Vector3& v) const { return in_single(turned(in_double(v))); }

private:
  /// by Rodrigues' formula
  Double3 turned(const Double3& v) const
  {
    const double along = (1. - m_cosine) * dot(m_axis, v);
    return m_cosine * v + m_sine * cross(m_axis, v) + along * m_axis;
  }

  static constexpr double pi = 3.14159265358979323846;

  Double3 m_axis, m_center;
  double m_cosine, m_sine;
};

/// The smallest turn that takes a shape to itself.
struct Turn
{
  int order = 1; ///< so many make a whole turn; 16 of a body of revolution
  /// the point that each point is taken nearest to; of a point without a counterpart, itself
  std::vector<Index> image;
};

/// returns whether turns about an axis take the points to themselves: one, two, four of them and so on, as nearly
/// any shape is near itself after a small turn.
inline bool are_turns_of_shape(const Motion_judge& judge, const Double3& axis,
                               const Double3& center, const int order, const double tolerance)
{
  int turns = 1;
  while (4 * turns <= order) turns *= 2;
  for (; turns > 0; turns /= 2)
  {
    const Rotation rotation(axis, center, turns, order);
    if (judge.fit(rotation, judge.few()).residual > 2. * tolerance ||
        !judge.fit(rotation, judge.many()).is_within(tolerance))
      return false;
  }
  return true;
}

/// returns the order of the smallest turn about an axis that takes the points to themselves, of three and more; 1 if
/// there is none.
inline int order_about_axis(const Motion_judge& judge, const Double3& axis, const Double3& center,
                            const double tolerance)
{
  constexpr int most = 64, enough_around = 16;
  for (int order = most; order > 2; --order)
    if (are_turns_of_shape(judge, axis, center, order, tolerance))
      return order < most ? order : enough_around; // a body of revolution has no smallest turn
  return 1;
}

/// returns the turn of the highest order that takes the points to themselves within a quarter of the tolerance: the
/// largest mean distance of turned points from the surface, relative to the extent. Teeth that are lower than that are
/// none.
///
/// Complexity: O(n log n) for n points.
inline Turn find_turn(const Motion_judge& judge, const double tolerance, const bool parallel)
{
  constexpr double about_equal = 1.1; // two moments, where turns by a third and less are possible
  const Surface_moments surface = judge.moments();
  Turn turn;
  if (!(surface.area > 0.)) return turn;
  const std::array<Double3, 3> axes = eigenvectors(surface.covariance);
  std::size_t best = 0;
  for (std::size_t k = 0; k < axes.size(); ++k)
  {
    const double first = surface.covariance.form(axes[(k + 1) % 3]);
    const double second = surface.covariance.form(axes[(k + 2) % 3]);
    if ((std::max)(first, second) > about_equal * (std::min)(first, second)) continue;
    const int order = order_about_axis(judge, axes[k], surface.center, 0.25 * tolerance);
    if (order <= turn.order) continue;
    turn.order = order;
    best = k;
  }
  if (turn.order > 1)
    turn.image = judge.images(Rotation(axes[best], surface.center, 1, turn.order), parallel);
  return turn;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TURN_H
