// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TORN_CLUSTERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TORN_CLUSTERS_H

// Clusters that are none to most votes: these have them with a neighbor, but not all with the same one. What lies
// between two places of a border is so; on average it seems to belong nowhere.

#include <CGAL/Weakly_convex_segmentation/internal/consensus/clusters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/number_labels.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Joins torn clusters to those that they are with most, and their mirror images likewise.
class Torn_clusters
{
public:
  /// takes the number of points of each class, how many of a row's class have their mirror image in a column's, if
  /// there are any, and the cluster of each class, in any numbers from 0 on.
  Torn_clusters(const std::vector<double>& sizes, const Eigen::MatrixXd& mirrored,
                std::vector<int>& clusters)
    : m_class_sizes(sizes), m_clusters(clusters)
  {
    m_sizes.assign(number_labels(m_clusters), 0.);
    for (std::size_t c = 0; c < sizes.size(); ++c) m_sizes[m_clusters[c]] += sizes[c];
    const Eigen::MatrixXd images = mirrored.size() == 0 ? mirrored : sums(mirrored);
    for (int c = 0; c < size(); ++c) m_image.push_back(mirror_image(images, m_sizes, c));
  }

  /// returns what takes a new vote: a function of two sets of classes and the probability that a point of the one
  /// is together with a point of the other.
  auto new_vote()
  {
    m_together.push_back(Eigen::MatrixXd::Zero(size(), size()));
    return [this](const std::vector<int>& first, const std::vector<int>& second,
                  const double probability)
    {
      for (const int a : first)
        for (const int b : second)
          m_together.back()(m_clusters[b], m_clusters[a]) +=
              probability * m_class_sizes[a] * m_class_sizes[b];
    };
  }

  /// joins a cluster, smallest first, where each vote's most likely neighbor is one with a probability of more than
  /// `least`, on average over the votes, and no single neighbor has as much on average.
  void join(const double least)
  {
    for (const int c : smallest_first(m_sizes))
    {
      const int home = m_sizes[c] > 0. ? home_of(c, least) : -1;
      if (home < 0) continue;
      const int image = m_image[c], image_of_home = m_image[home];
      const bool is_across = image == c && image_of_home != home; // its home has a double
      if (is_across && m_sizes[c] >= largest_sliver * m_sizes[home]) continue;
      join_two(home, c);
      // an image may be gone already: that of a cluster across the plane is itself
      if (image != home && image != image_of_home && m_sizes[image] > 0. &&
          m_sizes[image_of_home] > 0.)
        join_two(image_of_home, image);
    }
  }

private:
  int size() const { return static_cast<int>(m_sizes.size()); }

  /// the sums of what classes have to clusters
  Eigen::MatrixXd sums(const Eigen::MatrixXd& of_classes) const
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size(), size());
    for (Eigen::Index b = 0; b < of_classes.cols(); ++b)
      for (Eigen::Index a = 0; a < of_classes.rows(); ++a)
        result(m_clusters[a], m_clusters[b]) += of_classes(a, b);
    return result;
  }

  /// the cluster that one is with most, if it is torn; else -1
  int home_of(const int c, const double least) const
  {
    std::vector<double> most(m_together.size(), 0.);
    std::pair<double, int> best(0., -1);
    for (int other = 0; other < size(); ++other)
    {
      if (other == c || m_sizes[other] == 0.) continue;
      double sum = 0.;
      for (std::size_t s = 0; s < most.size(); ++s)
      {
        const double share = m_together[s](c, other) / (m_sizes[c] * m_sizes[other]);
        most[s] = (std::max)(most[s], share);
        sum += share;
      }
      best = (std::max)(best, {sum, other});
    }
    const double enough = least * static_cast<double>(most.size());
    return best.first <= enough && std::accumulate(most.begin(), most.end(), 0.) > enough
               ? best.second
               : -1;
  }
  void join_two(const int into, const int from)
  {
    for (Eigen::MatrixXd& pairs : m_together) merge_rows_and_columns(pairs, into, from);
    m_sizes[into] += m_sizes[from];
    m_sizes[from] = 0.;
    for (int& cluster : m_clusters)
      if (cluster == from) cluster = into;
  }

  const std::vector<double>& m_class_sizes;
  std::vector<int>& m_clusters;            ///< of each class
  std::vector<double> m_sizes;             ///< points in each cluster
  std::vector<int> m_image;                ///< of each cluster, or itself
  std::vector<Eigen::MatrixXd> m_together; ///< pairs of points of two clusters, in each vote
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_TORN_CLUSTERS_H
