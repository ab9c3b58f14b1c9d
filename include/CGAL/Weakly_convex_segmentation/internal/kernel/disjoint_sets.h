// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_DISJOINT_SETS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_DISJOINT_SETS_H

// Sets that are joined, each named by one of its members. In `boost::disjoint_sets` the sizes of the sets
// choose that member; here the caller does, as merged regions are known by their names.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Disjoint sets of the numbers from 0 on.
template <typename Number>
class Disjoint_sets
{
  std::vector<Number> m_parent;

public:
  explicit Disjoint_sets(const std::size_t n) : m_parent(n)
  {
    std::iota(m_parent.begin(), m_parent.end(), Number(0));
  }

  /// returns the name of the set of `i`, and shortens the way to it.
  Number find(Number i)
  {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  /// the same on any thread: the way stays as long as it is
  Number name_of(Number i) const
  {
    while (m_parent[i] != i) i = m_parent[i];
    return i;
  }

  /// joins the set named `second` to that named `first`, whose name stays.
  void join_named(const Number first, const Number second) { m_parent[second] = first; }
  /// joins the sets of two members; the name of that of `i` stays.
  void join(const Number i, const Number j) { join_named(find(i), find(j)); }
};

/// Disjoint sets of points, and for each point whether its normal is to be turned relative to that of
/// the first of its set.
class Parity_disjoint_sets
{
  std::vector<Index> m_parent;
  std::vector<unsigned char> m_is_turned; ///< relative to the parent

public:
  struct Place
  {
    Index set;
    unsigned char is_turned;
  };

  explicit Parity_disjoint_sets(const std::size_t n) : m_parent(n), m_is_turned(n, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), Index(0));
  }

  Place find(Index i)
  {
    unsigned char is_turned = 0;
    while (m_parent[i] != i)
    {
      const Index up = m_parent[i];
      m_is_turned[i] ^= m_is_turned[up]; // of the first of a set it is 0
      m_parent[i] = m_parent[up];
      is_turned ^= m_is_turned[i];
      i = m_parent[i];
    }
    return {i, is_turned};
  }

  /// makes one set of two if `i` and `j` are in different ones.
  void join(const Index i, const Index j, const bool turn)
  {
    const Place a = find(i), b = find(j);
    if (a.set == b.set) return;
    // the smaller index comes first: then the outcome is the same however the sets grew
    const Index first = (std::min)(a.set, b.set), second = (std::max)(a.set, b.set);
    m_parent[second] = first;
    m_is_turned[second] = a.is_turned ^ b.is_turned ^ static_cast<unsigned char>(turn);
  }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_DISJOINT_SETS_H
