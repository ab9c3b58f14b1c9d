// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_MADE_SCANS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_MADE_SCANS_H

#include "scanner/virtual_scanner.h"
#include "scans/posed_figures.h"
#include "shapes/shape_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// Clouds like those of the paper's Figures 5 and 10: shapes made in code, as a range scanner sees them from a
// few sides, and a room; with the true part, or object, of each point.

namespace Made_scans {

using Shape_generator::Labeled_mesh;
using Virtual_scanner::Point;
using Virtual_scanner::Scan;

/// A shape, of the generator or a pose of the figure, and where it is looked at from; z is up.
struct Single_scan
{
  std::string name;
  std::string pose; ///< empty: the name is that of a shape
  std::vector<Point> from;
};

inline const std::vector<Single_scan>& single_scans()
{
  static const std::vector<Single_scan> scans = {
      {"pose_tree", "tree", {{-0.5, -1., 0.2}, {0.7, -0.8, 0.4}}},
      {"pose_warrior", "warrior", {{-0.3, -1., 0.3}, {0.6, -0.9, 0.1}, {0.2, 1., 0.4}}},
      {"pose_sitting", "sitting", {{-0.8, -0.8, 0.4}, {0.7, -0.7, 0.5}}},
      {"four_leg", "", {{0.4, -1., 0.5}, {-0.6, -0.8, 0.2}}},
      {"ant", "", {{0.3, -0.6, 1.}, {0.2, 0.8, 0.6}}},
      {"octopus", "", {{0.9, -0.5, 0.8}, {-0.6, -0.7, 0.6}, {-0.1, 1., 0.5}}},
      {"hand", "", {{0.1, -1., 0.2}, {0.9, 0.5, 0.3}}},
      {"airplane", "", {{0.1, 0.05, 1.}}},
      {"chair", "", {{0.8, -0.9, 0.6}, {-0.9, -0.6, 0.3}}},
      {"cup", "", {{0.5, -1., 0.6}, {0.8, 0.8, 0.4}}}};
  return scans;
}

/// An object in the room, turned about z, then moved.
struct Placed_object
{
  std::string name, shape;
  double size, degrees;
  Point place;
};

inline const std::vector<Placed_object>& room_objects()
{
  static const std::vector<Placed_object> objects = {
      {"desk", "table", 1.3, 0., {0., 1.2, 0.}},
      {"cup", "cup", 0.3, 30., {0.45, 1.05, 0.858}},
      {"chair", "chair", 0.95, 180., {0., 0.35, 0.}},
      {"person", "sitting", 1.75, 180., {0., 0.38, -0.296}},
      {"other chair", "chair", 0.95, 75., {1.5, 0.5, 0.}},
      {"cabinet", "box", 1.1, 90., {-1.75, 1.3, 0.275}},
      {"dog", "four_leg", 0.75, 215., {-1.2, -0.5, 0.}},
      {"ball", "sphere", 0.45, 0., {0.8, -1.1, 0.225}}};
  return objects;
}

/// what is no object has this label
constexpr int background = -1;

inline Labeled_mesh mesh_of(const std::string& shape, const std::size_t faces)
{
  const auto names = Shape_generator::shape_names();
  return std::find(names.begin(), names.end(), shape) != names.end()
             ? Shape_generator::make_mesh(shape, faces)
             : Posed_figures::make_mesh(shape, faces);
}

/// adds a mesh, turned and moved, all of it with one label.
inline void place(const Labeled_mesh& mesh, const Placed_object& object, const int label,
                  Labeled_mesh& room)
{
  constexpr double pi = 3.14159265358979323846;
  const double c = std::cos(object.degrees * pi / 180.), s = std::sin(object.degrees * pi / 180.);
  const std::size_t first = room.points.size();
  for (const Point& p : mesh.points)
    room.points.push_back({object.place[0] + object.size * (c * p[0] - s * p[1]),
                           object.place[1] + object.size * (s * p[0] + c * p[1]),
                           object.place[2] + object.size * p[2]});
  for (const auto& f : mesh.faces)
  {
    room.faces.push_back({first + f[0], first + f[1], first + f[2]});
    room.labels.push_back(label);
  }
}

/// adds a rectangle, of the floor or a wall.
inline void add_background(const std::array<Point, 4>& corners, Labeled_mesh& room)
{
  const std::size_t first = room.points.size();
  room.points.insert(room.points.end(), corners.begin(), corners.end());
  for (const std::size_t i : {1, 2})
  {
    room.faces.push_back({first, first + i, first + i + 1});
    room.labels.push_back(background);
  }
}

/// returns a room with a floor and two walls.
inline Labeled_mesh make_room()
{
  constexpr double half = 2.4, height = 2.2;
  Labeled_mesh room;
  add_background({{{-half, -half, 0.}, {half, -half, 0.}, {half, half, 0.}, {-half, half, 0.}}},
                 room);
  add_background(
      {{{-half, half, 0.}, {half, half, 0.}, {half, half, height}, {-half, half, height}}}, room);
  add_background(
      {{{-half, -half, 0.}, {-half, half, 0.}, {-half, half, height}, {-half, -half, height}}},
      room);
  for (const Placed_object& object : room_objects())
  {
    room.part_names.push_back(object.name);
    place(mesh_of(object.shape, 12000), object, static_cast<int>(room.part_names.size()) - 1, room);
  }
  return room;
}

/// A cloud and the true label of each point.
struct Labeled_scan
{
  Scan scan;
  std::vector<int> labels;
};

/// scans a mesh from directions of any length, and leaves out the background.
inline Labeled_scan scan_labeled(const Labeled_mesh& mesh, std::vector<Point> from,
                                 const Virtual_scanner::Camera& camera)
{
  for (Point& direction : from) direction = Virtual_scanner::internal::normalized(direction);
  const Scan all = Virtual_scanner::scan_mesh(mesh, from, camera, 0);
  Labeled_scan result;
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    const int label = mesh.labels[all.faces[i]];
    if (label == background) continue;
    result.scan.points.push_back(all.points[i]);
    result.scan.normals.push_back(all.normals[i]);
    result.scan.faces.push_back(all.faces[i]);
    result.scan.views.push_back(all.views[i]);
    result.labels.push_back(label);
  }
  return result;
}

/// returns the room from three sides, or one of the single shapes.
inline Labeled_scan make_scan(const std::string& name)
{
  Virtual_scanner::Camera camera;
  if (name == "room")
  {
    camera.resolution = 420;
    return scan_labeled(make_room(), {{0.3, -0.85, 0.5}, {0.9, -0.3, 0.5}, {0.6, -0.6, 0.8}},
                        camera);
  }
  camera.noise = 0.0005; // a range scanner's: a quarter of that of depth cameras
  camera.normal_radius = 3;
  for (const Single_scan& single : single_scans())
    if (single.name == name)
      return scan_labeled(mesh_of(single.pose.empty() ? name : single.pose, 12000), single.from,
                          camera);
  throw std::invalid_argument("there is no scan '" + name + "'; see make_scans --help");
}

inline std::vector<std::string> scan_names()
{
  std::vector<std::string> names = {"room"};
  for (const Single_scan& single : single_scans()) names.push_back(single.name);
  return names;
}

} // namespace Made_scans

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_MADE_SCANS_H
