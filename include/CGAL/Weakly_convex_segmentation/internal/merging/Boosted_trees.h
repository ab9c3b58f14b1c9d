// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_BOOSTED_TREES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_BOOSTED_TREES_H

// A sum of small decision trees, as the fitted merge cost has them.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A node of a tree in an array: the children of an inner node are `child` and `child + 1`.
struct Tree_node
{
  float value;               ///< threshold of an inner node, summand of a leaf
  std::int16_t feature = -1; ///< -1 for a leaf
  std::int16_t child =
      0; ///< offset from this node to the first child, which holds what is below the
         ///< value; negative if features that are missing go to the second child
};

/// Nodes of all trees; a tree begins behind the last leaf of the one before.
struct Boosted_trees
{
  const Tree_node* nodes;
  const std::uint16_t* roots; ///< offset of each root in `nodes`
  std::size_t number_of_trees;
  double bias;

  /// returns the sum of the leaves that the features lead to.
  double operator()(const std::vector<float>& features) const
  {
    double sum = bias;
    for (std::size_t t = 0; t < number_of_trees; ++t)
    {
      const Tree_node* node = nodes + roots[t];
      while (node->feature >= 0)
      {
        const float x = features[static_cast<std::size_t>(node->feature)];
        const int child = node->child < 0 ? -node->child : node->child;
        const bool second = std::isnan(x) ? node->child < 0 : !(x < node->value);
        node += child + (second ? 1 : 0);
      }
      sum += node->value;
    }
    return sum;
  }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_BOOSTED_TREES_H
