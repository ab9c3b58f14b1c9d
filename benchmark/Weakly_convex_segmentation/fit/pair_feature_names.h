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

/// A feature's name and whether the willingness to merge may only rise (1) or fall (-1) with it.
struct Feature_name
{
  const char* name;
  int monotone;
};

inline const std::vector<Feature_name>& pair_feature_names()
{
  static const std::vector<Feature_name> list = {{"visibility", 1},
                                                 {"blind_share", -1},
                                                 {"inside_a", 0},
                                                 {"inside_b", 0},
                                                 {"inside_u", 1},
                                                 {"visibility_drop", 1},
                                                 {"edge_concave", -1},
                                                 {"edge_positive", -1},
                                                 {"edge_signed", -1},
                                                 {"near_signed", -1},
                                                 {"near_positive", -1},
                                                 {"near_over_15", -1},
                                                 {"near_over_30", -1},
                                                 {"near_under_20", 0},
                                                 {"far_signed", -1},
                                                 {"far_positive", -1},
                                                 {"far_over_15", -1},
                                                 {"far_over_30", -1},
                                                 {"far_under_20", 0},
                                                 {"far_minus_near", 0},
                                                 {"wide_signed", -1},
                                                 {"wide_positive", -1},
                                                 {"wide_over_15", -1},
                                                 {"wide_over_30", -1},
                                                 {"wide_under_20", 0},
                                                 {"wide_minus_far", 0},
                                                 {"concave_beyond_a", 0},
                                                 {"concave_beyond_b", 0},
                                                 {"emd", -1},
                                                 {"diameter_step", -1},
                                                 {"diameter_a", 0},
                                                 {"diameter_b", 0},
                                                 {"diameter_spread_a", 0},
                                                 {"diameter_spread_b", 0},
                                                 {"diameter_spread_u", 0},
                                                 {"share_a", -1},
                                                 {"share_b", 0},
                                                 {"seam_to_size_a", 1},
                                                 {"seam_to_size_b", 1},
                                                 {"seam_to_border_a", 1},
                                                 {"seam_to_border_b", 1},
                                                 {"seam_to_diameter", 0},
                                                 {"middle_a", 0},
                                                 {"middle_b", 0},
                                                 {"middle_u", 0},
                                                 {"short_a", 0},
                                                 {"short_b", 0},
                                                 {"short_u", 0},
                                                 {"normal_mean_a", 0},
                                                 {"normal_mean_b", 0},
                                                 {"normal_mean_u", 0},
                                                 {"normal_least_a", 0},
                                                 {"normal_least_b", 0},
                                                 {"normal_least_u", 0},
                                                 {"center_distance", 0},
                                                 {"long_growth", 0},
                                                 {"seam_open", 0},
                                                 {"seam_flat", 0},
                                                 {"seam_round", 0},
                                                 {"seam_extent", 0},
                                                 {"neck_a", 1},
                                                 {"neck_b", 1},
                                                 {"seam_off_a", 0},
                                                 {"seam_off_b", 0},
                                                 {"seam_along_a", 0},
                                                 {"seam_along_b", 0},
                                                 {"aligned", 0},
                                                 {"inward_ab", 1},
                                                 {"inward_ba", 1},
                                                 {"outward_ab", 0},
                                                 {"outward_ba", 0},
                                                 {"wall_ab", 1},
                                                 {"wall_ba", 1},
                                                 {"thin_a", 0},
                                                 {"thin_b", 0},
                                                 {"inward_aa", 0},
                                                 {"inward_bb", 0},
                                                 {"outward_aa", 0},
                                                 {"outward_bb", 0},
                                                 {"opposite", 0},
                                                 {"whole_diameter", 0},
                                                 {"whole_thin", 0},
                                                 {"fusion_cost", -1},
                                                 {"merging_cost", -1},
                                                 {"hand_made_cost", -1}};
  return list;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PAIR_FEATURE_NAMES_H
