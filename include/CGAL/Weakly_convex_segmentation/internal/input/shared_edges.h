// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SHARED_EDGES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SHARED_EDGES_H

// Where boxes of an assembly touch along an edge, a soup welded by position has more than two polygons there: each
// box has its own edge. Where they touch at a face, it is there twice, as are faces that are to be seen from behind.

#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/soup_orientation.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Parts the sides at the edges of more than two polygons.
class Shared_edges
{
  using Side = std::vector<Polygon_side>::iterator;

  const std::vector<std::size_t>& m_unwelded; ///< vertex of each corner as it was given
  const Raw_shape& m_raw;

  std::size_t next_corner(const Polygon_side& side) const
  {
    const std::size_t next = side.corner + 1;
    return next < m_raw.first_corner[side.face + 1] ? next : m_raw.first_corner[side.face];
  }

  /// gives an edge of its own to what is exactly two sides between the same vertices as they were given; returns
  /// where the sides without one begin.
  Side part_by_vertices(const Side begin, const Side end, Index& edge) const
  {
    std::map<std::array<std::size_t, 2>, std::vector<Side>> given;
    for (Side s = begin; s != end; ++s)
    {
      std::array<std::size_t, 2> ends = {m_unwelded[s->corner], m_unwelded[next_corner(*s)]};
      if (!s->along) std::swap(ends[0], ends[1]);
      given[ends].push_back(s);
    }
    for (const auto& [ends, sides] : given)
    {
      if (sides.size() != 2) continue;
      sides[0]->edge = sides[1]->edge = ++edge;
    }
    return std::stable_partition(begin, end, [](const Polygon_side& s) { return s.edge != 0; });
  }

  /// returns the angle of each side's polygon about the edge, in radians.
  std::vector<double> angles(const Side begin, const Side end) const
  {
    const auto low = [this](const Polygon_side& s)
    { return m_raw.corners[s.along ? s.corner : next_corner(s)]; };
    const auto high = [this](const Polygon_side& s)
    { return m_raw.corners[s.along ? next_corner(s) : s.corner]; };
    const Coordinates origin = low(*begin);
    const Coordinates axis = high(*begin) - origin;
    const auto across = [&](const Coordinates& p) -> Coordinates
    {
      const Coordinates v = p - origin;
      const double share = dot(v, axis) / dot(axis, axis);
      return {v[0] - share * axis[0], v[1] - share * axis[1], v[2] - share * axis[2]};
    };
    const Coordinates first = across(m_raw.positions[begin->face]);
    const Coordinates second = cross(axis, first);
    std::vector<double> result;
    for (Side s = begin; s != end; ++s)
    {
      const Coordinates v = across(m_raw.positions[s->face]);
      result.push_back(std::atan2(dot(v, second) / length(axis), dot(v, first)));
    }
    return result;
  }

  /// gives an edge of its own to each two sides that have the inside of their polygons between them and nothing
  /// else, if that holds for all.
  void part_by_insides(const Side begin, const Side end, Index& edge) const
  {
    constexpr double turn = 6.283185307179586, same = 1e-6; // radians
    const std::vector<double> angle = angles(begin, end);
    const std::size_t n = angle.size();
    std::vector<std::size_t> partner(n, n);
    for (std::size_t i = 0; i < n; ++i)
    {
      if (!begin[static_cast<std::ptrdiff_t>(i)].along) continue;
      double least = 2. * turn;
      std::size_t nearest = n;
      for (std::size_t j = 0; j < n; ++j)
      {
        if (begin[static_cast<std::ptrdiff_t>(j)].along) continue;
        double between = angle[i] - angle[j]; // the inside is where angles are smaller
        while (between <= same) between += turn;
        if (between < least) least = between, nearest = j;
      }
      if (nearest == n || partner[nearest] != n) return;
      partner[i] = nearest;
      partner[nearest] = i;
    }
    if (std::count(partner.begin(), partner.end(), n) > 0) return;
    for (std::size_t i = 0; i < n; ++i)
      if (partner[i] > i)
        begin[static_cast<std::ptrdiff_t>(i)].edge =
            begin[static_cast<std::ptrdiff_t>(partner[i])].edge = ++edge;
  }

public:
  Shared_edges(const std::vector<std::size_t>& unwelded, const Raw_shape& raw)
    : m_unwelded(unwelded), m_raw(raw)
  {}

  /// parts the sides between two vertices; those of an edge are in a row afterwards.
  void part(const Side begin, const Side end) const
  {
    Index edge = 0;
    const Side rest = part_by_vertices(begin, end, edge);
    if (end - rest > 2) part_by_insides(rest, end, edge);
    std::stable_sort(begin, end,
                     [](const Polygon_side& a, const Polygon_side& b) { return a.edge < b.edge; });
  }
};

/// numbers the edges of `sides`, see `sorted_sides()`, where more than two polygons meet between two vertices: two that
/// had the vertices for themselves before welding, or that are the two sides of one body, have an edge of their own.
/// The others share one, as do those of sheets that branch.
inline void part_shared_edges(const std::vector<std::size_t>& unwelded, const Raw_shape& raw,
                              std::vector<Polygon_side>& sides)
{
  for (Polygon_side& side : sides) side.edge = 0;
  const Shared_edges edges(unwelded, raw);
  for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end)
  {
    while (end != sides.end() && end->is_at_edge_of(*begin)) ++end;
    if (end - begin > 2) edges.part(begin, end);
  }
}

/// returns the first polygon with the same corners as each; nothing if all corners differ.
inline std::vector<Index> polygons_of_same_corners(const std::vector<std::size_t>& vertices,
                                                   const std::vector<std::size_t>& first)
{
  std::vector<Index> result;
  std::map<std::vector<std::size_t>, Index> known;
  for (std::size_t f = 0; f + 1 < first.size(); ++f)
  {
    std::vector<std::size_t> corners(vertices.begin() + static_cast<std::ptrdiff_t>(first[f]),
                                     vertices.begin() + static_cast<std::ptrdiff_t>(first[f + 1]));
    std::sort(corners.begin(), corners.end());
    result.push_back(known.emplace(std::move(corners), static_cast<Index>(f)).first->second);
  }
  if (known.size() == result.size()) result.clear();
  return result;
}

/// returns which polygons are one before them again, as where each is there twice to be seen from behind; nothing if
/// none is. The faces at which two bodies touch are not doubles.
inline std::vector<char> doubled_polygons(const std::vector<std::size_t>& vertices,
                                          const Raw_shape& raw,
                                          const std::vector<Polygon_side>& sides)
{
  bool has_shared = false;
  for (std::size_t i = 2; i < sides.size(); ++i)
    has_shared =
        has_shared || (sides[i].low == sides[i - 2].low && sides[i].high == sides[i - 2].high);
  if (!has_shared) return {};
  const std::vector<Index> same = polygons_of_same_corners(vertices, raw.first_corner);
  if (same.empty()) return {};
  std::vector<char> has_open_edge(raw.positions.size(), 0);
  const Soup_pieces pieces = find_pieces(across_edges(sides, has_open_edge), has_open_edge);
  std::vector<double> volumes; // of a body; 0: it is none
  for (std::size_t p = 0; p < pieces.size(); ++p)
    volumes.push_back(pieces.is_closed[p] != 0 ? signed_volume(raw, pieces, p) : 0.);
  std::vector<char> is_double(same.size(), 0);
  for (Index f = 0; f < same.size(); ++f)
  {
    const Index piece = pieces.of_face[f], other = pieces.of_face[same[f]];
    const bool is_wall = piece != other && volumes[piece] * volumes[other] > 0.;
    is_double[f] = same[f] != f && !is_wall ? 1 : 0;
  }
  if (std::count(is_double.begin(), is_double.end(), 1) == 0) is_double.clear();
  return is_double;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SHARED_EDGES_H
