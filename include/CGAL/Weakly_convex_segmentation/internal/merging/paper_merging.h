// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAPER_MERGING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAPER_MERGING_H

// The paper's way of merging: patches that see each other are fused into weakly convex components (section 4),
// and components merged by volumetric signature and seam sets (section 5).
//
// Where the paper is silent: histograms have equal bins from 0 to the largest diameter of the shape;
// max(D) is over all pairs, adjacent or not; pairs are merged by ascending distance and the histograms
// of merged components add up; a component is flat if hardly any sample has a diameter.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/diameters/shape_diameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/contraction.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// runs one round for each threshold theta: adjacent components are fused by descending visibility
/// while theta holds for all pairs of patches across them, or for their average.
///
/// The text asks for all pairs; with one bad pair as a veto the components stay small. The caption of
/// figure 4 speaks of a relaxed criterion: `Fusion_rule::AVERAGE` is our reading of it.
inline void fuse_components(Region_graph& graph, const Parameters& parameters,
                            const Contraction_log& log)
{
  for (const double theta : parameters.fusion_thresholds)
    contract(
        graph,
        [&](const int a, const int b)
        {
          const double average = graph.visibility(a, b);
          const double decisive =
              parameters.fusion == Fusion_rule::AVERAGE ? average : graph.least_visibility(a, b);
          return decisive >= theta ? 1. - average : std::numeric_limits<double>::infinity();
        },
        log);
}

/// The volumetric signatures of the components and what their distances are relative to.
class Component_signatures
{
public:
  Component_signatures(const Oriented_points& points, const Patches& patches,
                       const Parameters& parameters, const bool parallel)
    : m_points(points), m_patches(patches), m_parameters(parameters), m_parallel(parallel)
  {
    m_scale.logarithmic = false;
    m_scale.low = 0.;
  }

  const Histogram_scale& scale() const { return m_scale; }

  /// measures the histograms of all components, from the points or as `given`.
  void measure(Region_graph& graph, const std::vector<Diameter_sample>& given)
  {
    std::vector<std::vector<Diameter_sample>> samples(graph.regions().size());
    double largest = 0.;
    if (m_parameters.diameter == Diameter_rule::OWN_POINTS)
    {
      for (std::size_t r = 0; r < samples.size(); ++r)
        samples[r] = own_diameters(m_points, members(graph.regions()[r]), m_parameters, m_parallel);
    }
    else
    {
      std::vector<int> region_of_patch(samples.size());
      for (std::size_t r = 0; r < samples.size(); ++r)
        for (const int p : graph.regions()[r].patches) region_of_patch[p] = static_cast<int>(r);
      for (const Diameter_sample& s : given)
        samples[region_of_patch[m_patches.of_point[s.point]]].push_back(s);
    }
    for (const auto& of_region : samples)
      for (const Diameter_sample& s : of_region)
        largest = (std::max)(largest, static_cast<double>(s.diameter));
    m_scale.high = largest > 0. ? largest : 1.;
    for (std::size_t r = 0; r < samples.size(); ++r)
    {
      Diameter_histogram& histogram = graph.region(static_cast<int>(r)).diameters;
      histogram = Diameter_histogram();
      for (const Diameter_sample& s : samples[r]) histogram.add(m_scale, s.diameter);
    }
    find_largest_distance(graph);
  }

  bool is_flat(const Region& region) const
  {
    constexpr double flat_share = 0.1; // silent: of the samples, at most so many have a diameter
    return region.diameters.empty() ||
           region.diameters.measured <= flat_share * region.diameters.samples;
  }

  /// returns the distance of two signatures relative to the largest one, in [0, 1].
  double distance(const Region& a, const Region& b) const
  {
    return earth_movers_distance(a.diameters, b.diameters, m_scale) / m_largest_distance;
  }

private:
  std::vector<Index> members(const Region& region) const
  {
    std::vector<Index> result;
    for (const int p : region.patches)
      result.insert(result.end(), m_patches.members[p].begin(), m_patches.members[p].end());
    std::sort(result.begin(), result.end());
    return result;
  }

  void find_largest_distance(const Region_graph& graph)
  {
    m_largest_distance = 0.;
    for (std::size_t a = 0; a < graph.regions().size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
      {
        const Region &first = graph.regions()[a], &second = graph.regions()[b];
        if (!is_flat(first) && !is_flat(second))
          m_largest_distance =
              (std::max)(m_largest_distance,
                         earth_movers_distance(first.diameters, second.diameters, m_scale));
      }
    if (m_largest_distance == 0.) m_largest_distance = 1.;
  }

  const Oriented_points& m_points;
  const Patches& m_patches;
  const Parameters& m_parameters;
  bool m_parallel;
  Histogram_scale m_scale;
  double m_largest_distance = 1.;
};

/// merges adjacent components of similar signature, but over seams that are too concave.
inline void merge_similar_components(Region_graph& graph, const Component_signatures& signatures,
                                     const Parameters& parameters, const Contraction_log& log)
{
  contract(
      graph,
      [&](const int a, const int b)
      {
        constexpr double never = std::numeric_limits<double>::infinity();
        constexpr double concave_seam_ratio = 0.85; // of concave to convex seam edges
        const Region &first = graph.region(a), &second = graph.region(b);
        if (signatures.is_flat(first) || signatures.is_flat(second)) return never;
        const Seam& seam = graph.seam(a, b);
        if (seam.concave > 0. && seam.concave >= concave_seam_ratio * seam.convex) return never;
        const double d = signatures.distance(first, second);
        return d <= parameters.merging_threshold ? d : never;
      },
      log);
}

/// returns the neighbor that a flat component joins, or -1.
///
/// First the longest seam that is strictly convex, then the highest ratio of convex to concave seam
/// edges, if it is at least 1 and the two see each other well enough.
inline int neighbor_of_flat_component(Region_graph& graph, const int flat,
                                      const double flat_visibility = 0.4)
{
  std::vector<std::pair<double, int>> by_length, by_ratio;
  for (const auto& [other, seam] : graph.seams(flat))
  {
    by_length.push_back({-seam.edges, other});
    const double ratio =
        seam.concave > 0. ? seam.convex / seam.concave : (std::numeric_limits<double>::max)();
    by_ratio.push_back({-ratio, other});
  }
  std::sort(by_length.begin(), by_length.end());
  for (const auto& entry : by_length)
  {
    const Seam& seam = graph.seam(flat, entry.second);
    if (seam.convex == seam.edges) return entry.second;
  }
  std::sort(by_ratio.begin(), by_ratio.end());
  for (const auto& [negative_ratio, other] : by_ratio)
    if (-negative_ratio >= 1. && graph.visibility(flat, other) >= flat_visibility) return other;
  return -1;
}

/// gives each flat component to an adequate neighbor, if there is one.
inline void merge_flat_components(Region_graph& graph, const Component_signatures& signatures,
                                  const Parameters& parameters, const Contraction_log& log)
{
  std::vector<int> flat;
  for (int r = 0; r < static_cast<int>(graph.regions().size()); ++r)
    if (graph.is_region(r) && signatures.is_flat(graph.region(r))) flat.push_back(r);
  for (const int r : flat)
  {
    if (!graph.is_region(r)) continue; // an earlier flat component took it
    const int other = neighbor_of_flat_component(graph, r);
    if (other < 0 || !log.may_merge(other, r)) continue;
    graph.merge(other, r);
    log.add(other, r, parameters.merging_threshold);
  }
}

/// merges the components into segments: similar ones, flat ones, and with the signatures measured
/// anew once more similar ones.
inline void merge_components(Region_graph& graph, Component_signatures& signatures,
                             const std::vector<Diameter_sample>& given_diameters,
                             const Parameters& parameters, const Contraction_log& log)
{
  signatures.measure(graph, given_diameters);
  merge_similar_components(graph, signatures, parameters, log);
  merge_flat_components(graph, signatures, parameters, log);
  signatures.measure(graph, given_diameters);
  merge_similar_components(graph, signatures, parameters, log);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAPER_MERGING_H
