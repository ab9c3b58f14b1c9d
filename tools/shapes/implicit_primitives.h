// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_PRIMITIVES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_PRIMITIVES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Solids given by signed distances, negative inside.

namespace Shape_generator {

using Point = std::array<double, 3>;

namespace internal {

inline Point add(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

inline Point subtract(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Point scale(const Point& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }

inline double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Point& a) { return std::sqrt(dot(a, a)); }

inline Point normalized(const Point& a)
{
  const double l = length(a);
  return l > 0 ? scale(a, 1 / l) : Point{0, 0, 1};
}

} // namespace internal

struct Box
{
  Point lower = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                 std::numeric_limits<double>::infinity()};
  Point upper = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                 -std::numeric_limits<double>::infinity()};

  // Grows the box to hold the ball of the given centre and radius.
  void extend(const Point& center, double radius)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      lower[i] = (std::min)(lower[i], center[i] - radius);
      upper[i] = (std::max)(upper[i], center[i] + radius);
    }
  }

  double distance(const Point& p) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double d = (std::max)({lower[i] - p[i], p[i] - upper[i], 0.});
      sum += d * d;
    }
    return std::sqrt(sum);
  }
};

class Primitive
{
public:
  virtual ~Primitive() = default;
  virtual double distance(const Point& p) const = 0;
  virtual Box box() const = 0;
};

// Union of the balls whose centre and radius go linearly from (a, ra) to (b, rb), swept along
// `spread` to both sides, which flattens the cross-section to a stadium.
class Rounded_cone : public Primitive
{
public:
  Rounded_cone(const Point& a, double ra, const Point& b, double rb,
               const Point& spread = {0, 0, 0})
    : m_a(a), m_b(b), m_spread(spread), m_ra(ra), m_rb(rb),
      m_length(internal::length(internal::subtract(b, a))),
      m_axis(internal::normalized(internal::subtract(b, a))),
      m_slope(m_length > 0 ? (rb - ra) / m_length : 0), m_width(internal::length(spread)),
      m_spread_axis(internal::normalized(spread))
  {
    // The larger ball holds the other one: only it counts.
    if (std::abs(m_slope) >= 1)
    {
      if (rb > ra)
      {
        m_a = b;
        m_ra = rb;
      }
      m_length = m_slope = 0;
    }
  }

  double distance(const Point& p) const override
  {
    Point q = internal::subtract(p, m_a);
    if (m_width > 0)
    {
      const double t = internal::dot(q, m_spread_axis);
      const double moved = (std::max)(-m_width, (std::min)(m_width, t));
      q = internal::subtract(q, internal::scale(m_spread_axis, moved));
    }
    const double along = internal::dot(q, m_axis);
    const double across = std::sqrt((std::max)(0., internal::dot(q, q) - along * along));
    // The nearest ball is the minimum of a convex function of its position on the axis.
    const double free = along + across * m_slope / std::sqrt(1 - m_slope * m_slope);
    const double t = (std::max)(0., (std::min)(m_length, free));
    return std::sqrt(across * across + (along - t) * (along - t)) - (m_ra + m_slope * t);
  }

  Box box() const override
  {
    Box result;
    for (double side : {-1., 1.})
    {
      result.extend(internal::add(m_a, internal::scale(m_spread, side)), m_ra);
      result.extend(internal::add(m_b, internal::scale(m_spread, side)), m_rb);
    }
    return result;
  }

private:
  Point m_a, m_b, m_spread;
  double m_ra, m_rb, m_length;
  Point m_axis;
  double m_slope, m_width;
  Point m_spread_axis;
};

// A simple polygon in the plane of the unit vectors u and v, thickened to both sides along u x v
// by `half_thickness` and then grown by `rounding`.
class Prism : public Primitive
{
public:
  using Polygon = std::vector<std::array<double, 2>>;

  Prism(const Point& origin, const Point& u, const Point& v, Polygon polygon, double half_thickness,
        double rounding)
    : m_origin(origin), m_u(u), m_v(v), m_w(internal::cross(u, v)), m_polygon(std::move(polygon)),
      m_half_thickness(half_thickness), m_rounding(rounding)
  {}

  double distance(const Point& p) const override
  {
    const Point q = internal::subtract(p, m_origin);
    const double in_plane = polygon_distance(internal::dot(q, m_u), internal::dot(q, m_v));
    const double off_plane = std::abs(internal::dot(q, m_w)) - m_half_thickness;
    const double outside = std::hypot((std::max)(in_plane, 0.), (std::max)(off_plane, 0.));
    return (std::min)((std::max)(in_plane, off_plane), 0.) + outside - m_rounding;
  }

  Box box() const override
  {
    Box result;
    for (const std::array<double, 2>& c : m_polygon)
      for (double side : {-m_half_thickness, m_half_thickness})
      {
        Point p = internal::add(m_origin, internal::scale(m_u, c[0]));
        p = internal::add(p, internal::scale(m_v, c[1]));
        result.extend(internal::add(p, internal::scale(m_w, side)), m_rounding);
      }
    return result;
  }

private:
  double polygon_distance(double x, double y) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t i = 0; i < m_polygon.size(); ++i)
    {
      const std::array<double, 2>& a = m_polygon[i];
      const std::array<double, 2>& b = m_polygon[(i + 1) % m_polygon.size()];
      const double ex = b[0] - a[0], ey = b[1] - a[1], px = x - a[0], py = y - a[1];
      const double t = (std::max)(0., (std::min)(1., (px * ex + py * ey) / (ex * ex + ey * ey)));
      const double dx = px - t * ex, dy = py - t * ey;
      nearest = (std::min)(nearest, dx * dx + dy * dy);
      if ((a[1] > y) != (b[1] > y) && px < ex * py / ey) inside = !inside;
    }
    return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
  }

  Point m_origin, m_u, m_v, m_w;
  Polygon m_polygon;
  double m_half_thickness, m_rounding;
};

class Torus : public Primitive
{
public:
  Torus(const Point& center, const Point& unit_axis, double major_radius, double minor_radius)
    : m_center(center), m_axis(unit_axis), m_major(major_radius), m_minor(minor_radius)
  {}

  double distance(const Point& p) const override
  {
    const Point q = internal::subtract(p, m_center);
    const double along = internal::dot(q, m_axis);
    const double across = std::sqrt((std::max)(0., internal::dot(q, q) - along * along));
    return std::hypot(across - m_major, along) - m_minor;
  }

  Box box() const override
  {
    Box result;
    result.extend(m_center, m_major + m_minor);
    return result;
  }

private:
  Point m_center, m_axis;
  double m_major, m_minor;
};

// A wall of the given thickness around a polyline of (radius, height) turned about the z axis.
class Turned_wall : public Primitive
{
public:
  using Profile = std::vector<std::array<double, 2>>;

  Turned_wall(Profile profile, double half_thickness)
    : m_profile(std::move(profile)), m_half_thickness(half_thickness)
  {}

  double distance(const Point& p) const override
  {
    const Point q = {std::hypot(p[0], p[1]), 0, p[2]};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < m_profile.size(); ++i)
    {
      const Point a = {m_profile[i][0], 0, m_profile[i][1]};
      const Point b = {m_profile[i + 1][0], 0, m_profile[i + 1][1]};
      nearest =
          (std::min)(nearest, Rounded_cone(a, m_half_thickness, b, m_half_thickness).distance(q));
    }
    return nearest;
  }

  Box box() const override
  {
    Box result;
    for (const std::array<double, 2>& c : m_profile)
      for (const Point& p : {Point{c[0], c[0], c[1]}, Point{-c[0], -c[0], c[1]}})
        result.extend(p, m_half_thickness);
    return result;
  }

private:
  Profile m_profile;
  double m_half_thickness;
};

} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_PRIMITIVES_H
