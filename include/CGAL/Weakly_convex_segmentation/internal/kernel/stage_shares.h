// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_STAGE_SHARES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_STAGE_SHARES_H

// How the time of a run is divided.

#include <CGAL/Weakly_convex_segmentation/Visitor.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The share of the time that has passed when the input is prepared, and at the end of each stage; the last is 1.
using Stage_shares = std::array<double, number_of_stages + 1>;

/// returns about what a run of the default takes. Most stages see only the representatives, of which there are as
/// many for any input; the others take as long a point. Measured on a mesh and clouds of 4,000 to a million points.
inline Stage_shares stage_shares(const std::size_t number_of_points, const bool has_given_normals)
{
  // milliseconds, and those of a thousand points: the preparation (a mesh or estimated normals take long), the stages
  const double preparation = has_given_normals ? 0.1 : 2.3;
  const double costs[][2] = {{1., preparation}, {2., 0.2},  {12., 0.},  {39., 0.},
                             {1., 0.},          {21., 0.},  {130., 0.}, {3., 0.},
                             {1., 0.},          {9., 0.35}, {5., 0.005}};
  Stage_shares shares;
  double sum = 0.;
  for (std::size_t i = 0; i < shares.size(); ++i)
    shares[i] = sum += costs[i][0] + costs[i][1] * 1e-3 * static_cast<double>(number_of_points);
  for (double& share : shares) share /= sum;
  return shares;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_STAGE_SHARES_H
