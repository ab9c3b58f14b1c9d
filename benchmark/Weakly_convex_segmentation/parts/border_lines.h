// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_BORDER_LINES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_BORDER_LINES_H

#include "metrics/mesh_geometry.h"
#include "parts/Part_labels.h"
#include "parts/Sampled_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

// How straight the borders of the parts run, and whether along creases: the edges between faces of
// different parts, as lines in space.

namespace Part_measures {

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

constexpr double degrees = 180. / 3.14159265358979323846;

/// The border edges as a graph of their vertices.
struct Border_graph
{
  std::vector<Vector> positions;
  std::vector<std::vector<std::size_t>> neighbors;

  double length() const
  {
    double sum = 0.;
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (const std::size_t w : neighbors[v])
        if (v < w) sum += (positions[v] - positions[w]).norm();
    return sum;
  }
};

/// Numbers the vertices as they come.
class Border_graph_builder
{
public:
  explicit Border_graph_builder(const SM::Mesh& mesh) : m_mesh(mesh) {}
  void add_edge(const std::size_t v, const std::size_t w)
  {
    const std::size_t i = number(v), j = number(w);
    m_graph.neighbors[i].push_back(j);
    m_graph.neighbors[j].push_back(i);
  }
  const Border_graph& graph() const { return m_graph; }

private:
  std::size_t number(const std::size_t vertex)
  {
    const auto [it, is_new] = m_numbers.emplace(vertex, m_graph.positions.size());
    if (is_new)
    {
      m_graph.positions.push_back(vector(m_mesh.points[vertex]));
      m_graph.neighbors.emplace_back();
    }
    return it->second;
  }
  const SM::Mesh& m_mesh;
  std::unordered_map<std::size_t, std::size_t> m_numbers;
  Border_graph m_graph;
};

/// the angle between two directions in degrees, 0 if one of them has no length
inline double angle_between(const Vector& a, const Vector& b)
{
  return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

/// whether the surface is hollow along the edge of two faces, by more than ten degrees
inline bool is_concave(const Sampled_surface& surface, const SM::Face_adjacency& edge)
{
  constexpr double least_angle = 10.;
  const auto [f, g] = edge.faces;
  const Vector &m = surface.normal(f), &n = surface.normal(g);
  return (n - m).dot(surface.centroid(g) - surface.centroid(f)) < 0. &&
         angle_between(m, n) > least_angle;
}

/// Moves each vertex of two edges half-way to the middle of its neighbors, all at once.
inline void smooth(Border_graph& graph, const int rounds)
{
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<Vector> moved = graph.positions;
    for (std::size_t v = 0; v < moved.size(); ++v)
      if (const auto& n = graph.neighbors[v]; n.size() == 2)
        moved[v] =
            0.5 * graph.positions[v] + 0.25 * (graph.positions[n[0]] + graph.positions[n[1]]);
    graph.positions = std::move(moved);
  }
}

} // namespace internal

/// measures the borders of the parts.
inline Border_sums measure_borders(const SM::Mesh& mesh, const SM::Mesh_geometry& geometry,
                                   const Sampled_surface& surface, const Part_labels& labels)
{
  constexpr int smoothing_rounds = 12;
  Border_sums sums;
  internal::Border_graph_builder builder(mesh);
  for (const SM::Face_adjacency& edge : geometry.adjacencies)
  {
    if (labels.of_face[edge.faces[0]] == labels.of_face[edge.faces[1]]) continue;
    const auto [v, w] = edge.vertices;
    builder.add_edge(v, w);
    if (internal::is_concave(surface, edge))
      sums.concave_length += (vector(mesh.points[v]) - vector(mesh.points[w])).norm();
  }
  internal::Border_graph graph = builder.graph();
  sums.length = graph.length();
  for (std::size_t v = 0; v < graph.positions.size(); ++v)
    if (const auto& n = graph.neighbors[v]; n.size() == 2)
    {
      const Vector& p = graph.positions[v];
      sums.turns += internal::angle_between(p - graph.positions[n[0]], graph.positions[n[1]] - p);
      sums.bends += 1.;
    }
  internal::smooth(graph, smoothing_rounds);
  sums.smooth_length = graph.length();
  return sums;
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_BORDER_LINES_H
