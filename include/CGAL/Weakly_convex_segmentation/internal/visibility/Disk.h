// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_H

// Points as oriented disks and lines between them (section 3, "Weakly-convex parts").

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <cmath>

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

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_H
