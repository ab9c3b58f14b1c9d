// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_PCA_FRAME_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_PCA_FRAME_H

// A frame that turns with the shape, so that all that follows is the same however the shape lies: voxels
// and the order of the points are along the coordinate axes.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Three orthogonal unit vectors, right-handed.
struct Frame
{
  std::array<Double3, 3> axes = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};

  /// returns the coordinates along the axes.
  Coordinates operator()(const Coordinates& p) const
  {
    const Double3 v = {p[0], p[1], p[2]};
    return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)};
  }
  /// returns what has these coordinates along the axes.
  Coordinates inverse(const Double3& v) const
  {
    const Double3 p = v.x * axes[0] + v.y * axes[1] + v.z * axes[2];
    return {p.x, p.y, p.z};
  }
};

[[noreturn]] inline void refuse_extent()
{
  throw std::invalid_argument(
      "the coordinates are so large that the extent of the shape overflows; scale the shape down");
}

/// A cube about points, in a frame.
struct Bounding_cube
{
  Coordinates corner;
  double side;

  double unit() const { return side > 0. ? side : 1.; }
  /// returns where a point lies, against cancellation and overflow: each coordinate in `[0, 1]`.
  Coordinates within(const Coordinates& p) const // the reciprocal of the side may overflow
  {
    return {(p[0] - corner[0]) / unit(), (p[1] - corner[1]) / unit(), (p[2] - corner[2]) / unit()};
  }
};

/// returns the bounding cube of points that are turned by a frame first.
inline Bounding_cube bounding_cube(const std::vector<Coordinates>& positions,
                                   const Frame& frame = {}, const bool parallel = false)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Box
  {
    Coordinates low = {infinity, infinity, infinity};
    Coordinates high = {-infinity, -infinity, -infinity};
    void add(const Coordinates& first, const Coordinates& last)
    {
      for (int c = 0; c < 3; ++c)
      {
        low[c] = (std::min)(low[c], first[c]);
        high[c] = (std::max)(high[c], last[c]);
      }
    }
  };
  Box box;
  for (const Box& of_block : map_blocks(positions.size(), parallel,
                                        [&](const std::size_t begin, const std::size_t end)
                                        {
                                          Box own;
                                          for (std::size_t i = begin; i < end; ++i)
                                          {
                                            const Coordinates p = frame(positions[i]);
                                            own.add(p, p);
                                          }
                                          return own;
                                        }))
    box.add(of_block.low, of_block.high);
  const double side =
      (std::max)({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
  if (!std::isfinite(side)) refuse_extent();
  return {box.low, side};
}

/// returns sums over `[0, n)` of terms of at most 1 in size. They are cut off to a grid on which the sums
/// are exact, so that these do not depend on the order of the points.
template <std::size_t N, typename Terms>
std::array<double, N> sums_in_any_order(const std::size_t n, const bool parallel,
                                        const Terms& terms)
{
  int bits = 0;
  std::frexp(static_cast<double>(n), &bits);
  const double grid = std::ldexp(1., 62 - bits);
  using Sums = std::array<std::int64_t, N>;
  Sums total = {};
  for (const Sums& of_block : map_blocks(n, parallel,
                                         [&](const std::size_t begin, const std::size_t end)
                                         {
                                           Sums own = {};
                                           for (std::size_t i = begin; i < end; ++i)
                                           {
                                             const std::array<double, N> t = terms(i);
                                             for (std::size_t k = 0; k < N; ++k)
                                               own[k] += static_cast<std::int64_t>(t[k] * grid);
                                           }
                                           return own;
                                         }))
    for (std::size_t k = 0; k < N; ++k) total[k] += of_block[k];
  std::array<double, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = static_cast<double>(total[k]) / grid;
  return result;
}

/// The mean of points and their covariance matrix, in a cube of side 1.
struct Mean_and_covariance
{
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

/// measures `n` points, `point(i)` with coordinates in `[0, 1]`.
template <typename Point>
Mean_and_covariance measure_spread(const std::size_t n, const bool parallel, const Point& point)
{
  const std::array<double, 9> sums = sums_in_any_order<9>(
      n, parallel,
      [&](const std::size_t i) -> std::array<double, 9>
      {
        const Eigen::Vector3d v = point(i);
        return {v[0],        v[1],        v[2],        v[0] * v[0], v[1] * v[0],
                v[2] * v[0], v[1] * v[1], v[2] * v[1], v[2] * v[2]};
      });
  const auto count = static_cast<double>(n);
  Mean_and_covariance spread;
  spread.mean = Eigen::Vector3d(sums[0], sums[1], sums[2]) / count;
  spread.covariance << sums[3], sums[4], sums[5], sums[4], sums[6], sums[7], sums[5], sums[7],
      sums[8];
  spread.covariance = spread.covariance / count - spread.mean * spread.mean.transpose();
  return spread;
}

/// turns axes, the columns, to where the points reach farther, as far as a rotation allows: of the three
/// signs, that of the most even axis follows from the others. `third`: the third moments along the axes.
inline void choose_signs(const Mean_and_covariance& spread, const std::array<double, 3>& third,
                         Eigen::Matrix3d& axes)
{
  int evenest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const double moment = third[static_cast<std::size_t>(k)];
    if (moment < 0.) axes.col(k) *= -1.;
    const double variance = axes.col(k).dot(spread.covariance * axes.col(k));
    const double skew = variance > 0. ? std::abs(moment) / std::pow(variance, 1.5) : 0.;
    if (skew >= least) continue;
    least = skew;
    evenest = k;
  }
  if (axes.determinant() < 0.) axes.col(evenest) *= -1.;
}

/// returns a rotation that takes no axis near another one. The walls of many shapes are across their
/// principal axes, and where a plane lies along the faces of voxels chance decides which one has its points.
inline Eigen::Matrix3d oblique_rotation()
{
  return Eigen::AngleAxisd(1., Eigen::Vector3d(1., 2., 3.).normalized()).toRotationMatrix();
}

/// returns a frame that turns with the points: it is oblique to their principal axes, always in the same
/// way. Where two of the principal moments are equal, as those of a vase, any axes across the third may be
/// meant, and rounding decides.
///
/// Complexity: three linear passes. The result does not depend on the order of the points.
inline Frame pca_frame(const std::vector<Coordinates>& positions, const bool parallel)
{
  const Bounding_cube cube = bounding_cube(positions, Frame(), parallel);
  const auto point = [&](const std::size_t i)
  {
    const Coordinates p = cube.within(positions[i]);
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  const Mean_and_covariance spread = measure_spread(positions.size(), parallel, point);
  Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread.covariance).eigenvectors();
  const std::array<double, 3> third =
      sums_in_any_order<3>(positions.size(), parallel,
                           [&](const std::size_t i) -> std::array<double, 3>
                           {
                             // half, as no point is farther from the mean than the diagonal of the cube is long
                             const Eigen::Array3d v =
                                 0.5 * (axes.transpose() * (point(i) - spread.mean)).array();
                             return {v[0] * v[0] * v[0], v[1] * v[1] * v[1], v[2] * v[2] * v[2]};
                           });
  choose_signs(spread, third, axes);
  axes *= oblique_rotation();
  Frame frame;
  for (int k = 0; k < 3; ++k)
    frame.axes[static_cast<std::size_t>(k)] = {axes(0, k), axes(1, k), axes(2, k)};
  return frame;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_PCA_FRAME_H
