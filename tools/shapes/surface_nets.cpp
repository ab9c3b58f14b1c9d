// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/surface_nets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace Shape_generator {
namespace internal {

Distance_grid::Distance_grid(const Implicit_shape& shape, double cell_size, const Point& shift)
  : m_cell_size(cell_size)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double extent = shape.box().upper[a] - shape.box().lower[a];
    m_size[a] = static_cast<std::size_t>(std::ceil(extent / cell_size)) + 5;
    const double slack = double(m_size[a] - 1) * cell_size - extent;
    m_origin[a] = shape.box().lower[a] - slack / 2 + (shift[a] - 0.5) * cell_size;
    m_stride[a] = a == 0 ? 1 : m_stride[a - 1] * m_size[a - 1];
  }
  m_values.resize(m_size[0] * m_size[1] * m_size[2]);
  fill(shape);
}

std::array<std::size_t, 3> Distance_grid::coordinates(std::size_t i) const
{
  return {i % m_size[0], i / m_stride[1] % m_size[1], i / m_stride[2]};
}

Point Distance_grid::position(std::size_t i) const
{
  const std::array<std::size_t, 3> c = coordinates(i);
  return {m_origin[0] + double(c[0]) * m_cell_size, m_origin[1] + double(c[1]) * m_cell_size,
          m_origin[2] + double(c[2]) * m_cell_size};
}

std::size_t Distance_grid::corner(std::size_t cell, unsigned corner_bits) const
{
  return cell + (corner_bits & 1) * m_stride[0] + (corner_bits >> 1 & 1) * m_stride[1] +
         (corner_bits >> 2 & 1) * m_stride[2];
}

void Distance_grid::fill(const Implicit_shape& shape)
{
  constexpr std::size_t block = 4;
  const double radius = m_cell_size * double(block - 1) / 2 * std::sqrt(3.) * 1.05;
  for (std::size_t z = 0; z < m_size[2]; z += block)
    for (std::size_t y = 0; y < m_size[1]; y += block)
      for (std::size_t x = 0; x < m_size[0]; x += block)
      {
        const double half = m_cell_size * double(block - 1) / 2;
        const std::size_t first = x + y * m_stride[1] + z * m_stride[2];
        const double d = shape.distance(add(position(first), {half, half, half}));
        for (std::size_t k = z; k < (std::min)(z + block, m_size[2]); ++k)
          for (std::size_t j = y; j < (std::min)(y + block, m_size[1]); ++j)
            for (std::size_t i = x; i < (std::min)(x + block, m_size[0]); ++i)
            {
              const std::size_t p = i + j * m_stride[1] + k * m_stride[2];
              m_values[p] = std::abs(d) > radius ? d : shape.distance(position(p));
            }
      }
}

namespace {

// The edge of a cell on `axis` whose offsets on the two next axes (cyclically) are b and c.
std::size_t cell_edge(std::size_t axis, unsigned b, unsigned c) { return 4 * axis + b + 2 * c; }

// The edge between two corners of a cell that differ in one bit.
std::size_t cell_edge_between(unsigned corner_1, unsigned corner_2)
{
  const unsigned difference = corner_1 ^ corner_2;
  const std::size_t axis = difference == 1 ? 0 : difference == 2 ? 1 : 2;
  return cell_edge(axis, corner_1 >> (axis + 1) % 3 & 1, corner_1 >> (axis + 2) % 3 & 1);
}

// For each of the twelve edges of a cell a number that is the same for the edges that cross the
// same patch of the surface. On a face of the cell with four crossings, the two inner corners are
// cut off from each other; the cell on the other side of the face decides likewise.
std::array<std::size_t, 12> patches_of_cell(const Distance_grid& grid, std::size_t cell)
{
  std::array<std::size_t, 12> patch;
  for (std::size_t e = 0; e < 12; ++e) patch[e] = e;
  const auto join = [&patch](std::size_t e, std::size_t f)
  {
    const std::size_t from = patch[e], to = patch[f];
    std::replace(patch.begin(), patch.end(), from, to);
  };
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned side = 0; side < 2; ++side)
    {
      const unsigned b = 1u << (axis + 1) % 3, c = 1u << (axis + 2) % 3, base = side << axis;
      const std::array<unsigned, 4> corners = {base, base | b, base | b | c, base | c};
      std::array<bool, 4> inside;
      std::vector<std::size_t> crossings;
      for (std::size_t i = 0; i < 4; ++i) inside[i] = grid.is_inside(grid.corner(cell, corners[i]));
      for (std::size_t i = 0; i < 4; ++i)
        if (inside[i] != inside[(i + 1) % 4])
          crossings.push_back(cell_edge_between(corners[i], corners[(i + 1) % 4]));
      if (crossings.size() == 2) join(crossings[0], crossings[1]);
      if (crossings.size() == 4)
      {
        // Crossing i is between the corners i and i+1.
        const std::size_t first_inside = inside[0] ? 0 : 1;
        join(crossings[first_inside], crossings[(first_inside + 3) % 4]);
        join(crossings[first_inside + 1], crossings[(first_inside + 2) % 4]);
      }
    }
  return patch;
}

// Point of the grid edge from i on `axis` that is on the surface.
Point crossing_point(const Implicit_shape& shape, const Distance_grid& grid, std::size_t i,
                     std::size_t axis)
{
  const Point start = grid.position(i);
  double inner = 0, outer = 1;
  if (!grid.is_inside(i)) std::swap(inner, outer);
  const auto at = [&](double t)
  {
    Point p = start;
    p[axis] += t * grid.cell_size();
    return p;
  };
  // Near sharp edges the distance is not linear, so bisect instead of interpolating.
  for (int step = 0; step < 30 && shape.is_sharp(); ++step)
  {
    const double middle = (inner + outer) / 2;
    (shape.distance(at(middle)) < 0 ? inner : outer) = middle;
  }
  if (shape.is_sharp()) return at((inner + outer) / 2);
  const double a = grid.value(i), b = grid.value(i + grid.stride(axis));
  return at(a / (a - b));
}

// The point where the tangent planes at the crossings meet; of several such points the one nearest
// to the center of the crossings.
Point meet_tangent_planes(const std::vector<Point>& crossings, const std::vector<Point>& normals,
                          const Point& center)
{
  Point result = center;
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    Point move = {0, 0, 0};
    for (std::size_t i = 0; i < crossings.size(); ++i)
      move = add(move, scale(normals[i], dot(normals[i], subtract(crossings[i], result))));
    result = add(result, scale(move, 1. / double(crossings.size())));
  }
  return result;
}

// The direction of the sharp edge between faces of the given normals, or zero if they make a
// corner.
Point crease_direction(const std::vector<Point>& normals)
{
  Point result = {0, 0, 0};
  for (const Point& n : normals)
  {
    const Point candidate = cross(normals[0], n);
    if (dot(candidate, candidate) > dot(result, result)) result = candidate;
  }
  result = normalized(result);
  for (const Point& n : normals)
    if (std::abs(dot(result, n)) > 0.2) return {0, 0, 0};
  return result;
}

// Appends the vertex of one patch of a cell. On sharp shapes it goes to the edge or corner that
// the normals reveal.
void add_patch_vertex(const Implicit_shape& shape, const Distance_grid& grid, std::size_t cell,
                      const std::vector<Point>& crossings, Quad_mesh& mesh)
{
  Point center = {0, 0, 0};
  for (const Point& p : crossings) center = add(center, scale(p, 1. / double(crossings.size())));
  std::vector<Point> normals;
  double flatness = 1;
  for (std::size_t i = 0; i < crossings.size() && shape.is_sharp(); ++i)
  {
    normals.push_back(normalized(shape.gradient(crossings[i])));
    for (const Point& n : normals) flatness = (std::min)(flatness, dot(n, normals.back()));
  }
  if (flatness < 0.8)
  {
    center = meet_tangent_planes(crossings, normals, center);
    const Point lower = grid.position(cell);
    for (std::size_t a = 0; a < 3; ++a)
      center[a] = (std::max)(lower[a], (std::min)(lower[a] + grid.cell_size(), center[a]));
  }
  mesh.points.push_back(center);
  mesh.fixed.push_back(flatness < 0.8);
  mesh.creases.push_back(flatness < 0.8 ? crease_direction(normals) : Point{0, 0, 0});
}

// Vertices of all cells: for each cell that the surface crosses the vertex of each of its edges.
class Cell_vertices
{
public:
  Cell_vertices(const Implicit_shape& shape, const Distance_grid& grid, Quad_mesh& mesh)
    : m_index(grid.number_of_points(), 0), m_vertices(1)
  {
    grid.for_each_crossing(
        [&](std::size_t i, std::size_t axis)
        {
          for (unsigned bits = 0; bits < 4; ++bits)
            add_cell(shape, grid, cell_at(grid, i, axis, bits & 1, bits >> 1), mesh);
        });
  }

  // The cell in which the grid edge from i on `axis` has the offsets b and c.
  static std::size_t cell_at(const Distance_grid& grid, std::size_t i, std::size_t axis, unsigned b,
                             unsigned c)
  {
    return i - b * grid.stride((axis + 1) % 3) - c * grid.stride((axis + 2) % 3);
  }

  std::size_t vertex(const Distance_grid& grid, std::size_t i, std::size_t axis, unsigned b,
                     unsigned c) const
  {
    return m_vertices[m_index[cell_at(grid, i, axis, b, c)]][cell_edge(axis, b, c)];
  }

private:
  void add_cell(const Implicit_shape& shape, const Distance_grid& grid, std::size_t cell,
                Quad_mesh& mesh)
  {
    if (m_index[cell] != 0) return;
    m_index[cell] = m_vertices.size();
    m_vertices.emplace_back();
    const std::array<std::size_t, 12> patch = patches_of_cell(grid, cell);
    std::array<std::vector<Point>, 12> crossings;
    for (unsigned corner = 0; corner < 8; ++corner)
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        const unsigned other = corner | 1u << axis;
        const std::size_t from = grid.corner(cell, corner), to = grid.corner(cell, other);
        if (corner != other && grid.is_inside(from) != grid.is_inside(to))
          crossings[patch[cell_edge_between(corner, other)]].push_back(
              crossing_point(shape, grid, from, axis));
      }
    std::array<std::size_t, 12> vertex_of_patch = {};
    for (std::size_t p = 0; p < 12; ++p)
      if (!crossings[p].empty())
      {
        vertex_of_patch[p] = mesh.points.size();
        add_patch_vertex(shape, grid, cell, crossings[p], mesh);
      }
    for (std::size_t e = 0; e < 12; ++e) m_vertices.back()[e] = vertex_of_patch[patch[e]];
  }

  std::vector<std::size_t> m_index; // 0 for cells that have no vertices
  std::vector<std::array<std::size_t, 12>> m_vertices;
};

} // namespace

Quad_mesh surface_net(const Implicit_shape& shape, const Distance_grid& grid)
{
  Quad_mesh mesh;
  const Cell_vertices cells(shape, grid, mesh);
  grid.for_each_crossing(
      [&](std::size_t i, std::size_t axis)
      {
        // Counterclockwise as seen from the far end of the edge.
        std::array<std::size_t, 4> quad = {
            cells.vertex(grid, i, axis, 1, 1), cells.vertex(grid, i, axis, 0, 1),
            cells.vertex(grid, i, axis, 0, 0), cells.vertex(grid, i, axis, 1, 0)};
        if (!grid.is_inside(i)) std::swap(quad[1], quad[3]);
        mesh.quads.push_back(quad);
      });
  return mesh;
}

} // namespace internal
} // namespace Shape_generator
