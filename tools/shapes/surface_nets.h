// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SURFACE_NETS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SURFACE_NETS_H

#include "shapes/implicit_shape.h"

#include <array>
#include <cstddef>
#include <vector>

// Polygonisation of an implicit shape by dual surface nets. A grid cell gets one vertex for each
// patch of the surface in it (not one for the whole cell), so that sheets that come close to each
// other do not grow together.

namespace Shape_generator {
namespace internal {

struct Quad_mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4>> quads;
  std::vector<bool> fixed;    // vertices on sharp edges and corners
  std::vector<Point> creases; // for fixed vertices the direction of the edge, zero for a corner
};

// The signed distance at the points of a regular grid that surrounds the shape.
class Distance_grid
{
public:
  // `shift`, in cells, moves the grid against the shape.
  Distance_grid(const Implicit_shape& shape, double cell_size, const Point& shift);

  double cell_size() const { return m_cell_size; }
  std::size_t size(std::size_t axis) const { return m_size[axis]; }
  std::size_t stride(std::size_t axis) const { return m_stride[axis]; }
  std::size_t number_of_points() const { return m_values.size(); }
  bool is_inside(std::size_t i) const { return m_values[i] < 0; }
  double value(std::size_t i) const { return m_values[i]; }

  std::array<std::size_t, 3> coordinates(std::size_t i) const;

  Point position(std::size_t i) const;

  // Index of a corner of the cell whose lowest corner is `cell`; bit a of `corner` is its offset
  // on axis a.
  std::size_t corner(std::size_t cell, unsigned corner_bits) const;

  // Calls f(i, axis) for each grid edge that crosses the surface.
  template <class Function>
  void for_each_crossing(const Function& f) const
  {
    for (std::size_t i = 0; i < m_values.size(); ++i)
    {
      // The outermost layers are outside: no edge leaves the grid from an inner point.
      const std::array<std::size_t, 3> c = coordinates(i);
      for (std::size_t a = 0; a < 3; ++a)
        if (c[a] + 1 < m_size[a] && is_inside(i) != is_inside(i + m_stride[a])) f(i, a);
    }
  }

private:
  // A distance changes by no more than the way walked, so one value tells the sign of a whole
  // block of points that is far from the surface.
  void fill(const Implicit_shape& shape);

  double m_cell_size;
  Point m_origin;
  std::array<std::size_t, 3> m_size, m_stride;
  std::vector<double> m_values;
};

Quad_mesh surface_net(const Implicit_shape& shape, const Distance_grid& grid);

} // namespace internal
} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_SURFACE_NETS_H
