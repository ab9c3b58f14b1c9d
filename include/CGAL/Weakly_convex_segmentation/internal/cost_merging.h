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
#include <utility>
#include <vector>

// The default's criterion for fusion and merging (sections 4 and 5): one cost of visibility, seam
// concavity and volume, and of whether the regions are complete: the surface of a part closes around its
// volume, so lines inwards from a part end at the part itself. Half a limb ends at the other half.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The cost of merging two adjacent regions of a graph that was asked for shapes.
class Region_cost
{
public:
  Region_cost(Region_graph& graph, const Patches& patches,
              const std::vector<Diameter_sample>& samples, const Histogram_scale& scale,
              const Parameters& parameters)
    : m_graph(graph), m_patches(patches), m_samples(samples), m_scale(scale),
      m_parameters(parameters), m_inside(graph.regions().size())
  {}

  /// returns the weighted cost, infinity if it is above `threshold`. Lines of sight are cast only if
  /// the other terms leave the pair a chance.
  double operator()(const int a, const int b, const Merging_cost& weights,
                    const double threshold) const
  {
    const double known = without_visibility(a, b, weights);
    if (known > threshold) return std::numeric_limits<double>::infinity();
    const double cost = known + weights.visibility_weight * (1. - m_graph.visibility(a, b));
    return cost <= threshold ? cost : std::numeric_limits<double>::infinity();
  }

  /// returns the cost as if the regions did not see each other at all.
  double blind(const int a, const int b, const Merging_cost& weights) const
  {
    return weights.visibility_weight + without_visibility(a, b, weights);
  }

  /// share of the points in the smaller region, in [0, 1]
  double smaller_share(const int a, const int b) const
  {
    return (std::min)(m_graph.region(a).size, m_graph.region(b).size) / m_graph.total_size();
  }

private:
  /// What the samples of a region find inwards.
  struct Inside
  {
    double size = -1.;           ///< of the region when this was measured
    double closure = 0.7;        ///< share of the samples that face their own region
    double diameter_spread = 0.; ///< standard deviation of the logarithm
  };

  double without_visibility(int a, int b, const Merging_cost& weights) const
  {
    if (m_graph.region(a).size > m_graph.region(b).size) std::swap(a, b);
    const double c = m_graph.seam(a, b).concave_share();
    double cost = weights.concavity_weight * c * (1. - weights.concavity_saturation * c);
    cost += weights.diameter_weight * diameter_distance(a, b);
    if (weights.smaller_closure_weight > 0. || weights.diameter_spread_weight > 0.)
    {
      const Inside& inside = inside_of(a);
      cost += weights.smaller_closure_weight * inside.closure -
              weights.diameter_spread_weight * inside.diameter_spread;
    }
    if (weights.larger_closure_weight > 0.)
      cost += weights.larger_closure_weight * inside_of(b).closure;
    if (weights.seam_extent_weight > 0.) cost -= weights.seam_extent_weight * seam_extent(a, b);
    return cost;
  }

  double diameter_distance(const int a, const int b) const
  {
    const Diameter_histogram& first = m_graph.region(a).diameters;
    const Diameter_histogram& second = m_graph.region(b).diameters;
    if (first.empty() || second.empty()) return m_parameters.missing_diameter_distance;
    return earth_movers_distance(first, second, m_scale);
  }

  /// length of the seam's longest axis relative to that of the union
  double seam_extent(const int a, const int b) const
  {
    const Region &first = m_graph.region(a), &second = m_graph.region(b);
    const Seam& seam = m_graph.seam(a, b);
    const double seam_axis =
        longest_axis(seam.shape.position, seam.shape.position_squares, 2. * seam.edges);
    return seam_axis / longest_axis(first.shape.position + second.shape.position,
                                    first.shape.position_squares + second.shape.position_squares,
                                    first.size + second.size);
  }

  const Inside& inside_of(const int r) const
  {
    Inside& inside = m_inside[static_cast<std::size_t>(r)];
    const Region& region = m_graph.region(r);
    if (inside.size == region.size) return inside; // only a merge of the region itself changes it
    constexpr double usual_closure = 0.7;          // where the line leaves through a hole
    double own = 0., measured = 0., sum = 0., squares = 0.;
    for (const Index index : region.samples)
    {
      const Diameter_sample& s = m_samples[index];
      if (!s.inwards.found())
        own += usual_closure;
      else if (m_graph.region_of(m_patches.of_point[s.inwards.disk]) == r)
        own += 1.;
      if (!(s.diameter > 0.f)) continue;
      const double l = std::log(s.diameter);
      measured += 1.;
      sum += l;
      squares += l * l;
    }
    inside = Inside();
    inside.size = region.size;
    if (!region.samples.empty()) inside.closure = own / static_cast<double>(region.samples.size());
    if (measured > 0.)
      inside.diameter_spread =
          std::sqrt((std::max)(0., squares / measured - sum * sum / (measured * measured)));
    return inside;
  }

  Region_graph& m_graph;
  const Patches& m_patches;
  const std::vector<Diameter_sample>& m_samples;
  const Histogram_scale& m_scale;
  const Parameters& m_parameters;
  mutable std::vector<Inside> m_inside; // by region
};

/// fills the regions' histograms.
inline void set_signatures(Region_graph& graph, const Patches& patches,
                           const std::vector<Diameter_sample>& samples,
                           const Histogram_scale& scale)
{
  for (const Diameter_sample& s : samples)
    graph.region(patches.of_point[s.point]).diameters.add(scale, s.diameter);
}

/// contracts by ascending cost up to a threshold.
inline void contract_by_cost(Region_graph& graph, const Region_cost& cost,
                             const Merging_cost& weights, const double threshold,
                             const Contraction_log& log)
{
  contract(
      graph, [&](const int a, const int b) { return cost(a, b, weights, threshold); }, log);
}

/// gives regions that are too small for a part to the neighbor that suits best.
inline void absorb_small_regions(Region_graph& graph, const Region_cost& cost,
                                 const Parameters& parameters, const Contraction_log& log)
{
  Merging_cost balanced; // from the trial of the method
  balanced.visibility_weight = 1.;
  balanced.concavity_weight = 0.5;
  balanced.diameter_weight = 0.3;
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
