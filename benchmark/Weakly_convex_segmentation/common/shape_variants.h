// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SHAPE_VARIANTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SHAPE_VARIANTS_H

#include "metrics/princeton_benchmark.h"
#include "scanner/virtual_scanner.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What a labeled mesh is turned into before it is segmented, to fit and to score on more than meshes.

namespace Shape_variants {

namespace SM = Segmentation_metrics;
namespace WCS = CGAL::Weakly_convex_segmentation;
using WCS::internal::Raw_shape;

enum class Variant
{
  MESH,       ///< as it is
  POINTS,     ///< face centroids without the mesh
  HALF,       ///< a random half of the face centroids
  SURFACE,    ///< 10,000 points spread evenly over the surface
  ONE_VIEW,   ///< the face centroids that are seen from a random side
  TWO_VIEWS,  ///< the same from two sides
  FOUR_VIEWS, ///< the same from four sides
  NOISY_SCAN, ///< what a depth camera with realistic noise sees from 1, 2, 4 or 8 sides
  STRETCHED,  ///< the mesh stretched or squeezed along a random direction, by up to half
  NOISY_MESH, ///< the mesh with noise of .05 to 1 % of its diagonal on its vertices
  HULL ///< the flattened convex hull of a random part, a mesh or points without normals: one part
};

inline Variant variant_of_name(const std::string& name)
{
  const std::vector<std::pair<Variant, std::string>> names = {{Variant::MESH, "mesh"},
                                                              {Variant::POINTS, "points"},
                                                              {Variant::HALF, "half"},
                                                              {Variant::SURFACE, "surface"},
                                                              {Variant::ONE_VIEW, "one_view"},
                                                              {Variant::TWO_VIEWS, "two_views"},
                                                              {Variant::FOUR_VIEWS, "four_views"},
                                                              {Variant::NOISY_SCAN, "noisy_scan"},
                                                              {Variant::STRETCHED, "stretched"},
                                                              {Variant::NOISY_MESH, "noisy_mesh"},
                                                              {Variant::HULL, "hull"}};
  for (const auto& [variant, its_name] : names)
    if (name == its_name) return variant;
  throw std::invalid_argument("there is no variant '" + name + "'");
}

/// A shape to segment, and the face of the mesh that each of its elements comes from.
struct Variant_shape
{
  Raw_shape raw;
  std::vector<std::size_t> faces;
};

inline Raw_shape read_raw(const SM::Mesh& mesh)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  return WCS::internal::read_soup(
      points, mesh.faces, CGAL::Identity_property_map<CGAL::Simple_cartesian<double>::Point_3>());
}

/// returns which faces are seen from `views` random directions.
inline std::vector<char> seen_faces(const Raw_shape& raw, const int views, std::mt19937& random)
{
  WCS::Parameters parameters;
  parameters.number_of_representatives = 1000000;
  WCS::internal::Oriented_points points = WCS::internal::orient_points(raw);
  const auto graph = WCS::internal::build_neighbor_graph(points, 10, false);
  const WCS::internal::Line_of_sight_query sight(points, graph, parameters);
  std::vector<char> seen(points.size(), 0);
  std::normal_distribution<float> normal;
  for (int view = 0; view < views; ++view)
  {
    const auto camera =
        2.f * WCS::internal::normalized({normal(random), normal(random), 0.5f * normal(random)});
    for (std::size_t i = 0; i < points.size(); ++i)
      if (dot(points.normals[i], camera - points.positions[i]) > 0.f &&
          sight.is_free(points.positions[i], camera))
        seen[points.elements[i]] = 1;
  }
  return seen;
}

/// returns the centroids of the faces that are kept.
inline Variant_shape kept_centroids(const Raw_shape& whole, const std::vector<char>& keep)
{
  Variant_shape shape;
  for (std::size_t f = 0; f < keep.size(); ++f)
    if (keep[f] != 0)
    {
      shape.raw.positions.push_back(whole.positions[f]);
      shape.raw.normals.push_back(whole.normals[f]);
      shape.faces.push_back(f);
    }
  return shape;
}

/// returns `count` random points, as many a face as its area asks for.
inline Variant_shape surface_points(const SM::Mesh& mesh, const Raw_shape& whole,
                                    const std::size_t count, std::mt19937& random)
{
  std::vector<double> until; // area of the faces up to each
  for (const auto& [a, b, c] : mesh.faces)
    until.push_back((until.empty() ? 0. : until.back()) +
                    SM::internal::triangle_area(mesh.points[a], mesh.points[b], mesh.points[c]));
  std::uniform_real_distribution<double> uniform(0., 1.);
  Variant_shape shape;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double along = (static_cast<double>(i) + uniform(random)) / static_cast<double>(count);
    const auto it = std::lower_bound(until.begin(), until.end(), along * until.back());
    const std::size_t f =
        (std::min)(static_cast<std::size_t>(it - until.begin()), until.size() - 1);
    const double s = std::sqrt(uniform(random)), t = uniform(random);
    const std::array<double, 3> weights = {1. - s, s * (1. - t), s * t};
    std::array<double, 3> p{};
    for (int k = 0; k < 3; ++k)
      for (int x = 0; x < 3; ++x) p[x] += weights[k] * mesh.points[mesh.faces[f][k]][x];
    shape.raw.positions.push_back(p);
    shape.raw.normals.push_back(whole.normals[f]);
    shape.faces.push_back(f);
  }
  return shape;
}

inline Variant_shape noisy_scan(const SM::Mesh& mesh, const unsigned int seed)
{
  std::mt19937 random(seed);
  const auto scan = Virtual_scanner::scan_mesh(mesh, std::size_t(1) << random() % 4,
                                               Virtual_scanner::realistic_camera(), seed);
  Variant_shape shape;
  shape.raw.positions.assign(scan.points.begin(), scan.points.end());
  shape.raw.normals.assign(scan.normals.begin(), scan.normals.end());
  shape.faces = scan.faces;
  return shape;
}

inline SM::Mesh moved(SM::Mesh mesh, const std::function<SM::Point(const SM::Point&)>& move)
{
  for (SM::Point& p : mesh.points) p = move(p);
  return mesh;
}

inline double diagonal(const SM::Mesh& mesh)
{
  SM::Point low = mesh.points.front(), high = low;
  for (const SM::Point& p : mesh.points)
    for (std::size_t x = 0; x < 3; ++x)
    {
      low[x] = (std::min)(low[x], p[x]);
      high[x] = (std::max)(high[x], p[x]);
    }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

inline SM::Mesh noisy(const SM::Mesh& mesh, const double deviation, std::mt19937& random)
{
  std::normal_distribution<double> noise(0., deviation);
  return moved(mesh,
               [&](const SM::Point& p) {
                 return SM::Point{p[0] + noise(random), p[1] + noise(random), p[2] + noise(random)};
               });
}

/// stretches along a random direction.
inline SM::Mesh stretched(const SM::Mesh& mesh, const double factor, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const SM::Point d = {normal(random), normal(random), normal(random)};
  const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  return moved(mesh,
               [&](const SM::Point& p)
               {
                 const double along = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
                 const double shift = (factor - 1.) * along / squared;
                 return SM::Point{p[0] + shift * d[0], p[1] + shift * d[1], p[2] + shift * d[2]};
               });
}

/// returns a random number, as likely within a factor anywhere between these.
inline double random_factor(const double low, const double high, std::mt19937& random)
{
  return low * std::pow(high / low, std::uniform_real_distribution<double>(0., 1.)(random));
}

/// returns the convex hull of a random part, larger ones more often, flattened by up to 200: one part to everybody, as
/// no labeled shape is. Half of them are points without normals.
inline Variant_shape hull_of_part(const SM::Mesh& mesh,
                                  const std::vector<SM::Segmentation>& segmentations,
                                  std::mt19937& random)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const SM::Segmentation& labels = segmentations.at(random() % segmentations.size());
  const std::size_t its_face = random() % labels.size();
  std::vector<Point> points;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (labels[f] == labels[its_face])
      for (const std::size_t v : mesh.faces[f])
        points.emplace_back(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
  CGAL::Surface_mesh<Point> hull_mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), hull_mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(hull_mesh); // of a flat part
  points.clear();
  SM::Mesh hull;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(hull_mesh, points, hull.faces);
  for (const Point& p : points) hull.points.push_back({p.x(), p.y(), p.z()});
  hull = stretched(hull, random_factor(0.005, 1., random), random);
  Variant_shape shape = {read_raw(hull), std::vector<std::size_t>(hull.faces.size())};
  if (random() % 2 == 0)
  {
    shape = surface_points(hull, shape.raw, 5000, random);
    shape.raw.normals.clear();
  }
  std::fill(shape.faces.begin(), shape.faces.end(), its_face);
  return shape;
}

/// returns a variant of a mesh; `segmentations` are people's.
inline Variant_shape make_variant(SM::Mesh mesh, const Variant variant, const unsigned int seed,
                                  const std::vector<SM::Segmentation>& segmentations = {})
{
  std::mt19937 random(seed);
  if (variant == Variant::HULL) return hull_of_part(mesh, segmentations, random);
  if (variant == Variant::STRETCHED)
    mesh = stretched(mesh, random_factor(2. / 3., 1.5, random), random);
  if (variant == Variant::NOISY_MESH)
    mesh = noisy(mesh, random_factor(0.0005, 0.01, random) * diagonal(mesh), random);
  Variant_shape shape;
  shape.raw = read_raw(mesh);
  if (variant == Variant::MESH || variant == Variant::STRETCHED || variant == Variant::NOISY_MESH)
  {
    shape.faces.resize(mesh.faces.size());
    std::iota(shape.faces.begin(), shape.faces.end(), std::size_t(0));
    return shape;
  }
  if (variant == Variant::SURFACE) return surface_points(mesh, shape.raw, 10000, random);
  if (variant == Variant::NOISY_SCAN) return noisy_scan(mesh, seed);
  std::vector<char> keep(shape.raw.positions.size(), 1);
  if (variant == Variant::HALF)
    for (char& k : keep) k = random() % 2 == 0 ? 1 : 0;
  if (variant == Variant::ONE_VIEW) keep = seen_faces(shape.raw, 1, random);
  if (variant == Variant::TWO_VIEWS) keep = seen_faces(shape.raw, 2, random);
  if (variant == Variant::FOUR_VIEWS) keep = seen_faces(shape.raw, 4, random);
  return kept_centroids(shape.raw, keep);
}

} // namespace Shape_variants

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SHAPE_VARIANTS_H
