// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgWeaklyConvexSegmentationConcepts
\cgalConcept

What the named parameter `merge_cost` of `CGAL::weakly_convex_segmentation()` and of
`CGAL::Weakly_convex_segmentation::Segmenter::segment()` asks for: the cost of merging two adjacent regions. It
takes the place of `CGAL::Weakly_convex_segmentation::Parameters::merging`.

The patches are contracted greedily: the pair of the lowest cost is merged, and the costs of its neighbors are
asked for anew. Up to the fusion threshold patches become weakly convex components; from there up to the merging
threshold components become segments. Then the merge tree is completed in the order of the costs.

Regions that remain smaller than `CGAL::Weakly_convex_segmentation::Parameters::minimum_segment_share` are given
to a neighbor by a fixed sum of visibility, seam and diameters, whatever the model says.

A model is copy constructible: each set of patches has a copy of its own. One copy is called by one thread at a
time, but with `CGAL::Parallel_tag` several copies are called at once. Exceptions end the run and pass through to
the caller.

A model may have a member `static constexpr bool uses_cut_probability = true`. Only then may it ask for
`CGAL::Weakly_convex_segmentation::Region_pair::cut_probability()`, for which more is measured on the shape.

\cgalHasModel `CGAL::Weakly_convex_segmentation::Weighted_merge_cost`
\cgalHasModel `CGAL::Weakly_convex_segmentation::Learned_merge_cost`

\sa `CGAL::Weakly_convex_segmentation::Region_pair`
*/
class WeaklyConvexSegmentationMergeCost
{
public:
  /// returns the cost of merging two adjacent regions, without a unit. It may be negative.
  ///
  /// A cost above `limit` is as good as infinity: the regions are not merged. So a model may stop when it knows
  /// that the cost is above, before it asks for what is expensive, such as
  /// `CGAL::Weakly_convex_segmentation::Region_pair::visibility()`.
  ///
  /// \param pair is valid during the call only
  /// \param limit the fusion threshold, the merging threshold, or infinity for merges beyond both, of which only
  ///   the order is left to decide. Then the visibility of all pairs is 0.
  ///
  /// \post The cost depends on nothing but the pair and `limit`, not on earlier calls.
  /// \post If `limit` is infinity, the cost should be finite: pairs of infinite cost are merged after all others,
  ///   the smallest region with the nearest one, adjacent or not. A cost that is not a number counts as infinity.
  ///
  /// Complexity: O(1) besides what the pair computes. It is called for each pair of adjacent patches, and
  /// for each neighbor of a region that was merged, in each set of patches.
  double operator()(const CGAL::Weakly_convex_segmentation::Region_pair& pair, double limit) const;

  /// returns the highest cost at which patches are fused into a component. It is asked for once.
  double fusion_threshold() const;

  /// returns the highest cost at which components are merged into a segment. It is asked for once.
  ///
  /// \post It is at least `fusion_threshold()`.
  double merging_threshold() const;
};
