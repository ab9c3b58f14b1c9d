// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_CONNECTED_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_CONNECTED_PARTS_H

// Parts that hang together on the mesh. The neighbor graph also joins what is near in space, as two feet that touch.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the names of the connected pieces of labels: of each point, one of the points of its piece.
inline std::vector<Index> pieces_of_labels(const std::vector<std::array<Index, 2>>& links,
                                           const std::vector<int>& labels)
{
  Disjoint_sets<Index> sets(labels.size());
  for (const auto& [i, j] : links)
    if (labels[i] == labels[j]) sets.join(i, j);
  std::vector<Index> names;
  names.reserve(labels.size());
  for (Index i = 0; i < labels.size(); ++i) names.push_back(sets.find(i));
  return names;
}

/// Pieces of parts that do not hang together with the largest piece of the part, on one piece of a mesh.
class Torn_parts
{
public:
  /// `links`: of the mesh, between points or faces; without any, as of a cloud, nothing is torn
  Torn_parts(const std::vector<std::array<Index, 2>>& links, std::vector<int>& labels)
    : m_labels(labels)
  {
    if (links.empty()) return;
    m_pieces = pieces_of_labels(links, labels);
    m_sizes.assign(labels.size(), 0);
    const std::vector<Index> of_mesh = pieces_of_labels(links, std::vector<int>(labels.size(), 0));
    for (const Index piece : m_pieces) ++m_sizes[piece];
    for (Index i = 0; i < labels.size(); ++i)
    {
      if (m_pieces[i] != i) continue;
      Index& largest = m_largest.emplace(std::make_pair(labels[i], of_mesh[i]), i).first->second;
      if (m_sizes[i] > m_sizes[largest]) largest = i;
    }
    for (Index i = 0; i < labels.size(); ++i)
      if (m_pieces[i] == i && largest_of(i, of_mesh[i]) != i)
        m_torn.push_back({m_sizes[i], i, largest_of(i, of_mesh[i])});
    std::sort(m_torn.begin(), m_torn.end());
    if (m_torn.empty()) return;
    for (const auto& [i, j] : links)
      if (labels[i] != labels[j])
        for (const auto& [a, b] : {std::make_pair(i, j), std::make_pair(j, i)})
          ++m_contacts[{m_pieces[a], m_pieces[b]}];
  }

  /// gives small pieces to the neighbor with the longest border: those of fewer than `enough` points, and mere crumbs
  /// of a part.
  void join_small(const double enough)
  {
    constexpr double crumb = 0.1; // of the largest piece
    std::map<Index, int> label;
    for (const auto& [size, piece, largest] : m_torn)
      if (static_cast<double>(size) <
          (std::max)(enough, crumb * static_cast<double>(m_sizes[largest])))
        label[piece] = neighbor_of(piece, label);
    set_labels(label);
  }

  /// makes all pieces parts of their own, with labels from `next_label` on.
  void divide(int next_label)
  {
    std::map<Index, int> label;
    for (const Torn& torn : m_torn) label[torn.piece] = next_label++;
    set_labels(label);
  }

private:
  struct Torn
  {
    std::size_t size;
    Index piece, largest; ///< of the same part
    bool operator<(const Torn& t) const
    {
      return size < t.size || (size == t.size && piece < t.piece);
    }
  };

  void set_labels(const std::map<Index, int>& label)
  {
    for (std::size_t i = 0; i < m_labels.size() && !label.empty(); ++i)
    {
      const auto found = label.find(m_pieces[i]);
      if (found != label.end()) m_labels[i] = found->second;
    }
  }

  Index largest_of(const Index i, const Index of_mesh) const
  {
    return m_largest.at({m_labels[i], of_mesh});
  }

  /// returns the label with the longest border to a piece; `changed`: labels of pieces that are no longer as they were
  int neighbor_of(const Index piece, const std::map<Index, int>& changed) const
  {
    std::map<int, std::size_t> borders;
    for (auto at = m_contacts.lower_bound({piece, 0});
         at != m_contacts.end() && at->first.first == piece; ++at)
    {
      const Index other = at->first.second;
      const auto found = changed.find(other);
      borders[found != changed.end() ? found->second : m_labels[other]] += at->second;
    }
    std::pair<std::size_t, int> best(0, m_labels[piece]);
    for (const auto& [label, length] : borders)
      if (length > best.first) best = {length, label};
    return best.second;
  }

  std::vector<int>& m_labels;
  std::vector<Index> m_pieces;                      ///< of each point
  std::vector<std::size_t> m_sizes;                 ///< by the names of the pieces
  std::map<std::pair<int, Index>, Index> m_largest; ///< piece of a part, on a piece of the mesh
  std::vector<Torn> m_torn;
  std::map<std::pair<Index, Index>, std::size_t> m_contacts; ///< links between pieces
};

/// gives each piece of a mesh the label of most of its points, the smallest where several have as many.
inline void join_pieces(const std::vector<std::array<Index, 2>>& links, std::vector<int>& labels)
{
  if (links.empty()) return; // of a cloud
  const std::vector<Index> piece = pieces_of_labels(links, std::vector<int>(labels.size(), 0));
  std::map<std::pair<Index, int>, std::size_t> sizes;
  for (std::size_t i = 0; i < labels.size(); ++i) ++sizes[{piece[i], labels[i]}];
  std::map<Index, std::pair<std::size_t, int>> largest; // and its label
  for (const auto& [at, size] : sizes)
    if (size > largest[at.first].first) largest[at.first] = {size, at.second};
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = largest.at(piece[i]).second;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_CONNECTED_PARTS_H
