// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_KD_TREE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_KD_TREE_H

// Nearest neighbors by a k-d tree of our own: single precision, points in leaves of two times four, so
// that four distances are computed at once. CGAL's k-d tree takes longer for the same neighbors.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Float4.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/float_bits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A k-d tree. Queries are thread safe.
class Kd_tree
{
  struct Block
  {
    std::array<Float4, 3> position; ///< what only fills up lies far away
    std::array<Index, 4> index;
  };
  struct Node
  {
    float low_end, high_begin; ///< of the children's points along the axis
    std::uint32_t high_child;  ///< the other one follows the node; of a leaf, its first block
    std::uint32_t axis;        ///< 3 for a leaf
  };
  struct Pending
  {
    std::array<float, 3> gap; ///< from the query to the child's cell, by axis
    float distance;           ///< squared
    std::uint32_t node;

    void set_gap(const std::uint32_t axis, const float value)
    {
      gap[axis] = value;
      // summed as the distances of points are: rounding makes it no larger than theirs
      distance = gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2];
    }
  };
  static constexpr std::size_t leaf_size = 8;
  static constexpr float far_away = 1e18f;    ///< coordinate of what only fills up a block
  static constexpr float far_squared = 1e35f; ///< beyond all points, not beyond what fills up
  struct Entry
  {
    Vector3 position;
    Index index;
  };
  using Entries = std::vector<Entry>::iterator;

public:
  static constexpr std::size_t maximum_k = 128; ///< most neighbors that can be asked for

  explicit Kd_tree(const std::vector<Vector3>& positions) : m_size(positions.size())
  {
    std::vector<Entry> entries(m_size);
    for (std::size_t i = 0; i < m_size; ++i) entries[i] = {positions[i], static_cast<Index>(i)};
    m_nodes.reserve(m_size / 2 + 1);
    m_blocks.reserve(m_size / 3 + 2);
    if (m_size > 0) build(entries.begin(), entries.end());
  }

  /// calls `found(index, squared_distance)` for the `k` points nearest to `query`, nearest first, with their
  /// leading bits; for fewer if there are no more. `k`: at most `maximum_k`
  template <typename Found>
  void nearest(const Vector3& query, const std::size_t k, const Found& found) const
  {
    std::array<std::uint64_t, maximum_k + 1> best;
    std::size_t count = 0;
    search(query, (std::min)({k, m_size, maximum_k}), best, count);
    for (std::size_t i = 0; i < count; ++i) found(index_of(best[i]), distance_of(best[i]));
  }

private:
  /// Squared distance and point as one number, in the same order. Points that are
  /// equally near but for rounding come in the order of a hash: that of their indices would favor a direction,
  /// and bend borders on regular grids.
  static std::uint64_t entry(const float distance, const Index index)
  {
    return static_cast<std::uint64_t>(leading_bits(distance)) << 32 | index * 2654435761u;
  }
  static Index index_of(const std::uint64_t entry)
  {
    return static_cast<std::uint32_t>(entry) * 244002641u; // the inverse modulo 2^32
  }
  static float distance_of(const std::uint64_t entry)
  {
    return float_of_bits(static_cast<std::uint32_t>(entry >> 32));
  }
  /// no distance that counts as equal to that of the entry is larger
  static float bound_of(const std::uint64_t entry)
  {
    return float_of_bits(largest_bits(static_cast<std::uint32_t>(entry >> 32)));
  }

  void build(Entries first, Entries last);

  void add_leaf(const Entries first, const Entries last)
  {
    m_nodes.push_back({0.f, 0.f, static_cast<std::uint32_t>(m_blocks.size()), 3});
    for (std::size_t b = 0; b < leaf_size / 4; ++b)
    {
      Block block;
      block.index.fill(0);
      for (Float4& c : block.position) c = Float4(far_away);
      for (int k = 0; k < 4; ++k)
      {
        const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(4 * b) + k;
        if (i >= last - first) continue;
        for (int c = 0; c < 3; ++c) block.position[c][k] = first[i].position[c];
        block.index[k] = first[i].index;
      }
      m_blocks.push_back(block);
    }
  }

  void search(const Vector3& query, const std::size_t k,
              std::array<std::uint64_t, maximum_k + 1>& best, std::size_t& count) const
  {
    float bound = far_squared;
    std::array<Pending, 64> stack; // the tree is balanced: one a level waits
    std::size_t waiting = 0;
    if (k > 0) stack[waiting++] = {{0.f, 0.f, 0.f}, 0.f, 0};
    while (waiting > 0)
    {
      Pending at = stack[--waiting];
      if (at.distance > bound) continue;
      const Node* node = &m_nodes[at.node];
      for (; node->axis < 3; node = &m_nodes[at.node])
      {
        const float q = query[static_cast<int>(node->axis)];
        const float below = q - node->low_end, above = node->high_begin - q;
        const bool is_low = below < above; // the nearer child first
        const float old = at.gap[node->axis];
        Pending other = at;
        other.node = is_low ? node->high_child : at.node + 1;
        other.set_gap(node->axis, (std::max)(old, is_low ? above : below));
        if (other.distance <= bound) stack[waiting++] = other;
        at.node = is_low ? at.node + 1 : node->high_child;
        at.set_gap(node->axis, (std::max)(old, is_low ? below : above));
      }
      for (std::size_t b = 0; b < leaf_size / 4; ++b)
        bound = take_block(query, m_blocks[node->high_child + b], k, best, count, bound);
    }
  }

  /// puts the points of a block among the best; returns the new bound.
  float take_block(const Vector3& query, const Block& block, const std::size_t k,
                   std::array<std::uint64_t, maximum_k + 1>& best, std::size_t& count,
                   float bound) const
  {
    Float4 distances(0.f);
    for (int c = 0; c < 3; ++c)
    {
      const Float4 along = block.position[c] - Float4(query[c]);
      distances = distances + along * along;
    }
    for (int i = 0; i < 4; ++i)
    {
      if (distances[i] > bound) continue;
      const std::uint64_t e = entry(distances[i], block.index[i]);
      if (count == k && e > best[k - 1]) continue;
      std::size_t place = count < k ? count++ : k - 1;
      for (; place > 0 && best[place - 1] > e; --place) best[place] = best[place - 1];
      best[place] = e;
      if (count == k) bound = bound_of(best[k - 1]);
    }
    return bound;
  }

  std::size_t m_size;
  std::vector<Node> m_nodes;
  std::vector<Block> m_blocks;
};

/// halves the points along the longest axis of their box, with full leaves.
inline void Kd_tree::build(const Entries first, const Entries last)
{
  if (last - first <= static_cast<std::ptrdiff_t>(leaf_size)) return add_leaf(first, last);
  Vector3 low = first->position, high = low;
  for (Entries e = first; e != last; ++e)
  {
    const Vector3& p = e->position;
    low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
    high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
  }
  const Vector3 size = high - low;
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const std::ptrdiff_t leaf = static_cast<std::ptrdiff_t>(leaf_size);
  const Entries middle = first + ((last - first) / 2 + leaf - 1) / leaf * leaf;
  std::nth_element(first, middle, last,
                   [axis](const Entry& a, const Entry& b)
                   { return a.position[axis] < b.position[axis]; });
  float low_end = first->position[axis];
  for (Entries e = first; e != middle; ++e) low_end = (std::max)(low_end, e->position[axis]);
  const float high_begin = middle->position[axis];
  const std::size_t own = m_nodes.size();
  m_nodes.emplace_back();
  build(first, middle);
  m_nodes[own] = {low_end, high_begin, static_cast<std::uint32_t>(m_nodes.size()),
                  static_cast<std::uint32_t>(axis)};
  build(middle, last);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_KD_TREE_H
