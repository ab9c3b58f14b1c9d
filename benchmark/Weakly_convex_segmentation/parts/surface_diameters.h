// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_SURFACE_DIAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_SURFACE_DIAMETERS_H

#include "parts/Sampled_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

// How thick a shape is below points of its surface, by rays through it to its other side.

namespace Part_measures {

/// The thickness below a point; the order of the samples.
struct Diameter_sample
{
  Vector position;
  std::size_t face;
  double diameter;
};

/// the median, 0 of nothing
inline double median(std::vector<double> values)
{
  if (values.empty()) return 0.;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// returns the median length of rays inwards, straight and in a cone, or none where they leave the shape.
inline std::optional<double> diameter_below(const Sampled_surface& surface, const Vector& position,
                                            const std::size_t face)
{
  constexpr double slope = 0.5; // of the cone, about 27 degrees
  const Vector inwards = -surface.normal(face);
  if (inwards.isZero()) return std::nullopt;
  const Vector side = inwards.unitOrthogonal(), other = inwards.cross(side);
  const std::array<Vector, 5> rays{inwards, inwards + slope * side, inwards - slope * side,
                                   inwards + slope * other, inwards - slope * other};
  std::vector<double> lengths;
  for (const Vector& ray : rays)
    if (const auto length = surface.distance_along(position, ray, face)) lengths.push_back(*length);
  if (lengths.size() < 3) return std::nullopt;
  return median(std::move(lengths));
}

/// measures every second sample of the surface.
inline std::vector<Diameter_sample> sample_diameters(const Sampled_surface& surface)
{
  std::vector<Diameter_sample> diameters;
  const std::vector<Surface_sample>& samples = surface.samples();
  for (std::size_t i = 0; i < samples.size(); i += 2)
    if (const auto d = diameter_below(surface, samples[i].position, samples[i].face))
      diameters.push_back({samples[i].position, samples[i].face, *d});
  return diameters;
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_SURFACE_DIAMETERS_H
