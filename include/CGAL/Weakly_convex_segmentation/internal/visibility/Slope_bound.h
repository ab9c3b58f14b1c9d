// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_SLOPE_BOUND_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_SLOPE_BOUND_H

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <vector>

// How steeply a line can meet any of some disks: along a wire or a flat face it meets none of thousands
// at more than a grazing angle, and they need not be looked at.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A symmetric matrix of three rows.
struct Symmetric_matrix
{
  double xx = 0., yy = 0., zz = 0., xy = 0., xz = 0., yz = 0.;

  /// adds v v^T
  void add_square(const Vector3& v)
  {
    const double x = v.x, y = v.y, z = v.z;
    xx += x * x;
    yy += y * y;
    zz += z * z;
    xy += x * y;
    xz += x * z;
    yz += y * z;
  }
  void scale(const double s)
  {
    for (double* entry : {&xx, &yy, &zz, &xy, &xz, &yz}) *entry *= s;
  }
  /// returns v^T M v
  double form(const Vector3& v) const
  {
    const double x = v.x, y = v.y, z = v.z;
    return xx * x * x + yy * y * y + zz * z * z + 2. * (xy * x * y + xz * x * z + yz * y * z);
  }
  /// returns determinant * inverse
  Symmetric_matrix adjugate() const
  {
    return {yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy,
            xz * yz - xy * zz, xy * yz - xz * yy, xy * xz - yz * xx};
  }
  double determinant() const
  {
    const Symmetric_matrix a = adjugate();
    return xx * a.xx + xy * a.xy + xz * a.xz;
  }
};

/// An ellipsoid that bounds the slopes of a line to a set of disks: the products of its direction with
/// their unit normals.
class Slope_bound
{
public:
  /// bounds the normals, of which there is one at least.
  explicit Slope_bound(const std::vector<Vector3>& normals)
  {
    // the ellipsoid of their covariance is as flat as they lie, and blown up until it holds them all
    for (const Vector3& normal : normals) m_matrix.add_square(normal);
    m_matrix.scale(1. / static_cast<double>(normals.size()));
    constexpr double rounding = 1e-6; // makes it regular
    m_matrix.xx += rounding;
    m_matrix.yy += rounding;
    m_matrix.zz += rounding;
    const Symmetric_matrix adjugate = m_matrix.adjugate();
    const double determinant = m_matrix.determinant();
    double largest = 0.;
    for (const Vector3& normal : normals) largest = (std::max)(largest, adjugate.form(normal));
    const double blow = 1.001 * largest / determinant;
    m_matrix.scale(blow);
    // the two larger eigenvalues of the covariance have a product of at most 1/4: their sum is under 1
    m_least = 4. * determinant * blow;
  }

  /// returns an upper bound of the squared products with the normals, for a vector of any length.
  double squared_slope(const Vector3& direction) const { return m_matrix.form(direction); }
  /// a lower bound of `squared_slope()` over the unit vectors
  double least_squared_slope() const { return m_least; }

private:
  Symmetric_matrix m_matrix;
  double m_least = 0.;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_SLOPE_BOUND_H
