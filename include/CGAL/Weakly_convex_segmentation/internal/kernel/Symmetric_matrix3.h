// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SYMMETRIC_MATRIX3_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SYMMETRIC_MATRIX3_H

// Symmetric 3x3 matrices, for the axes of clouds of points. They do what
// Eigen's closed form does, with the same rounding, but take a compiler a hundredth of the time.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns a unit vector, or `a` if it has no direction.
inline Double3 unit_vector(const Double3& a)
{
  const double squared = dot(a, a);
  return squared > 0. ? a / std::sqrt(squared) : a;
}

/// Sums of the products of coordinates: a symmetric 3x3 matrix.
struct Symmetric_matrix3
{
  Double3 diagonal;
  Double3 off; ///< the coefficients (1, 0), (2, 0) and (2, 1)

  Symmetric_matrix3() = default;
  Symmetric_matrix3(const Double3& d, const Double3& o) : diagonal(d), off(o) {}
  /// the product of a vector and its transpose
  explicit Symmetric_matrix3(const Double3& a)
    : diagonal{a.x * a.x, a.y * a.y, a.z * a.z}, off{a.y * a.x, a.z * a.x, a.z * a.y}
  {}
  Double3 column(const int i) const
  {
    return i == 0   ? Double3{diagonal.x, off.x, off.y}
           : i == 1 ? Double3{off.x, diagonal.y, off.z}
                    : Double3{off.y, off.z, diagonal.z};
  }
  /// less a multiple of the identity
  Symmetric_matrix3 shifted(const double s) const { return {diagonal - Double3{s, s, s}, off}; }
  /// returns v^T M v
  double form(const Double3& v) const
  {
    return diagonal.x * v.x * v.x + diagonal.y * v.y * v.y + diagonal.z * v.z * v.z +
           2. * (off.x * v.x * v.y + off.y * v.x * v.z + off.z * v.y * v.z);
  }
  /// returns determinant * inverse
  Symmetric_matrix3 adjugate() const
  {
    const Double3 &d = diagonal, &o = off;
    return {{d.y * d.z - o.z * o.z, d.x * d.z - o.y * o.y, d.x * d.y - o.x * o.x},
            {o.y * o.z - o.x * d.z, o.x * o.z - o.y * d.y, o.x * o.y - o.z * d.x}};
  }
  double determinant() const
  {
    const Symmetric_matrix3 a = adjugate();
    return diagonal.x * a.diagonal.x + off.x * a.off.x + off.y * a.off.y;
  }
};

inline Symmetric_matrix3 operator+(const Symmetric_matrix3& a, const Symmetric_matrix3& b)
{
  return {a.diagonal + b.diagonal, a.off + b.off};
}
inline Symmetric_matrix3 operator-(const Symmetric_matrix3& a, const Symmetric_matrix3& b)
{
  return {a.diagonal - b.diagonal, a.off - b.off};
}
inline Symmetric_matrix3 operator*(const double s, const Symmetric_matrix3& a)
{
  return {s * a.diagonal, s * a.off};
}
inline Symmetric_matrix3 operator/(const Symmetric_matrix3& a, const double s)
{
  return {a.diagonal / s, a.off / s};
}
inline Symmetric_matrix3& operator+=(Symmetric_matrix3& a, const Symmetric_matrix3& b)
{
  return a = a + b;
}

/// returns the eigenvalues, ascending, of a matrix with coefficients of at most 1 and a trace near 0.
inline Double3 eigenvalues_of_scaled(const Symmetric_matrix3& m)
{
  const Double3 &d = m.diagonal, &o = m.off;
  // the roots of x^3 - c2 x^2 + c1 x - c0
  const double c0 =
      d.x * d.y * d.z + 2. * o.x * o.y * o.z - d.x * o.z * o.z - d.y * o.y * o.y - d.z * o.x * o.x;
  const double c1 = d.x * d.y - o.x * o.x + d.x * d.z - o.y * o.y + d.y * d.z - o.z * o.z;
  constexpr double third = 1. / 3.;
  const double mean = (d.x + d.y + d.z) * third;
  const double a = (std::max)(((d.x + d.y + d.z) * mean - c1) * third, 0.);
  const double half_b = 0.5 * (c0 + mean * (2. * mean * mean - c1));
  const double q = (std::max)(a * a * a - half_b * half_b, 0.);
  const double rho = std::sqrt(a), theta = std::atan2(std::sqrt(q), half_b) * third;
  const double cosine = std::cos(theta), sine = std::sin(theta), root = std::sqrt(3.);
  return {mean - rho * (cosine + root * sine), mean - rho * (cosine - root * sine),
          mean + 2. * rho * cosine};
}

/// returns the unit vector that a matrix of rank 2 maps to 0, and a column that is orthogonal to it.
inline std::pair<Double3, Double3> kernel_of(const Symmetric_matrix3& m)
{
  const Double3& d = m.diagonal;
  int largest = std::abs(d.y) > std::abs(d.x) ? 1 : 0;
  if (std::abs(d.z) > std::abs(d[largest])) largest = 2;
  const Double3 column = m.column(largest);
  const Double3 a = cross(column, m.column((largest + 1) % 3));
  const Double3 b = cross(column, m.column((largest + 2) % 3));
  const double squared_a = dot(a, a), squared_b = dot(b, b);
  return {squared_a > squared_b ? a / std::sqrt(squared_a) : b / std::sqrt(squared_b), column};
}

/// returns the eigenvector of the largest or the smallest eigenvalue, `own`; `opposite` is the one at the
/// other end.
inline Double3 direction_of(const Symmetric_matrix3& m, const double own, const double middle,
                            const double opposite)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (std::abs(own - middle) > 2. * epsilon * std::abs(middle - opposite))
    return kernel_of(m.shifted(own)).first;
  // the own and the middle one are the same but for rounding: any direction across the opposite one
  const auto [across, column] = kernel_of(m.shifted(opposite));
  return unit_vector(column - dot(across, column) * column);
}

/// Eigenvalues, ascending, and the eigenvectors at both ends.
class Principal_axes
{
public:
  explicit Principal_axes(const Symmetric_matrix3& m)
  {
    const Double3 &d = m.diagonal, &o = m.off;
    const double shift = (d.x + (d.y + d.z)) / 3.;
    m_scaled = m.shifted(shift);
    const Double3& e = m_scaled.diagonal;
    const double scale = (std::max)(
        {std::abs(e.x), std::abs(e.y), std::abs(e.z), std::abs(o.x), std::abs(o.y), std::abs(o.z)});
    if (scale > 0.) m_scaled = m_scaled / scale;
    m_roots = eigenvalues_of_scaled(m_scaled);
    m_values = scale * m_roots + Double3{shift, shift, shift};
  }

  const Double3& values() const { return m_values; }
  Double3 longest() const
  {
    return is_round() ? Double3{0., 0., 1.}
                      : direction_of(m_scaled, m_roots.z, m_roots.y, m_roots.x);
  }
  Double3 shortest() const
  {
    return is_round() ? Double3{1., 0., 0.}
                      : direction_of(m_scaled, m_roots.x, m_roots.y, m_roots.z);
  }

private:
  bool is_round() const // any direction will do
  {
    return m_roots.z - m_roots.x <= std::numeric_limits<double>::epsilon();
  }

  Symmetric_matrix3 m_scaled; ///< less a multiple of the identity, with coefficients of at most 1
  Double3 m_roots;            ///< its eigenvalues
  Double3 m_values;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_SYMMETRIC_MATRIX3_H
