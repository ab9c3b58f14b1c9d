// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_PIECES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_PIECES_H

#include "metrics/mesh_geometry.h"
#include "parts/Part_labels.h"
#include "parts/Sampled_surface.h"
#include "parts/border_lines.h"
#include "parts/surface_diameters.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

// The connected pieces of the parts, their borders and how thick they are.

namespace Part_measures {

/// A closed line, or a net of lines, about a piece.
struct Border_loop
{
  std::vector<Vector> vertices; ///< smoothed; the ends of each edge
  double length = 0., crease_length = 0.;
  std::map<std::size_t, double> length_with; ///< other pieces

  void add(const Border_loop& other)
  {
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    length += other.length;
    crease_length += other.crease_length;
    for (const auto& [piece, l] : other.length_with) length_with[piece] += l;
  }
};

struct Piece
{
  int label = 0; ///< as read
  double area = 0.;
  std::vector<Border_loop> loops;         ///< longest first
  std::vector<Diameter_sample> diameters; ///< below the piece

  /// of all loops, which have no zigzag
  double perimeter() const
  {
    double sum = 0.;
    for (const Border_loop& loop : loops) sum += loop.length;
    return sum;
  }
  double diameter() const
  {
    std::vector<double> values;
    for (const Diameter_sample& d : diameters) values.push_back(d.diameter);
    return median(std::move(values));
  }
};

namespace internal {

/// Numbers sets from 0 by their first members.
class Numbered_sets
{
public:
  explicit Numbered_sets(const std::size_t size) : m_parents(size), m_ranks(size)
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }
  void join(const std::size_t a, const std::size_t b) { sets().union_set(a, b); }
  std::vector<std::size_t> numbers()
  {
    std::vector<std::size_t> result;
    std::unordered_map<std::size_t, std::size_t> known;
    for (std::size_t i = 0; i < m_parents.size(); ++i)
      result.push_back(known.emplace(sets().find_set(i), known.size()).first->second);
    return result;
  }

private:
  boost::disjoint_sets<std::size_t*, std::size_t*> sets()
  {
    return {m_ranks.data(), m_parents.data()};
  }
  std::vector<std::size_t> m_parents, m_ranks;
};

inline std::vector<std::size_t> pieces_of_faces(const SM::Mesh_geometry& geometry,
                                                const Part_labels& labels)
{
  Numbered_sets sets(labels.of_face.size());
  for (const SM::Face_adjacency& edge : geometry.adjacencies)
    if (labels.of_face[edge.faces[0]] == labels.of_face[edge.faces[1]])
      sets.join(edge.faces[0], edge.faces[1]);
  return sets.numbers();
}

/// An edge of a piece's border, and the piece beyond.
struct Outer_edge
{
  const Border_edge* edge;
  std::size_t beyond;
};

/// the connected lines of border edges about a piece, longest first
inline std::vector<Border_loop> loops_of(const std::vector<Outer_edge>& edges,
                                         const Borders& borders, const Sampled_surface& surface)
{
  constexpr double crease = 35.; // degrees
  Numbered_sets sets(edges.size());
  std::unordered_map<std::size_t, std::size_t> edge_at;
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::size_t v : edges[e].edge->vertices)
      sets.join(e, edge_at.emplace(v, e).first->second);
  std::vector<Border_loop> loops;
  const std::vector<std::size_t> number = sets.numbers();
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (number[e] == loops.size()) loops.emplace_back();
    Border_loop& loop = loops[number[e]];
    const Border_edge& edge = *edges[e].edge;
    for (const std::size_t v : edge.vertices) loop.vertices.push_back(borders.smooth_positions[v]);
    const double length = borders.smooth_length(edge);
    loop.length += length;
    loop.length_with[edges[e].beyond] += length;
    if (std::abs(fold(surface, edge.mesh_edge)) > crease) loop.crease_length += length;
  }
  const auto longer = [](const auto& a, const auto& b) { return a.length > b.length; };
  std::stable_sort(loops.begin(), loops.end(), longer);
  return loops;
}

} // namespace internal

/// finds the pieces of the parts, with those of the samples of diameters that lie on them.
inline std::vector<Piece> find_pieces(const SM::Mesh_geometry& geometry,
                                      const Sampled_surface& surface, const Borders& borders,
                                      const std::vector<Diameter_sample>& diameters,
                                      const Part_labels& labels)
{
  const std::vector<std::size_t> of_face = internal::pieces_of_faces(geometry, labels);
  std::vector<Piece> pieces(1 + *std::max_element(of_face.begin(), of_face.end()));
  for (std::size_t f = 0; f < of_face.size(); ++f)
  {
    Piece& piece = pieces[of_face[f]];
    piece.label = labels.names[labels.of_face[f]];
    piece.area += geometry.face_areas[f];
  }
  for (const Diameter_sample& d : diameters) pieces[of_face[d.face]].diameters.push_back(d);
  std::vector<std::vector<internal::Outer_edge>> edges(pieces.size());
  for (const Border_edge& edge : borders.edges)
  {
    const std::size_t a = of_face[edge.mesh_edge.faces[0]], b = of_face[edge.mesh_edge.faces[1]];
    edges[a].push_back({&edge, b});
    edges[b].push_back({&edge, a});
  }
  for (std::size_t p = 0; p < pieces.size(); ++p)
    pieces[p].loops = internal::loops_of(edges[p], borders, surface);
  return pieces;
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_PIECES_H
