// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_EMBEDDING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_EMBEDDING_H

#include <CGAL/Weakly_convex_segmentation/internal/Four.h>
#include <CGAL/Weakly_convex_segmentation/internal/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// The nodes of a graph in the space of the lowest eigenvectors of its normalized Laplacian (section 4,
// "Initial patches"), by a polynomial filter of its spectrum instead of the eigenvectors themselves.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A weighted edge; each undirected edge is listed once.
struct Weighted_edge
{
  Index first, second;
  double weight;
};

/// The matrix D^-1/2 W D^-1/2 of a weighted graph, whose highest eigenvectors are the lowest ones of
/// the normalized Laplacian. Its spectrum lies in [-1, 1].
struct Normalized_graph
{
  struct Edge
  {
    Index node;
    float weight;
  };
  std::vector<std::size_t> first; ///< begin of each node's row in `edges`; size n + 1
  std::vector<Edge> edges;

  Normalized_graph(const std::size_t size, const std::vector<Weighted_edge>& undirected)
    : first(size + 1, 0), edges(2 * undirected.size())
  {
    std::vector<double> degree(size, 0.);
    for (const Weighted_edge& e : undirected)
      for (const Index node : {e.first, e.second})
      {
        degree[node] += e.weight;
        ++first[node + 1];
      }
    for (std::size_t i = 0; i < size; ++i) first[i + 1] += first[i];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (const Weighted_edge& e : undirected)
    {
      const float w = static_cast<float>(e.weight / std::sqrt(degree[e.first] * degree[e.second]));
      edges[next[e.first]++] = {e.second, w};
      edges[next[e.second]++] = {e.first, w};
    }
  }
  std::size_t size() const { return first.size() - 1; }
};

/// A dense matrix whose rows are filled up to a multiple of four numbers.
class Row_matrix
{
public:
  Row_matrix(const std::size_t rows, const std::size_t columns)
    : m_rows(rows), m_groups((columns + 3) / 4), m_values(rows * m_groups, Four(0.f))
  {}
  std::size_t rows() const { return m_rows; }
  std::size_t columns() const { return 4 * m_groups; }
  std::size_t groups() const { return m_groups; } ///< of four numbers in a row
  Four* row(const std::size_t i) { return m_values.data() + i * m_groups; }
  const Four* row(const std::size_t i) const { return m_values.data() + i * m_groups; }
  float& at(const std::size_t i, const std::size_t c)
  {
    return row(i)[c / 4][static_cast<int>(c % 4)];
  }
  float at(const std::size_t i, const std::size_t c) const
  {
    return row(i)[c / 4][static_cast<int>(c % 4)];
  }

private:
  std::size_t m_rows, m_groups;
  std::vector<Four> m_values;
};

/// adds `factor` times `added` to a row of `groups` times four numbers.
inline void add_multiple(Four* row, const std::size_t groups, const float factor, const Four* added)
{
  const Four four(factor);
  for (std::size_t g = 0; g < groups; ++g) row[g] = row[g] + four * added[g];
}

inline void divide(Four* row, const std::size_t groups, const float divisor)
{
  const Four four(divisor);
  for (std::size_t g = 0; g < groups; ++g) row[g] = row[g] / four;
}

/// returns the scalar product of two rows of `groups` times four numbers, `groups` at least 1.
inline float product_of(const Four* a, const Four* b, const std::size_t groups)
{
  Four even = a[0] * b[0];
  if (groups == 1) return sum(even);
  Four odd = a[1] * b[1]; // two sums, as one would wait for each addition
  const std::size_t pairs = groups / 2 * 2;
  for (std::size_t g = 2; g < pairs; g += 2)
  {
    even = even + a[g] * b[g];
    odd = odd + a[g + 1] * b[g + 1];
  }
  even = even + odd;
  return sum(pairs < groups ? even + a[pairs] * b[pairs] : even);
}

/// returns the coefficients of the Chebyshev polynomials of a step from 0 to 1 at cos(`angle`), damped
/// (Jackson) so that the filter is monotone.
inline std::vector<float> step_coefficients(const double angle, const std::size_t degree)
{
  const double pi = std::acos(-1.), n = static_cast<double>(degree) + 2.;
  std::vector<float> coefficients(degree + 1);
  for (std::size_t j = 0; j <= degree; ++j)
  {
    const double x = static_cast<double>(j);
    const double damping =
        ((n - x) * std::cos(pi * x / n) + std::sin(pi * x / n) / std::tan(pi / n)) / n;
    coefficients[j] =
        static_cast<float>(damping * (j == 0 ? angle / pi : 2. * std::sin(x * angle) / (x * pi)));
  }
  return coefficients;
}

/// returns sum of c_j T_j(graph) times `rows`, by the recurrence of Chebyshev's polynomials T_j.
inline Row_matrix filter_rows(const Normalized_graph& graph, const std::vector<float>& coefficients,
                              Row_matrix rows)
{
  const std::size_t groups = rows.groups();
  Row_matrix result(rows.rows(), rows.columns()), before(rows.rows(), rows.columns());
  for (std::size_t i = 0; i < rows.rows(); ++i)
    add_multiple(result.row(i), groups, coefficients[0], rows.row(i));
  for (std::size_t j = 1; j < coefficients.size(); ++j)
  {
    const float factor = j == 1 ? 1.f : 2.f;
    for (std::size_t i = 0; i < rows.rows(); ++i)
    {
      Four* next = before.row(i); // takes the place of what it is computed from
      for (std::size_t g = 0; g < groups; ++g) next[g] = Four(-1.f) * next[g];
      for (std::size_t e = graph.first[i]; e < graph.first[i + 1]; ++e)
        add_multiple(next, groups, factor * graph.edges[e].weight, rows.row(graph.edges[e].node));
      add_multiple(result.row(i), groups, coefficients[j], next);
    }
    std::swap(before, rows);
  }
  return result;
}

/// makes the columns orthonormal, by a Cholesky factorization of their products: each row becomes its
/// coordinates in that basis.
inline void orthonormalize_columns(Row_matrix& rows)
{
  const std::size_t n = rows.columns(), groups = rows.groups();
  Row_matrix factor(n, n); // products of columns, then their lower triangular factor, by column
  for (std::size_t i = 0; i < rows.rows(); ++i)
    for (std::size_t a = 0; a < n; ++a)
    {
      const float x = rows.at(i, a);
      if (x != 0.f) add_multiple(factor.row(a), groups, x, rows.row(i));
    }
  float trace = 0.f;
  for (std::size_t a = 0; a < n; ++a) trace += factor.at(a, a);
  const float least = 1e-6f * trace / static_cast<float>(n);
  for (std::size_t a = 0; a < n; ++a)
  {
    const float pivot = factor.at(a, a);
    // a column that depends on those before would only bring rounding: it vanishes
    const Four scale(pivot > least ? 1.f / std::sqrt(pivot) : 0.f);
    for (std::size_t g = 0; g < groups; ++g) factor.row(a)[g] = factor.row(a)[g] * scale;
    for (std::size_t b = a + 1; b < n; ++b)
      add_multiple(factor.row(b), groups, -factor.at(a, b), factor.row(a));
  }
  for (std::size_t i = 0; i < rows.rows(); ++i)
    for (std::size_t a = 0; a < n; ++a)
    {
      const float pivot = factor.at(a, a);
      const float x = rows.at(i, a) = pivot > 0.f ? rows.at(i, a) / pivot : 0.f;
      const std::size_t next = a / 4 + 1; // what is left of the own group goes one by one
      for (std::size_t c = a + 1; c < 4 * next; ++c) rows.at(i, c) -= x * factor.at(a, c);
      add_multiple(rows.row(i) + next, groups - next, -x, factor.row(a) + next);
    }
}

/// returns the nodes' coordinates, of unit length, in a space of `count` dimensions near that of the
/// lowest eigenvectors: what is left of the indicators of `cells` when high frequencies are taken away,
/// by a step that is about 3.6 / `degree` of the spectrum wide.
inline Row_matrix spectral_embedding(const Normalized_graph& graph, const std::vector<Index>& cells,
                                     const std::size_t count, const std::size_t degree)
{
  Row_matrix rows(graph.size(), count);
  for (std::size_t i = 0; i < graph.size(); ++i) rows.at(i, cells[i]) = 1.f;
  // of an even mesh of triangles the k lowest of n eigenvalues are up to about 3.6 k / n; the step is
  // wide, and what passes beyond it must not outweigh them
  const double share = static_cast<double>(count) / static_cast<double>(graph.size());
  const double angle = std::acos(1. - (std::min)(1.5, 2.5 * share));
  rows = filter_rows(graph, step_coefficients(angle, degree), std::move(rows));
  orthonormalize_columns(rows);
  for (std::size_t i = 0; i < graph.size(); ++i)
  {
    const float l = std::sqrt(product_of(rows.row(i), rows.row(i), rows.groups()));
    if (l > 0.f) divide(rows.row(i), rows.groups(), l);
  }
  return rows;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SPECTRAL_EMBEDDING_H
