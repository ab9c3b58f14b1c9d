// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

// List of the named parameters of this package, in the form of CGAL's own list: tag, (unused), name.
// It is included more than once, with a meaning of the macro each time, see named_parameters.h: no guard.

// clang-format off
CGAL_add_named_parameter(segmentation_parameters_t, segmentation_parameters, segmentation_parameters)
CGAL_add_named_parameter(maximum_number_of_segments_t, maximum_number_of_segments, maximum_number_of_segments)
CGAL_add_named_parameter(minimum_number_of_segments_t, minimum_number_of_segments, minimum_number_of_segments)
CGAL_add_named_parameter(minimum_segment_share_t, minimum_segment_share, minimum_segment_share)
CGAL_add_named_parameter(level_t, level, level)
CGAL_add_named_parameter(line_of_sight_t, line_of_sight, line_of_sight)
CGAL_add_named_parameter(patch_clustering_t, patch_clustering, patch_clustering)
CGAL_add_named_parameter(merge_cost_t, merge_cost, merge_cost)
CGAL_add_named_parameter(diameter_map_t, diameter_map, diameter_map)
