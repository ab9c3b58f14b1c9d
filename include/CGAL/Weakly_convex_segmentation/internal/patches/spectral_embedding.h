// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SPECTRAL_EMBEDDING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SPECTRAL_EMBEDDING_H

// The nodes of a graph in the space of the lowest eigenvectors of its normalized Laplacian (section 4,
// "Initial patches"), by Spectra.

#include <CGAL/Weakly_convex_segmentation/Convexity_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsShiftSolver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

using Graph_matrix = Eigen::SparseMatrix<float>;
/// coordinates of the nodes, a row each
using Embedding = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// returns the matrix D^-1/2 W D^-1/2 of a graph whose nodes have edges. Its highest eigenvectors are the
/// lowest ones of the normalized Laplacian; its spectrum lies in [-1, 1].
inline Graph_matrix normalized_adjacency(const Convexity_graph& graph)
{
  std::vector<double> degree(graph.number_of_nodes, 0.);
  for (const Convexity_graph::Edge& e : graph.edges)
    for (const Index node : {e.first, e.second}) degree[node] += e.weight;
  std::vector<Eigen::Triplet<float>> entries;
  entries.reserve(2 * graph.edges.size());
  for (const Convexity_graph::Edge& e : graph.edges)
  {
    const int i = static_cast<int>(e.first), j = static_cast<int>(e.second);
    const float w = static_cast<float>(e.weight / std::sqrt(degree[e.first] * degree[e.second]));
    entries.emplace_back(i, j, w);
    entries.emplace_back(j, i, w);
  }
  const Eigen::Index n = static_cast<Eigen::Index>(graph.number_of_nodes);
  Graph_matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Eigenvectors of a symmetric matrix, in columns.
struct Eigenvectors
{
  Eigen::VectorXf values;
  Eigen::MatrixXf vectors;
};

/// returns all eigenvectors of a symmetric matrix, their eigenvalues ascending, as
/// `Eigen::SelfAdjointEigenSolver` does in one step, which takes a compiler four times as long.
inline Eigenvectors dense_eigenvectors(const Eigen::MatrixXf& matrix)
{
  const Eigen::Tridiagonalization<Eigen::MatrixXf> reduced(matrix);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver;
  solver.computeFromTridiagonal(reduced.diagonal(), reduced.subDiagonal());
  Eigen::MatrixXf vectors = solver.eigenvectors();
  Eigen::VectorXf workspace(vectors.cols());
  for (Eigen::Index k = vectors.rows() - 2; k >= 0; --k)
  {
    const Eigen::Index below = vectors.rows() - k - 1;
    vectors.bottomRows(below).applyHouseholderOnTheLeft(
        reduced.packedMatrix().col(k).tail(below - 1), reduced.householderCoefficients()[k],
        workspace.data());
  }
  return {solver.eigenvalues(), std::move(vectors)};
}

/// The product with the inverse of `A - sigma I`, for Spectra: `sigma` lies above the spectrum of A, so the negative is
/// positive definite.
class Inverse_product
{
public:
  using Scalar = float;

  explicit Inverse_product(const Graph_matrix& matrix) : m_matrix(matrix) {}

  Eigen::Index rows() const { return m_matrix.rows(); }
  Eigen::Index cols() const { return m_matrix.cols(); }
  void set_shift(const float sigma)
  {
    Graph_matrix identity(rows(), cols());
    identity.setIdentity();
    m_solver.compute(sigma * identity - m_matrix);
  }
  void perform_op(const float* const in, float* const out) const
  {
    using Vector = Eigen::VectorXf;
    Eigen::Map<Vector>(out, rows()) = -m_solver.solve(Eigen::Map<const Vector>(in, cols()));
  }

private:
  const Graph_matrix& m_matrix;
  Eigen::SimplicialLLT<Graph_matrix> m_solver;
};

/// returns the eigenvectors of the `count` highest eigenvalues by Lanczos iteration in a space of
/// `lanczos_vectors` dimensions: those of them that converge.
///
/// The inverse spreads eigenvalues that lie close below 1, so about 80 products find 36 vectors of a shape's graph,
/// without it 350: 10 ms, not 37 (1,500 nodes).
inline Eigenvectors lanczos_eigenvectors(const Graph_matrix& matrix, const Eigen::Index count,
                                         const Eigen::Index lanczos_vectors)
{
  constexpr float shift = 1.005f;               // above the spectrum; 1.02 has the same scores
  constexpr float tolerance = 1e-3f;            // k-means needs no better
  constexpr Eigen::Index maximum_restarts = 20; // surfaces need about 4
  Inverse_product inverse(matrix);
  Spectra::SymEigsShiftSolver<Inverse_product> solver(inverse, count, lanczos_vectors, shift);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, maximum_restarts, tolerance);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// returns the eigenvectors of the `count` highest eigenvalues, or fewer where they do not converge. Small matrices are
/// solved densely.
inline Eigenvectors highest_eigenvectors(const Graph_matrix& matrix, const Eigen::Index count)
{
  const Eigen::Index lanczos_vectors = count + count / 2 + 10;
  if (matrix.rows() > lanczos_vectors) return lanczos_eigenvectors(matrix, count, lanczos_vectors);
  const Eigenvectors all = dense_eigenvectors(Eigen::MatrixXf(matrix));
  return {all.values.tail(count), all.vectors.rightCols(count)};
}

/// returns the nodes' coordinates, scaled to unit length, in the space of the `dimensions` highest
/// eigenvectors of a normalized adjacency.
///
/// An eigenvector counts the more, the lower its eigenvalue of the Laplacian, 1 - that of the adjacency, as
/// in the embedding by commute times, so that the space has no hard end: that has 1 - RI .0988, all alike
/// .0996 (default, mean of five seeds). Complexity: O(n^1.5) to factor the matrix of a surface's graph, and
/// O(n * dimensions^2) for each of about 4 restarts, 20 at most.
inline Embedding spectral_embedding(const Graph_matrix& matrix, const std::size_t dimensions)
{
  constexpr float floor = 0.2f; // of the lowest, relative to the highest
  const Eigen::Index wanted = (std::min)(static_cast<Eigen::Index>(dimensions), matrix.rows());
  Eigenvectors found = highest_eigenvectors(matrix, wanted);
  const Eigen::ArrayXf frequencies = (1.f - found.values.array()).max(0.f);
  if (frequencies.size() > 0 && frequencies.maxCoeff() > 0.f)
    found.vectors *= (frequencies + floor * frequencies.maxCoeff()).rsqrt().matrix().asDiagonal();
  Embedding rows = found.vectors;
  rows.rowwise().normalize(); // rows of zeros stay
  return rows;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PATCHES_SPECTRAL_EMBEDDING_H
