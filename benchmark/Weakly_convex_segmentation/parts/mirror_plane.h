// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_MIRROR_PLANE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_MIRROR_PLANE_H

#include "parts/Sampled_surface.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// The plane of reflection of a shape, if it has one. All directions are tried, and the best of them are
// moved to where they fit best; this shares nothing with what the library itself does about symmetry.

namespace Part_measures {

struct Mirror_plane
{
  Vector normal;
  double offset = 0.;
  double residual =
      0.; ///< mean distance of the mirrored shape to the shape, relative to the extent
  double agreement = 0.; ///< share of the mirrored normals that are about those of the shape there

  Vector mirrored(const Vector& p) const { return p - 2. * (normal.dot(p) - offset) * normal; }
  Vector turned(const Vector& v) const { return v - 2. * normal.dot(v) * normal; }
};

/// What a plane has to reach to be one of the shape.
struct Mirror_limits
{
  double residual = 0.015;
  double agreement = 0.8;
};

namespace internal {

/// Every n-th sample, as many as asked for.
inline std::vector<Surface_sample> some_samples(const Sampled_surface& surface,
                                                const std::size_t count)
{
  const std::vector<Surface_sample>& all = surface.samples();
  std::vector<Surface_sample> some;
  for (std::size_t i = 0; i < count && i < all.size(); ++i)
    some.push_back(all[i * all.size() / (std::min)(count, all.size())]);
  return some;
}

/// Measures a plane; gives up on what comes to more than `limit`.
inline void measure(const Sampled_surface& surface, const std::vector<Surface_sample>& samples,
                    const double limit, Mirror_plane& plane)
{
  const double scale = 1. / (surface.extent() * static_cast<double>(samples.size()));
  plane.residual = plane.agreement = 0.;
  for (const Surface_sample& s : samples)
  {
    const Vector p = plane.mirrored(s.position);
    const Closest_point c = surface.closest(p);
    plane.residual += scale * (p - c.position).norm();
    if (plane.residual > limit) return;
    if (surface.normal(c.face).dot(plane.turned(s.normal)) > 0.7)
      plane.agreement += 1. / static_cast<double>(samples.size());
  }
}

/// Points of the shape, and those that their images should be.
using Point_pairs = std::vector<std::pair<Vector, Vector>>;

inline Point_pairs closest_pairs(const Sampled_surface& surface,
                                 const std::vector<Surface_sample>& samples,
                                 const Mirror_plane& plane)
{
  std::vector<std::pair<double, std::pair<Vector, Vector>>> pairs;
  for (const Surface_sample& s : samples)
  {
    const Vector p = plane.mirrored(s.position);
    const Closest_point c = surface.closest(p);
    if (surface.normal(c.face).dot(plane.turned(s.normal)) > 0.)
      pairs.push_back({(p - c.position).squaredNorm(), {s.position, c.position}});
  }
  const auto nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(pairs.begin(), pairs.end(), nearer);
  pairs.resize(pairs.size() - pairs.size() / 10); // what is on one side only
  Point_pairs kept;
  for (const auto& pair : pairs) kept.push_back(pair.second);
  return kept;
}

/// Moves a plane to where it takes the first of each pair as near to the second as a plane can, which is
/// an eigenvector: the sum of the squared distances is 4 n^T M n and what doesn't depend on n.
inline void fit(const Point_pairs& pairs, Mirror_plane& plane)
{
  Vector from = Vector::Zero(), to = Vector::Zero();
  for (const auto& [p, q] : pairs)
  {
    from += p;
    to += q;
  }
  const double n = static_cast<double>(pairs.size());
  from /= n;
  to /= n;
  Eigen::Matrix3d m = -n / 4. * (from - to) * (from - to).transpose();
  for (const auto& [p, q] : pairs)
  {
    const Eigen::Matrix3d product = (p - from) * (q - to).transpose();
    m += 0.5 * (product + product.transpose());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  const Vector normal = solver.eigenvectors().col(0);
  plane.normal = normal.dot(plane.normal) < 0. ? Vector(-normal) : normal;
  plane.offset = plane.normal.dot(from + to) / 2.;
}

inline void refine(const Sampled_surface& surface, const std::vector<Surface_sample>& samples,
                   const int rounds, Mirror_plane& plane)
{
  for (int round = 0; round < rounds; ++round)
  {
    const Point_pairs pairs = closest_pairs(surface, samples, plane);
    if (pairs.size() < samples.size() / 3) return;
    const Mirror_plane before = plane;
    fit(pairs, plane);
    const double moved = (plane.normal - before.normal).norm() +
                         std::abs(plane.offset - before.offset) / surface.extent();
    if (moved < 1e-4) return;
  }
}

/// The principal axes, rings about each of them, and a hemisphere.
inline std::vector<Vector> directions(const Sampled_surface& surface)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr int on_ring = 18, on_hemisphere = 160;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Surface_sample& s : surface.samples())
    moments += (s.position - surface.center()) * (s.position - surface.center()).transpose();
  const Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors();
  std::vector<Vector> result;
  for (int axis = 0; axis < 3; ++axis) // the first of each ring is an axis
    for (int k = 0; k < on_ring; ++k)
    {
      const double angle = k * pi / on_ring;
      result.push_back(std::cos(angle) * axes.col(axis) +
                       std::sin(angle) * axes.col((axis + 1) % 3));
    }
  for (int k = 0; k < on_hemisphere; ++k)
  {
    const double z = (k + 0.5) / on_hemisphere, r = std::sqrt(1. - z * z);
    const double angle = k * pi * (3. - std::sqrt(5.));
    result.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return result;
}

/// The best planes through the center, none about the same as another.
inline std::vector<Mirror_plane> coarse_planes(const Sampled_surface& surface)
{
  constexpr std::size_t samples = 120, most_planes = 8;
  constexpr double hopeless = 0.1, about_the_same = 0.95;
  const std::vector<Surface_sample> few = some_samples(surface, samples);
  std::vector<Mirror_plane> planes;
  for (const Vector& direction : directions(surface))
  {
    Mirror_plane plane;
    plane.normal = direction;
    plane.offset = direction.dot(surface.center());
    measure(surface, few, hopeless, plane);
    if (plane.residual <= hopeless) planes.push_back(plane);
  }
  const auto better = [](const auto& a, const auto& b) { return a.residual < b.residual; };
  std::stable_sort(planes.begin(), planes.end(), better);
  std::vector<Mirror_plane> best;
  for (const Mirror_plane& plane : planes)
  {
    const auto same = [&](const Mirror_plane& other)
    { return std::abs(other.normal.dot(plane.normal)) > about_the_same; };
    if (best.size() < most_planes && std::none_of(best.begin(), best.end(), same))
      best.push_back(plane);
  }
  return best;
}

} // namespace internal

/// returns the plane of reflection that fits best, if one fits.
inline std::optional<Mirror_plane> find_mirror_plane(const Sampled_surface& surface,
                                                     const Mirror_limits& limits = {})
{
  const auto some = internal::some_samples(surface, 400);
  const auto many = internal::some_samples(surface, 2000);
  std::optional<Mirror_plane> best;
  for (Mirror_plane plane : internal::coarse_planes(surface))
  {
    internal::refine(surface, some, 6, plane);
    internal::measure(surface, some, 3. * limits.residual, plane);
    if (plane.residual > 3. * limits.residual) continue;
    internal::refine(surface, some, 14, plane);
    internal::measure(surface, many, limits.residual, plane);
    if (plane.residual > limits.residual || plane.agreement < limits.agreement) continue;
    if (!best || plane.residual < best->residual) best = plane;
  }
  return best;
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_MIRROR_PLANE_H
