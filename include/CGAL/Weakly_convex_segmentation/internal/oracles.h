// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ORACLES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ORACLES_H

// The parts of the analysis of a shape that a caller can put in the place of ours.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/oracle_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Line_of_sight_functions.h>
#include <CGAL/Weakly_convex_segmentation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What the caller gives; empty where it is ours.
struct Oracles
{
  Line_of_sight_functions line_of_sight;
  Patch_clustering patch_clustering;
};

/// reads what the caller has in the place of our parts.
template <typename NamedParameters>
Oracles read_oracles([[maybe_unused]] const NamedParameters& np)
{
  namespace params = CGAL::parameters;
  Oracles oracles;
  if constexpr (is_given<NamedParameters, names::line_of_sight_t>)
    oracles.line_of_sight =
        Line_of_sight_functions(params::get_parameter(np, names::line_of_sight_t()));
  if constexpr (is_given<NamedParameters, names::patch_clustering_t>)
    oracles.patch_clustering = params::get_parameter(np, names::patch_clustering_t());
  return oracles;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ORACLES_H
