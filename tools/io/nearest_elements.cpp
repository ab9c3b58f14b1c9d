// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/nearest_elements.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>

#include <cstddef>
#include <numeric>
#include <vector>

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

namespace Shape_io {

namespace {

// The place of an element: the point, or the mean of the corners of a face.
Point element_position(const Shape& shape, const std::size_t i)
{
  if (!shape.is_mesh()) return shape.points[i];
  const double n = static_cast<double>(shape.polygons[i].size());
  double x = 0., y = 0., z = 0.;
  for (const std::size_t corner : shape.polygons[i])
  {
    x += shape.points[corner].x() / n;
    y += shape.points[corner].y() / n;
    z += shape.points[corner].z() / n;
  }
  return Point(x, y, z);
}

// Nearest by distance to the triangles of the faces, those of no area left out.
class Nearest_face
{
  using Plain = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Plain::Triangle_3>;
#if CGAL_VERSION_NR >= 1060000000 // which warns of the names of before
  using Primitive = CGAL::AABB_triangle_primitive_3<Plain, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits_3<Plain, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Plain, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits<Plain, Primitive>;
#endif

public:
  explicit Nearest_face(const Shape& shape)
  {
    const auto plain = [&](const std::size_t corner)
    {
      const Point& p = shape.points[corner];
      return Plain::Point_3(p.x(), p.y(), p.z());
    };
    for (std::size_t f = 0; f < shape.polygons.size(); ++f)
    {
      const auto& corners = shape.polygons[f];
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      {
        const Plain::Triangle_3 t(plain(corners[0]), plain(corners[i]), plain(corners[i + 1]));
        if (!(t.squared_area() > 0.)) continue;
        m_triangles.push_back(t);
        m_faces.push_back(f);
      }
    }
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.build();
  }

  bool is_empty() const { return m_triangles.empty(); }
  std::size_t operator()(const Point& p) const
  {
    const Plain::Point_3 query(p.x(), p.y(), p.z());
    const auto nearest = m_tree.closest_point_and_primitive(query).second;
    return m_faces[static_cast<std::size_t>(nearest - m_triangles.cbegin())];
  }

private:
  Triangles m_triangles;
  std::vector<std::size_t> m_faces; // of each triangle
  CGAL::AABB_tree<Traits> m_tree;
};

// Nearest by distance to the points, of the nearest few the first whose normal does not point away: the
// other side of a thin wall may be nearer.
class Nearest_point
{
  using Map = CGAL::Pointer_property_map<Point>::const_type;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

public:
  Nearest_point(const std::vector<Point>& points, const std::vector<Vector>& normals)
    : m_normals(normals), m_map(CGAL::make_property_map(points)), m_tree(splitter(), Traits(m_map))
  {
    std::vector<std::size_t> indices(points.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    m_tree.insert(indices.begin(), indices.end());
    m_tree.build();
  }

  std::size_t operator()(const Point& p, const Vector& normal) const
  {
    const bool uses_normals = !m_normals.empty() && normal != CGAL::NULL_VECTOR;
    const Search search(m_tree, p, uses_normals ? 8u : 1u, 0., true, distance());
    for (const auto& hit : search)
      if (!uses_normals || m_normals[hit.first] * normal > 0.) return hit.first;
    return search.begin()->first;
  }

private:
  static typename Search::Splitter splitter() { return typename Search::Splitter(10); }
  typename Search::Distance distance() const { return typename Search::Distance(m_map); }

  const std::vector<Vector>& m_normals;
  Map m_map;
  typename Search::Tree m_tree;
};

} // namespace

std::vector<std::size_t> nearest_elements(const Shape& from, const Shape& to)
{
  std::vector<std::size_t> result(to.number_of_elements(), no_element);
  const auto fill = [&](const auto& nearest)
  {
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      const Point p = element_position(to, i);
      if (!is_gap(to, p)) result[i] = nearest(p, i);
    }
  };
  if (from.is_mesh())
  {
    const Nearest_face nearest(from);
    if (!nearest.is_empty())
    {
      fill([&](const Point& p, std::size_t) { return nearest(p); });
      return result;
    }
  }
  std::vector<Point> positions;
  for (std::size_t i = 0; i < from.number_of_elements(); ++i)
    positions.push_back(element_position(from, i));
  const std::vector<Vector> no_normals;
  const Nearest_point nearest(positions, from.is_mesh() ? no_normals : from.normals);
  const bool has_normals = !to.is_mesh() && !to.normals.empty();
  fill([&](const Point& p, const std::size_t i)
       { return nearest(p, has_normals ? to.normals[i] : Vector(CGAL::NULL_VECTOR)); });
  return result;
}

} // namespace Shape_io
