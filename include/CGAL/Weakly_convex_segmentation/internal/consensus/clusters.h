// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CLUSTERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CLUSTERS_H

// What all that merges clusters needs: their order, their sums in matrices, and which is the mirror image of which.

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the numbers of clusters, smallest first, those of one size in their order.
inline std::vector<int> smallest_first(const std::vector<double>& sizes)
{
  std::vector<int> result(sizes.size());
  std::iota(result.begin(), result.end(), 0);
  std::stable_sort(result.begin(), result.end(),
                   [&](const int a, const int b) { return sizes[a] < sizes[b]; });
  return result;
}

/// adds a row and a column of a square matrix to others.
inline void merge_rows_and_columns(Eigen::MatrixXd& matrix, const int into, const int from)
{
  if (matrix.size() == 0) return;
  matrix.row(into) += matrix.row(from);
  matrix.col(into) += matrix.col(from);
  matrix.row(from).setZero();
  matrix.col(from).setZero();
}

/// Up to this share of the size of its neighbor a cluster across a plane of reflection may go to one of two sides.
/// With a tenth, scans of pliers and birds from two sides, with noise, had both sides in one part.
constexpr double largest_sliver = 0.25;

/// returns the cluster where most of the mirror images of a cluster's points lie, if it is about as large; else the
/// cluster itself. `mirrored` has how many points of a row's cluster have them in a column's, or nothing.
inline int mirror_image(const Eigen::MatrixXd& mirrored, const std::vector<double>& sizes,
                        const int cluster)
{
  constexpr double most_ratio = 1.7;
  if (mirrored.size() == 0) return cluster;
  Eigen::Index best = 0;
  if (mirrored.row(cluster).maxCoeff(&best) <= 0.5 * sizes[cluster]) return cluster;
  const double ratio = sizes[static_cast<std::size_t>(best)] / sizes[cluster];
  return ratio < most_ratio && 1. < most_ratio * ratio ? static_cast<int>(best) : cluster;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_CLUSTERS_H
