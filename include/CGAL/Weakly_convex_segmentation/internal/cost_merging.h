// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_COST_MERGING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_COST_MERGING_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/Region_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/volumetric_signatures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// The default's criteria for fusion and merging (sections 4 and 5): one cost of visibility, seam
// concavity and volume, weighed for visibility first and for volume then.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The cost of merging two adjacent regions.
class Region_cost
{
public:
  Region_cost(Region_graph& graph, const Histogram_scale& scale, const Parameters& parameters)
    : m_graph(graph), m_scale(scale), m_parameters(parameters)
  {}

  /// returns the weighted cost, infinity if it is above `threshold`. Lines of sight are cast only if
  /// the other terms leave the pair a chance.
  double operator()(const int a, const int b, const Merging_cost& weights,
                    const double threshold) const
  {
    const double leniency = small_region_factor(a, b);
    const double known = weights.concavity_weight * m_graph.seam(a, b).concave_share() +
                         weights.diameter_weight * diameter_distance(a, b);
    if (known * leniency > threshold) return std::numeric_limits<double>::infinity();
    const double blindness = 1. - m_graph.visibility(a, b);
    const double cost = (known + weights.visibility_weight * blindness) * leniency;
    return cost <= threshold ? cost : std::numeric_limits<double>::infinity();
  }

  /// returns the cost as if the regions did not see each other at all.
  double blind(const int a, const int b, const Merging_cost& weights) const
  {
    return small_region_factor(a, b) *
           (weights.visibility_weight +
            weights.concavity_weight * m_graph.seam(a, b).concave_share() +
            weights.diameter_weight * diameter_distance(a, b));
  }

  /// share of the points in the smaller region, in [0, 1]
  double smaller_share(const int a, const int b) const
  {
    return (std::min)(m_graph.region(a).size, m_graph.region(b).size) / m_graph.total_size();
  }

private:
  double small_region_factor(const int a, const int b) const
  {
    const double share = smaller_share(a, b);
    if (share >= m_parameters.small_region_share) return 1.;
    return std::pow(share / m_parameters.small_region_share, m_parameters.small_region_exponent);
  }

  double diameter_distance(const int a, const int b) const
  {
    const Diameter_histogram& first = m_graph.region(a).diameters;
    const Diameter_histogram& second = m_graph.region(b).diameters;
    if (first.empty() || second.empty()) return m_parameters.missing_diameter_distance;
    return earth_movers_distance(first, second, m_scale);
  }

  Region_graph& m_graph;
  const Histogram_scale& m_scale;
  const Parameters& m_parameters;
};

/// fills the regions' histograms.
inline void set_signatures(Region_graph& graph, const Patches& patches,
                           const std::vector<Diameter_sample>& samples,
                           const Histogram_scale& scale)
{
  for (const Diameter_sample& s : samples)
    graph.region(patches.of_point[s.point]).diameters.add(scale, s.diameter);
}

/// contracts by one weighted cost up to its threshold.
inline void contract_by_cost(Region_graph& graph, const Region_cost& cost,
                             const Merging_cost& weights, const Contraction_log& log)
{
  contract(
      graph, [&](const int a, const int b) { return cost(a, b, weights, weights.threshold); }, log);
}

/// gives regions that are too small for a part to the neighbor that suits best.
inline void absorb_small_regions(Region_graph& graph, const Region_cost& cost,
                                 const Parameters& parameters, const Contraction_log& log)
{
  const Merging_cost balanced = {1., 0.5, 0.3, 0.}; // from the trial of the method
  constexpr double infinity = std::numeric_limits<double>::infinity();
  contract(
      graph,
      [&](const int a, const int b)
      {
        if (cost.smaller_share(a, b) >= parameters.minimum_segment_share) return infinity;
        return cost(a, b, balanced, (std::numeric_limits<double>::max)());
      },
      log);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_COST_MERGING_H
