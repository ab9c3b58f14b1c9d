// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_REPORT_DRAW_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_REPORT_DRAW_PARTS_H

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// Small pictures of parts, many a second: a viewer takes longer to start than this to draw a hundred.

namespace Draw_parts {

using Point = std::array<double, 3>;
using Color = std::array<unsigned char, 3>;

/// Triangles, or points with normals where there are no triangles; a label each.
struct Scene
{
  std::vector<Point> points;
  std::vector<Point> normals; ///< of the points, if there are no faces
  std::vector<std::array<std::size_t, 3>> faces;

  std::size_t number_of_elements() const { return faces.empty() ? points.size() : faces.size(); }
};

/// What is seen: the nearest element of each pixel, none where there is nothing.
struct View
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  int width = 0, height = 0;
  std::vector<std::size_t> element;
  std::vector<float> shade;
};

/// Axes of the picture in space: to the right, upwards, and towards the eye.
using Camera = Eigen::Matrix3d;

namespace internal {

inline Eigen::Vector3d vector(const Point& p) { return {p[0], p[1], p[2]}; }

/// Where the points come to lie in the picture.
class Projection
{
public:
  Projection(const Scene& scene, const Camera& camera, const int size) : m_camera(camera)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity), high = -low;
    for (const Point& p : scene.points)
    {
      low = low.cwiseMin(camera * vector(p));
      high = high.cwiseMax(camera * vector(p));
    }
    m_center = 0.5 * (low + high);
    const double extent = (std::max)((high - low).x(), (high - low).y());
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
    : m_depth(static_cast<std::size_t>(size * size), -std::numeric_limits<double>::infinity())
  {
    m_view.width = m_view.height = size;
    m_view.element.assign(m_depth.size(), View::none);
    m_view.shade.assign(m_depth.size(), 0.f);
  }
  View&& view() { return std::move(m_view); }

  void put(const int x, const int y, const double depth, const std::size_t element,
           const float shade)
  {
    if (x < 0 || y < 0 || x >= m_view.width || y >= m_view.height) return;
    const std::size_t i = static_cast<std::size_t>(y * m_view.width + x);
    if (depth <= m_depth[i]) return;
    m_depth[i] = depth;
    m_view.element[i] = element;
    m_view.shade[i] = shade;
  }

  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const std::size_t element, const float shade)
  {
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
        if (s >= 0. && t >= 0. && s + t <= 1.)
          put(x, y, a.z() + s * u.z() + t * v.z(), element, shade);
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
  View m_view;
  std::vector<double> m_depth;
};

/// light from the eye, and some from above left
inline float shade(const Camera& camera, const Eigen::Vector3d& normal, const bool two_sided)
{
  const Eigen::Vector3d n = (camera * normal).normalized();
  double front = n.z(), above = 0.45 * n.y() - 0.3 * n.x() + 0.84 * n.z();
  if (two_sided && front < 0.) front = -front, above = -above;
  return static_cast<float>(0.25 + 0.4 * (std::max)(0., front) + 0.4 * (std::max)(0., above));
}

} // namespace internal

/// looks at the scene from far away.
inline View look(const Scene& scene, const Camera& camera, const int size)
{
  const internal::Projection project(scene, camera, size);
  internal::Canvas canvas(size);
  if (scene.faces.empty())
  {
    const double radius =
        std::clamp(size / std::sqrt(static_cast<double>(scene.points.size())), 1., 10.);
    for (std::size_t i = 0; i < scene.points.size(); ++i)
    {
      const bool has_normal = i < scene.normals.size();
      const float shade =
          has_normal ? internal::shade(camera, internal::vector(scene.normals[i]), true) : 0.9f;
      canvas.splat(project(scene.points[i]), radius, i, shade);
    }
    return canvas.view();
  }
  std::vector<Eigen::Vector3d> corners;
  for (const Point& p : scene.points) corners.push_back(project(p));
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
  {
    const auto& [a, b, c] = scene.faces[f];
    const Eigen::Vector3d origin = internal::vector(scene.points[a]);
    const Eigen::Vector3d normal = (internal::vector(scene.points[b]) - origin)
                                       .cross(internal::vector(scene.points[c]) - origin);
    canvas.triangle(corners[a], corners[b], corners[c], f, internal::shade(camera, normal, true));
  }
  return canvas.view();
}

/// how much of the parts is seen: the entropy of their shares of the picture, nothing a part too.
inline double visible_detail(const View& view, const std::vector<int>& labels)
{
  std::map<int, double> pixels;
  for (const std::size_t e : view.element) pixels[e == View::none ? -1 : labels[e]] += 1.;
  double entropy = 0.;
  for (const auto& entry : pixels)
  {
    const double share = entry.second / static_cast<double>(view.element.size());
    entropy -= share * std::log(share);
  }
  return entropy;
}

/// returns the one of several slanted views of the principal axes that shows most of the parts. The
/// longest axis goes to the right, or upwards if it is that of y.
inline Camera best_camera(const Scene& scene, const std::vector<int>& labels)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Point& p : scene.points)
    mean += internal::vector(p) / static_cast<double>(scene.points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point& p : scene.points)
  {
    const Eigen::Vector3d d = internal::vector(p) - mean;
    spread += d * d.transpose();
  }
  const Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().transpose();
  Eigen::Vector3d right = axes.row(2), up = axes.row(1);
  if (std::abs(right.y()) > 0.7) std::swap(right, up);
  if (up.y() < 0.) up = -up;
  Camera best = Camera::Identity();
  double most = -1.;
  for (const double side : {-1., 1.})
    for (const double turn : {-0.6, 0.6})
      for (const double tilt : {-0.5, 0.5})
      {
        const Eigen::Vector3d r = side * right, out = r.cross(up);
        Camera camera;
        camera.row(2) = (out + turn * r + tilt * up).normalized();
        camera.row(0) = up.cross(Eigen::Vector3d(camera.row(2))).normalized();
        camera.row(1) = Eigen::Vector3d(camera.row(2)).cross(Eigen::Vector3d(camera.row(0)));
        const double detail = visible_detail(look(scene, camera, 64), labels);
        if (detail > most) most = detail, best = camera;
      }
  return best;
}

/// writes the view at half its size as a PPM file; borders between parts are dark.
inline void write_picture(const View& view, const std::vector<int>& labels,
                          const std::vector<Color>& color_of_label,
                          const std::filesystem::path& path)
{
  const auto label_at = [&](const int x, const int y)
  {
    const std::size_t e = view.element[static_cast<std::size_t>(y * view.width + x)];
    return e == View::none ? -1 : labels[e];
  };
  std::ofstream out(path, std::ios::binary);
  out << "P6\n" << view.width / 2 << ' ' << view.height / 2 << "\n255\n";
  for (int y = 0; y + 1 < view.height; y += 2)
    for (int x = 0; x + 1 < view.width; x += 2)
    {
      std::array<float, 3> sum{};
      for (const auto& [i, j] : {std::pair(x, y), {x + 1, y}, {x, y + 1}, {x + 1, y + 1}})
      {
        const int label = label_at(i, j);
        const bool border = label >= 0 && i > 0 && j > 0 &&
                            (label_at(i - 1, j) != label || label_at(i, j - 1) != label);
        const float shade = view.shade[static_cast<std::size_t>(j * view.width + i)];
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] +=
              label < 0
                  ? 255.f
                  : (border ? 0.4f : 1.f) *
                        (std::min)(255.f,
                                   shade * color_of_label.at(static_cast<std::size_t>(label))[c]);
      }
      for (const float s : sum) out.put(static_cast<char>(static_cast<unsigned char>(s / 4.f)));
    }
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

} // namespace Draw_parts

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_REPORT_DRAW_PARTS_H
