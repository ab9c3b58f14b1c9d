// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_VECTOR3_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_VECTOR3_H

// Vectors of three numbers, and angles.

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// index of a point, patch or region
using Index = std::uint32_t;

/// Three numbers.
template <typename Number>
struct Basic_vector3
{
  Number x = 0, y = 0, z = 0;

  Number operator[](const int i) const { return i == 0 ? x : (i == 1 ? y : z); }

  friend Basic_vector3 operator+(const Basic_vector3& a, const Basic_vector3& b)
  {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Basic_vector3 operator-(const Basic_vector3& a, const Basic_vector3& b)
  {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Basic_vector3 operator*(const Number s, const Basic_vector3& a)
  {
    return {s * a.x, s * a.y, s * a.z};
  }
  friend Basic_vector3 operator/(const Basic_vector3& a, const Number s)
  {
    return {a.x / s, a.y / s, a.z / s};
  }
  friend Basic_vector3& operator+=(Basic_vector3& a, const Basic_vector3& b) { return a = a + b; }
  friend Number dot(const Basic_vector3& a, const Basic_vector3& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend Basic_vector3 cross(const Basic_vector3& a, const Basic_vector3& b)
  {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Number squared_length(const Basic_vector3& a) { return dot(a, a); }
  friend Number length(const Basic_vector3& a) { return std::sqrt(dot(a, a)); }
};

/// The core works on coordinates of about unit size, where single precision is ample and half the memory
/// traffic of double.
using Vector3 = Basic_vector3<float>;
/// for sums over many points
using Double3 = Basic_vector3<double>;

inline Double3 in_double(const Vector3& a) { return {a.x, a.y, a.z}; }

/// returns a unit vector, or `fallback` if `a` has no direction.
inline Vector3 normalized(const Vector3& a, const Vector3& fallback = {0.f, 0.f, 1.f})
{
  const float l = length(a);
  return l > 0.f ? (1.f / l) * a : fallback;
}

/// returns the angle between two unit vectors in radians.
inline float angle(const Vector3& a, const Vector3& b)
{
  const float c = dot(a, b);
  return std::acos(c > 1.f ? 1.f : (c < -1.f ? -1.f : c));
}

/// returns the angle between the unit normals `n` at `p` and `m` at `q`, negative if the edge between them is
/// convex: concave iff (m - n) . (q - p) < 0, that is iff the normals lean towards each other.
inline float signed_concavity(const Vector3& p, const Vector3& n, const Vector3& q,
                              const Vector3& m)
{
  const float turn = dot(m - n, q - p);
  const float bend = angle(n, m);
  return turn < 0.f ? bend : -bend;
}

constexpr float radians(const double degrees)
{
  return static_cast<float>(degrees * (3.14159265358979323846 / 180.));
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_VECTOR3_H
