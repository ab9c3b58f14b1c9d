// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/part_hulls.h"

#include "io/separate_parts.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cstddef>
#include <map>
#include <vector>

namespace Shape_io {

namespace {

// Whether all points lie in one plane, exactly.
bool is_flat(const std::vector<Point>& points)
{
  std::size_t second = 1, third;
  while (second < points.size() && points[second] == points[0]) ++second;
  third = second + 1;
  while (third < points.size() && CGAL::collinear(points[0], points[second], points[third]))
    ++third;
  for (std::size_t i = third + 1; i < points.size(); ++i)
    if (!CGAL::coplanar(points[0], points[second], points[third], points[i])) return false;
  return true;
}

void add_hull(const std::vector<Point>& points, const int label, Part_hulls& hulls)
{
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  std::map<CGAL::SM_Vertex_index, std::size_t> index;
  for (const auto v : hull.vertices())
  {
    index[v] = hulls.shape.points.size();
    hulls.shape.points.push_back(hull.point(v));
  }
  for (const auto f : hull.faces())
  {
    hulls.shape.polygons.emplace_back();
    for (const auto v : hull.vertices_around_face(hull.halfedge(f)))
      hulls.shape.polygons.back().push_back(index[v]);
    hulls.labels.push_back(label);
  }
}

} // namespace

Part_hulls part_hulls(const Shape& shape, const std::vector<int>& labels,
                      const std::size_t number_of_parts)
{
  Part_hulls hulls;
  const auto elements = elements_of_parts(labels, number_of_parts);
  for (std::size_t label = 0; label < number_of_parts; ++label)
  {
    const std::vector<Point> points = shape_of_elements(shape, elements[label]).points;
    if (is_flat(points))
      hulls.flat_parts.push_back(static_cast<int>(label));
    else
      add_hull(points, static_cast<int>(label), hulls);
  }
  return hulls;
}

} // namespace Shape_io
