// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_BORDER_LINES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_BORDER_LINES_H

#include "metrics/mesh_geometry.h"
#include "parts/Part_labels.h"
#include "parts/Sampled_surface.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

// The borders of the parts as lines in space, the edges between faces of different parts: how straight they
// run, and whether along creases.

namespace Part_measures {

/// An edge between two parts: its ends among the vertices of the borders, and its faces.
struct Border_edge
{
  std::array<std::size_t, 2> vertices;
  SM::Face_adjacency mesh_edge;
};

/// The borders as a graph, where they are and where they would be without their zigzag.
struct Borders
{
  std::vector<Border_edge> edges;
  std::vector<Vector> positions, smooth_positions;
  std::vector<std::vector<std::size_t>> neighbors; ///< of the vertices

  double length(const Border_edge& e) const
  {
    return (positions[e.vertices[0]] - positions[e.vertices[1]]).norm();
  }
  double smooth_length(const Border_edge& e) const
  {
    return (smooth_positions[e.vertices[0]] - smooth_positions[e.vertices[1]]).norm();
  }
};

/// Sums, so that several labelings of a mesh can be added up.
struct Border_sums
{
  double length = 0., smooth_length = 0., concave_length = 0.;
  double turns = 0.; ///< in degrees, at vertices with two border edges
  double bends = 0.; ///< the number of these

  void add(const Border_sums& other)
  {
    length += other.length;
    smooth_length += other.smooth_length;
    concave_length += other.concave_length;
    turns += other.turns;
    bends += other.bends;
  }
  double roughness() const { return smooth_length > 0. ? length / smooth_length : 1.; }
  double mean_turn() const { return bends > 0. ? turns / bends : 0.; }
  double concave_share() const { return length > 0. ? concave_length / length : 0.; }
};

namespace internal {

constexpr double pi = 3.14159265358979323846;
constexpr double degrees = 180. / pi;

/// the angle between two directions in degrees, 0 if one of them has no length
inline double angle_between(const Vector& a, const Vector& b)
{
  return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

/// by how much the surface turns at the edge of two faces, in degrees: negative where it is hollow
inline double fold(const Sampled_surface& surface, const SM::Face_adjacency& edge)
{
  const auto [f, g] = edge.faces;
  const Vector &m = surface.normal(f), &n = surface.normal(g);
  const double angle = angle_between(m, n);
  return (n - m).dot(surface.centroid(g) - surface.centroid(f)) < 0. ? -angle : angle;
}

/// Moves each vertex of two edges half-way to the middle of its neighbors, all at once.
inline void smooth(Borders& borders, const int rounds)
{
  borders.smooth_positions = borders.positions;
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<Vector> before = borders.smooth_positions;
    for (std::size_t v = 0; v < before.size(); ++v)
      if (const auto& n = borders.neighbors[v]; n.size() == 2)
        borders.smooth_positions[v] = 0.5 * before[v] + 0.25 * (before[n[0]] + before[n[1]]);
  }
}

} // namespace internal

/// finds the borders of the parts.
inline Borders find_borders(const SM::Mesh& mesh, const SM::Mesh_geometry& geometry,
                            const Part_labels& labels)
{
  constexpr int smoothing_rounds = 12;
  Borders borders;
  std::unordered_map<std::size_t, std::size_t> numbers;
  const auto number = [&](const std::size_t vertex)
  {
    const auto [it, is_new] = numbers.emplace(vertex, borders.positions.size());
    if (is_new)
    {
      borders.positions.push_back(vector(mesh.points[vertex]));
      borders.neighbors.emplace_back();
    }
    return it->second;
  };
  for (const SM::Face_adjacency& edge : geometry.adjacencies)
  {
    if (labels.of_face[edge.faces[0]] == labels.of_face[edge.faces[1]]) continue;
    const std::size_t v = number(edge.vertices[0]), w = number(edge.vertices[1]);
    borders.edges.push_back({{v, w}, edge});
    borders.neighbors[v].push_back(w);
    borders.neighbors[w].push_back(v);
  }
  internal::smooth(borders, smoothing_rounds);
  return borders;
}

/// measures the borders of the parts.
inline Border_sums measure_borders(const Sampled_surface& surface, const Borders& borders)
{
  constexpr double concave = 10.;
  Border_sums sums;
  for (const Border_edge& edge : borders.edges)
  {
    sums.length += borders.length(edge);
    sums.smooth_length += borders.smooth_length(edge);
    if (internal::fold(surface, edge.mesh_edge) < -concave)
      sums.concave_length += borders.length(edge);
  }
  for (std::size_t v = 0; v < borders.positions.size(); ++v)
    if (const auto& n = borders.neighbors[v]; n.size() == 2)
    {
      const Vector& p = borders.positions[v];
      sums.turns +=
          internal::angle_between(p - borders.positions[n[0]], borders.positions[n[1]] - p);
      sums.bends += 1.;
    }
  return sums;
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_BORDER_LINES_H
