// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_MESH_GEOMETRY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_MESH_GEOMETRY_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

// What the measures of segmentation_metrics.h need to know of a mesh and of a segmentation,
// computed once each, however many segmentations are compared.

namespace Segmentation_metrics {

using Point = std::array<double, 3>;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> faces;
};

// One label a face; any values, connected or not: faces of equal label are one segment.
using Segmentation = std::vector<int>;

// Two faces and the ends of the edge they share. An edge of k faces makes k - 1 of these.
struct Face_adjacency
{
  std::array<std::size_t, 2> vertices;
  std::array<std::size_t, 2> faces;
};

struct Neighbor
{
  std::size_t vertex;
  double length;
};

// What the measures need to know of a mesh; independent of any segmentation.
struct Mesh_geometry
{
  std::vector<double> face_areas;
  double mean_radius = 0.; // area-weighted mean distance of face centroids to the centroid
  std::vector<Face_adjacency> adjacencies;
  std::vector<std::size_t> first_neighbor; // of vertex v: neighbors[first[v]] to [first[v + 1]]
  std::vector<Neighbor> neighbors;
};

// The vertices on the cuts of a segmentation, and the distance along edges from every vertex of
// the mesh to the nearest of them (infinite where none can be reached).
struct Cut_field
{
  std::vector<std::size_t> cut_vertices;
  std::vector<double> distances;
};

// A segmentation, ready to be compared with many others.
struct Prepared_segmentation
{
  std::vector<std::size_t> labels; // 0 to number_of_segments - 1, numbered as they appear
  std::size_t number_of_segments = 0;
  Cut_field cuts;
};

namespace internal {

inline Point subtract(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double norm(const Point& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

inline double triangle_area(const Point& a, const Point& b, const Point& c)
{
  const Point u = subtract(b, a);
  const Point v = subtract(c, a);
  return norm({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}) /
         2.;
}

inline void check_mesh(const Mesh& mesh)
{
  if (mesh.faces.empty())
    throw std::invalid_argument("The mesh has no faces, there is nothing to segment: "
                                "check that the right file was read.");
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const std::size_t v : mesh.faces[f])
      if (v >= mesh.points.size())
        throw std::invalid_argument("Face " + std::to_string(f) + " names vertex " +
                                    std::to_string(v) + ", but the mesh has only " +
                                    std::to_string(mesh.points.size()) +
                                    ": vertices are numbered from 0.");
}

// The cut discrepancy is measured in this length, so that the scale of the mesh does not matter.
inline double mean_radius(const Mesh& mesh, const std::vector<double>& areas)
{
  std::vector<Point> centroids;
  centroids.reserve(mesh.faces.size());
  Point center{0., 0., 0.};
  double total_area = 0.;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    Point centroid{0., 0., 0.};
    for (const std::size_t v : mesh.faces[f])
      for (std::size_t i = 0; i < 3; ++i) centroid[i] += mesh.points[v][i] / 3.;
    for (std::size_t i = 0; i < 3; ++i) center[i] += areas[f] * centroid[i];
    total_area += areas[f];
    centroids.push_back(centroid);
  }
  if (!(total_area > 0.) || !std::isfinite(total_area))
    throw std::invalid_argument("The area of the mesh is zero or not finite, so no measure is "
                                "defined: check the coordinates of the points.");
  for (double& coordinate : center) coordinate /= total_area;

  double sum = 0.;
  for (std::size_t f = 0; f < centroids.size(); ++f)
    sum += areas[f] * norm(subtract(centroids[f], center));
  return sum / total_area;
}

// Every edge once for every face at it, as (lower vertex, higher vertex, face), sorted.
using Edge_use = std::tuple<std::size_t, std::size_t, std::size_t>;

inline std::vector<Edge_use> sorted_edge_uses(const Mesh& mesh)
{
  std::vector<Edge_use> uses;
  uses.reserve(3 * mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax({mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]});
      if (low != high) // else a degenerate face, which has no such edge
        uses.emplace_back(low, high, f);
    }
  std::sort(uses.begin(), uses.end());
  return uses;
}

inline void set_neighbors(const Mesh& mesh, const std::vector<std::array<std::size_t, 2>>& edges,
                          Mesh_geometry& geometry)
{
  geometry.first_neighbor.assign(mesh.points.size() + 1, 0);
  for (const auto& edge : edges)
    for (const std::size_t v : edge) ++geometry.first_neighbor[v + 1];
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    geometry.first_neighbor[v + 1] += geometry.first_neighbor[v];

  std::vector<std::size_t> next(geometry.first_neighbor.begin(), geometry.first_neighbor.end());
  geometry.neighbors.resize(2 * edges.size());
  for (const auto& [v, w] : edges)
  {
    const double length = norm(subtract(mesh.points[v], mesh.points[w]));
    geometry.neighbors[next[v]++] = {w, length};
    geometry.neighbors[next[w]++] = {v, length};
  }
}

inline std::vector<double> distances_along_edges(const Mesh_geometry& geometry,
                                                 const std::vector<std::size_t>& sources)
{
  using Entry = std::pair<double, std::size_t>;
  const std::size_t number_of_vertices = geometry.first_neighbor.size() - 1;
  std::vector<double> distances(number_of_vertices, std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::size_t v : sources)
  {
    distances[v] = 0.;
    queue.emplace(0., v);
  }
  while (!queue.empty())
  {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue; // superseded by a shorter way found later
    for (std::size_t i = geometry.first_neighbor[v]; i < geometry.first_neighbor[v + 1]; ++i)
    {
      const Neighbor& neighbor = geometry.neighbors[i];
      const double candidate = distance + neighbor.length;
      if (candidate < distances[neighbor.vertex])
      {
        distances[neighbor.vertex] = candidate;
        queue.emplace(candidate, neighbor.vertex);
      }
    }
  }
  return distances;
}

} // namespace internal

inline Mesh_geometry compute_mesh_geometry(const Mesh& mesh)
{
  internal::check_mesh(mesh);
  Mesh_geometry geometry;
  geometry.face_areas.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces)
    geometry.face_areas.push_back(
        internal::triangle_area(mesh.points[a], mesh.points[b], mesh.points[c]));
  geometry.mean_radius = internal::mean_radius(mesh, geometry.face_areas);

  std::vector<std::array<std::size_t, 2>> edges;
  std::size_t previous_face = 0;
  for (const auto& [v, w, face] : internal::sorted_edge_uses(mesh))
  {
    const std::array<std::size_t, 2> edge{v, w};
    if (!edges.empty() && edges.back() == edge)
      geometry.adjacencies.push_back({edge, {previous_face, face}});
    else
      edges.push_back(edge);
    previous_face = face;
  }
  internal::set_neighbors(mesh, edges, geometry);
  return geometry;
}

template <typename Label>
Cut_field compute_cut_field(const Mesh_geometry& geometry, const std::vector<Label>& labels)
{
  if (labels.size() != geometry.face_areas.size())
    throw std::invalid_argument("The segmentation has " + std::to_string(labels.size()) +
                                " labels, but the mesh has " +
                                std::to_string(geometry.face_areas.size()) +
                                " faces: give one label a face, of the same mesh.");
  Cut_field field;
  std::vector<bool> is_cut(geometry.first_neighbor.size() - 1, false);
  for (const Face_adjacency& adjacency : geometry.adjacencies)
    if (labels[adjacency.faces[0]] != labels[adjacency.faces[1]])
      for (const std::size_t v : adjacency.vertices) is_cut[v] = true;
  for (std::size_t v = 0; v < is_cut.size(); ++v)
    if (is_cut[v]) field.cut_vertices.push_back(v);
  field.distances = internal::distances_along_edges(geometry, field.cut_vertices);
  return field;
}

inline Prepared_segmentation prepare(const Mesh_geometry& geometry,
                                     const Segmentation& segmentation)
{
  Prepared_segmentation prepared;
  prepared.labels.reserve(segmentation.size());
  std::unordered_map<int, std::size_t> numbers;
  for (const int label : segmentation)
    prepared.labels.push_back(numbers.emplace(label, numbers.size()).first->second);
  prepared.number_of_segments = numbers.size();
  prepared.cuts = compute_cut_field(geometry, prepared.labels);
  return prepared;
}

} // namespace Segmentation_metrics

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_MESH_GEOMETRY_H
