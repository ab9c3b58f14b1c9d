// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_PRIMITIVES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_PRIMITIVES_H

#include <array>
#include <cmath>
#include <limits>
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

  // Grows the box to hold the ball of the given center and radius.
  void extend(const Point& center, double radius);

  double distance(const Point& p) const;
};

class Primitive
{
public:
  virtual ~Primitive() = default;
  virtual double distance(const Point& p) const = 0;
  virtual Box box() const = 0;
};

// Union of the balls whose center and radius go linearly from (a, ra) to (b, rb), swept along
// `spread` to both sides, which flattens the cross-section to a stadium.
class Rounded_cone : public Primitive
{
public:
  Rounded_cone(const Point& a, double ra, const Point& b, double rb,
               const Point& spread = {0, 0, 0});

  double distance(const Point& p) const override;

  Box box() const override;

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
        double rounding);

  double distance(const Point& p) const override;

  Box box() const override;

private:
  double polygon_distance(double x, double y) const;

  Point m_origin, m_u, m_v, m_w;
  Polygon m_polygon;
  double m_half_thickness, m_rounding;
};

class Torus : public Primitive
{
public:
  Torus(const Point& center, const Point& unit_axis, double major_radius, double minor_radius);

  double distance(const Point& p) const override;

  Box box() const override;

private:
  Point m_center, m_axis;
  double m_major, m_minor;
};

// A wall of the given thickness around a polyline of (radius, height) turned about the z axis.
class Turned_wall : public Primitive
{
public:
  using Profile = std::vector<std::array<double, 2>>;

  Turned_wall(Profile profile, double half_thickness);

  double distance(const Point& p) const override;

  Box box() const override;

private:
  Profile m_profile;
  double m_half_thickness;
};

} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_PRIMITIVES_H
