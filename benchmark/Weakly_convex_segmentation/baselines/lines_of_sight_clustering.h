// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_CLUSTERING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_CLUSTERING_H

#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/spectral_clustering.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Patch_visibility.h>

#include "baselines/k_means.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// The steps of the decomposition by lines of sight; what each chooses where public text on the method
// is silent stands with `decompose()`.

namespace Lines_of_sight {

namespace WCS = CGAL::Weakly_convex_segmentation;
using WCS::internal::Embedding;
using WCS::internal::Index;
using WCS::internal::Line_of_sight_query;
using WCS::internal::Oriented_points;

/// How far apart two points count: opposite sides of a thin sheet must not stand for each other, so
/// that opposite normals are as far apart as 6 % of the shape's extent.
inline float sample_distance(const Oriented_points& points, const Index i, const Index j)
{
  constexpr float normal_weight = 0.03f;
  return squared_length(points.positions[i] - points.positions[j]) +
         normal_weight * normal_weight * squared_length(points.normals[i] - points.normals[j]);
}

/// returns at most `count` points each of which is farthest from those before, beginning with the one
/// farthest from the centroid. Duplicates are not chosen. Complexity: O(n count).
inline std::vector<Index> farthest_points(const Oriented_points& points, const std::size_t count)
{
  const std::size_t n = points.size();
  std::vector<float> distance(n, std::numeric_limits<float>::infinity());
  Index next = 0;
  for (Index i = 1; i < n; ++i)
    if (squared_length(points.positions[i]) > squared_length(points.positions[next])) next = i;
  std::vector<Index> sample;
  while (sample.size() < count && distance[next] > 0.f)
  {
    sample.push_back(next);
    const Index last = next;
    distance[last] = 0.f; // the first to be compared with
    for (Index i = 0; i < n; ++i)
    {
      distance[i] = (std::min)(distance[i], sample_distance(points, i, last));
      if (distance[i] > distance[next]) next = i;
    }
  }
  return sample;
}

/// returns the matrix with 1 where two of the sample are in line of sight, and on the diagonal.
inline Eigen::MatrixXd line_of_sight_matrix(const Line_of_sight_query& sight,
                                            const std::vector<Index>& sample,
                                            const double tolerance, const bool parallel)
{
  const Eigen::Index n = static_cast<Eigen::Index>(sample.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  WCS::internal::parallel_for(
      sample.size(), parallel,
      [&](const std::size_t i)
      {
        for (std::size_t j = 0; j < i; ++j)
          if (sight.sees_inside(sample[i], sample[j], tolerance))
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = 1.;
      },
      8);
  return matrix.selfadjointView<Eigen::Lower>();
}

/// Eigenvalues of the normalized Laplacian, ascending, and its eigenvectors in columns.
struct Spectrum
{
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// \throws std::runtime_error if the solver does not converge.
inline Spectrum laplacian_spectrum(const Eigen::MatrixXd& affinity)
{
  const Eigen::VectorXd scale = affinity.rowwise().sum().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd laplacian =
      Eigen::MatrixXd::Identity(affinity.rows(), affinity.cols()) -
      Eigen::MatrixXd(scale.asDiagonal() * affinity * scale.asDiagonal());
  // the dense solver: an iterative one may lose some of the equal eigenvalues of separate parts
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(laplacian);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvectors of the lines of sight did not converge; change the "
                             "number of samples");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// returns the number of eigenvalues before the largest gap, from 2 to `most`, the smaller of equals;
/// 1 if the second eigenvalue is at least one half. That is a bound for the lines of sight that any cut
/// in two must cross, relative to those of either side: a shape that is so hard to cut is one part. Of
/// most other shapes, too, the gap after the first eigenvalue is the largest and says nothing.
inline std::size_t clusters_by_eigengap(const Eigen::VectorXd& values, const std::size_t most)
{
  constexpr double hard_to_cut = 0.5;
  std::size_t best = 1;
  if (values.size() < 2 || values[1] >= hard_to_cut) return best;
  double largest = -1.;
  for (Eigen::Index k = 2; k < values.size() && static_cast<std::size_t>(k) <= most; ++k)
  {
    const double gap = values[k] - values[k - 1];
    if (gap <= largest) continue;
    largest = gap;
    best = static_cast<std::size_t>(k);
  }
  return best;
}

/// A clustering of rows with the sum of squared distances to the means.
struct Row_clusters
{
  std::vector<Index> of_row;
  double spread = std::numeric_limits<double>::infinity();
};

/// measures the spread, after it has filled each empty cluster with the row that is farthest from its
/// mean: exactly `count` clusters remain.
inline void fill_empty_clusters(const Embedding& rows, const std::size_t count,
                                Row_clusters& clusters)
{
  while (true)
  {
    const Embedding means = WCS::internal::cluster_means(rows, clusters.of_row, count);
    std::vector<std::size_t> sizes(count, 0);
    for (const Index c : clusters.of_row) ++sizes[c];
    clusters.spread = 0.;
    std::pair<double, std::size_t> farthest(-1., 0);
    for (std::size_t i = 0; i < clusters.of_row.size(); ++i)
    {
      const Index c = clusters.of_row[i];
      const double d =
          (rows.row(static_cast<Eigen::Index>(i)) - means.row(static_cast<Eigen::Index>(c)))
              .squaredNorm();
      clusters.spread += d;
      if (sizes[c] > 1 && d > farthest.first) farthest = {d, i};
    }
    const auto empty = std::find(sizes.begin(), sizes.end(), std::size_t(0));
    if (empty == sizes.end()) return;
    clusters.of_row[farthest.second] = static_cast<Index>(empty - sizes.begin());
  }
}

/// clusters the sample by the first `count` eigenvectors, each row scaled to unit length: the best of
/// several runs of k-means. `count` is at most the number of rows.
inline std::vector<Index> cluster_spectrum(const Spectrum& spectrum, const std::size_t count,
                                           const unsigned int seed)
{
  constexpr int runs = 10;
  const Eigen::Index k = static_cast<Eigen::Index>(count);
  if (count <= 1) return std::vector<Index>(static_cast<std::size_t>(spectrum.values.size()), 0);
  Embedding rows = spectrum.vectors.leftCols(k).cast<float>();
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    const float l = rows.row(i).norm();
    if (l > 0.f) rows.row(i) /= l;
  }
  std::mt19937 random(seed);
  Row_clusters best;
  for (int run = 0; run < runs; ++run)
  {
    Row_clusters clusters;
    clusters.of_row = WCS::internal::k_means(rows, count, random);
    fill_empty_clusters(rows, count, clusters);
    if (clusters.spread < best.spread) best = std::move(clusters);
  }
  return best.of_row;
}

/// returns the cluster of every point: that of the nearest of its nearest samples that it sees, or of
/// the nearest if it sees none.
inline std::vector<int> spread_clusters(const Line_of_sight_query& sight,
                                        const std::vector<Index>& sample,
                                        const std::vector<Index>& cluster, const double tolerance,
                                        const bool parallel)
{
  constexpr std::size_t candidates = 8;
  const Oriented_points& points = sight.points();
  std::vector<WCS::internal::Vector3> positions;
  for (const Index s : sample) positions.push_back(points.positions[s]);
  const WCS::internal::Kd_tree tree(positions);
  std::vector<int> labels(points.size());
  WCS::internal::parallel_for(
      points.size(), parallel,
      [&](const std::size_t i)
      {
        const Index point = static_cast<Index>(i);
        std::vector<std::pair<float, Index>> near;
        tree.nearest(points.positions[i], (std::min)(candidates, sample.size()),
                     [&](const Index s, float) {
                       near.push_back({sample_distance(points, point, sample[s]), s});
                     });
        std::sort(near.begin(), near.end());
        auto seen =
            std::find_if(near.begin(), near.end(),
                         [&](const std::pair<float, Index>& candidate)
                         { return sight.sees_inside(point, sample[candidate.second], tolerance); });
        if (seen == near.end()) seen = near.begin();
        labels[i] = static_cast<int>(cluster[seen->second]);
      });
  return labels;
}

} // namespace Lines_of_sight

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_CLUSTERING_H
