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

#include <CGAL/Weakly_convex_segmentation/internal/consensus/clusters.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/local_search.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/overlay.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/torn_clusters.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/votes.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The share of cuts that have to put two points together, on average. No tie of few votes: half of them are more,
/// two of five are less.
constexpr double least_share_of_cuts = 0.42;

/// Clusters of the classes of an overlay, by the share of the votes that have two points of them
/// together, on average over the points: pairs of points add up under merging.
///
/// Where the shape is its own mirror image, two clusters and their images are merged both or not at all.
class Consensus
{
public:
  Consensus(std::vector<double> sizes, Eigen::MatrixXd together, Eigen::MatrixXd mirrored)
    : m_sizes(std::move(sizes)), m_clusters(m_sizes.size()), m_together(std::move(together)),
      m_mirrored(std::move(mirrored))
  {}

  /// makes clusters of the classes that have one number, each still alone.
  void merge_as(const std::vector<int>& numbers)
  {
    std::map<int, int> first;
    for (int c = 0; c < size(); ++c)
    {
      const auto [it, is_new] = first.emplace(numbers[c], c);
      if (!is_new) merge(it->second, c);
    }
  }

  /// merges clusters, those of highest agreement first, while two points of different clusters are
  /// together in more than the share `least` of the votes, on average.
  void merge_down_to(const double least)
  {
    m_best.assign(m_sizes.size(), {});
    for (int a = 0; a < size(); ++a) find_best(a, least);
    while (true)
    {
      const Candidate best = *std::max_element(m_best.begin(), m_best.end());
      if (best.a < 0) return;
      const auto [first, second] = mirror_images(best.a, best.b);
      const With_image with_image = merge_with_image(best, first, second, least);
      if (with_image == With_image::NEITHER)
      {
        m_refused.insert({best.a, best.b});
        for (const int end : {best.a, best.b}) find_best(end, least);
        continue;
      }
      merge_and_look(best.a, best.b, least);
      const int c = cluster_of(first), d = cluster_of(second);
      if (with_image != With_image::ALONE && c != d && m_together(c, d) > 0.)
        merge_and_look(c, d, least);
    }
  }

  /// gives clusters of fewer points, smallest first, to the one that they agree with most.
  void absorb_smaller_than(const double least_size)
  {
    for (const int c : smallest_first(m_sizes))
    {
      if (cluster_of(c) != c || m_sizes[c] >= least_size) continue;
      std::pair<double, int> best(0., -1);
      for (int other = 0; other < size(); ++other)
        if (other != c && cluster_of(other) == other && m_together(c, other) > 0.)
          best = (std::max)(best, {m_together(c, other) / m_sizes[other], other});
      if (best.second >= 0) merge(best.second, c);
    }
  }

  /// cluster of a class, named by one of its classes
  int cluster_of(const int c) const { return m_clusters.name_of(c); }
  std::vector<int> clusters() const
  {
    std::vector<int> result;
    for (int c = 0; c < size(); ++c) result.push_back(cluster_of(c));
    return result;
  }

private:
  /// Two clusters that may be merged, or none.
  struct Candidate
  {
    double share = -1., pairs = 0.;
    int a = -1, b = -1;
    /// Of equal shares, which few segmentations have many of, that of most points is first: what lies
    /// between two borders then goes with the large neighbors, not with another sliver beside it.
    bool operator<(const Candidate& other) const // the largest is merged
    {
      return std::tie(share, pairs, other.a, other.b) < std::tie(other.share, other.pairs, a, b);
    }
    bool has(const int cluster) const { return a == cluster || b == cluster; }
  };

  int size() const { return static_cast<int>(m_sizes.size()); }

  Candidate candidate(const int a, const int b, const double least) const
  {
    const double pairs = m_sizes[a] * m_sizes[b];
    if (b == a || m_together(b, a) <= least * pairs) return {}; // 0 where it is merged
    const auto [low, high] = std::minmax(a, b);
    if (m_refused.count({low, high}) > 0) return {};
    return {m_together(b, a) / pairs, pairs, low, high};
  }

  /// finds the cluster that one is best merged with.
  void find_best(const int a, const double least)
  {
    m_best[a] = {};
    for (int b = 0; b < size(); ++b) m_best[a] = (std::max)(m_best[a], candidate(a, b, least));
  }

  /// merges `b` into `a`, and finds what others are best merged with then.
  void merge_and_look(const int a, const int b, const double least)
  {
    merge(a, b);
    for (auto it = m_refused.begin(); it != m_refused.end();)
    {
      const auto [c, d] = *it;
      it = c == a || c == b || d == a || d == b ? m_refused.erase(it) : std::next(it);
    }
    m_best[b] = {};
    find_best(a, least);
    for (int c = 0; c < size(); ++c)
    {
      if (c == a || c == b) continue;
      if (m_best[c].has(a) || m_best[c].has(b))
        find_best(c, least);
      else
        m_best[c] = (std::max)(m_best[c], candidate(c, a, least));
    }
  }

  /// returns the images of two clusters if they are another pair; else a cluster twice.
  std::pair<int, int> mirror_images(const int a, const int b) const
  {
    if (m_mirrored.size() == 0) return {a, a};
    const int c = mirror_image(m_mirrored, m_sizes, a), d = mirror_image(m_mirrored, m_sizes, b);
    return std::minmax(a, b) == std::minmax(c, d) ? std::make_pair(a, a) : std::make_pair(c, d);
  }

  /// What is merged of a pair and its image.
  enum class With_image
  {
    BOTH,
    NEITHER,
    ALONE ///< the pair, without its image
  };
  /// Where a pair and its images c and d share a cluster, the second merge has to be one that is made after the
  /// first; else there is neither. But a sliver across the plane, that belongs to either side, is no part of its own.
  With_image merge_with_image(const Candidate& merge, const int c, const int d,
                              const double least) const
  {
    const bool has_c = merge.has(c), has_d = merge.has(d);
    if (has_c == has_d) return With_image::BOTH;
    const int other = has_c ? d : c, shared = has_c ? c : d;
    const double pairs = (m_sizes[merge.a] + m_sizes[merge.b]) * m_sizes[other];
    if (m_together(merge.a, other) + m_together(merge.b, other) > least * pairs)
      return With_image::BOTH;
    return m_sizes[shared] < largest_sliver * m_sizes[other] ? With_image::ALONE
                                                             : With_image::NEITHER;
  }

  /// merges `b` into `a`.
  void merge(const int a, const int b)
  {
    merge_rows_and_columns(m_together, a, b);
    merge_rows_and_columns(m_mirrored, a, b);
    m_sizes[a] += m_sizes[b];
    m_clusters.join_named(a, b);
  }

  std::vector<double> m_sizes;   ///< points in each cluster
  Disjoint_sets<int> m_clusters; ///< of classes
  /// pairs of points of two clusters that are together, a mean over the votes
  Eigen::MatrixXd m_together;
  /// points of a row's cluster whose mirror images lie in a column's; or empty
  Eigen::MatrixXd m_mirrored;
  /// Of each cluster. A queue of all pairs took 1.5 times as long on shapes of thousands of classes, as of 5,000
  /// pieces or of a flat sheet (whole run; `benchmark_speed`).
  std::vector<Candidate> m_best;
  std::set<std::pair<int, int>> m_refused; ///< that their images keep from being merged as they are
};

/// returns the votes and, where points have mirror images, the same votes about these.
inline std::vector<Votes> with_mirrored(std::vector<Votes> votes, const std::vector<Index>& image)
{
  const std::size_t count = image.empty() ? 0 : votes.size();
  for (std::size_t s = 0; s < count; ++s)
  {
    Votes mirrored = votes[s];
    for (std::size_t i = 0; i < image.size(); ++i) mirrored.labels[i] = votes[s].labels[image[i]];
    votes.push_back(std::move(mirrored));
  }
  return votes;
}

/// returns the cluster of each class by what the votes agree on, named by one of its classes; see
/// `consensus_labels()`.
inline std::vector<int> consensus_clusters(const Overlay& classes, const std::vector<Votes>& votes,
                                           const Eigen::MatrixXd& mirrored, const double least,
                                           const double minimum_size)
{
  Eigen::MatrixXd together = pairs_together(classes, votes);
  Consensus agreement(classes.sizes, together, mirrored);
  agreement.merge_down_to(least);
  if (!votes.front().together.empty()) // where a majority of cuts decides, this gains nothing
  {
    std::vector<int> clusters = agreement.clusters();
    Class_moves(classes.sizes, together, least, clusters).run();
    Torn_clusters torn(classes.sizes, mirrored, clusters);
    for (std::size_t s = 0; s < votes.size(); ++s)
      for_each_together(classes, votes, s, torn.new_vote());
    torn.join((std::max)(0.5, least)); // no part to most votes
    agreement = Consensus(classes.sizes, std::move(together), {});
    agreement.merge_as(clusters);
  }
  agreement.absorb_smaller_than(minimum_size);
  return agreement.clusters();
}

/// returns the labels that the votes agree on, one a point, from 0 on but with gaps. Two points of different
/// segments are together with a probability of no more than `least`, on average. Segments of fewer than
/// `minimum_size` points join the one that they agree with most. `image`: where a plane of
/// reflection takes each point, as in `Mirror`; empty if there is no such plane.
///
/// Complexity: linear in the number of points, besides O(m^2) expected for m classes of the overlay that the votes know
/// anything about together.
inline std::vector<int> consensus_labels(std::vector<Votes> votes, const double least,
                                         const double minimum_size,
                                         const std::vector<Index>& image = {})
{
  votes = with_mirrored(std::move(votes), image);
  const Overlay classes = overlay(votes);
  const Class_images images = images_of_classes(classes, image);
  std::vector<int> clusters(classes.sizes.size());
  for (const std::vector<int>& group : independent_classes(classes, votes, images))
  {
    const std::vector<int> own =
        consensus_clusters(chosen_classes(classes, group), votes, mirrored_classes(group, images),
                           least, minimum_size);
    for (std::size_t i = 0; i < group.size(); ++i) clusters[group[i]] = group[own[i]];
  }
  std::vector<int> labels;
  labels.reserve(classes.of_point.size());
  for (const int c : classes.of_point) labels.push_back(clusters[c]);
  return labels;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CONSENSUS_H
