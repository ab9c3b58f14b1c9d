// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_K_MEANS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_K_MEANS_H

// k-means of the rows of a matrix, from centers far from each other.

#include <CGAL/Weakly_convex_segmentation/internal/patches/spectral_embedding.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns a number in [0, 1) that is the same with every standard library.
inline double unit_random(std::mt19937& random)
{
  return static_cast<double>(random()) / 4294967296.;
}

/// chooses k-means centers far from each other (k-means++).
inline Embedding spread_centers(const Embedding& rows, const std::size_t count,
                                std::mt19937& random)
{
  const Eigen::Index n = rows.rows();
  Embedding centers(static_cast<Eigen::Index>(count), rows.cols());
  Eigen::VectorXf nearest = Eigen::VectorXf::Constant(n, (std::numeric_limits<float>::max)());
  Eigen::Index next = static_cast<Eigen::Index>(unit_random(random) * static_cast<double>(n));
  for (Eigen::Index c = 0; c < centers.rows(); ++c)
  {
    centers.row(c) = rows.row(next);
    double sum = 0.;
    for (Eigen::Index i = 0; i < n; ++i)
    {
      nearest[i] = (std::min)(nearest[i], (rows.row(i) - centers.row(c)).squaredNorm());
      sum += nearest[i];
    }
    double left = unit_random(random) * sum;
    next = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      if (nearest[i] > 0.f)
      {
        next = i;
        left -= nearest[i];
        if (left < 0.) break;
      }
  }
  return centers;
}

/// Lloyd's algorithm; returns the cluster of each row.
inline std::vector<Index> k_means(const Embedding& rows, const std::size_t count,
                                  std::mt19937& random)
{
  constexpr int maximum_iterations = 30;
  Embedding centers = spread_centers(rows, count, random);
  const Eigen::Index n = rows.rows();
  std::vector<Index> cluster(static_cast<std::size_t>(n), 0);
  for (int iteration = 0; iteration < maximum_iterations; ++iteration)
  {
    // |x - c|^2 = |x|^2 - 2 x.c + |c|^2: one matrix product for all
    const Eigen::VectorXf half_norms = 0.5f * centers.rowwise().squaredNorm();
    const Embedding products = rows * centers.transpose();
    bool changed = false;
    for (Eigen::Index i = 0; i < n; ++i)
    {
      Eigen::Index best;
      (products.row(i).transpose() - half_norms).maxCoeff(&best);
      Index& mine = cluster[static_cast<std::size_t>(i)];
      changed = changed || mine != static_cast<Index>(best);
      mine = static_cast<Index>(best);
    }
    if (!changed) break;
    Embedding sums = Embedding::Zero(centers.rows(), centers.cols());
    Eigen::VectorXf sizes = Eigen::VectorXf::Zero(centers.rows());
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const Eigen::Index c = static_cast<Eigen::Index>(cluster[static_cast<std::size_t>(i)]);
      sums.row(c) += rows.row(i);
      sizes[c] += 1.f;
    }
    for (Eigen::Index c = 0; c < centers.rows(); ++c)
      if (sizes[c] > 0.f) centers.row(c) = sums.row(c) / sizes[c];
  }
  return cluster;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_K_MEANS_H
