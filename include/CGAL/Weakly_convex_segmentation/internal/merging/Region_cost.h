// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_COST_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_COST_H

// The `training_free` criterion for fusion and merging (sections 4 and 5): one cost of visibility, seam
// concavity and volume, and of whether the regions are complete: the surface of a part closes around its
// volume, so lines inwards from a part end at the part itself. Half a limb ends at the other half.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/diameters/shape_diameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/contraction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The cost of merging two adjacent regions of a graph that was asked for shapes.
class Region_cost
{
public:
  Region_cost(Region_graph& graph, const Patches& patches,
              const std::vector<Diameter_sample>& samples, const Histogram_scale& scale,
              const double missing_diameter_distance = 0.35)
    : m_graph(graph), m_patches(patches), m_samples(samples), m_scale(scale),
      m_missing_distance(missing_diameter_distance), m_inside(graph.regions().size())
  {}

  /// returns the weighted cost, infinity if it is above `threshold`. Lines of sight are cast only if
  /// the other terms leave the pair a chance.
  double operator()(const int a, const int b, const Merging_cost& weights,
                    const double threshold) const
  {
    const double known = without_visibility(a, b, weights);
    if (known > threshold) return std::numeric_limits<double>::infinity();
    const double cost = known + (1. - m_graph.visibility(a, b));
    return cost <= threshold ? cost : std::numeric_limits<double>::infinity();
  }

  /// returns the cost as if the regions did not see each other at all.
  double blind(const int a, const int b, const Merging_cost& weights) const
  {
    return 1. + without_visibility(a, b, weights);
  }

  /// share of the points in the smaller region, in [0, 1]
  double smaller_share(const int a, const int b) const { return (std::min)(share(a), share(b)); }

  /// \name Terms of the cost
  /// @{

  /// share of the points in a region, in [0, 1]
  double share(const int r) const { return m_graph.region(r).size / m_graph.total_size(); }
  double visibility(const int a, const int b) const { return m_graph.visibility(a, b); }
  double concave_share(const int a, const int b) const
  {
    return m_graph.seam(a, b).concave_share();
  }
  double diameter_distance(const int a, const int b) const;
  double closure(const int r) const { return inside_of(r).closure; }
  double diameter(const int r) const { return inside_of(r).diameter; }
  double diameter_spread(const int r) const { return inside_of(r).diameter_spread; }
  double seam_extent(const int a, const int b) const { return axes(a, b).extent(); }
  double continuation(const int a, const int b) const { return continuation(a, b, axes(a, b)); }

  /// @}

private:
  /// What the samples of a region find inwards.
  struct Inside
  {
    double size = -1.;           ///< of the region when this was measured
    double closure = 0.7;        ///< share of the samples that face their own region
    double diameter_spread = 0.; ///< standard deviation of the logarithm
    double diameter = 0.;        ///< geometric mean, 0 if unknown
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
    if (weights.seam_extent_weight > 0. || weights.continuation_weight > 0.)
    {
      const Seam_axes seam = axes(a, b);
      cost -= weights.seam_extent_weight * seam.extent();
      if (weights.continuation_weight > 0.)
        cost -= weights.continuation_weight * continuation(a, b, seam);
    }
    return cost;
  }

  /// The axes of a seam, and the longest one of the union of its regions: a standard deviation.
  struct Seam_axes
  {
    Axes seam;
    double longest_of_union;

    Seam_axes(const Region& first, const Region& second, const Seam& of)
      : seam(of.shape.position, of.shape.position_squares, 2. * of.edges),
        longest_of_union(longest_axis(first.shape.position + second.shape.position,
                                      first.shape.position_squares + second.shape.position_squares,
                                      first.size + second.size))
    {}
    double extent() const { return seam.lengths[2] / longest_of_union; }
  };
  Seam_axes axes(const int a, const int b) const
  {
    return {m_graph.region(a), m_graph.region(b), m_graph.seam(a, b)};
  }

  /// How much two regions are pieces of one tube, in [0, 1]. People do not cut a limb where it goes on
  /// straight, though its pieces hardly see each other and each is complete but for its ends.
  double continuation(const int a, const int b, const Seam_axes& axes) const
  {
    const Region &first = m_graph.region(a), &second = m_graph.region(b);
    const double diameter_a = inside_of(a).diameter, diameter_b = inside_of(b).diameter;
    if (!(diameter_a > 0. && diameter_b > 0.)) return 0.;
    const Double3& lengths = axes.seam.lengths;
    const double slenderness = 1. - lengths[2] / axes.longest_of_union;
    const double straightness =
        dot(unit_vector(axes.seam.center - first.shape.position / first.size),
            unit_vector(second.shape.position / second.size - axes.seam.center));
    if (!(slenderness > 0. && straightness > 0.)) return 0.;
    // the seam is a ring that is as wide as the tube on either side: a circle deviates by its radius
    // over the root of two along both axes
    const double roundness = lengths[1] / lengths[2];
    const double width = std::sqrt(8. * lengths[1] * lengths[2]);
    const double fit =
        std::exp(-std::abs(std::log(width / diameter_a)) - std::abs(std::log(width / diameter_b)));
    const double seam_length = m_graph.seam(a, b).shape.length;
    return slenderness * straightness * roundness * roundness * fit * fit *
           tubularity(a, seam_length) * tubularity(b, seam_length);
  }

  /// How much a region is a tube of which the seam is an end, in [0, 1]: all normals are across some axis,
  /// and the border has room for one more such end, but not for the branches of a joint.
  double tubularity(const int r, const double seam_length) const
  {
    constexpr double most_ends = 2.5;
    double border = 0.;
    for (const auto& entry : m_graph.seams(r)) border += entry.second.shape.length;
    const double unbranched = (std::min)(1., (std::max)(0., 1. + most_ends - border / seam_length));
    if (unbranched == 0.) return 0.;
    const Region& region = m_graph.region(r);
    const Principal_axes normals(region.shape.normal_squares / region.size);
    return unbranched * (std::max)(0., 1. - 3. * normals.values().x); // a third for a sphere
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
    {
      inside.diameter = std::exp(sum / measured);
      inside.diameter_spread =
          std::sqrt((std::max)(0., squares / measured - sum * sum / (measured * measured)));
    }
    return inside;
  }

  Region_graph& m_graph;
  const Patches& m_patches;
  const std::vector<Diameter_sample>& m_samples;
  const Histogram_scale& m_scale;
  double m_missing_distance;            ///< of histograms of which one is empty
  mutable std::vector<Inside> m_inside; // by region
};

inline double Region_cost::diameter_distance(const int a, const int b) const
{
  const Diameter_histogram& first = m_graph.region(a).diameters;
  const Diameter_histogram& second = m_graph.region(b).diameters;
  if (first.empty() || second.empty()) return m_missing_distance;
  return earth_movers_distance(first, second, m_scale);
}

/// fills the regions' histograms.
inline void set_signatures(Region_graph& graph, const Patches& patches,
                           const std::vector<Diameter_sample>& samples,
                           const Histogram_scale& scale)
{
  for (const Diameter_sample& s : samples)
    graph.region(patches.of_point[s.point]).diameters.add(scale, s.diameter);
}

/// gives regions that are too small for a part to the neighbor that suits best.
inline void absorb_small_regions(Region_graph& graph, const Region_cost& cost,
                                 const Merging_parameters& parameters, const Contraction_log& log)
{
  Merging_cost balanced; // from the trial of the method
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

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_COST_H
