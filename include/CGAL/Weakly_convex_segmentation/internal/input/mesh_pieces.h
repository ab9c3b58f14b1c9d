// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_MESH_PIECES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_MESH_PIECES_H

// The pieces of a mesh: what hangs together across edges; and which open ones go on in one another, as those of a torn
// scan do, and the faces of a solid that were tessellated one by one.

#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <CGAL/Bbox_3.h>

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

/// A side of a face that no other face has: its ends, and unit vectors across the face and away from it.
struct Boundary_edge
{
  std::array<Coordinates, 2> ends;
  Coordinates normal, outwards;
  double length = 0.;

  Coordinates at(const double share) const
  {
    Coordinates p;
    for (int c = 0; c < 3; ++c) p[c] = (1. - share) * ends[0][c] + share * ends[1][c];
    return p;
  }

  /// returns the distance of a point from the edge.
  double distance(const Coordinates& p) const
  {
    const double share = dot(p - ends[0], ends[1] - ends[0]) / (length * length);
    return internal::length(p - at((std::min)(1., (std::max)(0., share))));
  }
};

/// A piece of a mesh: faces that hang together across edges.
struct Mesh_piece
{
  double area = 0., volume = 0.; ///< times 2 and 6
  CGAL::Bbox_3 box;
  std::vector<Boundary_edge> boundary; ///< of an open piece
};

/// returns the boundary edges of a mesh and the face of each, in the order of where they lie.
inline std::vector<std::pair<Boundary_edge, Index>> boundary_edges(const Raw_shape& raw,
                                                                   const std::vector<char>& is_open)
{
  struct Side
  {
    Index face = 0;
    std::size_t from = 0, to = 0; ///< corners
    bool is_alone = true;
  };
  std::map<std::array<Coordinates, 2>, Side> sides;
  for (Index f = 0; f < raw.positions.size(); ++f)
  {
    const std::size_t begin = raw.first_corner[f], end = raw.first_corner[f + 1];
    for (std::size_t i = begin; i < end && is_open[f] != 0; ++i)
    {
      const std::size_t next = i + 1 < end ? i + 1 : begin;
      std::array<Coordinates, 2> ends = {raw.corners[i], raw.corners[next]};
      std::sort(ends.begin(), ends.end());
      const auto [side, is_new] = sides.emplace(ends, Side{f, i, next});
      side->second.is_alone = is_new;
    }
  }
  std::vector<std::pair<Boundary_edge, Index>> edges;
  for (const auto& [ends, side] : sides)
  {
    if (!side.is_alone) continue;
    const Coordinates along = raw.corners[side.to] - raw.corners[side.from];
    const Coordinates outwards = cross(along, raw.normals[side.face]);
    const double l = length(along), n = length(raw.normals[side.face]), o = length(outwards);
    if (!(o > 0.)) continue;
    Boundary_edge edge;
    edge.ends = ends;
    edge.length = l;
    for (int c = 0; c < 3; ++c)
    {
      edge.normal[c] = raw.normals[side.face][c] / n;
      edge.outwards[c] = outwards[c] / o;
    }
    edges.push_back({edge, side.face});
  }
  return edges;
}

/// returns the pieces of a mesh by the first face of each, and fills `sets` with them.
inline std::map<Index, Mesh_piece> mesh_pieces(const Raw_shape& raw, Disjoint_sets<Index>& sets)
{
  std::vector<std::size_t> links(raw.positions.size(), 0);
  for (const auto& [f, g] : raw.links)
  {
    const auto [first, second] = std::minmax({sets.find(f), sets.find(g)});
    sets.join_named(first, second);
    ++links[f], ++links[g];
  }
  std::map<Index, Mesh_piece> pieces;
  std::vector<char> is_open(links.size(), 0);
  for (Index f = 0; f < links.size(); ++f)
  {
    Mesh_piece& piece = pieces[sets.find(f)];
    const Coordinates &p = raw.positions[f], &origin = raw.positions[sets.find(f)];
    piece.area += length(raw.normals[f]);
    piece.volume += dot(p - origin, raw.normals[f]);
    const std::size_t begin = raw.first_corner[f], end = raw.first_corner[f + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const Coordinates& q = raw.corners[i];
      piece.box += CGAL::Bbox_3(q[0], q[1], q[2], q[0], q[1], q[2]);
    }
    if (links[f] < end - begin) is_open[sets.find(f)] = 1;
  }
  for (Index f = 0; f < links.size(); ++f) is_open[f] = is_open[sets.find(f)];
  if (pieces.size() > 1)
    for (auto& [edge, face] : boundary_edges(raw, is_open))
      pieces[sets.find(face)].boundary.push_back(edge);
  return pieces;
}

/// Which open pieces go on in one another.
class Piece_seams
{
public:
  explicit Piece_seams(std::vector<const Mesh_piece*> pieces) : m_pieces(std::move(pieces)) {}

  /// calls `join(i, j)` for pieces that are torn apart, or stitched together without common vertices, as the faces of
  /// tessellated solids are.
  ///
  /// Complexity: O(p^2 + q n) for p pieces, of which q pairs are near, and n boundary edges of a piece.
  template <typename Join>
  void for_each(const Join& join) const
  {
    constexpr double torn = 0.25;     // of either boundary looks at the other one over a gap
    constexpr double stitched = 0.75; // of a boundary lie along those of others,
    constexpr double stitch = 0.05;   // and so much along one of these
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
    {
      double along_others = 0.;
      std::vector<std::pair<std::size_t, double>> along;
      for (std::size_t j = 0; j < m_pieces.size(); ++j)
      {
        const double reach = reach_of(i, j);
        if (i == j || gap(m_pieces[i]->box, m_pieces[j]->box) > reach) continue;
        const Shares shares = shares_of(*m_pieces[i], *m_pieces[j], reach);
        if (shares.facing >= torn) join(i, j);
        along_others += shares.along;
        along.push_back({j, shares.along});
      }
      for (const auto& [j, share] : along)
        if (along_others >= stitched && share >= stitch) join(i, j);
    }
  }

private:
  /// of the length of a boundary
  struct Shares
  {
    double facing = 0., along = 0.;
  };

  double reach_of(const std::size_t i, const std::size_t j) const
  {
    constexpr double widest = 0.25; // gap, of the diagonal of the smaller piece
    return widest * (std::min)(diagonal(m_pieces[i]->box), diagonal(m_pieces[j]->box));
  }

  /// returns whether a boundary edge looks at another from one of its points, as over a gap in one surface.
  static bool is_facing(const Boundary_edge& edge, const Coordinates& p, const Boundary_edge& other,
                        const double reach)
  {
    const Coordinates between = other.at(0.5) - p;
    const double d = length(between);
    return d <= reach && dot(edge.normal, other.normal) > 0.7 &&
           dot(edge.outwards, other.outwards) < -0.5 && dot(edge.outwards, between) > 0.7 * d;
  }

  static Shares shares_of(const Mesh_piece& piece, const Mesh_piece& other, const double reach)
  {
    constexpr double samples = 100.; // of a boundary, or one an edge of the longer ones
    constexpr double near = 4e-3;    // of the reach: chords of the same curve
    const auto lies_along = [&](const Boundary_edge& edge, const Coordinates& p)
    {
      for (const Boundary_edge& o : other.boundary)
        if (o.distance(p) <= (std::min)(near * reach, 0.05 * (std::max)(edge.length, o.length)))
          return true;
      return false;
    };
    const auto faces = [&](const Boundary_edge& edge, const Coordinates& p)
    {
      for (const Boundary_edge& o : other.boundary)
        if (is_facing(edge, p, o, reach)) return true;
      return false;
    };
    double length = 0.;
    for (const Boundary_edge& edge : piece.boundary) length += edge.length;
    Shares shares;
    double waiting = 0.; // length since the last sample
    for (const Boundary_edge& edge : piece.boundary)
    {
      waiting += edge.length;
      const double pieces = std::floor(waiting / length * samples);
      for (double k = 0.; k < pieces; k += 1.)
      {
        const Coordinates p = edge.at((k + 0.5) / pieces);
        const double share = waiting / length / pieces;
        if (gap(CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]), other.box) > reach) continue;
        if (lies_along(edge, p))
          shares.along += share;
        else if (faces(edge, p))
          shares.facing += share;
      }
      if (pieces > 0.) waiting = 0.;
    }
    return shares;
  }

  std::vector<const Mesh_piece*> m_pieces;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_MESH_PIECES_H
