// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_CANVAS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_CANVAS_H

#include "draw/draw_parts.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// What is nearest to the eye at each sample.

namespace Draw_parts {
namespace internal {

inline Eigen::Vector3d vector(const Point& p) { return {p[0], p[1], p[2]}; }

enum class Scale
{
  FILLS_PICTURE,
  SAME_FROM_ALL_SIDES
};

/// Where the points come to lie in the picture.
class Projection
{
public:
  Projection(const Scene& scene, const Camera& camera, const int size, const Scale scale)
    : m_camera(camera)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity), high = -low;
    for (const Point& p : scene.points)
    {
      low = low.cwiseMin(camera * vector(p));
      high = high.cwiseMax(camera * vector(p));
    }
    m_center = 0.5 * (low + high);
    const Eigen::Vector3d box = high - low;
    const double extent = scale == Scale::FILLS_PICTURE ? (std::max)(box.x(), box.y()) : box.norm();
    m_scale = extent > 0. ? 0.94 * size / extent : 1.;
    m_middle = Eigen::Vector3d(0.5 * size, 0.5 * size, 0.);
  }
  Eigen::Vector3d operator()(const Point& p) const
  {
    Eigen::Vector3d q = m_scale * (m_camera * vector(p) - m_center);
    q.y() = -q.y(); // rows go down
    return q + m_middle;
  }

private:
  Camera m_camera;
  Eigen::Vector3d m_center, m_middle;
  double m_scale = 1.;
};

/// The elements in front so far.
class Canvas
{
public:
  explicit Canvas(const int size)
  {
    const auto side = static_cast<std::size_t>(size);
    m_view.width = m_view.height = size;
    m_view.element.assign(side * side, View::none);
    m_view.shade.assign(side * side, 0.f);
    m_view.depth.assign(side * side, -std::numeric_limits<float>::infinity());
  }
  int size() const { return m_view.width; }
  View take_view() { return std::move(m_view); }

  /// `shades` of the corners
  void triangle(const std::array<Eigen::Vector3d, 3>& corners, const std::size_t element,
                const std::array<float, 3>& shades)
  {
    const auto& [a, b, c] = corners;
    const Eigen::Vector3d u = b - a, v = c - a;
    const double area = u.x() * v.y() - u.y() * v.x();
    if (area == 0.) return;
    const auto range = [](const double p, const double q, const double r)
    {
      const auto [low, high] = std::minmax({p, q, r});
      return std::pair<int, int>(static_cast<int>(std::floor(low)),
                                 static_cast<int>(std::ceil(high)));
    };
    const auto [left, right] = range(a.x(), b.x(), c.x());
    const auto [top, bottom] = range(a.y(), b.y(), c.y());
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x)
      {
        const double dx = x + 0.5 - a.x(), dy = y + 0.5 - a.y();
        const double s = (dx * v.y() - dy * v.x()) / area, t = (u.x() * dy - u.y() * dx) / area;
        if (s < 0. || t < 0. || s + t > 1.) continue;
        const double light = shades[0] + s * (shades[1] - shades[0]) + t * (shades[2] - shades[0]);
        put(x, y, a.z() + s * u.z() + t * v.z(), element, static_cast<float>(light));
      }
  }

  void splat(const Eigen::Vector3d& center, const double radius, const std::size_t element,
             const float shade)
  {
    const int reach = static_cast<int>(std::ceil(radius));
    const int x0 = static_cast<int>(center.x()), y0 = static_cast<int>(center.y());
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (x * x + y * y <= radius * radius) put(x0 + x, y0 + y, center.z(), element, shade);
  }

private:
  void put(const int x, const int y, const double depth, const std::size_t element,
           const float shade)
  {
    if (x < 0 || y < 0 || x >= m_view.width || y >= m_view.height) return;
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_view.width) +
                   static_cast<std::size_t>(x);
    if (static_cast<float>(depth) <= m_view.depth[i]) return;
    m_view.depth[i] = static_cast<float>(depth);
    m_view.element[i] = element;
    m_view.shade[i] = shade;
  }

  View m_view;
};

} // namespace internal
} // namespace Draw_parts

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_CANVAS_H
