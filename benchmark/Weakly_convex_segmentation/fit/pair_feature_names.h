// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PAIR_FEATURE_NAMES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PAIR_FEATURE_NAMES_H

#include <vector>

// What `Pair_features` computes, in order; only the fit needs to know.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

inline const std::vector<const char*>& pair_feature_names()
{
  static const std::vector<const char*> list = {"visibility",
                                                "blind_share",
                                                "inside_a",
                                                "inside_b",
                                                "inside_u",
                                                "visibility_drop",
                                                "edge_concave",
                                                "edge_positive",
                                                "edge_signed",
                                                "near_signed",
                                                "near_positive",
                                                "near_over_15",
                                                "near_over_30",
                                                "near_under_20",
                                                "far_signed",
                                                "far_positive",
                                                "far_over_15",
                                                "far_over_30",
                                                "far_under_20",
                                                "far_minus_near",
                                                "wide_signed",
                                                "wide_positive",
                                                "wide_over_15",
                                                "wide_over_30",
                                                "wide_under_20",
                                                "wide_minus_far",
                                                "concave_beyond_a",
                                                "concave_beyond_b",
                                                "emd",
                                                "diameter_step",
                                                "diameter_a",
                                                "diameter_b",
                                                "diameter_spread_a",
                                                "diameter_spread_b",
                                                "diameter_spread_u",
                                                "share_a",
                                                "share_b",
                                                "seam_to_size_a",
                                                "seam_to_size_b",
                                                "seam_to_border_a",
                                                "seam_to_border_b",
                                                "seam_to_diameter",
                                                "middle_a",
                                                "middle_b",
                                                "middle_u",
                                                "short_a",
                                                "short_b",
                                                "short_u",
                                                "normal_mean_a",
                                                "normal_mean_b",
                                                "normal_mean_u",
                                                "normal_least_a",
                                                "normal_least_b",
                                                "normal_least_u",
                                                "center_distance",
                                                "long_growth",
                                                "seam_open",
                                                "seam_flat",
                                                "seam_round",
                                                "seam_extent",
                                                "neck_a",
                                                "neck_b",
                                                "seam_off_a",
                                                "seam_off_b",
                                                "seam_along_a",
                                                "seam_along_b",
                                                "aligned",
                                                "inward_ab",
                                                "inward_ba",
                                                "outward_ab",
                                                "outward_ba",
                                                "wall_ab",
                                                "wall_ba",
                                                "thin_a",
                                                "thin_b",
                                                "inward_aa",
                                                "inward_bb",
                                                "outward_aa",
                                                "outward_bb",
                                                "opposite",
                                                "whole_diameter",
                                                "whole_thin",
                                                "fusion_cost",
                                                "merging_cost",
                                                "hand_made_cost"};
  return list;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PAIR_FEATURE_NAMES_H
