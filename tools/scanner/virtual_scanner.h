// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_VIRTUAL_SCANNER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_VIRTUAL_SCANNER_H

#include "scanner/depth_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

// A depth camera that looks at a mesh from some viewpoints, as scanners do: it sees one side of what is
// in front, with noise, and nothing of what it grazes. A depth buffer finds the first hits.
//
// A mesh is anything with `points` (three doubles each) and `faces` (three indices each).

namespace Virtual_scanner {

struct Camera
{
  std::size_t resolution = 200;  // pixels along a side of the square image
  double field_of_view = 40.;    // full angle along a side, in degrees
  double distance = 1.6;         // from the shape's center, in diameters of its bounding sphere
  double noise = 0.;             // standard deviation along the ray, in diameters
  double quantum = 0.;           // step of the measured depths, in diameters; 0: none
  double grazing_angle = 85.;    // degrees between ray and normal from which nothing returns
  std::size_t normal_radius = 2; // half side of the window of pixels that a normal comes from
};

// What a depth camera of the time when they became common measures of an object of half a meter from
// a meter away: an error of a millimeter, steps of half a millimeter.
Camera realistic_camera();

struct Scan
{
  std::vector<Point> points;
  std::vector<Point> normals;     // of length one, towards the camera that saw the point
  std::vector<std::size_t> faces; // which face of the mesh was hit
  std::vector<int> views;         // which viewpoint saw it
};

struct Bounding_sphere
{
  Point center{};
  double diameter = 0.;
};

namespace internal {

struct Pose
{
  Point eye{}, right{}, up{}, forward{};
};

struct Hit
{
  double depth = std::numeric_limits<double>::infinity(); // along the viewing direction
  std::size_t face = 0;
};

Pose look_at(const Point& eye, const Point& target);

// A point in the image: column and row in pixels, and 1 / depth, which is linear in both.
Point project(const Pose& pose, const Point& p, double focal, double middle);

void draw(const std::array<Point, 3>& t, std::size_t face, std::size_t side,
          std::vector<Hit>& hits);

template <typename Mesh>
Point face_normal(const Mesh& mesh, const std::size_t face)
{
  const auto& f = mesh.faces[face];
  return normalized(
      cross(mesh.points[f[1]] - mesh.points[f[0]], mesh.points[f[2]] - mesh.points[f[0]]));
}

template <typename Mesh>
std::vector<Hit> first_hits(const Mesh& mesh, const Pose& pose, const Camera& camera,
                            const double focal)
{
  const double middle = 0.5 * (static_cast<double>(camera.resolution) - 1.);
  std::vector<Point> projected;
  for (const auto& p : mesh.points) projected.push_back(project(pose, p, focal, middle));
  std::vector<Hit> hits(camera.resolution * camera.resolution);
  for (std::size_t face = 0; face < mesh.faces.size(); ++face)
  {
    const auto& f = mesh.faces[face];
    const std::array<Point, 3> triangle = {projected[f[0]], projected[f[1]], projected[f[2]]};
    // what is behind the camera is not in the image
    if (triangle[0][2] > 0. && triangle[1][2] > 0. && triangle[2][2] > 0.)
      draw(triangle, face, camera.resolution, hits);
  }
  return hits;
}

double measured(double range, const Camera& camera, double diameter, std::mt19937& random);

template <typename Mesh>
void scan_from(const Mesh& mesh, const Pose& pose, const int view, const Camera& camera,
               const double diameter, std::mt19937& random, Scan& scan)
{
  constexpr double pi = 3.14159265358979323846;
  const std::size_t side = camera.resolution;
  const double middle = 0.5 * (static_cast<double>(side) - 1.);
  const double focal = middle / std::tan(0.5 * camera.field_of_view * pi / 180.);
  const double least_cosine = std::cos(camera.grazing_angle * pi / 180.);
  const std::vector<Hit> hits = first_hits(mesh, pose, camera, focal);
  Depth_image image{side, side, std::vector<Point>(hits.size()), std::vector<char>(hits.size(), 0)};
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    if (!std::isfinite(hits[i].depth)) continue;
    const double x = (static_cast<double>(i % side) - middle) / focal;
    const double y = (static_cast<double>(i / side) - middle) / focal;
    const Point ray = pose.forward + x * pose.right + y * pose.up;
    const Point unit = normalized(ray);
    // either side of a face is seen: scanners don't know which is the outer one
    if (std::abs(dot(unit, face_normal(mesh, hits[i].face))) < least_cosine) continue;
    const double range = hits[i].depth * std::sqrt(dot(ray, ray));
    image.points[i] = pose.eye + measured(range, camera, diameter, random) * unit;
    image.is_known[i] = 1;
  }
  const std::vector<Point> normals = estimate_normals(image, pose.eye, camera.normal_radius);
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    if (image.is_known[i] == 0 || dot(normals[i], normals[i]) == 0.) continue;
    scan.points.push_back(image.points[i]);
    scan.normals.push_back(normals[i]);
    scan.faces.push_back(hits[i].face);
    scan.views.push_back(view);
  }
}

} // namespace internal

// A sphere that holds the mesh, about the center of its bounding box.
template <typename Mesh>
Bounding_sphere bounding_sphere(const Mesh& mesh)
{
  if (mesh.points.empty() || mesh.faces.empty())
    throw std::invalid_argument("Virtual_scanner: the mesh has no faces; there is nothing to scan");
  Point low = mesh.points.front(), high = low;
  for (const auto& p : mesh.points)
    for (int i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  Bounding_sphere sphere;
  sphere.center = 0.5 * (low + high);
  for (const auto& p : mesh.points)
  {
    const Point d = p - sphere.center;
    sphere.diameter = (std::max)(sphere.diameter, 2. * std::sqrt(dot(d, d)));
  }
  if (!(sphere.diameter > 0.))
    throw std::invalid_argument("Virtual_scanner: the mesh has no extent; check its points");
  return sphere;
}

// Directions spread evenly over the sphere, turned at random by the seed.
std::vector<Point> view_directions(std::size_t count, unsigned seed);

// The points that a camera sees from viewpoints in these directions, of length one, from the mesh.
// Throws std::invalid_argument for a mesh without faces or extent and for a camera that sees nothing.
template <typename Mesh>
Scan scan_mesh(const Mesh& mesh, const std::vector<Point>& directions, const Camera& camera,
               const unsigned seed)
{
  if (camera.resolution < 2 || camera.resolution > 10000)
    throw std::invalid_argument("Virtual_scanner: the resolution has to be from 2 to 10000 pixels");
  if (!(camera.field_of_view > 0. && camera.field_of_view < 179.))
    throw std::invalid_argument("Virtual_scanner: the field of view has to be within 0 and 179");
  if (!(camera.distance > 0.5))
    throw std::invalid_argument(
        "Virtual_scanner: the camera has to be outside of the shape: take a "
        "distance above 0.5 diameters");
  if (!(camera.noise >= 0. && camera.quantum >= 0.))
    throw std::invalid_argument("Virtual_scanner: noise and quantum have to be at least 0");
  const Bounding_sphere sphere = bounding_sphere(mesh);
  std::mt19937 random(seed);
  Scan scan;
  int view = 0;
  for (const Point& direction : directions)
  {
    const Point eye = sphere.center + camera.distance * sphere.diameter * direction;
    internal::scan_from(mesh, internal::look_at(eye, sphere.center), view++, camera,
                        sphere.diameter, random, scan);
  }
  return scan;
}

// The same from `views` viewpoints all around the mesh.
template <typename Mesh>
Scan scan_mesh(const Mesh& mesh, const std::size_t views, const Camera& camera, const unsigned seed)
{
  return scan_mesh(mesh, view_directions(views, seed), camera, seed);
}

} // namespace Virtual_scanner

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_VIRTUAL_SCANNER_H
