// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_SLOPE_BOUND_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_SLOPE_BOUND_H

// How steeply a line can meet any of some disks: along a wire or a flat face it meets none of thousands
// at more than a grazing angle, and they need not be looked at.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// An ellipsoid that bounds the slopes of a line to a set of disks: the products of its direction with
/// their unit normals.
class Slope_bound
{
public:
  /// bounds the normals, of which there is one at least.
  explicit Slope_bound(const std::vector<Vector3>& normals)
  {
    // the ellipsoid of their covariance is as flat as they lie, and blown up until it holds them all
    for (const Vector3& normal : normals) m_matrix += Symmetric_matrix3(in_double(normal));
    constexpr double rounding = 1e-6; // makes it regular
    m_matrix = (1. / static_cast<double>(normals.size()) * m_matrix).shifted(-rounding);
    const Symmetric_matrix3 adjugate = m_matrix.adjugate();
    const double determinant = m_matrix.determinant();
    double largest = 0.;
    for (const Vector3& normal : normals)
      largest = (std::max)(largest, adjugate.form(in_double(normal)));
    const double blow = 1.001 * largest / determinant;
    m_matrix = blow * m_matrix;
    // the two larger eigenvalues of the covariance have a product of at most 1/4: their sum is under 1
    m_least = 4. * determinant * blow;
  }

  /// returns an upper bound of the squared products with the normals, for a vector of any length.
  double squared_slope(const Vector3& direction) const
  {
    return m_matrix.form(in_double(direction));
  }
  /// a lower bound of `squared_slope()` over the unit vectors
  double least_squared_slope() const { return m_least; }

private:
  Symmetric_matrix3 m_matrix;
  double m_least = 0.;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_SLOPE_BOUND_H
