// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_LOCAL_SEARCH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_LOCAL_SEARCH_H

// A better partition near a given one: what linkage has joined early it does not part again, though its
// classes may turn out to be more at home in a cluster that came later.

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Moves single classes of points between clusters while that raises the sum, over all pairs of points in one
/// cluster, of how much they are together less what is the `least` for that.
class Class_moves
{
public:
  /// takes the number of points of each class, what it is together with the others, summed over pairs of
  /// points, and its cluster, in numbers from 0 to the number of classes.
  Class_moves(const std::vector<double>& sizes, const Eigen::MatrixXd& together, const double least,
              std::vector<int>& clusters)
    : m_sizes(sizes), m_together(together), m_least(least), m_clusters(clusters),
      m_cluster_sizes(sizes.size(), 0.)
  {
    for (std::size_t i = 0; i < clusters.size(); ++i) m_cluster_sizes[clusters[i]] += sizes[i];
  }

  /// goes through all classes, at most so many times.
  void run(const int rounds = 60)
  {
    for (int round = 0; round < rounds; ++round)
    {
      bool moved = false;
      for (int i = 0; i < static_cast<int>(m_clusters.size()); ++i)
        if (const int best = best_cluster(i); best != m_clusters[i])
        {
          m_cluster_sizes[m_clusters[i]] -= m_sizes[i];
          m_cluster_sizes[best] += m_sizes[i];
          m_clusters[i] = best;
          moved = true;
        }
      if (!moved) return;
    }
  }

private:
  /// the cluster in which a class adds most to the sum; its own unless another one is clearly better
  int best_cluster(const int i) const
  {
    std::map<int, double> with;
    for (int j = 0; j < static_cast<int>(m_clusters.size()); ++j)
      if (j != i) with[m_clusters[j]] += m_together(j, i);
    const int own = m_clusters[i];
    const auto gain = [&](const int cluster, const double others)
    { return with[cluster] - m_least * m_sizes[i] * others; };
    const double rounding = 1e-9 * m_sizes[i] * m_cluster_sizes[own];
    double most = gain(own, m_cluster_sizes[own] - m_sizes[i]) + rounding;
    int best = own;
    for (const auto& entry : with)
    {
      const double gained = gain(entry.first, m_cluster_sizes[entry.first]);
      if (entry.first == own || gained <= most) continue;
      most = gained;
      best = entry.first;
    }
    return most < 0. ? empty_cluster() : best;
  }
  int empty_cluster() const
  {
    std::vector<char> is_used(m_clusters.size() + 1, 0);
    for (const int c : m_clusters) is_used[c] = 1;
    int c = 0;
    while (is_used[c] != 0) ++c;
    return c;
  }

  const std::vector<double>& m_sizes;
  const Eigen::MatrixXd& m_together;
  double m_least;
  std::vector<int>& m_clusters;
  std::vector<double> m_cluster_sizes; ///< points in each
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_LOCAL_SEARCH_H
