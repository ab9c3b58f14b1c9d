// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_ORACLE_FUNCTIONS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_ORACLE_FUNCTIONS_H

// What a caller can put in the place of the patch clustering and of the merge cost, as functions: the stages that
// call them need not know their types, nor the callers the stages.

#include <CGAL/Weakly_convex_segmentation/Convexity_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

class Region_pair;

namespace internal {

/// Any model of `WeaklyConvexSegmentationPatchClustering`.
using Clusters_of_seed = std::function<std::vector<Index>(unsigned int)>;
using Patch_clustering = std::function<Clusters_of_seed(const Convexity_graph&, std::size_t)>;

template <typename Cost, typename = void>
struct Uses_cut_probability : std::false_type
{};
template <typename Cost>
struct Uses_cut_probability<Cost, std::void_t<decltype(Cost::uses_cut_probability)>>
  : std::bool_constant<Cost::uses_cut_probability>
{};

/// Any model of `WeaklyConvexSegmentationMergeCost`.
struct Merge_cost
{
  std::function<double(const Region_pair&, double)> cost;
  double fusion_threshold = 0., merging_threshold = 0.;
  bool uses_cut_probability = false;

  Merge_cost() = default; ///< none
  template <typename Model>
  explicit Merge_cost(const Model& model)
    : cost(model), fusion_threshold(model.fusion_threshold()),
      merging_threshold(model.merging_threshold()),
      uses_cut_probability(Uses_cut_probability<Model>::value)
  {}
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_ORACLE_FUNCTIONS_H
