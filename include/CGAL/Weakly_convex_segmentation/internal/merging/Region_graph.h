// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_GRAPH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_GRAPH_H

// The region adjacency graph on which sections 4 (fusion) and 5 (merging) run: regions and seams with
// statistics that add up under merging.

#include <CGAL/Weakly_convex_segmentation/internal/diameters/Diameter_histogram.h>
#include <CGAL/Weakly_convex_segmentation/internal/diameters/shape_diameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/number_labels.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_moments.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Patch_visibility.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A union of patches.
struct Region
{
  std::vector<int> patches; ///< empty once the region was merged into another one
  double size = 0.;         ///< number of points
  Vector3 center_sum;       ///< sum of the positions
  Diameter_histogram diameters;
  Region_moments shape;       ///< only if the graph was asked for shapes
  std::vector<Index> samples; ///< diameter samples in the region, likewise
  double inside_visibility =
      0.; ///< sum over pairs of its patches, weighted by their sizes; only if
          ///< the graph was asked for profiles
};

/// The border between two adjacent regions: counts of the neighbor edges across it (the seam sets of
/// section 5) and the visibility of the pairs of patches across it, of a sample where there are many.
struct Seam
{
  double edges = 0.;
  double convex = 0.;  ///< CVXSeam: convex or flat
  double concave = 0.; ///< CNCSeam: concave by more than the tolerance
  double opposite =
      0.; ///< not concave, normals far apart: the edge joins two sides of a thin sheet
  double visibility_sum = 0.;   ///< sum of the visibility of pairs of patches times their sizes
  double visibility_least = 1.; ///< the least visibility of a pair
  double visibility_low = 0.;   ///< weight of the pairs of visibility under 0.3
  bool visibility_known = false;
  Seam_moments shape;   ///< only if the graph was asked for shapes
  Seam_profile profile; ///< only if the graph was asked for profiles

  void add_edges(const Seam& other)
  {
    edges += other.edges;
    convex += other.convex;
    concave += other.concave;
    opposite += other.opposite;
    shape += other.shape;
    profile += other.profile;
  }
  void add_visibility(const Seam& other)
  {
    visibility_sum += other.visibility_sum;
    visibility_low += other.visibility_low;
    visibility_least = (std::min)(visibility_least, other.visibility_least);
  }
  /// share of the edges that are concave, but for those through a thin sheet, in [0, 1]
  double concave_share() const
  {
    const double along_surface = edges - opposite;
    return along_surface > 0. ? concave / along_surface : 0.;
  }
};

/// Regions, seams and the patches' visibility. Regions are named by one of their patches.
class Region_graph
{
public:
  /// makes each patch a region. `piece_of` is empty, or has for each patch the one that it is a piece of and
  /// whose visibility it has.
  Region_graph(const Oriented_points& points, const Neighbor_graph& graph, const Patches& patches,
               Patch_visibility& visibility, const Merging_parameters& parameters,
               std::vector<int> piece_of = {});

  std::size_t number_of_regions() const { return m_count; }
  double total_size() const { return m_total; }
  const std::vector<Region>& regions() const { return m_regions; }
  Region& region(const int r) { return m_regions[r]; }
  const Region& region(const int r) const { return m_regions[r]; }
  bool is_region(const int r) const { return !m_regions[r].patches.empty(); }
  /// seams of a region, by neighbor
  const std::map<int, Seam>& seams(const int r) const { return m_seams[r]; }
  const Seam& seam(const int a, const int b) const { return m_seams[a].at(b); }

  /// returns the mean visibility of the pairs of patches of two adjacent regions, weighted by the patches'
  /// sizes, in [0, 1]: of all pairs with `Merging_rule::PAPER`, else of a sample where there are many.
  double visibility(const int a, const int b)
  {
    return measured_seam(a, b).visibility_sum / (m_regions[a].size * m_regions[b].size);
  }
  /// returns the least visibility of these pairs, in [0, 1].
  double least_visibility(const int a, const int b) { return measured_seam(a, b).visibility_least; }

  /// returns the weight share of the pairs of patches that hardly see each other, in [0, 1].
  double blind_share(const int a, const int b)
  {
    return measured_seam(a, b).visibility_low / (m_regions[a].size * m_regions[b].size);
  }

  /// region of a patch
  int region_of(const int patch) const { return m_sets.name_of(patch); }

  /// measures the shapes of regions and seams for the weighted and the fitted cost; before any merge.
  void add_shapes(const Oriented_points& points, const Neighbor_graph& graph,
                  const Patches& patches, const std::vector<Diameter_sample>& samples);
  /// measures the concavity of seams at fixed distances for the fitted cost; before any merge.
  void add_profiles(const Oriented_points& points, const Neighbor_graph& graph,
                    const Patches& patches);

  /// merges region `b` into region `a`, adjacent or not.
  void merge(const int a, const int b);

  /// returns the region of each patch, numbered from 0 in the order of the patches.
  std::vector<int> labels() const;

private:
  Seam& measured_seam(int a, int b);
  /// returns pairs of patches of two regions that stand for all of them.
  std::vector<std::pair<int, int>> pairs_of_patches(int a, int b) const;
  /// visibility over the pairs of patches of `a` and `b`, whether they are adjacent or not
  Seam measure_visibility(int a, int b);

  std::vector<Region> m_regions;
  std::vector<double> m_patch_sizes;
  std::vector<std::map<int, Seam>> m_seams; // symmetric; the lower end's entry holds the visibility
  Patch_visibility& m_visibility;
  std::vector<int> m_piece_of; // what the visibility calls each patch; empty if the same
  Disjoint_sets<int> m_sets;   // of patches, by the names of the regions
  std::size_t m_count = 0;
  double m_total = 0.;
  std::size_t m_most_pairs; // of patches, that are looked at for two regions
  bool m_has_profiles = false;
};

inline Region_graph::Region_graph(const Oriented_points& points, const Neighbor_graph& graph,
                                  const Patches& patches, Patch_visibility& visibility,
                                  const Merging_parameters& parameters, std::vector<int> piece_of)
  : m_regions(patches.size()), m_seams(patches.size()), m_visibility(visibility),
    m_piece_of(std::move(piece_of)), m_sets(patches.size()), m_count(patches.size()),
    m_total(static_cast<double>(points.size())),
    // a fusion of the paper asks that every pair see each other; for means, 24 or 64 are as good as all (1 - RI)
    m_most_pairs(
        parameters.merging == Merging_rule::PAPER ? (std::numeric_limits<std::size_t>::max)() : 24)
{
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    m_regions[p].patches = {static_cast<int>(p)};
    m_regions[p].size = static_cast<double>(patches.members[p].size());
    m_patch_sizes.push_back(m_regions[p].size);
    for (const Index i : patches.members[p])
      m_regions[p].center_sum = m_regions[p].center_sum + points.positions[i];
  }
  const float tolerance = radians(parameters.seam_concavity_tolerance);
  const float opposite = radians(115.); // from the trial of the method
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const int a = patches.of_point[i], b = patches.of_point[edge.point];
      if (a == b) continue;
      Seam& seam = m_seams[a][b];
      seam.edges += 1.;
      if (edge.concavity <= 0.f) seam.convex += 1.;
      if (edge.concavity > tolerance) seam.concave += 1.;
      if (edge.concavity < -opposite) seam.opposite += 1.;
    }
}

inline void Region_graph::add_shapes(const Oriented_points& points, const Neighbor_graph& graph,
                                     const Patches& patches,
                                     const std::vector<Diameter_sample>& samples)
{
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const Index i : patches.members[p])
      m_regions[p].shape.add(points.positions[i], points.normals[i], graph.spacing[i]);
  for (std::size_t s = 0; s < samples.size(); ++s)
    m_regions[patches.of_point[samples[s].point]].samples.push_back(static_cast<Index>(s));
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const int a = patches.of_point[i], b = patches.of_point[edge.point];
      if (a != b)
        m_seams[a][b].shape.add(points.positions[i], points.normals[i],
                                0.5f * (graph.spacing[i] + graph.spacing[edge.point]));
    }
  // both ends of an edge belong to the seam, whichever of its regions it is looked at from
  for (std::size_t a = 0; a < m_seams.size(); ++a)
    for (auto& [b, seam] : m_seams[a])
      if (static_cast<int>(a) < b)
      {
        Seam& back = m_seams[b].at(static_cast<int>(a));
        seam.shape += back.shape;
        back.shape = seam.shape;
      }
}

inline void Region_graph::add_profiles(const Oriented_points& points, const Neighbor_graph& graph,
                                       const Patches& patches)
{
  m_has_profiles = true;
  for (std::size_t p = 0; p < patches.size(); ++p) // patches are near convex
    m_regions[p].inside_visibility = m_patch_sizes[p] * m_patch_sizes[p];
  const Smoothed_borders borders(points, graph, patches, {0.015f, 0.03f, 0.06f});
  for (Index i = 0; i < graph.size(); ++i)
    for (const Neighbor& edge : graph[i])
    {
      const int a = patches.of_point[i], b = patches.of_point[edge.point];
      if (a != b) m_seams[a][b].profile.add_edge(borders, i, edge);
    }
}

inline std::vector<std::pair<int, int>> Region_graph::pairs_of_patches(const int a,
                                                                       const int b) const
{
  const std::vector<int>&from = m_regions[a].patches, &to = m_regions[b].patches;
  const std::size_t all = from.size() * to.size(), stride = coprime_stride(all);
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0, at = 0; i < (std::min)(all, m_most_pairs); ++i, at = (at + stride) % all)
    pairs.push_back({from[at % from.size()], to[at / from.size()]});
  return pairs;
}

inline Seam Region_graph::measure_visibility(const int a, const int b)
{
  const auto name = [this](const int p) { return m_piece_of.empty() ? p : m_piece_of[p]; };
  const std::vector<std::pair<int, int>> pairs = pairs_of_patches(a, b);
  std::vector<std::pair<int, int>> seen;
  for (const auto& [p, q] : pairs)
    if (name(p) != name(q)) seen.push_back({name(p), name(q)});
  m_visibility.prepare(seen);
  Seam result;
  double measured = 0.;
  for (const auto& [p, q] : pairs)
  {
    const double v = name(p) != name(q) ? m_visibility(name(p), name(q)) : 1.;
    const double weight = m_patch_sizes[p] * m_patch_sizes[q];
    measured += weight;
    result.visibility_sum += v * weight;
    if (v < 0.3) result.visibility_low += weight;
    result.visibility_least = (std::min)(result.visibility_least, v);
  }
  const double scale = m_regions[a].size * m_regions[b].size / measured;
  result.visibility_sum *= scale;
  result.visibility_low *= scale;
  return result;
}

inline Seam& Region_graph::measured_seam(const int a, const int b)
{
  Seam& seam = m_seams[(std::min)(a, b)].at((std::max)(a, b));
  if (!seam.visibility_known)
  {
    const Seam measured = measure_visibility(a, b);
    seam.visibility_sum = measured.visibility_sum;
    seam.visibility_least = measured.visibility_least;
    seam.visibility_low = measured.visibility_low;
    seam.visibility_known = true;
  }
  return seam;
}

inline void Region_graph::merge(const int a, const int b)
{
  if (m_has_profiles) // regions that do not touch are merged last of all: they need not be looked at
    m_regions[a].inside_visibility +=
        m_regions[b].inside_visibility +
        (m_seams[a].count(b) > 0 ? 2. * measured_seam(a, b).visibility_sum : 0.);
  std::map<int, Seam> merged; // seams of the union, by neighbor
  for (const int end : {a, b})
    for (const auto& entry : m_seams[end])
      if (entry.first != a && entry.first != b) merged[entry.first].add_edges(entry.second);
  for (auto& [c, seam] : merged)
  {
    // a sum that is known for one part of the union and missing for the other is completed, unless
    // nobody has asked for either yet
    const auto known = [&, c = c](const int end)
    {
      const auto& row = m_seams[(std::min)(end, c)];
      const auto it = row.find((std::max)(end, c));
      return it != row.end() && it->second.visibility_known ? &it->second : nullptr;
    };
    const Seam *from_a = known(a), *from_b = known(b);
    if (from_a == nullptr && from_b == nullptr) continue;
    seam.add_visibility(from_a != nullptr ? *from_a : measure_visibility(a, c));
    seam.add_visibility(from_b != nullptr ? *from_b : measure_visibility(b, c));
    seam.visibility_known = true;
  }
  for (const int end : {a, b})
    for (const auto& entry : m_seams[end]) m_seams[entry.first].erase(end);
  m_seams[b].clear();
  m_seams[a].clear();
  for (const auto& [c, seam] : merged) m_seams[c][a] = m_seams[a][c] = seam;

  Region &into = m_regions[a], &from = m_regions[b];
  into.patches.insert(into.patches.end(), from.patches.begin(), from.patches.end());
  into.size += from.size;
  into.center_sum = into.center_sum + from.center_sum;
  into.diameters += from.diameters;
  into.shape += from.shape;
  into.samples.insert(into.samples.end(), from.samples.begin(), from.samples.end());
  from = Region();
  m_sets.join_named(a, b);
  --m_count;
}

inline std::vector<int> Region_graph::labels() const
{
  std::vector<int> labels(m_regions.size());
  for (std::size_t p = 0; p < labels.size(); ++p) labels[p] = region_of(static_cast<int>(p));
  number_labels(labels);
  return labels;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_GRAPH_H
