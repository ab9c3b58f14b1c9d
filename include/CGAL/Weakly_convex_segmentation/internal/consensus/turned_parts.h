// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TURNED_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TURNED_PARTS_H

// What comes several times about an axis is one thing. What most places about the axis have the same label for, gets
// that everywhere; and what is cut off at half of the places or more, as the teeth of a gear, is cut off at all. Few
// sets of patches would agree on labels that were turned by every tooth, as they do on mirrored ones; so this goes by
// what was decided.

#include <CGAL/Weakly_convex_segmentation/internal/consensus/turn.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Makes labels the same at all places that a turn takes points to, as far as most places agree.
class Turned_parts
{
public:
  Turned_parts(const Turn& turn, std::vector<int>& labels)
    : m_order(turn.order), m_labels(labels), m_turned(static_cast<std::size_t>(turn.order))
  {
    for (Index i = 0; i < labels.size(); ++i) m_turned[0].push_back(i);
    for (int r = 1; r < m_order; ++r)
      for (const Index i : m_turned[r - 1]) m_turned[r].push_back(turn.image[i]);
  }

  /// gives each point the label that more than half of the places have that it is taken to, if there is one.
  void take_what_most_have()
  {
    const std::vector<int> before = m_labels;
    std::map<int, int> counts;
    for (Index i = 0; i < before.size(); ++i)
    {
      counts.clear();
      for (int r = 0; r < m_order; ++r)
        if (const int label = before[m_turned[r][i]]; 2 * ++counts[label] > m_order)
          m_labels[i] = label;
    }
  }

  /// cuts off at all places what is cut off at half of them or more.
  void cut_what_half_have()
  {
    m_before = m_labels;
    m_points.clear();
    for (Index i = 0; i < m_before.size(); ++i) m_points[m_before[i]].push_back(i);
    m_next = 1 + m_points.rbegin()->first;
    std::set<int> done;
    for (const auto& [label, points] : m_points)
      if (done.count(label) == 0) cut_like(label, done);
  }

private:
  /// What is where a turn takes a part.
  struct Place
  {
    int label = -1;       ///< that most of it has; -1 if there is none
    bool is_part = false; ///< whether it has most of the other part, too: both are the same
  };

  /// cuts off what is where turns take a part, and adds the parts that are the same to those that are done.
  void cut_like(const int label, std::set<int>& done)
  {
    std::vector<Place> places;
    std::set<int> parts;
    std::ptrdiff_t count = 0;
    for (int r = 0; r < m_order; ++r)
    {
      places.push_back(place_of(label, r));
      if (!places.back().is_part) continue;
      parts.insert(places.back().label);
      ++count;
    }
    done.insert(parts.begin(), parts.end());
    const bool comes_to_itself = count > static_cast<std::ptrdiff_t>(parts.size());
    if (comes_to_itself || 2 * count < m_order) return;
    for (int r = 1; r < m_order; ++r)
      if (const Place& place = places[r];
          !place.is_part && place.label >= 0 && place.label != label)
        cut(label, r, place.label);
  }

  /// returns what is where so many turns take a part.
  Place place_of(const int label, const int turns) const
  {
    const std::vector<Index>& points = m_points.at(label);
    std::map<int, std::size_t> counts;
    for (const Index i : points) ++counts[m_before[m_turned[turns][i]]];
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto [other, common] = *most;
    if (2 * common <= points.size()) return {};
    return {other, 2 * common > m_points.at(other).size()};
  }

  /// makes what lies where so many turns take a part, and in another part, a part of its own.
  void cut(const int label, const int turns, const int around)
  {
    for (const Index i : m_points.at(around))
      if (m_before[m_turned[m_order - turns][i]] == label) m_labels[i] = m_next;
    ++m_next;
  }

  int m_order;
  std::vector<int>& m_labels;
  std::vector<std::vector<Index>> m_turned; ///< where so many turns take each point

  // while parts are cut off
  std::vector<int> m_before;                  ///< the labels
  std::map<int, std::vector<Index>> m_points; ///< of each of these
  int m_next = 0;                             ///< label that no part has
};

/// makes labels the same at all places that a turn takes points to, as far as most places agree.
///
/// Complexity: linear in the number of points and in the order of the turn, besides sorting.
inline void decide_places_alike(const Turn& turn, std::vector<int>& labels)
{
  Turned_parts parts(turn, labels);
  parts.take_what_most_have();
  parts.cut_what_half_have();
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TURNED_PARTS_H
