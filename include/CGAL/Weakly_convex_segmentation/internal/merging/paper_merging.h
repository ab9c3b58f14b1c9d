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
// Section 4 wants theta "for all pairs of patches contained in" two components, but also to keep "the
// intra-component mutual visibility above a threshold", and the caption of figure 4 calls the former relaxed.
// `Fusion_rule::AVERAGE` takes the share of the pairs of points that see each other, which is what the
// convexity rank (equation 1) counts. With one bad pair of patches as a veto, `EVERY_PAIR`, components stay small: a
// 1 - RI of 0.185 instead of 0.140.
//
// Where the paper is silent: histograms have 64 equal bins from 0 to the largest diameter of the shape, and max(D)
// is over all pairs that are not flat, adjacent or not (adjacent alone: 0.142). "Following this ordering" is one pass
// for each theta (always the best pair: 0.140), "any two adjacent components" all of them at once (one after another:
// 0.140).

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

/// runs one iteration for each threshold theta: goes over the pairs of adjacent components, sorted by descending
/// visibility, and fuses them where theta holds for what they have grown to by then.
inline void fuse_components(Region_graph& graph, const Parameters& parameters,
                            const Contraction_log& log)
{
  const auto blindness = [&](const int a, const int b) { return 1. - graph.visibility(a, b); };
  for (const double theta : parameters.fusion_thresholds)
    sweep(
        graph, blindness,
        [&](const int a, const int b)
        {
          return theta <= (parameters.fusion == Fusion_rule::AVERAGE
                               ? graph.visibility(a, b)
                               : graph.least_visibility(a, b));
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

  /// "any component with an empty histogram": nothing of it is opposite to any of its samples. Scans from one side
  /// have many with few diameters, which those do tell apart.
  bool is_flat(const Region& region) const { return region.diameters.empty(); }

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
    std::vector<const Diameter_histogram*> signatures;
    for (const Region& region : graph.regions())
      if (!is_flat(region)) signatures.push_back(&region.diameters);
    m_largest_distance = 0.;
    for (std::size_t a = 0; a < signatures.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        m_largest_distance = (std::max)(
            m_largest_distance, earth_movers_distance(*signatures[a], *signatures[b], m_scale));
    if (m_largest_distance == 0.) m_largest_distance = 1.;
  }

  const Oriented_points& m_points;
  const Patches& m_patches;
  const Parameters& m_parameters;
  bool m_parallel;
  Histogram_scale m_scale;
  double m_largest_distance = 1.;
};

/// merges any two adjacent components of similar signature, but over seams that are too concave. Distances and
/// seams are those before the first merge, as the paper's matrix D is.
inline void merge_similar_components(Region_graph& graph, const Component_signatures& signatures,
                                     const Parameters& parameters, const Contraction_log& log)
{
  const auto distance = [&](const int a, const int b)
  {
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr double concave_seam_ratio = 0.85; // of concave to convex seam edges
    const Region &first = graph.region(a), &second = graph.region(b);
    if (signatures.is_flat(first) || signatures.is_flat(second)) return never;
    const Seam& seam = graph.seam(a, b);
    if (seam.concave > 0. && seam.concave >= concave_seam_ratio * seam.convex) return never;
    const double d = signatures.distance(first, second);
    return d <= parameters.merging_threshold ? d : never;
  };
  sweep(
      graph, distance, [](int, int) { return true; }, log);
}

/// returns the neighbor that a flat component joins, or -1.
///
/// First the longest seam that is strictly convex, all of it in CVXSeam, then the highest ratio of convex to
/// concave seam edges, if it is at least 1 and the two see each other well enough.
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

/// gives each flat component to an adequate neighbor, if there is one; returns whether any is flat.
inline bool merge_flat_components(Region_graph& graph, const Component_signatures& signatures,
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
  return !flat.empty();
}

/// merges the components into segments: similar ones, and if there are flat ones, these, and with the signatures
/// measured anew once more similar ones.
inline void merge_components(Region_graph& graph, Component_signatures& signatures,
                             const std::vector<Diameter_sample>& given_diameters,
                             const Parameters& parameters, const Contraction_log& log)
{
  signatures.measure(graph, given_diameters);
  merge_similar_components(graph, signatures, parameters, log);
  if (!merge_flat_components(graph, signatures, parameters, log)) return;
  signatures.measure(graph, given_diameters);
  merge_similar_components(graph, signatures, parameters, log);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAPER_MERGING_H
