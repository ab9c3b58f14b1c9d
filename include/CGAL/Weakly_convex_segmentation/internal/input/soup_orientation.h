// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOUP_ORIENTATION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOUP_ORIENTATION_H

// The polygons of a soup may be turned over one by one, or whole pieces inside out. For the run they
// are turned: consistently within each piece, and closed pieces that are inside out to the outside.

#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/sort_in_runs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A side of a polygon: its vertices ascending, and whether the polygon runs along them.
struct Polygon_side
{
  Index low = 0, high = 0;
  Index face = 0;
  Index edge = 0;         ///< of several between the vertices, see `part_shared_edges()`
  std::size_t corner = 0; ///< of all polygons, from which the polygon runs along the side
  bool along = false;

  bool is_at_edge_of(const Polygon_side& other) const
  {
    return low == other.low && high == other.high && edge == other.edge;
  }
};

/// returns the sides of all polygons without those of no length, the same edge in a row.
inline std::vector<Polygon_side> sorted_sides(const std::vector<std::size_t>& vertices,
                                              const std::vector<std::size_t>& first)
{
  std::vector<Polygon_side> sides;
  sides.reserve(vertices.size());
  std::size_t bound = 0;
  for (std::size_t f = 0; f + 1 < first.size(); ++f)
    for (std::size_t i = first[f]; i < first[f + 1]; ++i)
    {
      const Index a = static_cast<Index>(vertices[i]);
      const Index b = static_cast<Index>(vertices[i + 1 < first[f + 1] ? i + 1 : first[f]]);
      if (a == b) continue;
      sides.push_back({(std::min)(a, b), (std::max)(a, b), static_cast<Index>(f), 0, i, a < b});
      bound = (std::max)(bound, std::size_t(sides.back().low) + 1);
    }
  sort_in_runs(
      sides, bound, [](const Polygon_side& side) { return side.low; },
      [](const Polygon_side& a, const Polygon_side& b)
      {
        if (a.high != b.high) return a.high < b.high;
        return a.face != b.face ? a.face < b.face : a.along < b.along;
      });
  return sides;
}

/// Pieces of a soup whose polygons hang together across edges of two polygons each.
struct Soup_pieces : Compressed_rows<Index> // the faces of each piece
{
  std::vector<Index> of_face;
  std::vector<char> is_flipped; ///< of each face, against the first face of its piece
  std::vector<char> is_closed;  ///< of each piece
};

/// Across an edge of a face: the other face, and whether both run along the edge the same way.
struct Across_edge
{
  Index face = 0, other = 0;
  bool is_turned = false;
};

/// returns what lies across the manifold edges, from both sides, by face; marks faces with others.
inline std::vector<Across_edge> across_edges(const std::vector<Polygon_side>& sides,
                                             std::vector<char>& has_open_edge)
{
  std::vector<Across_edge> across;
  across.reserve(sides.size());
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end)
  {
    while (end < sides.size() && sides[end].is_at_edge_of(sides[i])) ++end;
    if (end - i == 2 && sides[i].face != sides[i + 1].face)
    {
      const bool is_turned = sides[i].along == sides[i + 1].along;
      across.push_back({sides[i].face, sides[i + 1].face, is_turned});
      across.push_back({sides[i + 1].face, sides[i].face, is_turned});
    }
    else
      for (std::size_t j = i; j < end; ++j) has_open_edge[sides[j].face] = 1;
  }
  sort_in_runs(
      across, has_open_edge.size(), [](const Across_edge& a) { return a.face; },
      [](const Across_edge& a, const Across_edge& b) { return a.other < b.other; });
  return across;
}

/// walks over the pieces, turning faces to agree with where the walk came from.
inline Soup_pieces find_pieces(const std::vector<Across_edge>& across,
                               const std::vector<char>& has_open_edge)
{
  constexpr Index none = static_cast<Index>(-1);
  const std::size_t n = has_open_edge.size();
  Soup_pieces pieces;
  pieces.of_face.assign(n, none);
  pieces.is_flipped.assign(n, 0);
  std::vector<std::size_t> begin(n + 1, 0);
  for (const Across_edge& a : across) ++begin[a.face + 1];
  for (std::size_t f = 0; f < n; ++f) begin[f + 1] += begin[f];
  for (std::size_t seed = 0; seed < n; ++seed)
  {
    if (pieces.of_face[seed] != none) continue;
    const Index piece = static_cast<Index>(pieces.size());
    pieces.is_closed.push_back(1);
    pieces.of_face[seed] = piece;
    pieces.entries.push_back(static_cast<Index>(seed));
    for (std::size_t next = pieces.first.back(); next < pieces.entries.size(); ++next)
    {
      const Index f = pieces.entries[next];
      if (has_open_edge[f] != 0) pieces.is_closed.back() = 0;
      for (std::size_t i = begin[f]; i < begin[f + 1]; ++i)
      {
        const Index g = across[i].other;
        if (pieces.of_face[g] != none) continue;
        pieces.of_face[g] = piece;
        pieces.is_flipped[g] =
            static_cast<char>((pieces.is_flipped[f] != 0) != across[i].is_turned);
        pieces.entries.push_back(g);
      }
    }
    pieces.end_row();
  }
  return pieces;
}

/// turns the smaller part (by number) of each piece, so that a consistent piece stays as it is.
inline void keep_majority(Soup_pieces& pieces)
{
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    std::size_t flipped = 0;
    for (const Index f : pieces[p]) flipped += pieces.is_flipped[f];
    if (2 * flipped <= pieces[p].size()) continue;
    for (const Index f : pieces[p]) pieces.is_flipped[f] ^= 1;
  }
}

/// returns six times the signed volume of a piece, from its first face's point on.
inline double signed_volume(const Raw_shape& raw, const Soup_pieces& pieces, const std::size_t p)
{
  const Coordinates& origin = raw.positions[*pieces[p].begin()];
  double volume = 0.;
  for (const Index f : pieces[p])
  {
    double share = 0.;
    for (int c = 0; c < 3; ++c) share += (raw.positions[f][c] - origin[c]) * raw.normals[f][c];
    volume += pieces.is_flipped[f] != 0 ? -share : share;
  }
  return volume;
}

/// returns whether the box of another piece holds that of piece `p`.
inline bool is_inside_another(const std::vector<std::array<double, 6>>& boxes, const std::size_t p)
{
  for (std::size_t q = 0; q < boxes.size(); ++q)
  {
    bool inside = q != p;
    for (int c = 0; c < 3; ++c)
      inside = inside && boxes[q][c] < boxes[p][c] && boxes[q][c + 3] > boxes[p][c + 3];
    if (inside) return true;
  }
  return false;
}

/// returns low and high corner of the face points of each piece.
inline std::vector<std::array<double, 6>> boxes_of(const Raw_shape& raw, const Soup_pieces& pieces)
{
  std::vector<std::array<double, 6>> boxes(pieces.size());
  for (std::size_t p = 0; p < boxes.size(); ++p)
    for (const Index& f : pieces[p])
      for (int c = 0; c < 3; ++c)
      {
        const double x = raw.positions[f][c];
        const bool is_first = &f == pieces[p].begin();
        boxes[p][c] = is_first ? x : (std::min)(boxes[p][c], x);
        boxes[p][c + 3] = is_first ? x : (std::max)(boxes[p][c + 3], x);
      }
  return boxes;
}

/// turns the normals of `raw`, one a polygon, for the sides of a soup of welded vertices: polygons agree across
/// edges of two polygons, as most of their piece have it; closed pieces of negative volume are turned
/// unless they lie within the box of another, where they may bound a cavity. Surfaces that are
/// oriented and have their normals outwards stay as they are.
///
/// Complexity: O(n log n), and O(p) a closed piece of negative volume, for p pieces.
/// \returns the number of turned polygons
inline std::size_t orient_soup(const std::vector<Polygon_side>& sides, Raw_shape& raw)
{
  std::vector<char> has_open_edge(raw.positions.size(), 0);
  Soup_pieces pieces = find_pieces(across_edges(sides, has_open_edge), has_open_edge);
  keep_majority(pieces);
  std::vector<std::array<double, 6>> boxes;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    if (pieces.is_closed[p] == 0 || !(signed_volume(raw, pieces, p) < 0.)) continue;
    if (boxes.empty()) boxes = boxes_of(raw, pieces);
    if (is_inside_another(boxes, p)) continue;
    for (const Index f : pieces[p]) pieces.is_flipped[f] ^= 1;
  }
  std::size_t turned = 0;
  for (std::size_t f = 0; f < raw.normals.size(); ++f)
  {
    if (pieces.is_flipped[f] == 0) continue;
    ++turned;
    for (double& c : raw.normals[f]) c = -c;
  }
  return turned;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOUP_ORIENTATION_H
