// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_DENOISE_MESH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_DENOISE_MESH_H

// Noise of the vertices of a mesh, told from shape as in denoise_points.h and smoothed along the mesh before it is
// thinned: the mesh still knows the two sides of a wall apart where noise has mixed their points. The
// paper is silent on noise in the input.
//
// denoise_points.h alone is not enough: labels of 38 meshes with noise of 1 % of the diagonal change by .056, without
// this by .226 (`benchmark_stability DATA --per-category 2`).

#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// the roughness, in radians, above which a mesh is smoothed
constexpr double mesh_noise_tolerance = radians(4.6);

/// returns how far noise turns the normals of faces that share an edge, in radians: the median over at
/// most 20,000 or so of the faces of twice the smaller one of the mean convex and the mean concave angle.
inline double face_roughness(const Raw_shape& raw)
{
  struct Angles
  {
    double concave = 0., convex = 0., edges = 0.;
  };
  const std::size_t step = (std::max)(raw.positions.size() / 20000, std::size_t(1));
  std::vector<Angles> of_face((raw.positions.size() + step - 1) / step);
  for (const auto& [f, g] : raw.links)
  {
    if (f % step != 0 && g % step != 0) continue;
    const double lengths = length(raw.normals[f]) * length(raw.normals[g]);
    if (!(lengths > 0.)) continue;
    const Coordinates along = raw.positions[g] - raw.positions[f];
    const double turn = dot(along, raw.normals[g]) * length(raw.normals[f]) -
                        dot(along, raw.normals[f]) * length(raw.normals[g]);
    const double cosine = dot(raw.normals[f], raw.normals[g]) / lengths;
    const double angle = std::acos((std::max)(-1., (std::min)(1., cosine)));
    for (const Index end : {f, g})
      if (end % step == 0)
      {
        Angles& own = of_face[end / step];
        (turn < 0. ? own.concave : own.convex) += angle;
        own.edges += 1.;
      }
  }
  std::vector<double> rough(of_face.size());
  for (std::size_t i = 0; i < rough.size(); ++i)
    if (of_face[i].edges > 0.)
      rough[i] = 2. * (std::min)(of_face[i].concave, of_face[i].convex) / of_face[i].edges;
  const auto median = rough.begin() + static_cast<std::ptrdiff_t>(rough.size() / 2);
  std::nth_element(rough.begin(), median, rough.end());
  return rough.empty() ? 0. : *median;
}

/// Vertices of a mesh: corners at the same position are one. They are in the order of their coordinates,
/// so that no sum depends on the order of the faces.
struct Mesh_vertices
{
  std::vector<Coordinates> positions;
  std::vector<Index> of_corner;
  std::vector<std::size_t> first; ///< begin of each vertex's row in `neighbors`, and the end
  std::vector<Index> neighbors;   ///< those it shares edges with, ascending
};

/// fills the positions and `of_corner`.
inline void weld_corners(const std::vector<Coordinates>& corners, const bool parallel,
                         Mesh_vertices& vertices)
{
  std::vector<Index> order(corners.size());
  std::iota(order.begin(), order.end(), Index(0));
  parallel_sort(order.begin(), order.end(), parallel,
                [&corners](const Index a, const Index b)
                { return corners[a] < corners[b] || (corners[a] == corners[b] && a < b); });
  vertices.of_corner.resize(corners.size());
  for (const Index c : order)
  {
    if (vertices.positions.empty() || vertices.positions.back() != corners[c])
      vertices.positions.push_back(corners[c]);
    vertices.of_corner[c] = static_cast<Index>(vertices.positions.size() - 1);
  }
}

/// calls `side(a, b)` for the vertices of each side of each face.
template <typename Side>
void for_each_side(const Raw_shape& raw, const Mesh_vertices& vertices, const Side& side)
{
  for (std::size_t f = 0; f + 1 < raw.first_corner.size(); ++f)
    for (std::size_t i = raw.first_corner[f], last = raw.first_corner[f + 1] - 1; i <= last; ++i)
      side(vertices.of_corner[i], vertices.of_corner[i < last ? i + 1 : raw.first_corner[f]]);
}

/// fills the neighbors.
inline void join_vertices(const Raw_shape& raw, Mesh_vertices& vertices)
{
  std::vector<std::size_t> fill(vertices.positions.size() + 1, 0);
  for_each_side(raw, vertices, [&](const Index a, const Index b) { ++fill[a + 1], ++fill[b + 1]; });
  std::partial_sum(fill.begin(), fill.end(), fill.begin());
  const std::vector<std::size_t> begin = fill;
  std::vector<Index> ends(begin.back());
  for_each_side(raw, vertices,
                [&](const Index a, const Index b) { ends[fill[a]++] = b, ends[fill[b]++] = a; });
  vertices.first.push_back(0);
  for (std::size_t v = 0; v < vertices.positions.size(); ++v)
  {
    const auto row = ends.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    const auto row_end = ends.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(row, row_end);
    vertices.neighbors.insert(vertices.neighbors.end(), row, std::unique(row, row_end));
    vertices.first.push_back(vertices.neighbors.size());
  }
}

/// returns the positions after so many rounds in which each moves most of the way to the mean of its
/// neighbors.
inline std::vector<Coordinates> diffused(const Mesh_vertices& vertices,
                                         std::vector<Coordinates> positions, const int rounds,
                                         const Run_control& control)
{
  constexpr double share = 0.65;
  std::vector<Coordinates> next(positions.size());
  for (int round = 0; round < rounds; ++round)
  {
    control.check();
    parallel_for(
        positions.size(), control.parallel,
        [&](const std::size_t v)
        {
          Coordinates sum = {0., 0., 0.};
          const std::size_t first = vertices.first[v], last = vertices.first[v + 1];
          for (std::size_t i = first; i < last; ++i)
            for (int c = 0; c < 3; ++c) sum[c] += positions[vertices.neighbors[i]][c];
          const double count = static_cast<double>(last - first);
          for (int c = 0; c < 3; ++c)
            next[v][c] = positions[v][c] + share * (sum[c] / count - positions[v][c]);
        },
        4096);
    positions.swap(next);
  }
  return positions;
}

/// smooths the positions, and gives back what smoothing takes from the shape: diffusion shrinks limbs, but
/// what it took, diffused as well, is mostly shape and little noise ("twicing", Tukey 1977).
inline std::vector<Coordinates> smoothed_positions(const Mesh_vertices& vertices, const int rounds,
                                                   const Run_control& control)
{
  std::vector<Coordinates> smooth = diffused(vertices, vertices.positions, rounds, control);
  std::vector<Coordinates> taken(smooth.size());
  for (std::size_t v = 0; v < smooth.size(); ++v) taken[v] = vertices.positions[v] - smooth[v];
  taken = diffused(vertices, std::move(taken), rounds, control);
  for (std::size_t v = 0; v < smooth.size(); ++v)
    for (int c = 0; c < 3; ++c) smooth[v][c] += taken[v][c];
  return smooth;
}

/// returns the mesh with its corners moved to the vertices' `positions`. Normals that were turned against
/// the order of the corners stay so.
inline Raw_shape with_positions(const Raw_shape& raw, const Mesh_vertices& vertices,
                                const std::vector<Coordinates>& positions)
{
  Raw_shape moved;
  moved.links = raw.links;
  moved.element_of = raw.element_of;
  moved.number_of_elements = raw.number_of_elements;
  moved.is_far = raw.is_far;
  moved.exponent = raw.exponent;
  std::vector<Coordinates> polygon;
  for (std::size_t f = 0; f + 1 < raw.first_corner.size(); ++f)
  {
    const std::size_t first = raw.first_corner[f], last = raw.first_corner[f + 1];
    polygon.assign(raw.corners.begin() + static_cast<std::ptrdiff_t>(first),
                   raw.corners.begin() + static_cast<std::ptrdiff_t>(last));
    const bool is_turned = dot(area_vector(polygon), raw.normals[f]) < 0.;
    for (std::size_t i = first; i < last; ++i)
      polygon[i - first] = positions[vertices.of_corner[i]];
    add_polygon(polygon, moved);
    if (is_turned)
      for (double& c : moved.normals.back()) c = -c;
  }
  return moved;
}

/// smooths a mesh whose faces are rougher than a tolerance, the more the rougher they are.
/// Returns whether `result` was made: points without faces and smooth meshes serve as they are.
///
/// What noise leaves of the slopes after so many rounds goes with its size over their number. Complexity:
/// linear in the faces but for the sort of their corners.
inline bool denoise_mesh(const Raw_shape& raw, const Run_control& control, Raw_shape& result)
{
  constexpr double roughness_per_round = radians(2.4);
  if (raw.first_corner.size() != raw.positions.size() + 1) return false;
  const double rough = face_roughness(raw);
  if (!(rough > mesh_noise_tolerance)) return false;
  check_finite(raw.positions, "position", control.parallel); // NaN has no place in an order
  Mesh_vertices vertices;
  weld_corners(raw.corners, control.parallel, vertices);
  control.check();
  join_vertices(raw, vertices);
  const int rounds = (std::max)(1, static_cast<int>(rough / roughness_per_round + 0.5));
  result = with_positions(raw, vertices, smoothed_positions(vertices, rounds, control));
  return true;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_DENOISE_MESH_H
