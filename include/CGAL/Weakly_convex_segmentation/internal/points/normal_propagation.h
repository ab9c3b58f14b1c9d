// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_PROPAGATION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_PROPAGATION_H

// Unoriented normals made consistent along the minimum spanning forest of the nearest neighbors. CGAL's
// `mst_orient_normals()` takes longer, is right less often, and can't be interrupted: see estimate_normals.h.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Points, the mean square of the distances from the plane through each and its neighbors, and these.
struct Unoriented_points
{
  Oriented_points& points;
  std::vector<float> roughness;
  std::vector<Index> nearest; ///< `k` a point; a point that has fewer is its own neighbor
  std::size_t k;

  /// returns how well the normals of two neighbors fit, from -1 to 1; negative if one has to be turned.
  ///
  /// One normal is mirrored at the bisector of the two points: on a circle through both they then agree,
  /// however much it bends, and across a thin wall they are opposite. Their own product, which Hoppe et
  /// al. 1992 and CGAL take, is 0 around a right angle and 1 across a wall. But noise tilts the
  /// connection of near points: the mirror fades out where they are as near as the surface is rough.
  float agreement(const Index i, const Index j) const
  {
    constexpr float fading = 4.f;
    const Vector3 along = points.positions[j] - points.positions[i];
    const Vector3 &a = points.normals[i], &b = points.normals[j];
    const float square = squared_length(along) + fading * (roughness[i] + roughness[j]);
    const float mirrored = square > 0.f ? 2.f * dot(a, along) * dot(b, along) / square : 0.f;
    return dot(a, b) - mirrored;
  }
};

/// Weights of edges, rounded, so that sorting them takes linear time.
struct Edge_weight
{
  static constexpr std::uint16_t number = 4096;
  static constexpr std::uint16_t none = number; ///< no edge, or one that its other end has too

  static std::uint16_t of(const Unoriented_points& shape, const Index i, const Index j)
  {
    const auto row = shape.nearest.begin() + static_cast<std::ptrdiff_t>(j * shape.k);
    const auto end = row + static_cast<std::ptrdiff_t>(shape.k);
    if (i == j || (j < i && std::find(row, end, i) != end)) return none;
    const float weight = (std::max)(0.f, 1.f - std::abs(shape.agreement(i, j)));
    return static_cast<std::uint16_t>(weight * static_cast<float>(number - 1));
  }
};

/// returns the edges, the best agreement first: where they are in `shape.nearest`.
inline std::vector<std::size_t> edges_by_weight(const Unoriented_points& shape, const bool parallel,
                                                const Run_control& control)
{
  const std::size_t k = shape.k;
  std::vector<std::uint16_t> weights(shape.nearest.size());
  parallel_for(shape.points.size(), parallel,
               [&](const std::size_t i)
               {
                 control.check_sometimes();
                 for (std::size_t e = i * k; e < (i + 1) * k; ++e)
                   weights[e] = Edge_weight::of(shape, static_cast<Index>(i), shape.nearest[e]);
               });
  std::vector<std::size_t> place(Edge_weight::number + 2u, 0);
  for (const std::uint16_t w : weights) ++place[w + 1u];
  for (std::size_t w = 0; w < Edge_weight::number; ++w) place[w + 1] += place[w];
  std::vector<std::size_t> edges(place[Edge_weight::number]);
  control.check();
  for (std::size_t e = 0; e < weights.size(); ++e)
    if (weights[e] != Edge_weight::none) edges[place[weights[e]]++] = e;
  control.check();
  return edges;
}

/// turns normals so that neighbors agree, along the minimum spanning forest of the graph; returns the
/// piece of each point, by its first point.
inline std::vector<Index> propagate_orientation(const Unoriented_points& shape, const bool parallel,
                                                const Run_control& control)
{
  Parity_disjoint_sets sets(shape.points.size());
  for (const std::size_t e : edges_by_weight(shape, parallel, control))
  {
    const Index i = static_cast<Index>(e / shape.k), j = shape.nearest[e];
    sets.join(i, j, shape.agreement(i, j) < 0.f);
    control.check_sometimes();
  }
  std::vector<Index> piece(shape.points.size());
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    const auto place = sets.find(static_cast<Index>(i));
    piece[i] = place.set;
    if (place.is_turned != 0) shape.points.normals[i] = -1.f * shape.points.normals[i];
    control.check_sometimes();
  }
  return piece;
}

/// Decides which side of a piece is its outside.
class Piece_outside
{
  /// both ways along the edges, diagonals and space diagonals of a cube
  static constexpr std::array<Vector3, 13> directions = {{{1.f, 0.f, 0.f},
                                                          {0.f, 1.f, 0.f},
                                                          {0.f, 0.f, 1.f},
                                                          {1.f, 1.f, 0.f},
                                                          {1.f, -1.f, 0.f},
                                                          {1.f, 0.f, 1.f},
                                                          {1.f, 0.f, -1.f},
                                                          {0.f, 1.f, 1.f},
                                                          {0.f, 1.f, -1.f},
                                                          {1.f, 1.f, 1.f},
                                                          {1.f, 1.f, -1.f},
                                                          {1.f, -1.f, 1.f},
                                                          {1.f, -1.f, -1.f}}};
  static constexpr std::size_t upwards = 2;

  std::array<Index, 13> m_lowest, m_highest; ///< points along the directions
  std::size_t m_size = 0;
  double m_volume = 0., m_lengths = 0.; ///< in the sense of is_inside_out()
  std::array<double, 3> m_positions = {0., 0., 0.}, m_normals = {0., 0., 0.}; ///< sums

public:
  explicit Piece_outside(const Index first)
  {
    m_lowest.fill(first);
    m_highest.fill(first);
  }

  void add(const Oriented_points& points, const Index i)
  {
    const Vector3 &p = points.positions[i], &n = points.normals[i];
    for (std::size_t d = 0; d < directions.size(); ++d)
    {
      const float height = dot(directions[d], p);
      if (height < dot(directions[d], points.positions[m_lowest[d]])) m_lowest[d] = i;
      if (height > dot(directions[d], points.positions[m_highest[d]])) m_highest[d] = i;
    }
    for (int c = 0; c < 3; ++c)
    {
      m_positions[c] += static_cast<double>(p[c]);
      m_normals[c] += static_cast<double>(n[c]);
    }
    m_volume += static_cast<double>(dot(p, n));
    m_lengths += static_cast<double>(length(p - points.positions[m_lowest[0]]));
    ++m_size;
  }

  /// returns whether the normals look inwards. What is nearly closed has a volume whose sign decides; else it
  /// is asked how steeply they look away from the extreme points. What is flat should look upwards.
  bool is_inside_out(const Oriented_points& points) const
  {
    constexpr double largest_opening = 0.3, least_volume = 0.05;
    constexpr float least_steepness = 0.5f;
    const double n = static_cast<double>(m_size);
    double volume = m_volume, squared_opening = 0.;
    for (std::size_t c = 0; c < 3; ++c)
    {
      volume -= m_positions[c] * m_normals[c] / n;
      squared_opening += m_normals[c] * m_normals[c] / (n * n);
    }
    if (squared_opening < largest_opening * largest_opening &&
        std::abs(volume) > least_volume * m_lengths)
      return volume < 0.;
    float steepness = 0.f;
    for (std::size_t d = 0; d < directions.size(); ++d)
    {
      const Vector3 outwards = normalized(directions[d]);
      const float low = dot(outwards, points.normals[m_lowest[d]]);
      const float high = dot(outwards, points.normals[m_highest[d]]);
      steepness += high * std::abs(high) - low * std::abs(low);
    }
    if (std::abs(steepness) > least_steepness) return steepness < 0.f;
    return points.normals[m_highest[upwards]].z < 0.f;
  }
};

/// turns the pieces whose normals look inwards. `piece`: see propagate_orientation()
inline void orient_outwards(Oriented_points& points, const std::vector<Index>& piece,
                            const Run_control& control)
{
  std::vector<Index> number(points.size());
  std::vector<Piece_outside> pieces;
  for (Index i = 0; i < points.size(); ++i)
  {
    control.check_sometimes();
    number[i] = piece[i] == i ? static_cast<Index>(pieces.size()) : number[piece[i]];
    if (piece[i] == i) pieces.emplace_back(i);
    pieces[number[i]].add(points, i);
  }
  std::vector<char> is_inside_out;
  for (const Piece_outside& p : pieces) is_inside_out.push_back(p.is_inside_out(points) ? 1 : 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_inside_out[number[i]] != 0) points.normals[i] = -1.f * points.normals[i];
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_NORMAL_PROPAGATION_H
