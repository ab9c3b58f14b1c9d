// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CONSENSUS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CONSENSUS_H

// What the votes of several sets of patches on one shape agree on. Where patches end is left to chance in part, and
// with it whether a part is found that is hardly one. Segmentations from several sets of patches err
// independently of each other, so most of them are right more often than each of them.

#include <CGAL/Weakly_convex_segmentation/internal/consensus/local_search.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/votes.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The coarsest partition of which each class lies in one segment of each of some segmentations.
struct Overlay
{
  std::vector<int> of_point;
  std::vector<std::vector<int>> labels; ///< of each class, one a segmentation
  std::vector<double> sizes;            ///< points in each class
};

inline Overlay overlay(const std::vector<Votes>& votes)
{
  Overlay result;
  std::map<std::vector<int>, int> number;
  std::vector<int> labels(votes.size());
  for (std::size_t i = 0; i < votes.front().labels.size(); ++i)
  {
    for (std::size_t s = 0; s < labels.size(); ++s) labels[s] = votes[s].labels[i];
    const auto [slot, is_new] = number.emplace(labels, static_cast<int>(result.sizes.size()));
    if (is_new)
    {
      result.labels.push_back(labels);
      result.sizes.push_back(0.);
    }
    result.of_point.push_back(slot->second);
    result.sizes[slot->second] += 1.;
  }
  return result;
}

/// Clusters of the classes of an overlay, by the share of the votes that have two points of them
/// together, on average over the points: sums of pairs of points add up under merging.
class Consensus
{
public:
  Consensus(const Overlay& classes, const std::vector<Votes>& votes)
    : m_runs(static_cast<double>(votes.size())), m_sizes(classes.sizes),
      m_clusters(classes.sizes.size()), m_together(classes.sizes.size()),
      m_age(classes.sizes.size(), 0)
  {
    for (std::size_t s = 0; s < votes.size(); ++s)
    {
      std::map<int, std::vector<int>> of_region;
      for (std::size_t c = 0; c < m_sizes.size(); ++c)
        of_region[classes.labels[c][s]].push_back(static_cast<int>(c));
      for (const auto& [region, members] : of_region)
      {
        add(members, members, 1.);
        if (votes[s].together.empty()) continue;
        for (const auto& [other, probability] : votes[s].together[region])
        {
          const auto found = of_region.find(other); // refined borders may leave a region no point
          if (found != of_region.end()) add(members, found->second, probability);
        }
      }
    }
  }

  /// makes clusters of the classes that have one number, each still alone.
  void merge_as(const std::vector<int>& numbers)
  {
    std::map<int, int> first;
    for (int c = 0; c < static_cast<int>(numbers.size()); ++c)
    {
      const auto [it, is_new] = first.emplace(numbers[c], c);
      if (!is_new) merge(it->second, c);
    }
  }

  /// merges clusters, those of highest agreement first, while two points of different clusters are
  /// together in more than the share `least` of the segmentations, on average.
  void merge_down_to(const double least)
  {
    for (int a = 0; a < static_cast<int>(m_sizes.size()); ++a) consider(a, least, true);
    while (!m_queue.empty())
    {
      const Candidate best = m_queue.top();
      m_queue.pop();
      if (m_age[best.a] != best.age_a || m_age[best.b] != best.age_b) continue;
      merge(best.a, best.b);
      consider(best.a, least, false);
    }
  }

  /// gives clusters of fewer points, smallest first, to the one that they agree with most.
  void absorb_smaller_than(const double size)
  {
    std::vector<int> by_size;
    for (int c = 0; c < static_cast<int>(m_sizes.size()); ++c) by_size.push_back(c);
    std::stable_sort(by_size.begin(), by_size.end(),
                     [this](const int a, const int b) { return m_sizes[a] < m_sizes[b]; });
    for (const int c : by_size)
    {
      if (cluster_of(c) != c || m_sizes[c] >= size) continue;
      std::pair<double, int> best(0., -1);
      for (const auto& [other, together] : m_together[c])
        best = (std::max)(best, {together / m_sizes[other], other});
      if (best.second >= 0) merge(best.second, c);
    }
  }

  /// pairs of points of two clusters that are together, summed over the votes
  const std::vector<std::map<int, double>>& together() const { return m_together; }

  /// cluster of a class, named by one of its classes
  int cluster_of(const int c) const { return m_clusters.name_of(c); }

private:
  void add(const std::vector<int>& first, const std::vector<int>& second, const double probability)
  {
    for (const int a : first)
      for (const int b : second)
        if (a != b) m_together[a][b] += probability * (m_sizes[a] * m_sizes[b]);
  }

  struct Candidate
  {
    double share, pairs;
    int a, b;
    std::size_t age_a, age_b;
    /// Of equal shares, which few segmentations have many of, that of most points is first: what lies
    /// between two borders then goes with the large neighbors, not with another sliver beside it.
    bool operator<(const Candidate& other) const // the queue's top is its largest element
    {
      return std::tie(share, pairs, other.a, other.b) < std::tie(other.share, other.pairs, a, b);
    }
  };

  void consider(const int a, const double least, const bool only_higher)
  {
    for (const auto& [b, together] : m_together[a])
    {
      const double pairs = m_sizes[a] * m_sizes[b], share = together / (m_runs * pairs);
      if (share <= least || (only_higher && b < a)) continue;
      const int low = (std::min)(a, b), high = (std::max)(a, b);
      m_queue.push({share, pairs, low, high, m_age[low], m_age[high]});
    }
  }

  /// merges `b` into `a`.
  void merge(const int a, const int b)
  {
    for (const auto& [c, together] : m_together[b])
    {
      m_together[c].erase(b);
      if (c == a) continue;
      m_together[a][c] += together;
      m_together[c][a] = m_together[a][c];
    }
    m_together[b].clear();
    m_sizes[a] += m_sizes[b];
    m_clusters.join_named(a, b);
    ++m_age[a];
    ++m_age[b];
  }

  double m_runs;                 ///< number of votes
  std::vector<double> m_sizes;   ///< points in each cluster
  Disjoint_sets<int> m_clusters; ///< of classes
  /// pairs of points of two clusters that are together, summed over the votes
  std::vector<std::map<int, double>> m_together;
  std::vector<std::size_t> m_age;
  std::priority_queue<Candidate> m_queue;
};

/// returns the consensus after a local search from one that was linked.
inline Consensus with_moves(const Overlay& classes, const std::vector<Votes>& votes,
                            const double least, const Consensus& linked)
{
  std::vector<int> clusters;
  for (int c = 0; c < static_cast<int>(classes.sizes.size()); ++c)
    clusters.push_back(linked.cluster_of(c));
  Consensus result(classes, votes);
  Class_moves(classes.sizes, result.together(), least * static_cast<double>(votes.size()), clusters)
      .run();
  result.merge_as(clusters);
  return result;
}

/// returns the labels that the votes agree on, one a point, from 0 on but with gaps. Two points of different
/// segments are together with a probability of no more than `least`, on average. Segments of fewer than
/// `minimum_size` points join the one that they agree with most.
///
/// Complexity: linear in the number of points, besides O(m^2 log m) for m classes that overlap in a
/// segment.
inline std::vector<int> consensus_labels(const std::vector<Votes>& votes, const double least,
                                         const double minimum_size)
{
  const Overlay classes = overlay(votes);
  Consensus agreement(classes, votes);
  agreement.merge_down_to(least);
  const bool are_cuts = votes.front().together.empty();
  // where a majority of cuts decides, the search gains nothing
  if (!are_cuts) agreement = with_moves(classes, votes, least, agreement);
  agreement.absorb_smaller_than(minimum_size);
  std::vector<int> labels;
  labels.reserve(classes.of_point.size());
  for (const int c : classes.of_point) labels.push_back(agreement.cluster_of(c));
  return labels;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CONSENSUS_H
