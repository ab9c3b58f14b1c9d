// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOLIDS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOLIDS_H

// The pieces of a mesh, as of an assembly or a piece of furniture: each is an object of its own, and where two nearly
// touch, no part goes from one into the other. Only open pieces that go on in one another are one object.

#include <CGAL/Weakly_convex_segmentation/internal/input/mesh_pieces.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the first faces of the pieces that no part is to leave: all but cavities and crumbs.
inline std::vector<Index> large_pieces(const std::map<Index, Mesh_piece>& pieces)
{
  constexpr double crumb = 0.02; // of the largest area: screws and eyes
  constexpr double least = 2e-4; // of the whole area: each needs some of a bounded number of points
  double largest = 0., largest_body = 0., volume = 0., area = 0.;
  for (const auto& [first, piece] : pieces)
  {
    area += piece.area;
    largest = (std::max)(largest, piece.area);
    if (piece.boundary.empty() && piece.area > largest_body)
      largest_body = piece.area, volume = piece.volume;
  }
  std::vector<Index> large;
  for (const auto& [first, piece] : pieces)
  {
    const bool is_cavity = piece.boundary.empty() && piece.volume * volume < 0.;
    if (!is_cavity && piece.area >= (std::max)(crumb * largest, least * area))
      large.push_back(first);
  }
  return large;
}

/// returns the sets of pieces, by their places in `large`, that go on in one another.
inline Disjoint_sets<Index> torn_objects(const std::map<Index, Mesh_piece>& pieces,
                                         const std::vector<Index>& large)
{
  Disjoint_sets<Index> objects(large.size());
  std::vector<Index> places;
  std::vector<const Mesh_piece*> open;
  for (Index i = 0; i < large.size(); ++i)
  {
    const Mesh_piece& piece = pieces.at(large[i]);
    if (piece.boundary.empty()) continue;
    places.push_back(i);
    open.push_back(&piece);
  }
  Piece_seams(std::move(open))
      .for_each([&](const std::size_t i, const std::size_t j)
                { objects.join(places[i], places[j]); });
  return objects;
}

/// returns for each face of a mesh the number of the object that it is of, from 1 on, or 0: for a cavity, or a crumb
/// beside the largest piece. It is empty if there are not two objects.
///
/// Complexity: O(n log n), and O(p^2) for p large open pieces.
inline std::vector<Index> find_solids(const Raw_shape& raw)
{
  if (raw.first_corner.size() != raw.positions.size() + 1) return {};
  Disjoint_sets<Index> sets(raw.positions.size());
  const std::map<Index, Mesh_piece> pieces = mesh_pieces(raw, sets);
  const std::vector<Index> large = large_pieces(pieces);
  Disjoint_sets<Index> objects = torn_objects(pieces, large);
  std::map<Index, Index> number_of_object, number_of_piece;
  for (Index i = 0; i < large.size(); ++i)
    number_of_piece[large[i]] =
        number_of_object.emplace(objects.find(i), static_cast<Index>(number_of_object.size() + 1))
            .first->second;
  if (number_of_object.size() < 2) return {};
  std::vector<Index> solids;
  for (Index f = 0; f < raw.positions.size(); ++f)
  {
    const auto found = number_of_piece.find(sets.find(f));
    solids.push_back(found != number_of_piece.end() ? found->second : 0);
  }
  return solids;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_SOLIDS_H
