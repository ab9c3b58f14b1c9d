// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_MERGE_COST_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_MERGE_COST_H

// The costs by which patches are fused into components and these merged into segments (sections 4 and 5):
// models of `WeaklyConvexSegmentationMergeCost`.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Region_pair.h>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The cost of the preset `Parameters::training_free()`: a weighted sum of visibility, seam concavity, volume and
/// closure, see `Merging_cost`.
///
/// \cgalModels `WeaklyConvexSegmentationMergeCost`
class Weighted_merge_cost
{
  Merging_cost m_weights;
  double m_fusion_threshold, m_merging_threshold;

public:
  /// takes the weights and thresholds of `parameters`.
  explicit Weighted_merge_cost(const Merging_parameters& parameters = Parameters::training_free())
    : m_weights(parameters.merging_cost), m_fusion_threshold(parameters.fusion_threshold),
      m_merging_threshold(parameters.merging_threshold)
  {}
  double operator()(const Region_pair& pair, const double limit) const
  {
    return pair.weighted_cost(m_weights, limit);
  }
  double fusion_threshold() const { return m_fusion_threshold; }
  double merging_threshold() const { return m_merging_threshold; }
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The probability that people cut between two regions, by the trees of the default preset.
///
/// \cgalModels `WeaklyConvexSegmentationMergeCost`
class Learned_merge_cost
{
  double m_fusion_threshold, m_merging_threshold;

public:
  static constexpr bool uses_cut_probability = true;

  /// takes the thresholds of `parameters`.
  explicit Learned_merge_cost(const Merging_parameters& parameters = {})
    : m_fusion_threshold(parameters.fusion_threshold),
      m_merging_threshold(parameters.merging_threshold)
  {}
  double operator()(const Region_pair& pair, double /* limit */) const
  {
    return pair.cut_probability();
  }
  double fusion_threshold() const { return m_fusion_threshold; }
  double merging_threshold() const { return m_merging_threshold; }
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_MERGE_COST_H
