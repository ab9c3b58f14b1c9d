// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_DEPTH_NORMALS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_DEPTH_NORMALS_H

#include <Eigen/Eigenvalues>

#include <algorithm>
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

namespace internal {

// The direction in which the points vary least.
inline Point flattest_direction(const std::vector<Point>& points)
{
  Point mean{};
  for (const Point& p : points) mean = mean + p;
  mean = (1. / static_cast<double>(points.size())) * mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Point& p : points)
  {
    const Eigen::Vector3d d(p[0] - mean[0], p[1] - mean[1], p[2] - mean[2]);
    covariance += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d n = solver.eigenvectors().col(0);
  return normalized({n[0], n[1], n[2]});
}

} // namespace internal

// Normals towards `eye` by principal components of the known pixels within `radius`. Neighbors that a
// step in depth parts from the pixel don't count. A pixel with fewer than 3 others gets no normal: zeros.
inline std::vector<Point> estimate_normals(const Depth_image& image, const Point& eye,
                                           const std::size_t radius)
{
  // The width of a pixel at the depth of the point, from a field of view as usual cameras have: a
  // surface seen at 75 degrees changes its depth by 4 of them from pixel to pixel.
  constexpr double steepest = 4.;
  const long r = static_cast<long>(radius), width = static_cast<long>(image.width),
             height = static_cast<long>(image.height);
  const auto range = [&](const std::size_t i)
  {
    const Point d = image.points[i] - eye;
    return std::sqrt(dot(d, d));
  };
  std::vector<Point> normals(image.points.size(), Point{});
  std::vector<Point> window;
  for (long row = 0; row < height; ++row)
    for (long column = 0; column < width; ++column)
    {
      const std::size_t i = static_cast<std::size_t>(row * width + column);
      if (image.is_known[i] == 0) continue;
      const double depth = range(i);
      window.clear();
      for (long y = (std::max)(row - r, 0L); y <= (std::min)(row + r, height - 1); ++y)
        for (long x = (std::max)(column - r, 0L); x <= (std::min)(column + r, width - 1); ++x)
        {
          const std::size_t j = static_cast<std::size_t>(y * width + x);
          if (image.is_known[j] == 0) continue;
          const double pixel = 0.75 * depth / static_cast<double>(image.width);
          const double steps =
              static_cast<double>((std::max)(std::abs(y - row), std::abs(x - column)));
          if (std::abs(range(j) - depth) > steepest * pixel * steps) continue;
          window.push_back(image.points[j]);
        }
      if (window.size() < 4) continue;
      const Point n = internal::flattest_direction(window);
      normals[i] = dot(n, eye - image.points[i]) >= 0. ? n : -1. * n;
    }
  return normals;
}

} // namespace Virtual_scanner

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_DEPTH_NORMALS_H
