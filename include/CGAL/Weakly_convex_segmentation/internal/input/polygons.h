// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_POLYGONS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_POLYGONS_H

// The faces of a mesh as the method sees them: one point each (section 6), and their corners.

#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

inline Coordinates operator-(const Coordinates& a, const Coordinates& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double dot(const Coordinates& a, const Coordinates& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Coordinates& a) { return std::hypot(a[0], a[1], a[2]); }

inline double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

/// returns the distance of two boxes.
inline double gap(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b)
{
  Coordinates between;
  for (int c = 0; c < 3; ++c)
    between[c] = (std::max)({0., a.min(c) - b.max(c), b.min(c) - a.max(c)});
  return length(between);
}

/// returns the normal of a polygon, as long as twice its area; of a triangle the same to the last bit from any corner
/// on, and its opposite if it is turned over.
inline Coordinates area_vector(const std::vector<Coordinates>& polygon)
{
  const Coordinates origin = *std::min_element(polygon.begin(), polygon.end());
  Coordinates normal = {0., 0., 0.};
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Coordinates share =
        cross(polygon[i] - origin, polygon[(i + 1) % polygon.size()] - origin);
    for (int c = 0; c < 3; ++c) normal[c] += share[c];
  }
  return normal;
}

/// returns the mean of the corners, the same to the last bit in any order.
inline Coordinates centroid_of(std::vector<Coordinates> polygon)
{
  std::sort(polygon.begin(), polygon.end());
  Coordinates centroid = {0., 0., 0.};
  for (const Coordinates& corner : polygon)
    for (int c = 0; c < 3; ++c) centroid[c] += corner[c] / static_cast<double>(polygon.size());
  return centroid;
}

/// makes room for so many polygons, most of them triangles.
inline void reserve_polygons(const std::size_t count, Raw_shape& raw)
{
  raw.positions.reserve(count);
  raw.normals.reserve(count);
  raw.first_corner.reserve(count + 1);
  raw.corners.reserve(3 * count);
}

/// adds centroid, area vector and corners of a polygon.
inline void add_polygon(const std::vector<Coordinates>& polygon, Raw_shape& raw)
{
  raw.positions.push_back(centroid_of(polygon));
  raw.normals.push_back(area_vector(polygon));
  if (raw.first_corner.empty()) raw.first_corner.push_back(0);
  raw.corners.insert(raw.corners.end(), polygon.begin(), polygon.end());
  raw.first_corner.push_back(raw.corners.size());
}

/// adds the polygons again, about of size 1, if their coordinates are of an unusual magnitude.
inline void scale_polygons(Raw_shape& raw)
{
  raw.exponent = unusual_exponent(raw.corners);
  if (raw.exponent == 0) return;
  const std::vector<Coordinates> corners = std::move(raw.corners);
  const std::vector<std::size_t> first = std::move(raw.first_corner);
  raw.positions.clear(), raw.normals.clear(), raw.corners.clear(), raw.first_corner.clear();
  std::vector<Coordinates> polygon;
  for (std::size_t f = 0; f + 1 < first.size(); ++f)
  {
    polygon.clear();
    for (std::size_t i = first[f]; i < first[f + 1]; ++i)
      polygon.push_back(scaled(corners[i], -raw.exponent));
    add_polygon(polygon, raw);
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_POLYGONS_H
