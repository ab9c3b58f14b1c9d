// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H

#include <CGAL/Weakly_convex_segmentation/internal/Vector3.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsShiftSolver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

// Normalized spectral clustering of a small weighted graph (section 4, "Initial patches").

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A weighted edge; each undirected edge is listed once.
struct Weighted_edge
{
  Index first, second;
  double weight;
};

/// The operator (L - sigma I)^-1 of the shift-and-invert mode; positive definite for sigma < 0, so
/// that a Cholesky factorization serves where Spectra's own operator takes a slower LU.
class Shifted_inverse
{
public:
  using Scalar = double;
  explicit Shifted_inverse(const Eigen::SparseMatrix<double>& matrix) : m_matrix(matrix) {}
  Eigen::Index rows() const { return m_matrix.rows(); }
  Eigen::Index cols() const { return m_matrix.cols(); }
  void set_shift(const double sigma)
  {
    Eigen::SparseMatrix<double> identity(rows(), cols());
    identity.setIdentity();
    m_solver.compute(m_matrix - sigma * identity);
    if (m_solver.info() != Eigen::Success)
      throw std::runtime_error("the factorization of the patch graph's Laplacian failed");
  }
  void perform_op(const double* x, double* y) const
  {
    Eigen::Map<const Eigen::VectorXd> in(x, rows());
    Eigen::Map<Eigen::VectorXd> out(y, rows());
    out = m_solver.solve(in);
  }

private:
  const Eigen::SparseMatrix<double>& m_matrix;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
};

/// returns the symmetric normalized Laplacian I - D^-1/2 W D^-1/2.
inline Eigen::SparseMatrix<double> normalized_laplacian(const std::size_t size,
                                                        const std::vector<Weighted_edge>& edges)
{
  std::vector<double> degree(size, 0.);
  for (const Weighted_edge& e : edges)
  {
    degree[e.first] += e.weight;
    degree[e.second] += e.weight;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edges.size() + size);
  for (std::size_t i = 0; i < size; ++i)
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i), 1.);
  for (const Weighted_edge& e : edges)
  {
    const double w = -e.weight / std::sqrt(degree[e.first] * degree[e.second]);
    entries.emplace_back(static_cast<int>(e.first), static_cast<int>(e.second), w);
    entries.emplace_back(static_cast<int>(e.second), static_cast<int>(e.first), w);
  }
  Eigen::SparseMatrix<double> laplacian(static_cast<Eigen::Index>(size),
                                        static_cast<Eigen::Index>(size));
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

using Embedding = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// returns the `dimension` lowest eigenvectors of the Laplacian, a node a row, rows of unit length.
/// \throws std::runtime_error if the solver does not converge.
inline Embedding spectral_embedding(const Eigen::SparseMatrix<double>& laplacian,
                                    const std::size_t dimension)
{
  const Eigen::Index n = laplacian.rows(), k = static_cast<Eigen::Index>(dimension);
  Shifted_inverse operation(laplacian);
  // a larger basis converges where many eigenvalues lie close together
  for (const Eigen::Index basis : {2 * k + 10, 4 * k + 40})
  {
    Spectra::SymEigsShiftSolver<Shifted_inverse> solver(operation, k, (std::min)(n, basis), -1e-3);
    solver.init();
    if (solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-4) < k) continue;
    Embedding rows = solver.eigenvectors().cast<float>();
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const float l = rows.row(i).norm();
      if (l > 0.f) rows.row(i) /= l;
    }
    return rows;
  }
  throw std::runtime_error("the eigenvectors of the patch graph did not converge; change "
                           "Parameters::number_of_supervoxels");
}

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

/// clusters the `size` nodes of a connected graph into at most `count` clusters.
///
/// Complexity: that of `count` eigenvectors of a sparse matrix and of k-means in `count` dimensions.
inline std::vector<Index> spectral_clusters(const std::size_t size,
                                            const std::vector<Weighted_edge>& edges,
                                            const std::size_t count, const unsigned int seed)
{
  if (count <= 1 || size <= 2) return std::vector<Index>(size, 0);
  if (count + 1 >= size)
  {
    std::vector<Index> own(size);
    for (std::size_t i = 0; i < size; ++i) own[i] = static_cast<Index>(i);
    return own;
  }
  std::mt19937 random(seed);
  const Embedding rows = spectral_embedding(normalized_laplacian(size, edges), count);
  return k_means(rows, count, random);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_CLUSTERING_H
