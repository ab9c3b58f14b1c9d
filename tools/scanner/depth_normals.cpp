// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanner/depth_normals.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Virtual_scanner {
namespace internal {

namespace {

// The direction in which the points vary least.
Point flattest_direction(const std::vector<Point>& points)
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

} // namespace
} // namespace internal

std::vector<Point> estimate_normals(const Depth_image& image, const Point& eye,
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
