// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanner/virtual_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace Virtual_scanner {

Camera realistic_camera()
{
  Camera camera;
  camera.noise = 0.002;
  camera.quantum = 0.001;
  camera.grazing_angle = 80.;
  camera.normal_radius = 4;
  return camera;
}

namespace internal {

Pose look_at(const Point& eye, const Point& target)
{
  Pose pose;
  pose.eye = eye;
  pose.forward = normalized(target - eye);
  const Point helper = std::abs(pose.forward[2]) < 0.9 ? Point{0., 0., 1.} : Point{1., 0., 0.};
  pose.right = normalized(cross(pose.forward, helper));
  pose.up = cross(pose.right, pose.forward);
  return pose;
}

Point project(const Pose& pose, const Point& p, const double focal, const double middle)
{
  const Point d = p - pose.eye;
  const double depth = dot(d, pose.forward);
  return {middle + focal * dot(d, pose.right) / depth, middle + focal * dot(d, pose.up) / depth,
          1. / depth};
}

namespace {

double doubled_area(const Point& a, const Point& b, const double x, const double y)
{
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

} // namespace

void draw(const std::array<Point, 3>& t, const std::size_t face, const std::size_t side,
          std::vector<Hit>& hits)
{
  const double area = doubled_area(t[0], t[1], t[2][0], t[2][1]);
  if (!(std::abs(area) > 0.)) return;
  const auto pixel_range = [&](const int axis)
  {
    const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    const double last = static_cast<double>(side) - 1.;
    return std::array<long, 2>{static_cast<long>(std::ceil((std::max)(low, 0.))),
                               static_cast<long>(std::floor((std::min)(high, last)))};
  };
  const std::array<long, 2> columns = pixel_range(0), rows = pixel_range(1);
  for (long row = rows[0]; row <= rows[1]; ++row)
    for (long column = columns[0]; column <= columns[1]; ++column)
    {
      const double x = static_cast<double>(column), y = static_cast<double>(row);
      const double a = doubled_area(t[1], t[2], x, y) / area;
      const double b = doubled_area(t[2], t[0], x, y) / area;
      if (a < 0. || b < 0. || a + b > 1.) continue;
      const double depth = 1. / (a * t[0][2] + b * t[1][2] + (1. - a - b) * t[2][2]);
      Hit& hit = hits[static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column)];
      if (depth < hit.depth) hit = {depth, face};
    }
}

double measured(const double range, const Camera& camera, const double diameter,
                std::mt19937& random)
{
  double result = range;
  if (camera.noise > 0.)
    result += std::normal_distribution<double>(0., camera.noise * diameter)(random);
  const double step = camera.quantum * diameter;
  return step > 0. ? step * std::round(result / step) : result;
}

} // namespace internal

std::vector<Point> view_directions(const std::size_t count, const unsigned seed)
{
  constexpr double pi = 3.14159265358979323846;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return Point{normal(random), normal(random), normal(random)}; };
  const Point x = internal::normalized(draw());
  const Point y = internal::normalized(internal::cross(x, draw()));
  const Point z = internal::cross(x, y);
  const double golden_angle = pi * (3. - std::sqrt(5.));
  std::vector<Point> directions;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double h = 1. - (2. * static_cast<double>(i) + 1.) / static_cast<double>(count);
    const double r = std::sqrt(1. - h * h), a = golden_angle * static_cast<double>(i);
    directions.push_back(r * std::cos(a) * x + r * std::sin(a) * y + h * z);
  }
  return directions;
}

} // namespace Virtual_scanner
