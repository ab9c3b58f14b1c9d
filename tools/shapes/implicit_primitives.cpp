// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/implicit_primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace Shape_generator {

void Box::extend(const Point& center, double radius)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    lower[i] = (std::min)(lower[i], center[i] - radius);
    upper[i] = (std::max)(upper[i], center[i] + radius);
  }
}

double Box::distance(const Point& p) const
{
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double d = (std::max)({lower[i] - p[i], p[i] - upper[i], 0.});
    sum += d * d;
  }
  return std::sqrt(sum);
}

Rounded_cone::Rounded_cone(const Point& a, double ra, const Point& b, double rb,
                           const Point& spread)
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

double Rounded_cone::distance(const Point& p) const
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

Box Rounded_cone::box() const
{
  Box result;
  for (double side : {-1., 1.})
  {
    result.extend(internal::add(m_a, internal::scale(m_spread, side)), m_ra);
    result.extend(internal::add(m_b, internal::scale(m_spread, side)), m_rb);
  }
  return result;
}

Prism::Prism(const Point& origin, const Point& u, const Point& v, Polygon polygon,
             double half_thickness, double rounding)
  : m_origin(origin), m_u(u), m_v(v), m_w(internal::cross(u, v)), m_polygon(std::move(polygon)),
    m_half_thickness(half_thickness), m_rounding(rounding)
{}

double Prism::distance(const Point& p) const
{
  const Point q = internal::subtract(p, m_origin);
  const double in_plane = polygon_distance(internal::dot(q, m_u), internal::dot(q, m_v));
  const double off_plane = std::abs(internal::dot(q, m_w)) - m_half_thickness;
  const double outside = std::hypot((std::max)(in_plane, 0.), (std::max)(off_plane, 0.));
  return (std::min)((std::max)(in_plane, off_plane), 0.) + outside - m_rounding;
}

Box Prism::box() const
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

double Prism::polygon_distance(double x, double y) const
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

Torus::Torus(const Point& center, const Point& unit_axis, double major_radius, double minor_radius)
  : m_center(center), m_axis(unit_axis), m_major(major_radius), m_minor(minor_radius)
{}

double Torus::distance(const Point& p) const
{
  const Point q = internal::subtract(p, m_center);
  const double along = internal::dot(q, m_axis);
  const double across = std::sqrt((std::max)(0., internal::dot(q, q) - along * along));
  return std::hypot(across - m_major, along) - m_minor;
}

Box Torus::box() const
{
  Box result;
  result.extend(m_center, m_major + m_minor);
  return result;
}

Turned_wall::Turned_wall(Profile profile, double half_thickness)
  : m_profile(std::move(profile)), m_half_thickness(half_thickness)
{}

double Turned_wall::distance(const Point& p) const
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

Box Turned_wall::box() const
{
  Box result;
  for (const std::array<double, 2>& c : m_profile)
    for (const Point& p : {Point{c[0], c[0], c[1]}, Point{-c[0], -c[0], c[1]}})
      result.extend(p, m_half_thickness);
  return result;
}

} // namespace Shape_generator
