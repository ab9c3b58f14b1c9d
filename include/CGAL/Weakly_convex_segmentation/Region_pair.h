// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_REGION_PAIR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_REGION_PAIR_H

// What a merge cost can ask about two adjacent regions.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Learned_cost.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_cost.h>

#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Two adjacent regions, each a union of patches, and the seam between them, as a model of
/// `WeaklyConvexSegmentationMergeCost` is asked for the cost of merging them.
///
/// It is valid during that call. Everything is computed when it is asked for; lines of sight that were cast
/// once are kept. All lengths are relative to the extent of the shape.
class Region_pair
{
public:
  /// share of the points of the shape in the smaller region, in `[0, 1]`
  double size_of_smaller() const { return m_measures.share(m_smaller); }
  /// share of the points of the shape in the larger region, in `[0, 1]`
  double size_of_larger() const { return m_measures.share(m_larger); }
  /// share of the lines of sight between the regions that are free, in `[0, 1]` (section 4). It is the
  /// most expensive measure: ask for it last. Where the limit is infinity, only the order of the merge tree
  /// is left to decide: no more lines are cast, and it is 0.
  double visibility() const { return m_is_blind ? 0. : m_measures.visibility(m_smaller, m_larger); }
  /// share of the seam that is concave, in `[0, 1]` (section 5)
  double concave_share() const { return m_measures.concave_share(m_smaller, m_larger); }
  /// earth mover's distance of the histograms of the logarithms of the shape diameter (section 5), at least
  /// 0; 0.35 where one of the regions has no diameter
  double diameter_distance() const { return m_measures.diameter_distance(m_smaller, m_larger); }
  /// geometric mean of the shape diameter in the smaller region, relative to the extent; 0: none
  double diameter_of_smaller() const { return m_measures.diameter(m_smaller); }
  /// geometric mean of the shape diameter in the larger region, relative to the extent; 0: none
  double diameter_of_larger() const { return m_measures.diameter(m_larger); }
  /// standard deviation of the logarithm of the shape diameter in the smaller region
  double diameter_spread_of_smaller() const { return m_measures.diameter_spread(m_smaller); }
  /// share of the points of the smaller region whose line inwards ends at the region itself, in `[0, 1]`:
  /// high for complete parts
  double closure_of_smaller() const { return m_measures.closure(m_smaller); }
  /// the same of the larger region
  double closure_of_larger() const { return m_measures.closure(m_larger); }
  /// longest axis of the seam relative to that of both regions together, about in `[0, 1]`
  double seam_extent() const { return m_measures.seam_extent(m_smaller, m_larger); }
  /// how much the two are pieces of one tube that goes on straight, in `[0, 1]`
  double continuation() const { return m_measures.continuation(m_smaller, m_larger); }

  /// the weighted sum of `Merging_cost`, or infinity once it is known to be over `limit`: then
  /// lines of sight are not cast
  double weighted_cost(const Merging_cost& weights, const double limit) const
  {
    return m_is_blind ? m_measures.blind(m_smaller, m_larger, weights)
                      : m_measures(m_smaller, m_larger, weights, limit);
  }
  /// the probability that people cut between the regions, in `[0, 1]`, as learned from their
  /// segmentations of shapes of 19 kinds. A run that uses it measures more of the seams, and takes about 1.6
  /// times as long.
  /// \throws std::logic_error if the cost does not say that it uses it, see
  ///   `WeaklyConvexSegmentationMergeCost`
  double cut_probability() const
  {
    if (m_learned == nullptr)
      throw std::logic_error("a merge cost that asks for Region_pair::cut_probability() needs a "
                             "member 'static constexpr bool uses_cut_probability = true'");
    return (*m_learned)(m_smaller, m_larger);
  }

#ifndef DOXYGEN_RUNNING
  Region_pair(const internal::Region_cost& measures, const internal::Learned_cost* learned,
              const int a, const int b, const bool is_blind)
    : m_measures(measures), m_learned(learned), m_smaller(a), m_larger(b), m_is_blind(is_blind)
  {
    if (m_measures.share(a) > m_measures.share(b)) std::swap(m_smaller, m_larger);
  }
#endif

private:
  const internal::Region_cost& m_measures;
  const internal::Learned_cost* m_learned;
  int m_smaller, m_larger;
  bool m_is_blind;
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_REGION_PAIR_H
