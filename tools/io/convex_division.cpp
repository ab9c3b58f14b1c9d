// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/convex_division.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/bounding_box.h>
#include <CGAL/centroid.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/linear_least_squares_fitting_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_io {

namespace PMP = CGAL::Polygon_mesh_processing;

bool has_hull(const std::vector<Point>& points)
{
  std::size_t second = 1, third;
  while (second < points.size() && points[second] == points[0]) ++second;
  third = second + 1;
  while (third < points.size() && CGAL::collinear(points[0], points[second], points[third]))
    ++third;
  for (std::size_t i = third + 1; i < points.size(); ++i)
    if (!CGAL::coplanar(points[0], points[second], points[third], points[i])) return true;
  return false;
}

Hull_mesh hull_of(const std::vector<Point>& points)
{
  Hull_mesh hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return hull;
}

Solid_part::Solid_part(const Shape& shape) : m_mesh(std::make_unique<Hull_mesh>())
{
  std::vector<Point> points = shape.points;
  std::vector<std::vector<std::size_t>> polygons = shape.polygons;
  if (!PMP::orient_polygon_soup(points, polygons) || !PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, *m_mesh);
  PMP::triangulate_faces(*m_mesh);
  if (CGAL::is_closed(*m_mesh) && CGAL::is_triangle_mesh(*m_mesh))
    m_side = std::make_unique<CGAL::Side_of_triangle_mesh<Hull_mesh, Kernel>>(*m_mesh);
}

std::vector<Point> points_of(const Piece& piece)
{
  std::vector<Point> points;
  for (const auto& polygon : piece) points.insert(points.end(), polygon.begin(), polygon.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

namespace {

double diagonal(const std::vector<Point>& points)
{
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  return std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
}

using Triangles = std::vector<Kernel::Triangle_3>;
using Triangle_tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Triangles triangles_of(const Piece& piece)
{
  Triangles triangles;
  for (const auto& polygon : piece)
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      triangles.emplace_back(polygon[0], polygon[i - 1], polygon[i]);
      if (triangles.back().is_degenerate()) triangles.pop_back();
    }
  return triangles;
}

Hull_error error_at_samples(const Hull_mesh& hull, const double spacing,
                            const Triangle_tree& surface,
                            const std::vector<const Solid_part*>& parts)
{
  std::vector<Point> samples;
  PMP::sample_triangle_mesh(
      hull, std::back_inserter(samples),
      CGAL::parameters::use_random_uniform_sampling(false).use_grid_sampling(true).grid_spacing(
          spacing));
  Hull_error worst;
  for (const Point& p : samples)
  {
    if (std::any_of(parts.begin(), parts.end(),
                    [&](const Solid_part* part) { return part->holds(p); }))
      continue;
    const Point nearest = surface.closest_point(p);
    const double distance = std::sqrt(CGAL::squared_distance(p, nearest));
    if (distance > worst.distance) worst = {distance, nearest};
  }
  return worst;
}

} // namespace

Hull_error hull_error(const Hull_mesh& hull, const Piece& piece,
                      const std::vector<const Solid_part*>& parts, const double largest_error)
{
  const Triangles triangles = triangles_of(piece);
  if (triangles.empty()) return {};
  const Triangle_tree surface(triangles.begin(), triangles.end());
  const double coarse = diagonal(points_of(piece)) / 20.;
  const Hull_error error = error_at_samples(hull, coarse, surface, parts);
  const double fine = (std::max)(error.distance, largest_error) / 4.;
  return coarse <= fine ? error : error_at_samples(hull, fine, surface, parts);
}

namespace {

// What of the piece lies on the positive side of a plane.
Piece clipped(const Piece& piece, const Kernel::Plane_3& plane)
{
  Piece result;
  for (const auto& polygon : piece)
  {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double at_p = plane.a() * p.x() + plane.b() * p.y() + plane.c() * p.z() + plane.d();
      const double at_q = plane.a() * q.x() + plane.b() * q.y() + plane.c() * q.z() + plane.d();
      if (at_p >= 0.) kept.push_back(p);
      if ((at_p > 0. && at_q < 0.) || (at_p < 0. && at_q > 0.))
        kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    if (kept.size() > 2) result.push_back(std::move(kept));
  }
  return result;
}

// The axes of the points, and what lies between these.
std::vector<Vector> directions(const std::vector<Point>& points)
{
  Kernel::Plane_3 plane;
  CGAL::linear_least_squares_fitting_3(points.begin(), points.end(), plane,
                                       CGAL::Dimension_tag<0>());
  Kernel::Line_3 line;
  CGAL::linear_least_squares_fitting_3(points.begin(), points.end(), line,
                                       CGAL::Dimension_tag<0>());
  const auto unit = [](const Vector& v) { return v / std::sqrt(v.squared_length()); };
  const Vector x = unit(line.to_vector()), z = unit(plane.orthogonal_vector());
  const Vector y = CGAL::cross_product(z, x);
  std::vector<Vector> result;
  for (int i = 0; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        if (i > 0 || j > 0 || (j == 0 && k > 0))
          result.push_back(unit(double(i) * x + double(j) * y + double(k) * z));
  return result;
}

double hull_volume(const std::vector<Point>& points)
{
  return has_hull(points) ? CGAL::to_double(PMP::volume(hull_of(points))) : 0.;
}

// Every so many of the polygons, for what only compares planes.
Piece thinned(const Piece& piece)
{
  constexpr std::size_t enough = 400;
  const std::size_t step = piece.size() / enough + 1;
  Piece result;
  for (std::size_t i = 0; i < piece.size(); i += step) result.push_back(piece[i]);
  return result;
}

// The plane through the place, or through the middle of the piece, that leaves the least volume in hulls.
Kernel::Plane_3 best_plane(const Piece& piece, const Point& place)
{
  const Piece few = thinned(piece);
  const std::vector<Point> points = points_of(few);
  const Point middle = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
  Kernel::Plane_3 best(place, Vector(1., 0., 0.));
  double least = std::numeric_limits<double>::infinity();
  for (const Point& through : {place, middle})
    for (const Vector& normal : directions(points))
    {
      const Kernel::Plane_3 plane(through, normal);
      const double volume = hull_volume(points_of(clipped(few, plane))) +
                            hull_volume(points_of(clipped(few, plane.opposite())));
      if (volume < least)
      {
        least = volume;
        best = plane;
      }
    }
  return best;
}

} // namespace

std::vector<Piece> divided(const Piece& whole, const Solid_part& part, const double largest_error)
{
  // a bound for what has an inside that planes do not come near to, such as a fine sponge
  constexpr std::size_t most_pieces = 256;
  std::vector<Piece> open = {whole}, done;
  while (!open.empty())
  {
    const Piece piece = std::move(open.back());
    open.pop_back();
    const std::vector<Point> points = points_of(piece);
    if (!has_hull(points)) continue;
    const Hull_error error = hull_error(hull_of(points), piece, {&part}, largest_error);
    Piece above, below;
    if (error.distance > largest_error && open.size() + done.size() < most_pieces)
    {
      const Kernel::Plane_3 plane = best_plane(piece, error.nearest);
      above = clipped(piece, plane);
      below = clipped(piece, plane.opposite());
    }
    if (above.empty() || below.empty())
      done.push_back(piece);
    else
    {
      open.push_back(std::move(above));
      open.push_back(std::move(below));
    }
  }
  return done;
}

} // namespace Shape_io
