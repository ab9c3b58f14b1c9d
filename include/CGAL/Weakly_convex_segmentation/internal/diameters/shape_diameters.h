// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DIAMETERS_SHAPE_DIAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DIAMETERS_SHAPE_DIAMETERS_H

// Shape diameters (section 5, "Merging by volumetric signature"): of a component's own points, as in
// the paper, or through the whole shape.
//
// The paper's alpha is read as the full opening of the cone, its lengths "weighted by the cosine" as multiplied.
// With half of the cone, or a median weighted by the cosine, the `paper` preset has the same 1 - RI, 0.140.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/diameters/Diameter_histogram.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Patch_visibility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// rays of a point for the diameter through the whole shape
constexpr std::size_t diameter_rays = 10;
/// points with such a diameter, spread over the shape
constexpr std::size_t number_of_diameters = 2000;

/// A point with the diameter of the shape there; 0 if there is none. The points that it faces along
/// its normal, across the volume and across the space outside, show walls and cavities.
struct Diameter_sample
{
  Index point;
  float diameter;
  Ray_hit inwards = {};
  Ray_hit outwards = {};
};

/// returns the median of `values` of (length, weight), 0 if there are none.
inline float weighted_median(std::vector<std::pair<float, float>>& values)
{
  std::sort(values.begin(), values.end());
  float total = 0.f, sum = 0.f;
  for (const auto& v : values) total += v.second;
  for (const auto& v : values)
  {
    sum += v.second;
    if (2.f * sum >= total) return v.first;
  }
  return 0.f;
}

/// returns the lower median of `values`, 0 if there are none.
inline float median(std::vector<float>& values)
{
  if (values.empty()) return 0.f;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// returns unit vectors in a cone about the unit vector `axis`, evenly spread (a sunflower).
inline void cone_directions(const Vector3& axis, const float half_angle, const std::size_t count,
                            std::vector<Vector3>& directions)
{
  const Vector3 helper = std::abs(axis.x) < 0.6f ? Vector3{1.f, 0.f, 0.f} : Vector3{0.f, 1.f, 0.f};
  const Vector3 u = normalized(cross(axis, helper)), v = cross(axis, u);
  constexpr float golden_angle = 2.39996323f;
  directions.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float tilt = half_angle * std::sqrt(share), turn = golden_angle * static_cast<float>(i);
    directions.push_back(std::cos(tilt) * axis + (std::sin(tilt) * std::cos(turn)) * u +
                         (std::sin(tilt) * std::sin(turn)) * v);
  }
}

/// measures the diameter through the whole shape at a point; 0 if no ray leaves it.
///
/// Rays start inwards in a cone about the reversed normal and end where they first leave the shape;
/// their median, weighted by the cosine, is the diameter.
inline float cone_diameter(const Line_of_sight_query& sight, const Index i,
                           const Diameter_parameters& parameters)
{
  const Oriented_points& points = sight.points();
  const Vector3 inwards = -1.f * points.normals[i];
  std::vector<Vector3> directions;
  std::vector<std::pair<float, float>> lengths;
  cone_directions(inwards, radians(0.5 * parameters.diameter_cone_angle), diameter_rays,
                  directions);
  for (const Vector3& d : directions)
  {
    const Ray_hit exit = sight.exit(i, d);
    if (exit.found()) lengths.push_back({exit.distance, dot(d, inwards)});
  }
  return weighted_median(lengths);
}

/// samples a bounded number of points over the whole shape: what they face, and the diameters, but with
/// `Diameter_rule::GIVEN`, when they come from elsewhere.
inline std::vector<Diameter_sample> shape_diameters(const Line_of_sight_query& sight,
                                                    const Diameter_parameters& parameters,
                                                    const bool parallel)
{
  const Oriented_points& points = sight.points();
  const std::size_t count = (std::min)(points.size(), number_of_diameters);
  const bool is_given = parameters.diameter == Diameter_rule::GIVEN;
  std::vector<Diameter_sample> samples(count);
  parallel_for(
      count, parallel,
      [&](const std::size_t s)
      {
        const Index i = static_cast<Index>((2 * s + 1) * points.size() / (2 * count));
        const Vector3& n = points.normals[i];
        samples[s] = {i, is_given ? 0.f : cone_diameter(sight, i, parameters),
                      sight.exit(i, -1.f * n), sight.entry(i, n)};
      },
      64);
  return samples;
}

/// measures the diameters of a component from its own points only, as the paper does: the median of the lengths
/// to the points in a cone about the reversed normal, each times the cosine of its angle; at
/// max(100, 0.1 |C|) points spread over the component.
inline std::vector<Diameter_sample> own_diameters(const Oriented_points& points,
                                                  const std::vector<Index>& component,
                                                  const Diameter_parameters& parameters,
                                                  const bool parallel)
{
  const std::size_t wanted = (std::max)(std::size_t(100), component.size() / 10);
  const std::vector<Index> sample = spread_sample(component, wanted);
  const float lowest = std::cos(radians(0.5 * parameters.diameter_cone_angle));
  std::vector<Diameter_sample> samples(sample.size());
  parallel_for(
      sample.size(), parallel,
      [&](const std::size_t s)
      {
        const Index u = sample[s];
        std::vector<float> lengths;
        for (const Index v : component)
        {
          const Vector3 ray = points.positions[v] - points.positions[u];
          const float along = -dot(points.normals[u], ray);
          if (along > 0.f && along * along >= lowest * lowest * squared_length(ray))
            lengths.push_back(along);
        }
        samples[s] = {u, median(lengths), {}, {}};
      },
      16);
  return samples;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DIAMETERS_SHAPE_DIAMETERS_H
