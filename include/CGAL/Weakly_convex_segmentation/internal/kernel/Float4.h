// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FLOAT4_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FLOAT4_H

// Four floats at once.

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Float4 floats that are computed with at once, by Eigen. Each operation is one of its own: of long
/// expressions, Eigen makes a type each with dozens of functions, which take a compiler seconds.
class Float4
{
  using Array = Eigen::Array4f;
  Array m_array;

  explicit Float4(const Array& array) : m_array(array) {}

public:
  Float4() = default; ///< of any values
  explicit Float4(const float all) : m_array(Array::Constant(all)) {}
  Float4(const float a, const float b, const float c, const float d) : m_array(a, b, c, d) {}

  float operator[](const int i) const { return m_array.coeff(i); }
  float& operator[](const int i) { return m_array.coeffRef(i); }

  friend Float4 operator+(const Float4& a, const Float4& b)
  {
    return Float4(a.m_array + b.m_array);
  }
  friend Float4 operator-(const Float4& a, const Float4& b)
  {
    return Float4(a.m_array - b.m_array);
  }
  friend Float4 operator*(const Float4& a, const Float4& b)
  {
    return Float4(a.m_array * b.m_array);
  }
  friend Float4 operator/(const Float4& a, const Float4& b)
  {
    return Float4(a.m_array / b.m_array);
  }
  friend Float4 minimum(const Float4& a, const Float4& b)
  {
    return Float4(a.m_array.min(b.m_array));
  }
  friend Float4 maximum(const Float4& a, const Float4& b)
  {
    return Float4(a.m_array.max(b.m_array));
  }
  friend float sum(const Float4& a) { return a.m_array.sum(); }
  friend float smallest(const Float4& a) { return a.m_array.minCoeff(); }
  friend float largest(const Float4& a) { return a.m_array.maxCoeff(); }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FLOAT4_H
