// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_LEARNED_COST_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_LEARNED_COST_H

// The default criterion for fusion and merging: the probability that a person would have two
// points across a seam in one part, as boosted trees over the features of the pair.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Boosted_trees.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Pair_features.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_graph.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The cost of a pair: one minus the probability that people put it in one part.
class Learned_cost
{
public:
  Learned_cost(Pair_features& features, const Boosted_trees& trees)
    : m_features(features), m_trees(trees)
  {}
  double operator()(const int a, const int b) const
  {
    m_features.compute(a, b, m_values);
    return 1. / (1. + std::exp(m_trees(m_values)));
  }

private:
  Pair_features& m_features;
  const Boosted_trees& m_trees;
  mutable std::vector<float> m_values; // kept between calls, against an allocation each
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_LEARNED_COST_H
