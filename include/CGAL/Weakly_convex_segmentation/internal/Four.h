// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FOUR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FOUR_H

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Four floats that are computed with at once, by Eigen. Each operation is one of its own: of long
/// expressions, Eigen makes a type each with dozens of functions, which take a compiler seconds.
class Four
{
  using Array = Eigen::Array4f;
  Array m_array;

  explicit Four(const Array& array) : m_array(array) {}

public:
  Four() = default; ///< of any values
  explicit Four(const float all) : m_array(Array::Constant(all)) {}
  Four(const float a, const float b, const float c, const float d) : m_array(a, b, c, d) {}

  float operator[](const int i) const { return m_array.coeff(i); }
  float& operator[](const int i) { return m_array.coeffRef(i); }

  friend Four operator+(const Four& a, const Four& b) { return Four(a.m_array + b.m_array); }
  friend Four operator-(const Four& a, const Four& b) { return Four(a.m_array - b.m_array); }
  friend Four operator*(const Four& a, const Four& b) { return Four(a.m_array * b.m_array); }
  friend Four operator/(const Four& a, const Four& b) { return Four(a.m_array / b.m_array); }
  friend Four minimum(const Four& a, const Four& b) { return Four(a.m_array.min(b.m_array)); }
  friend Four maximum(const Four& a, const Four& b) { return Four(a.m_array.max(b.m_array)); }
  friend float sum(const Four& a) { return a.m_array.sum(); }
  friend float smallest(const Four& a) { return a.m_array.minCoeff(); }
  friend float largest(const Four& a) { return a.m_array.maxCoeff(); }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FOUR_H
