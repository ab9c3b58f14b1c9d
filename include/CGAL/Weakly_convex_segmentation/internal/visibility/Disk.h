// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_H

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <cmath>
#include <limits>

// Points as oriented disks and lines between them (section 3, "Weakly-convex parts").

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A point's share of the surface.
struct Disk
{
  Vector3 center;
  Vector3 normal; ///< unit length
  float radius;
};

/// A segment between two points of the shape.
struct Line_of_sight
{
  Vector3 source;
  Vector3 direction;  ///< target - source, not normalized
  Vector3 reciprocal; ///< componentwise 1 / direction
  float limit = 1.f;  ///< only the part up to source + limit * direction counts

  Line_of_sight(const Vector3& from, const Vector3& to) : source(from), direction(to - from)
  {
    // a huge finite number instead of infinity keeps 0 * inf = NaN out of the slab test
    const auto inverse = [](const float d)
    { return std::abs(d) > 1e-20f ? 1.f / d : (d < 0.f ? -1e20f : 1e20f); };
    reciprocal = {inverse(direction.x), inverse(direction.y), inverse(direction.z)};
  }
};

/// returns where the line crosses the disk, as a factor of its direction; infinity if it does not, or
/// if the disk's center is within `clearance` radii of an end: the ends lie on the surface, and disks
/// there would hide every point behind its own neighborhood. Nor does a line count that grazes the
/// disk: the sine of the angle between them is under `least_sine`.
inline float crossing(const Line_of_sight& line, const Disk& disk, const float clearance,
                      const float least_sine = 0.f)
{
  constexpr float none = (std::numeric_limits<float>::max)();
  const float slope = dot(disk.normal, line.direction);
  if (slope == 0.f) return none;
  if (slope * slope < least_sine * least_sine * squared_length(line.direction)) return none;
  const Vector3 to_center = disk.center - line.source;
  const float t = dot(disk.normal, to_center) / slope;
  if (!(t > 0.f && t < line.limit)) return none;
  const float r2 = disk.radius * disk.radius;
  if (squared_length(t * line.direction - to_center) > r2) return none;
  const float cleared = clearance * clearance * r2;
  if (squared_length(to_center) < cleared) return none;
  if (squared_length(to_center - line.direction) < cleared) return none;
  return t;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_H
