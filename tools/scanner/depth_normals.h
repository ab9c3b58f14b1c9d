// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_DEPTH_NORMALS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_DEPTH_NORMALS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Normals of a depth camera's points from the pixels around, as for real data.

namespace Virtual_scanner {

using Point = std::array<double, 3>;

namespace internal {

inline Point operator+(const Point& a, const Point& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Point operator-(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Point operator*(const double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }

inline double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A vector of length 0 stays as it is.
inline Point normalized(const Point& a)
{
  const double length = std::sqrt(dot(a, a));
  return length > 0. ? (1. / length) * a : a;
}

} // namespace internal

// std::array's operators are not found by argument lookup
using internal::operator+;
using internal::operator-;
using internal::operator*;
using internal::dot;

// A raster of points; some pixels are not known.
struct Depth_image
{
  std::size_t width = 0, height = 0;
  std::vector<Point> points;  // row after row
  std::vector<char> is_known; // whether there is a point in the pixel
};

// Normals towards `eye` by principal components of the known pixels within `radius`. Neighbors that a
// step in depth parts from the pixel don't count. A pixel with fewer than 3 others gets no normal: zeros.
std::vector<Point> estimate_normals(const Depth_image& image, const Point& eye, std::size_t radius);

} // namespace Virtual_scanner

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_DEPTH_NORMALS_H
