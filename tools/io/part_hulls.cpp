// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/part_hulls.h"

#include "io/closed_parts.h"
#include "io/convex_division.h"
#include "io/separate_parts.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/bounding_box.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shape_io {

namespace {

// A hull that is being made, and what it is the hull of.
struct Draft
{
  Hull_mesh hull;
  double volume = 0.;
  Piece piece = {};                                  // if errors are measured
  std::map<std::size_t, double> volume_of_part = {}; // how much of it is due to which part
};

std::vector<Point> corners_of(const Hull_mesh& hull)
{
  return {hull.points().begin(), hull.points().end()};
}

Draft draft_of(const std::vector<Point>& points, const std::size_t part)
{
  Hull_mesh hull = hull_of(points);
  const double volume = CGAL::Polygon_mesh_processing::volume(hull);
  return {std::move(hull), volume, {}, {{part, volume}}};
}

Hull_mesh hull_together(const Draft& a, const Draft& b)
{
  std::vector<Point> points = corners_of(a.hull);
  points.insert(points.end(), b.hull.points().begin(), b.hull.points().end());
  return hull_of(points);
}

void join(Draft& a, Draft& b)
{
  a.hull = hull_together(a, b);
  a.volume = CGAL::Polygon_mesh_processing::volume(a.hull);
  a.piece.insert(a.piece.end(), b.piece.begin(), b.piece.end());
  for (const auto& [part, volume] : b.volume_of_part) a.volume_of_part[part] += volume;
}

// Joins the two that enclose the least more together, until there are few enough.
void join_until(std::vector<Draft>& drafts, const std::size_t most)
{
  if (drafts.size() <= most) return;
  const std::size_t n = drafts.size();
  std::vector<std::vector<double>> added(n, std::vector<double>(n));
  const auto measure = [&](const std::size_t i, const std::size_t j)
  {
    added[i][j] = CGAL::Polygon_mesh_processing::volume(hull_together(drafts[i], drafts[j])) -
                  drafts[i].volume - drafts[j].volume;
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) measure(i, j);
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < n; ++i) left.insert(i);
  while (left.size() > most)
  {
    std::pair<std::size_t, std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : left)
      for (auto j = left.upper_bound(i); j != left.end(); ++j)
        if (added[i][*j] < least)
        {
          least = added[i][*j];
          best = {i, *j};
        }
    join(drafts[best.first], drafts[best.second]);
    left.erase(best.second);
    for (const std::size_t i : left)
      if (i != best.first) measure((std::min)(i, best.first), (std::max)(i, best.first));
  }
  std::vector<Draft> kept;
  for (const std::size_t i : left) kept.push_back(std::move(drafts[i]));
  drafts.swap(kept);
}

// The corners that matter most: each the furthest from the hull of those before it.
Hull_mesh with_fewer_corners(const Hull_mesh& whole, const std::size_t most)
{
  if (whole.number_of_vertices() <= most) return whole;
  const std::vector<Point> corners = corners_of(whole);
  std::vector<Point> kept = {*std::min_element(corners.begin(), corners.end())};
  const auto take_furthest = [&](const auto& squared_distance)
  {
    double furthest = -1.;
    Point best = kept.front();
    for (const Point& p : corners)
      if (const double d = squared_distance(p); d > furthest)
      {
        furthest = d;
        best = p;
      }
    kept.push_back(best);
  };
  take_furthest([&](const Point& p) { return CGAL::squared_distance(p, kept[0]); });
  take_furthest([&](const Point& p)
                { return CGAL::squared_distance(p, Kernel::Line_3(kept[0], kept[1])); });
  take_furthest([&](const Point& p)
                { return CGAL::squared_distance(p, Kernel::Plane_3(kept[0], kept[1], kept[2])); });
  while (kept.size() < most)
  {
    const Hull_mesh hull = hull_of(kept);
    std::vector<Kernel::Plane_3> planes;
    for (const auto f : hull.faces())
    {
      const auto h = hull.halfedge(f);
      planes.emplace_back(hull.point(hull.source(h)), hull.point(hull.target(h)),
                          hull.point(hull.target(hull.next(h))));
    }
    take_furthest(
        [&](const Point& p)
        {
          double out = 0.;
          for (const auto& plane : planes)
            if (plane.has_on_positive_side(p))
              out = (std::max)(out, double(CGAL::squared_distance(p, plane)));
          return out;
        });
  }
  return hull_of(kept);
}

Part_hull finished(const Draft& draft, const std::vector<Solid_part>& parts, const double scale,
                   const Hull_options& options)
{
  const Hull_mesh hull = with_fewer_corners(draft.hull, options.most_corners);
  Part_hull result;
  result.points = corners_of(hull);
  for (const auto f : hull.faces())
  {
    result.triangles.emplace_back();
    for (const auto v : hull.vertices_around_face(hull.halfedge(f)))
      result.triangles.back().push_back(static_cast<std::size_t>(v));
  }
  const auto largest =
      std::max_element(draft.volume_of_part.begin(), draft.volume_of_part.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  result.label = static_cast<int>(largest->first);
  if (draft.piece.empty()) return result;
  std::vector<const Solid_part*> own;
  for (const auto& entry : draft.volume_of_part) own.push_back(&parts[entry.first]);
  result.error = hull_error(hull, draft.piece, own, options.largest_error * scale).distance / scale;
  return result;
}

Piece piece_of(const Shape& part)
{
  Piece piece;
  for (const auto& polygon : part.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      piece.push_back(
          {part.points[polygon[0]], part.points[polygon[i - 1]], part.points[polygon[i]]});
  return piece;
}

} // namespace

Part_hulls part_hulls(const Shape& shape, const std::vector<int>& labels,
                      const std::size_t number_of_parts, const Hull_options& options)
{
  const bool is_divided = std::isfinite(options.largest_error);
  if (is_divided && !shape.is_mesh())
    throw std::invalid_argument("the inside of a cloud's parts is not known, so that the error of "
                                "hulls can't be measured; give a mesh, or leave out --hull-error");
  const auto box = CGAL::bounding_box(shape.points.begin(), shape.points.end());
  const double scale = std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
  const auto elements = elements_of_parts(labels, number_of_parts);
  const std::vector<Closed_part> closed =
      is_divided ? closed_parts(shape, labels, number_of_parts) : std::vector<Closed_part>();
  std::vector<Solid_part> parts;
  for (const Closed_part& part : closed) parts.emplace_back(part.shape);
  Part_hulls result;
  std::vector<Draft> drafts;
  for (std::size_t label = 0; label < number_of_parts; ++label)
  {
    const Shape part = shape_of_elements(shape, elements[label]);
    if (!has_hull(part.points))
    {
      result.flat_parts.push_back(static_cast<int>(label));
      continue;
    }
    if (!is_divided)
    {
      drafts.push_back(draft_of(part.points, label));
      continue;
    }
    for (Piece& piece : divided(piece_of(part), parts[label], options.largest_error * scale))
    {
      drafts.push_back(draft_of(points_of(piece), label));
      drafts.back().piece = std::move(piece);
    }
  }
  join_until(drafts, options.most_hulls);
  for (const Draft& draft : drafts) result.hulls.push_back(finished(draft, parts, scale, options));
  return result;
}

Shape mesh_of_hulls(const std::vector<Part_hull>& hulls)
{
  Shape mesh;
  Property hull = {"hull", "int", {}};
  for (std::size_t i = 0; i < hulls.size(); ++i)
  {
    const std::size_t first = mesh.points.size();
    mesh.points.insert(mesh.points.end(), hulls[i].points.begin(), hulls[i].points.end());
    for (auto triangle : hulls[i].triangles)
    {
      for (std::size_t& corner : triangle) corner += first;
      mesh.polygons.push_back(std::move(triangle));
      hull.values.push_back(static_cast<double>(i));
    }
  }
  mesh.face_properties.push_back(std::move(hull));
  return mesh;
}

} // namespace Shape_io
