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

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

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
  Double3 mean;
  Symmetric_matrix3 covariance;
};

/// measures `n` points, `point(i)` with coordinates in `[0, 1]`.
template <typename Point>
Mean_and_covariance measure_spread(const std::size_t n, const bool parallel, const Point& point)
{
  const std::array<double, 9> sums =
      sums_in_any_order<9>(n, parallel,
                           [&](const std::size_t i) -> std::array<double, 9>
                           {
                             const Double3 v = point(i);
                             const Symmetric_matrix3 squares(v);
                             return {v.x,
                                     v.y,
                                     v.z,
                                     squares.diagonal.x,
                                     squares.diagonal.y,
                                     squares.diagonal.z,
                                     squares.off.x,
                                     squares.off.y,
                                     squares.off.z};
                           });
  const auto count = static_cast<double>(n);
  const Double3 mean = Double3{sums[0], sums[1], sums[2]} / count;
  const Symmetric_matrix3 squares({sums[3], sums[4], sums[5]}, {sums[6], sums[7], sums[8]});
  return {mean, squares / count - Symmetric_matrix3(mean)};
}

/// returns the eigenvectors of a symmetric matrix by growing eigenvalues. They are iterated: where two
/// eigenvalues are nearly equal, the closed form of `Principal_axes` is less exact. Where they are so nearly equal that
/// the last digits of the points would decide, as for a vase, the coordinate axes do (single precision changes 1e-7 of
/// the largest).
inline std::array<Double3, 3> eigenvectors(const Symmetric_matrix3& m)
{
  constexpr double margin = 1e-4;
  Eigen::Matrix3d matrix;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) matrix(r, c) = m.column(c)[r];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const Eigen::Matrix3d& vectors = solver.eigenvectors();
  const Eigen::Vector3d& values = solver.eigenvalues();
  std::array<Double3, 3> axes;
  for (int c = 0; c < 3; ++c)
    axes[static_cast<std::size_t>(c)] = {vectors(0, c), vectors(1, c), vectors(2, c)};
  const bool first = values[1] - values[0] <= margin * values[2]; // two that are equal
  const bool last = values[2] - values[1] <= margin * values[2];
  if (first && last) return Frame().axes;
  if (!first && !last) return axes;
  const std::size_t single = first ? 2 : 0, next = (single + 1) % 3;
  const Double3 own = axes[single];
  const Double3 axis = Frame().axes[std::abs(own.x) < 0.6 ? 0 : 1]; // one of the two is across
  const Double3 across = axis - dot(axis, own) * own;
  axes[next] = across / std::sqrt(dot(across, across));
  axes[(next + 1) % 3] = cross(own, axes[next]);
  return axes;
}

/// turns axes to where the points reach farther, as far as a rotation allows: of the three signs, that of the
/// most even axis follows from the others. `third`: the third moments along the axes. Where the points are so even that
/// their last digits would decide, an axis goes to one side of the coordinates.
inline void choose_signs(const Mean_and_covariance& spread, const std::array<double, 3>& third,
                         std::array<Double3, 3>& axes)
{
  constexpr double margin = 1e-5;
  constexpr Double3 side = {0.8, 0.51, 0.23}; // across no axis that shapes have
  std::size_t evenest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double variance = spread.covariance.form(axes[k]);
    double skew = variance > 0. ? std::abs(third[k]) / std::pow(variance, 1.5) : 0.;
    if (skew < margin) skew = 0.;
    if ((skew > 0. ? third[k] : dot(side, axes[k])) < 0.) axes[k] = -1. * axes[k];
    if (skew >= least) continue;
    least = skew;
    evenest = k;
  }
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0.) axes[evenest] = -1. * axes[evenest];
}

/// returns three axes after a rotation in their own frame that takes none near another one: by one radian
/// about (1, 2, 3). The walls of many shapes are across their principal axes, and where a plane lies along
/// the faces of voxels chance decides which one has its points.
inline std::array<Double3, 3> turned_obliquely(const std::array<Double3, 3>& axes)
{
  constexpr std::array<Double3, 3> columns = {
      {{0.57313785544898688, 0.74034884046078198, -0.35127851212351696},
       {-0.60900664213739331, 0.67164450419152844, 0.42190587791811218},
       {0.54829180960859991, -0.027879282947946255, 0.83582225209576422}}};
  std::array<Double3, 3> result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = columns[k].x * axes[0] + (columns[k].y * axes[1] + columns[k].z * axes[2]);
  return result;
}

/// returns a frame that turns with the points: it is oblique to their principal axes, always in the same
/// way. Where two of the principal moments are equal, as those of a vase, any axes across the third may be
/// meant: it does not turn with the points there.
///
/// Complexity: three linear passes. The result does not depend on the order of the points.
inline Frame pca_frame(const std::vector<Coordinates>& positions, const bool parallel)
{
  const Bounding_cube cube = bounding_cube(positions, Frame(), parallel);
  const auto point = [&](const std::size_t i) -> Double3
  {
    const Coordinates p = cube.within(positions[i]);
    return {p[0], p[1], p[2]};
  };
  const Mean_and_covariance spread = measure_spread(positions.size(), parallel, point);
  std::array<Double3, 3> axes = eigenvectors(spread.covariance);
  const std::array<double, 3> third =
      sums_in_any_order<3>(positions.size(), parallel,
                           [&](const std::size_t i) -> std::array<double, 3>
                           {
                             // half, as no point is farther from the mean than the diagonal of the cube is long
                             const Double3 v = point(i) - spread.mean;
                             std::array<double, 3> cubes;
                             for (std::size_t k = 0; k < 3; ++k)
                             {
                               const double along = 0.5 * dot(axes[k], v);
                               cubes[k] = along * along * along;
                             }
                             return cubes;
                           });
  choose_signs(spread, third, axes);
  return {turned_obliquely(axes)};
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_PCA_FRAME_H
