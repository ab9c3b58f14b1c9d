// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/implicit_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace Shape_generator {

std::size_t Implicit_shape::add_part(const std::string& name)
{
  m_parts.push_back({name, {}, Box()});
  return m_parts.size() - 1;
}

void Implicit_shape::add_ball(std::size_t part, const Point& center, double radius)
{
  add<Rounded_cone>(part, center, radius, center, radius);
}

void Implicit_shape::add_limb(std::size_t part, const std::vector<Station>& stations,
                              const Point& spread)
{
  constexpr int steps = 5;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i)
  {
    Station from = stations[i];
    for (int step = 1; step <= steps; ++step)
    {
      const Station to = between(stations, i, double(step) / steps);
      add<Rounded_cone>(part, from.position, from.radius, to.position, to.radius, spread);
      from = to;
    }
  }
}

double Implicit_shape::distance(const Point& p) const
{
  double result = std::numeric_limits<double>::infinity();
  for (const Part& part : m_parts)
    if (part.box.distance(p) <= result + m_blend) result = smooth_minimum(result, part.distance(p));
  return result;
}

Point Implicit_shape::gradient(const Point& p) const
{
  // Small, as on a sharp shape the points next to an edge count with one side only.
  constexpr double step = 1e-7;
  Point result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    Point before = p, after = p;
    before[i] -= step;
    after[i] += step;
    result[i] = (distance(after) - distance(before)) / (2 * step);
  }
  return result;
}

Point Implicit_shape::project(Point p, double max_step) const
{
  for (int iteration = 0; iteration < 4; ++iteration)
  {
    const double d = distance(p);
    if (std::abs(d) < 1e-7) break;
    const Point g = gradient(p);
    const double step = (std::max)(-max_step, (std::min)(max_step, d));
    p = internal::subtract(p, internal::scale(g, step / (std::max)(internal::dot(g, g), 0.1)));
  }
  return p;
}

int Implicit_shape::nearest_part(const Point& p) const
{
  double nearest = std::numeric_limits<double>::infinity();
  int result = 0;
  for (std::size_t i = 0; i < m_parts.size(); ++i)
  {
    const double d = m_parts[i].distance(p);
    if (d < nearest - 1e-4)
    {
      nearest = d;
      result = static_cast<int>(i);
    }
  }
  return result;
}

std::vector<std::string> Implicit_shape::part_names() const
{
  std::vector<std::string> result;
  for (const Part& part : m_parts) result.push_back(part.name);
  return result;
}

double Implicit_shape::smooth_minimum(double a, double b) const
{
  const double overlap = m_blend - std::abs(a - b);
  const double minimum = (std::min)(a, b);
  return overlap > 0 ? minimum - overlap * overlap / (4 * m_blend) : minimum;
}

Station Implicit_shape::between(const std::vector<Station>& stations, std::size_t i, double t)
{
  const Station& b = stations[i];
  const Station& c = stations[i + 1];
  const Station& a = i > 0 ? stations[i - 1] : b;
  const Station& d = i + 2 < stations.size() ? stations[i + 2] : c;
  const auto interpolate = [t](double p, double q, double r, double s)
  {
    const double slope_q = (r - p) / 2, slope_r = (s - q) / 2;
    const double u = 1 - t;
    return u * u * (1 + 2 * t) * q + t * t * (3 - 2 * t) * r + t * u * u * slope_q -
           t * t * u * slope_r;
  };
  Station result;
  for (std::size_t k = 0; k < 3; ++k)
    result.position[k] = interpolate(a.position[k], b.position[k], c.position[k], d.position[k]);
  result.radius = interpolate(a.radius, b.radius, c.radius, d.radius);
  return result;
}

} // namespace Shape_generator
