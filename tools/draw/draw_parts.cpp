// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "draw/draw_parts.h"

#include "draw/canvas.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Draw_parts {

namespace {

using internal::Projection;
using internal::vector;

// light from the eye, and some from above left
float shade(const Camera& camera, const Eigen::Vector3d& normal)
{
  Eigen::Vector3d n = (camera * normal).normalized();
  if (n.z() < 0.) n = -n; // both sides are lit
  const double above = 0.45 * n.y() - 0.3 * n.x() + 0.84 * n.z();
  return static_cast<float>(0.55 + 0.2 * n.z() + 0.3 * (std::max)(0., above));
}

// The normals of the corners of all faces: the mean of those around, but not across sharp edges.
std::vector<std::array<Eigen::Vector3d, 3>> corner_normals(const Scene& scene)
{
  std::vector<Eigen::Vector3d> normals; // as long as twice the area
  std::vector<std::vector<std::size_t>> around(scene.points.size());
  for (const auto& [a, b, c] : scene.faces)
  {
    const Eigen::Vector3d origin = vector(scene.points[a]);
    for (const std::size_t corner : {a, b, c}) around[corner].push_back(normals.size());
    normals.push_back((vector(scene.points[b]) - origin).cross(vector(scene.points[c]) - origin));
  }
  std::vector<std::array<Eigen::Vector3d, 3>> result(scene.faces.size());
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
    {
      result[f][i] = Eigen::Vector3d::Zero();
      for (const std::size_t other : around[scene.faces[f][i]])
        if (normals[f].dot(normals[other]) >= 0.75 * normals[f].norm() * normals[other].norm())
          result[f][i] += normals[other];
    }
  return result;
}

void draw_points(const Scene& scene, const Camera& camera, const Projection& project,
                 internal::Canvas& canvas)
{
  const double radius = std::clamp(
      1.8 * canvas.size() / std::sqrt(static_cast<double>(scene.points.size())), 1.5, 24.);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
  {
    const bool has_normal = i < scene.normals.size();
    canvas.splat(project(scene.points[i]), radius, i,
                 has_normal ? shade(camera, vector(scene.normals[i])) : 0.95f);
  }
}

void draw_faces(const Scene& scene, const Camera& camera, const Projection& project,
                internal::Canvas& canvas)
{
  const auto normals = corner_normals(scene);
  std::vector<Eigen::Vector3d> corners;
  for (const Point& p : scene.points) corners.push_back(project(p));
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
  {
    const auto& [a, b, c] = scene.faces[f];
    canvas.triangle(
        {corners[a], corners[b], corners[c]}, f,
        {shade(camera, normals[f][0]), shade(camera, normals[f][1]), shade(camera, normals[f][2])});
  }
}

View look_at_samples(const Scene& scene, const Camera& camera, const int size,
                     const internal::Scale scale)
{
  const Projection project(scene, camera, size, scale);
  internal::Canvas canvas(size);
  if (scene.faces.empty())
    draw_points(scene, camera, project, canvas);
  else
    draw_faces(scene, camera, project, canvas);
  View view = canvas.take_view();
  if (!scene.sources.empty())
    for (std::size_t& e : view.element)
      if (e != View::none) e = scene.sources[e];
  return view;
}

// how much of the parts is seen: the entropy of their shares of the picture, nothing a part too
double visible_detail(const View& view, const std::vector<int>& labels)
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

Camera camera_from(const Eigen::Vector3d& eye, const Eigen::Vector3d& up)
{
  Camera camera;
  const Eigen::Vector3d out = eye.normalized(), right = up.cross(out).normalized();
  camera << right.transpose(), out.cross(right).transpose(), out.transpose();
  return camera;
}

Camera best_of(const std::vector<Camera>& cameras, const Scene& scene,
               const std::vector<int>& labels)
{
  Camera best = cameras.front();
  double most = -1.;
  for (const Camera& camera : cameras)
  {
    const double detail = visible_detail(
        look_at_samples(scene, camera, 64, internal::Scale::SAME_FROM_ALL_SIDES), labels);
    if (detail > most) most = detail, best = camera;
  }
  return best;
}

} // namespace

Scene make_scene(const Shape_io::Shape& shape, const std::vector<int>& labels)
{
  Scene scene;
  const auto add = [](const auto& v, std::vector<Point>& to) {
    to.push_back({v.x(), v.y(), v.z()});
  };
  if (shape.is_mesh())
    for (const auto& p : shape.points) add(p, scene.points);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (labels[i] < 0) continue;
    if (!shape.is_mesh())
    {
      add(shape.points[i], scene.points);
      if (!shape.normals.empty()) add(shape.normals[i], scene.normals);
      scene.sources.push_back(i);
      continue;
    }
    const auto& polygon = shape.polygons[i];
    for (std::size_t k = 2; k < polygon.size(); ++k)
    {
      scene.faces.push_back({polygon[0], polygon[k - 1], polygon[k]});
      scene.sources.push_back(i);
    }
  }
  return scene;
}

View look(const Scene& scene, const Camera& camera, const int size)
{
  return look_at_samples(scene, camera, size * samples, internal::Scale::FILLS_PICTURE);
}

Camera best_camera(const Scene& scene, const std::vector<int>& labels)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Point& p : scene.points) mean += vector(p) / static_cast<double>(scene.points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point& p : scene.points)
  {
    const Eigen::Vector3d d = vector(p) - mean;
    spread += d * d.transpose();
  }
  const Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().transpose();
  Eigen::Vector3d right = axes.row(2), up = axes.row(1);
  if (std::abs(right.y()) > 0.7) std::swap(right, up);
  if (up.y() < 0.) up = -up;
  std::vector<Camera> cameras;
  for (const double side : {-1., 1.})
    for (const double turn : {-0.6, 0.6})
      for (const double tilt : {-0.5, 0.5})
      {
        const Eigen::Vector3d r = side * right;
        cameras.push_back(camera_from(r.cross(up) + turn * r + tilt * up, up));
      }
  return best_of(cameras, scene, labels);
}

Camera best_upright_camera(const Scene& scene, const std::vector<int>& labels, const Point& up)
{
  const double pi = std::acos(-1.);
  const Eigen::Vector3d upwards = vector(up), right(up[2], up[0], up[1]);
  std::vector<Camera> cameras;
  // shapes often stand along the axes, and look flat straight from the front
  for (const int degrees : {30, 60, 120, 150, 210, 240, 300, 330})
    cameras.push_back(camera_from(
        Eigen::AngleAxisd(degrees * pi / 180., upwards) * right + 0.35 * upwards, upwards));
  return best_of(cameras, scene, labels);
}

namespace {

// Lines are where another part, or nothing, is near, or where something far behind begins.
bool is_on_line(const View& view, const std::vector<int>& labels, const int x, const int y)
{
  constexpr int reach = 2; // samples to both sides
  const auto index = [&](const int i, const int j)
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(view.width) +
           static_cast<std::size_t>(i);
  };
  const auto label = [&](const std::size_t i)
  { return view.element[i] == View::none ? -1 : labels[view.element[i]]; };
  const std::size_t here = index(x, y);
  const float jump = 0.04f * static_cast<float>(view.width);
  for (const auto& [dx, dy] : {std::pair(reach, 0),
                               {-reach, 0},
                               {0, reach},
                               {0, -reach},
                               {1, 1},
                               {1, -1},
                               {-1, 1},
                               {-1, -1}})
  {
    if (x + dx < 0 || x + dx >= view.width || y + dy < 0 || y + dy >= view.height) continue;
    const std::size_t there = index(x + dx, y + dy);
    if (label(there) != label(here) || std::abs(view.depth[there] - view.depth[here]) > jump)
      return true;
  }
  return false;
}

// Dark colors show light and shade too.
float pale(const unsigned char channel)
{
  return 0.84f * static_cast<float>(channel) + 0.16f * 255.f;
}

} // namespace

Picture make_picture(const View& view, const std::vector<int>& labels,
                     const std::vector<Color>& color_of_label)
{
  std::vector<std::array<float, 3>> sums(static_cast<std::size_t>(view.width / samples) *
                                         static_cast<std::size_t>(view.height / samples));
  Picture picture(view.width / samples, view.height / samples);
  std::size_t i = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x, ++i)
    {
      const std::size_t e = view.element[i];
      const float light = view.shade[i] * (is_on_line(view, labels, x, y) ? 0.3f : 1.f);
      auto& sum = sums[static_cast<std::size_t>(y / samples * picture.width + x / samples)];
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += e == View::none
                      ? static_cast<float>(paper[c])
                      : (std::min)(255.f, light * pale(color_of_label.at(
                                                      static_cast<std::size_t>(labels[e]))[c]));
    }
  for (std::size_t p = 0; p < sums.size(); ++p)
    for (std::size_t c = 0; c < 3; ++c)
      picture.pixels[p][c] = static_cast<unsigned char>(sums[p][c] / (samples * samples) + 0.5f);
  return picture;
}

} // namespace Draw_parts
