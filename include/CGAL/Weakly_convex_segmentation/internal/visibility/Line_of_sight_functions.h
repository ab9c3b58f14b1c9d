// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_LINE_OF_SIGHT_FUNCTIONS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_LINE_OF_SIGHT_FUNCTIONS_H

// A line of sight of the caller's own, in place of the disks: the core knows no kernel.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <CGAL/number_utils.h>

#include <functional>
#include <memory>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Any model of `WeaklyConvexSegmentationLineOfSight`, in coordinates of the input. A ray costs a call.
struct Line_of_sight_functions
{
  std::function<bool(const Coordinates&, const Coordinates&)> sees;
  std::function<double(const Coordinates&, const Coordinates&)> distance_to_exit, distance_to_entry;

  Line_of_sight_functions() = default; ///< none
  template <typename Model>
  explicit Line_of_sight_functions(const Model& line_of_sight)
  {
    using Point = typename Model::Point_3;
    using Vector = typename Model::Vector_3;
    const auto model = std::make_shared<const Model>(line_of_sight); // may be large
    const auto point = [](const Coordinates& p) { return Point(p[0], p[1], p[2]); };
    const auto vector = [](const Coordinates& v) { return Vector(v[0], v[1], v[2]); };
    sees = [=](const Coordinates& p, const Coordinates& q)
    { return model->sees(point(p), point(q)); };
    distance_to_exit = [=](const Coordinates& p, const Coordinates& d)
    { return CGAL::to_double(model->distance_to_exit(point(p), vector(d))); };
    distance_to_entry = [=](const Coordinates& p, const Coordinates& d)
    { return CGAL::to_double(model->distance_to_entry(point(p), vector(d))); };
  }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_LINE_OF_SIGHT_FUNCTIONS_H
