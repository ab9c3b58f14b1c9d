// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_REFINE_BORDERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_REFINE_BORDERS_H

// Border refinement (section 5, equations 3-5): borders move within a narrow band to where the surface is
// concave, by alpha expansion as in the paper or by cuts of single seams.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/alpha_expansion.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/seam_cuts.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// gives pieces that the cut left behind to the label around them: those under a hundredth of their
/// segment. Pieces that touch no other label stay.
inline void remove_islands(const Neighbor_graph& graph, std::vector<int>& labels)
{
  const Pieces pieces = connected_pieces(graph, std::vector<Index>(labels.begin(), labels.end()));
  std::map<int, std::size_t> segment_sizes;
  for (const int l : labels) ++segment_sizes[l];
  std::map<int, std::map<int, std::size_t>> contacts; // of small pieces: edges to each label
  for (Index i = 0; i < graph.size(); ++i)
  {
    const int piece = pieces.of_point[i];
    if (100 * pieces.sizes[piece] >= segment_sizes[labels[i]]) continue;
    for (const Neighbor& edge : graph[i])
      if (labels[edge.point] != labels[i]) ++contacts[piece][labels[edge.point]];
  }
  std::map<int, int> new_label;
  for (const auto& [piece, edges] : contacts)
    new_label[piece] =
        std::max_element(edges.begin(), edges.end(),
                         [](const auto& x, const auto& y) { return x.second < y.second; })
            ->first;
  if (new_label.empty()) return;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const auto it = new_label.find(pieces.of_point[i]);
    if (it != new_label.end()) labels[i] = it->second;
  }
}

/// whether borders are refined at all
inline bool has_refinement(const Border_parameters& parameters)
{
  return parameters.refinement != Refinement_rule::NONE && parameters.band_width > 0.;
}

inline std::size_t number_of_changes(const std::vector<int>& before, const std::vector<int>& labels)
{
  std::size_t changes = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) changes += labels[i] != before[i] ? 1 : 0;
  return changes;
}

/// moves the borders once, by the rule that is asked for.
inline void move_borders(const Neighbor_graph& graph, const Border_parameters& parameters,
                         std::vector<int>& labels, const bool parallel)
{
  if (parameters.refinement == Refinement_rule::SEAM_CUTS)
    cut_seams(graph, parameters, labels, parallel);
  else
    expand_labels(graph, parameters, labels);
}

/// moves the borders; returns the number of points that changed. Cuts of seams are repeated from where they are
/// then, without what islands they leave, until they stay: borders that began apart come to the same place more
/// often, and three rounds are as good as more. The paper's rule moves all of them once, and has no such islands.
inline std::size_t refine_borders(const Neighbor_graph& graph, const Border_parameters& parameters,
                                  std::vector<int>& labels, const bool parallel = false,
                                  const int most_rounds = 3)
{
  if (!has_refinement(parameters)) return 0;
  const bool is_repeated = parameters.refinement == Refinement_rule::SEAM_CUTS;
  const std::vector<int> before = labels;
  std::vector<int> last;
  for (int round = 0; round < (is_repeated ? most_rounds : 1) && labels != last; ++round)
  {
    last = labels;
    move_borders(graph, parameters, labels, parallel);
    if (is_repeated) remove_islands(graph, labels);
  }
  return number_of_changes(before, labels);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_REFINE_BORDERS_H
