// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOLIDS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOLIDS_H

// The closed pieces of a mesh, as of an assembly or a piece of furniture: each is an object of its own, and where two
// nearly touch, no part goes from one into the other.

#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A piece of a mesh: faces that hang together across edges.
struct Mesh_piece
{
  double area = 0., volume = 0.; ///< times 2 and 6
  bool is_closed = true;
};

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
  for (Index f = 0; f < links.size(); ++f)
  {
    Mesh_piece& piece = pieces[sets.find(f)];
    const Coordinates &p = raw.positions[f], &origin = raw.positions[sets.find(f)];
    const Coordinates& n = raw.normals[f];
    piece.area += std::hypot(n[0], n[1], n[2]);
    for (int c = 0; c < 3; ++c) piece.volume += (p[c] - origin[c]) * n[c];
    piece.is_closed = piece.is_closed && links[f] >= raw.first_corner[f + 1] - raw.first_corner[f];
  }
  return pieces;
}

/// returns for each face of a mesh the number of the closed piece that it is of, from 1 on, or 0: for what is open, a
/// cavity, or a crumb beside the largest one. It is empty if there are not two such pieces.
///
/// Complexity: O(n log n).
inline std::vector<Index> find_solids(const Raw_shape& raw)
{
  constexpr double crumb = 0.02; // of the largest area: screws and eyes
  constexpr double least = 2e-4; // of the whole area: each needs some of a bounded number of points
  if (raw.first_corner.size() != raw.positions.size() + 1) return {};
  Disjoint_sets<Index> sets(raw.positions.size());
  const std::map<Index, Mesh_piece> pieces = mesh_pieces(raw, sets);
  Mesh_piece largest;
  double area = 0.;
  for (const auto& [first, piece] : pieces)
  {
    area += piece.area;
    if (piece.is_closed && piece.area > largest.area) largest = piece;
  }
  std::map<Index, Index> number;
  for (const auto& [first, piece] : pieces)
    if (piece.is_closed && piece.volume * largest.volume >= 0. &&
        piece.area >= (std::max)(crumb * largest.area, least * area))
      number.emplace(first, static_cast<Index>(number.size() + 1));
  if (number.size() < 2) return {};
  std::vector<Index> solids;
  for (Index f = 0; f < raw.positions.size(); ++f)
  {
    const auto found = number.find(sets.find(f));
    solids.push_back(found != number.end() ? found->second : 0);
  }
  return solids;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOLIDS_H
