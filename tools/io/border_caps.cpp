// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/border_caps.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/centroid.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Shape_io {

namespace {

// Twice the area, along the normal.
Vector area_vector(const std::vector<Point>& points, const Loop& loop)
{
  Vector sum = CGAL::NULL_VECTOR;
  for (std::size_t i = 2; i < loop.size(); ++i)
    sum = sum + CGAL::cross_product(points[loop[i - 1]] - points[loop[0]],
                                    points[loop[i]] - points[loop[0]]);
  return sum;
}

double length(const Vector& v) { return std::sqrt(v.squared_length()); }

std::vector<Point> positions(const std::vector<Point>& points, const Loop& loop)
{
  std::vector<Point> result;
  for (const std::size_t v : loop) result.push_back(points[v]);
  return result;
}

// Loops with the surface between them: one, or a larger one and the holes in it, as where a hollow shape is cut.
using Outline = std::vector<Loop>;

// Whether the first loop is a hole in a plane surface of the second: it runs the other way around, and lies within
// the second where both are seen along its normal, and not far before or behind it.
bool is_hole_in(const std::vector<Point>& points, const Loop& hole, const Loop& outer)
{
  const Vector normal = area_vector(points, outer), of_hole = area_vector(points, hole);
  if (!(of_hole.squared_length() < normal.squared_length()) || !(normal * of_hole < 0.))
    return false;
  const std::vector<Point> ring = positions(points, outer);
  const Point middle = CGAL::centroid(ring.begin(), ring.end());
  const double extent = std::sqrt(length(normal));
  const CGAL::Projection_traits_3<Kernel> plane(normal);
  return std::all_of(hole.begin(), hole.end(),
                     [&](const std::size_t v)
                     {
                       const double height = (points[v] - middle) * normal / length(normal);
                       return std::abs(height) < .5 * extent &&
                              CGAL::bounded_side_2(ring.begin(), ring.end(), points[v], plane) ==
                                  CGAL::ON_BOUNDED_SIDE;
                     });
}

std::vector<Outline> outlines(const std::vector<Point>& points, const std::vector<Loop>& loops)
{
  std::vector<Loop> sorted = loops;
  const auto area = [&](const Loop& loop) { return length(area_vector(points, loop)); };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto& a, const auto& b) { return area(a) > area(b); });
  std::vector<Outline> result;
  for (const Loop& loop : sorted)
  {
    // of several around it the smallest
    const auto around = std::find_if(result.rbegin(), result.rend(),
                                     [&](const Outline& outline)
                                     { return is_hole_in(points, loop, outline.front()); });
    if (around == result.rend())
      result.push_back({loop});
    else
      around->push_back(loop);
  }
  return result;
}

using Plane_traits = CGAL::Projection_traits_3<Kernel>;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Plane_traits>;
using Face_base = CGAL::Triangulation_face_base_with_info_2<
    int, Plane_traits, CGAL::Constrained_triangulation_face_base_2<Plane_traits>>;
using Plane_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Plane_traits, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
    CGAL::No_constraint_intersection_tag>;

// Numbers faces by how many loops are around them, from without; unknown ones are -1.
void count_loops_around(Plane_triangulation& plane)
{
  for (const auto face : plane.all_face_handles()) face->info() = -1;
  std::vector<Plane_triangulation::Face_handle> now = {plane.infinite_face()}, next;
  now.front()->info() = 0;
  for (int count = 0; !now.empty(); ++count, now.swap(next), next.clear())
    while (!now.empty())
    {
      const auto face = now.back();
      now.pop_back();
      for (int i = 0; i < 3; ++i)
      {
        const auto beside = face->neighbor(i);
        const bool is_across = face->is_constrained(i);
        if (beside->info() >= 0) continue;
        beside->info() = is_across ? count + 1 : count;
        (is_across ? next : now).push_back(beside);
      }
    }
}

// Throws if edges of the outline cross in the plane.
std::vector<Triangle> filled_in_plane(const std::vector<Point>& points, const Outline& outline)
{
  const Vector normal = area_vector(points, outline.front());
  if (normal == CGAL::NULL_VECTOR) return {};
  Plane_triangulation plane{Plane_traits(normal)};
  std::size_t count = 0;
  for (const Loop& loop : outline)
  {
    std::vector<Plane_triangulation::Vertex_handle> vertices;
    for (const std::size_t v : loop)
    {
      vertices.push_back(plane.insert(points[v]));
      vertices.back()->info() = v;
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
      plane.insert_constraint(vertices[i], vertices[(i + 1) % loop.size()]);
    count += loop.size();
  }
  if (plane.number_of_vertices() != count) return {};
  count_loops_around(plane);
  std::vector<Triangle> triangles;
  for (const auto face : plane.finite_face_handles())
    if (face->info() % 2 == 1)
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

std::vector<Triangle> filled_by_delaunay(const std::vector<Point>& points, const Loop& loop)
{
  std::vector<CGAL::Triple<int, int, int>> filling;
  const std::vector<Point> ring = positions(points, loop);
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(ring, std::back_inserter(filling));
  std::vector<Triangle> triangles;
  const auto at = [&](const int i) { return loop[static_cast<std::size_t>(i)]; };
  for (const auto& t : filling) triangles.push_back({at(t.first), at(t.second), at(t.third)});
  return triangles;
}

std::vector<Triangle> filled_by_cone(std::vector<Point>& points, const Loop& loop)
{
  const std::vector<Point> ring = positions(points, loop);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < loop.size(); ++i)
    triangles.push_back({loop[i], loop[(i + 1) % loop.size()], points.size()});
  points.push_back(CGAL::centroid(ring.begin(), ring.end()));
  return triangles;
}

// Whether a triangle has the first edge of the loop in its direction.
bool is_along(const Loop& loop, const std::vector<Triangle>& triangles)
{
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == loop[0] && t[(i + 1) % 3] == loop[1]) return true;
  return false;
}

// The triangles run along the loops; there are none if it can't be filled so.
std::vector<Triangle> filled(std::vector<Point>& points, const Outline& outline,
                             const Filling filling)
{
  std::vector<Triangle> triangles;
  try
  {
    if (filling == Filling::PLANE)
      triangles = filled_in_plane(points, outline);
    else if (outline.size() == 1 && filling == Filling::DELAUNAY)
      triangles = filled_by_delaunay(points, outline.front());
    else if (outline.size() == 1)
      triangles = filled_by_cone(points, outline.front());
  }
  catch (const std::exception&) // edges that cross, as CGAL says it
  {
    return {};
  }
  if (!is_along(outline.front(), triangles))
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

// By the wanted way, or else by the next that is one; a hole that can't be one is filled for itself.
void add_filled(std::vector<Point>& points, const Outline& outline, const Filling wanted,
                std::vector<Triangle>& triangles)
{
  for (const Filling filling : {wanted, Filling::PLANE, Filling::DELAUNAY, Filling::CONE})
  {
    const std::vector<Triangle> found = filled(points, outline, filling);
    triangles.insert(triangles.end(), found.begin(), found.end());
    if (!found.empty()) return;
  }
  if (outline.size() > 1)
    for (const Loop& loop : outline) add_filled(points, {loop}, wanted, triangles);
}

double mean_length(const Border& border, const std::vector<Point>& points)
{
  double sum = 0., count = 0.;
  for (const auto& of_pair : border)
    for (const auto& [from, to] : of_pair.second)
    {
      sum += length(points[to] - points[from]);
      ++count;
    }
  return sum / count;
}

// Takes zigzags out of the border; points where it branches stay.
void smooth(const Border& border, const int rounds, std::vector<Point>& points)
{
  std::map<std::size_t, std::set<std::size_t>> beside;
  for (const auto& of_pair : border)
    for (const auto& [from, to] : of_pair.second)
    {
      beside[from].insert(to);
      beside[to].insert(from);
    }
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<std::pair<std::size_t, Point>> moved;
    for (const auto& [p, others] : beside)
      if (others.size() == 2)
        moved.emplace_back(p, CGAL::midpoint(points[p], CGAL::midpoint(points[*others.begin()],
                                                                       points[*others.rbegin()])));
    for (const auto& [p, place] : moved) points[p] = place;
  }
}

// Moves the border inwards, and adds the strips that lie between where it was and where it is.
std::map<Label_pair, std::vector<Triangle>> move_inwards(Border& border, const Entrance& entrance,
                                                         const std::vector<Vector>& normals,
                                                         std::vector<Point>& points)
{
  const double step = entrance.depth * mean_length(border, points);
  std::map<std::size_t, std::size_t> below;
  const auto point_below = [&](const std::size_t p)
  {
    const auto place = below.emplace(p, points.size());
    if (place.second) points.push_back(points[p] - step * normals[p]);
    return place.first->second;
  };
  std::map<Label_pair, std::vector<Triangle>> strips;
  for (auto& [pair, edges] : border)
    for (Edge& edge : edges)
    {
      const auto [from, to] = edge;
      edge = {point_below(from), point_below(to)};
      strips[pair].push_back({from, to, edge.second});
      strips[pair].push_back({from, edge.second, edge.first});
    }
  smooth(border, entrance.smoothing, points);
  return strips;
}

} // namespace

void join_hollow_cuts(std::vector<Border>& borders, const std::vector<Point>& points)
{
  std::map<Label_pair, std::vector<std::pair<Loop, std::size_t>>>
      simple; // with the number of their border
  for (std::size_t i = 0; i < borders.size(); ++i)
    if (borders[i].size() == 1)
      for (const Loop& loop : loops_of(borders[i].begin()->second))
        simple[borders[i].begin()->first].emplace_back(loop, i);
  for (const auto& [pair, loops] : simple)
    for (const auto& [hole, from] : loops)
      for (const auto& [outer, to] : loops)
      {
        if (from == to || !is_hole_in(points, hole, outer)) continue;
        std::vector<Edge>& edges = borders[from][pair];
        borders[to][pair].insert(borders[to][pair].end(), edges.begin(), edges.end());
        edges.clear();
      }
  borders.erase(std::remove_if(borders.begin(), borders.end(),
                               [](const Border& border) { return border.begin()->second.empty(); }),
                borders.end());
}

std::vector<Vector> normals_of_points(const Welded_shape& shape)
{
  std::vector<Vector> normals(shape.points.size(), CGAL::NULL_VECTOR);
  for (const auto& polygon : shape.polygons)
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i)
    {
      const Point& p = shape.points[polygon[i]];
      const Vector a = shape.points[polygon[(i + 1) % n]] - p;
      const Vector b = shape.points[polygon[(i + n - 1) % n]] - p;
      const Vector across = CGAL::cross_product(a, b);
      const double size = length(across);
      if (size > 0.)
        normals[polygon[i]] = normals[polygon[i]] + std::atan2(size, a * b) / size * across;
    }
  for (Vector& normal : normals)
    if (normal != CGAL::NULL_VECTOR) normal = normal / length(normal);
  return normals;
}

std::vector<Cap> caps_of(Border border, const Cap_style& style, const std::vector<Vector>& normals,
                         std::vector<Point>& points)
{
  auto triangles = move_inwards(border, style.entrance, normals, points);
  close_border(border, points);
  std::vector<Cap> caps;
  for (const auto& [pair, edges] : border)
  {
    const auto other = style.fillings.find(pair);
    const Filling filling = other == style.fillings.end() ? Filling::PLANE : other->second;
    for (const Outline& outline : outlines(points, loops_of(edges)))
      add_filled(points, outline, filling, triangles[pair]);
    caps.push_back({pair, triangles[pair]});
  }
  return caps;
}

} // namespace Shape_io
