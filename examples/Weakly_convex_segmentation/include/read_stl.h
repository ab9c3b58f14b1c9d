// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_IO_READ_STL_H
#define SHAPE_IO_READ_STL_H

#include "byte_stream.h"
#include "shape.h"

#include <CGAL/IO/STL.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// STL, ASCII and binary. Equal corners become one point.

namespace Shape_io {
namespace internal {

// CGAL's STL reader finds the corners that triangles share by looking points up in a map. This type
// has an order for NaN too, so that such a point is not taken for another but found and refused.
struct Stl_point : std::array<double, 3>
{
  friend bool operator<(const Stl_point& a, const Stl_point& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (std::isnan(a[i]) != std::isnan(b[i])) return std::isnan(b[i]);
      if (a[i] < b[i] || b[i] < a[i]) return a[i] < b[i];
    }
    return false;
  }
};

inline void read_stl(const std::string& bytes, Shape& shape)
{
  Byte_stream stream(bytes.data(), bytes.size());
  std::vector<Stl_point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  refuse_unless(CGAL::IO::read_STL(stream, points, triangles), "STL");
  for (const Stl_point& p : points) shape.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& t : triangles) shape.polygons.emplace_back(t.begin(), t.end());
}

} // namespace internal
} // namespace Shape_io

#endif // SHAPE_IO_READ_STL_H
