// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAIR_FEATURES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAIR_FEATURES_H

// What the fitted merge cost knows of a pair of adjacent regions. All of it comes from sums that add up
// under merging; lengths are relative to the extent of the shape, so nothing depends on scale or pose.

#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_cost.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// measures what the features of a graph's pairs are made of; before any merge.
inline void measure_pairs(Region_graph& graph, const Oriented_points& points,
                          const Neighbor_graph& neighbors, const Patches& patches,
                          const std::vector<Diameter_sample>& samples)
{
  set_signatures(graph, patches, samples, Histogram_scale());
  graph.add_shapes(points, neighbors, patches, samples);
  graph.add_profiles(points, neighbors, patches);
}

/// Features of pairs of regions of one graph; `a` is the smaller region, `u` the union.
class Pair_features
{
public:
  Pair_features(Region_graph& graph, const Patches& patches,
                const std::vector<Diameter_sample>& samples)
    : m_graph(graph), m_patches(patches), m_samples(samples),
      m_cost(graph, patches, samples, m_scale, missing_diameter_distance)
  {
    double measured = 0., sum = 0.;
    for (const Diameter_sample& s : samples)
      if (s.diameter > 0.f)
      {
        measured += 1.;
        sum += std::log(s.diameter);
        m_whole_thin += s.diameter < wall ? 1. : 0.;
      }
    m_whole_diameter = measured > 0. ? sum / measured : missing();
    m_whole_thin = measured > 0. ? m_whole_thin / measured : missing();
  }

  /// fills `features` for two adjacent regions, in the order of `pair_feature_names()`.
  void compute(int a, int b, std::vector<float>& features);

  /// the weighted cost, the last feature: with constants of its own, so that a change of `Merging_cost` moves no
  /// table
  double weighted_cost(const int a, const int b) const
  {
    constexpr Merging_cost weights = {2.23, 0.38, 0.67, 0.505, 0.305, 0.565, 0.44, 1.5};
    return m_cost(a, b, weights, (std::numeric_limits<double>::max)());
  }

private:
  static constexpr double missing_diameter_distance = 0.302; ///< as when the table was fitted
  static constexpr float wall = 0.025f; ///< thickness of a wall, relative to the extent
  static double missing() { return std::numeric_limits<double>::quiet_NaN(); }

  /// Logarithms of the diameters of a region, and what its samples face.
  struct Sight_counts
  {
    double samples = 0., measured = 0., sum = 0., squares = 0.;
    double inward = 0., outward = 0., through_wall = 0., thin = 0.;
    double inward_self = 0., outward_self = 0.;

    double mean() const { return measured > 0. ? sum / measured : missing(); }
    double spread() const
    {
      if (measured <= 0.) return missing();
      return std::sqrt((std::max)(0., squares / measured - mean() * mean()));
    }
    double share(const double count) const { return samples > 0. ? count / samples : missing(); }
  };

  Sight_counts count_sights(const int region, const int other) const
  {
    Sight_counts counts;
    for (const Index index : m_graph.region(region).samples)
    {
      const Diameter_sample& s = m_samples[index];
      counts.samples += 1.;
      if (s.diameter > 0.f)
      {
        const double l = std::log(s.diameter);
        counts.measured += 1.;
        counts.sum += l;
        counts.squares += l * l;
      }
      if (s.inwards.found())
      {
        const bool thin = s.inwards.distance < wall;
        counts.thin += thin ? 1. : 0.;
        const int faced = region_at(s.inwards);
        counts.inward_self += faced == region ? 1. : 0.;
        counts.inward += faced == other ? 1. : 0.;
        counts.through_wall += faced == other && thin ? 1. : 0.;
      }
      if (s.outwards.found())
      {
        const int faced = region_at(s.outwards);
        counts.outward_self += faced == region ? 1. : 0.;
        counts.outward += faced == other ? 1. : 0.;
      }
    }
    return counts;
  }
  int region_at(const Ray_hit& hit) const
  {
    return m_graph.region_of(m_patches.of_point[hit.disk]);
  }

  /// The whole border of a region: it does not change while its neighbors merge.
  struct Border
  {
    double length = 0., edges = 0., concavity = 0.;
  };
  Border border(const int region) const
  {
    Border sum;
    for (const auto& entry : m_graph.seams(region))
    {
      sum.length += 0.5 * entry.second.shape.length;
      sum.edges += entry.second.edges;
      sum.concavity += entry.second.profile.radii[1].positive_sum;
    }
    return sum;
  }

  void add_visibility(int a, int b, std::vector<float>& f);
  void add_concavity(const Seam& seam, const Border& of_a, const Border& of_b,
                     std::vector<float>& f) const;
  void add_diameters(int a, int b, const Sight_counts& of_a, const Sight_counts& of_b,
                     std::vector<float>& f) const;
  void add_sizes(int a, int b, const Sight_counts& of_a, double border_a, double border_b,
                 std::vector<float>& f) const;
  void add_shapes(int a, int b, std::vector<float>& f) const;
  void add_seam_shape(const Region& first, const Region& second, const Axes& axes_a,
                      const Axes& axes_b, const Axes& axes_u, const Seam& seam,
                      std::vector<float>& f) const;
  void add_costs(int a, int b, std::vector<float>& f);

  Region_graph& m_graph;
  const Patches& m_patches;
  const std::vector<Diameter_sample>& m_samples;
  const Histogram_scale m_scale = {};
  const Region_cost m_cost;
  double m_whole_diameter = 0., m_whole_thin = 0.;
};

inline void add_feature(std::vector<float>& f, const double value)
{
  f.push_back(static_cast<float>(value));
}

inline void Pair_features::add_visibility(const int a, const int b, std::vector<float>& f)
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  const double v = m_graph.visibility(a, b);
  const double inside_a = first.inside_visibility / (first.size * first.size);
  const double inside_b = second.inside_visibility / (second.size * second.size);
  const double size = first.size + second.size;
  const double inside_u =
      (first.inside_visibility + second.inside_visibility + 2. * v * first.size * second.size) /
      (size * size);
  for (const double value : {v, m_graph.blind_share(a, b), inside_a, inside_b, inside_u,
                             v - (std::min)(inside_a, inside_b)})
    add_feature(f, value);
}

inline void Pair_features::add_concavity(const Seam& seam, const Border& of_a, const Border& of_b,
                                         std::vector<float>& f) const
{
  add_feature(f, seam.concave_share());
  add_feature(f, seam.profile.edge_positive / seam.edges);
  add_feature(f, seam.profile.edge_signed / seam.edges);
  const auto& radii = seam.profile.radii;
  for (std::size_t r = 0; r < radii.size(); ++r)
  {
    const auto& at = radii[r];
    for (const double sum : {at.signed_sum, at.positive_sum, at.over_15, at.over_30, at.under_20})
      add_feature(f, sum / seam.edges);
    if (r > 0) add_feature(f, (at.signed_sum - radii[r - 1].signed_sum) / seam.edges);
  }
  // how concave the rest of a region's border is: a deeper cut elsewhere speaks for the merge here
  for (const Border& whole : {of_a, of_b})
    add_feature(f, whole.edges > seam.edges
                       ? (whole.concavity - radii[1].positive_sum) / (whole.edges - seam.edges)
                       : missing());
}

inline void Pair_features::add_diameters(const int a, const int b, const Sight_counts& of_a,
                                         const Sight_counts& of_b, std::vector<float>& f) const
{
  const Diameter_histogram &first = m_graph.region(a).diameters,
                           &second = m_graph.region(b).diameters;
  const bool both = !first.empty() && !second.empty();
  Sight_counts of_u = of_a;
  of_u.measured += of_b.measured;
  of_u.sum += of_b.sum;
  of_u.squares += of_b.squares;
  add_feature(f, both ? earth_movers_distance(first, second, Histogram_scale()) : missing());
  add_feature(f, both ? std::abs(of_a.mean() - of_b.mean()) : missing());
  for (const double value : {of_a.mean(), of_b.mean(), of_a.spread(), of_b.spread(), of_u.spread()})
    add_feature(f, value);
}

inline double ratio_or_missing(const double x, const double y)
{
  return y > 0. ? x / y : std::numeric_limits<double>::quiet_NaN();
}

inline void Pair_features::add_sizes(const int a, const int b, const Sight_counts& of_a,
                                     const double border_a, const double border_b,
                                     std::vector<float>& f) const
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  const double seam = 0.5 * m_graph.seam(a, b).shape.length;
  add_feature(f, first.size / m_graph.total_size());
  add_feature(f, second.size / m_graph.total_size());
  add_feature(f, ratio_or_missing(seam, std::sqrt(first.shape.area)));
  add_feature(f, ratio_or_missing(seam, std::sqrt(second.shape.area)));
  add_feature(f, ratio_or_missing(seam, border_a));
  add_feature(f, ratio_or_missing(seam, border_b));
  add_feature(f, of_a.measured > 0. ? seam / std::exp(of_a.mean()) : missing());
}

inline void Pair_features::add_shapes(const int a, const int b, std::vector<float>& f) const
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  Region_moments both = first.shape;
  both += second.shape;
  const double size = first.size + second.size;
  const Axes axes_a(first.shape.position, first.shape.position_squares, first.size);
  const Axes axes_b(second.shape.position, second.shape.position_squares, second.size);
  const Axes axes_u(both.position, both.position_squares, size);
  const Shape_ratios of_a = shape_ratios(first.shape, axes_a, first.size);
  const Shape_ratios of_b = shape_ratios(second.shape, axes_b, second.size);
  const Shape_ratios of_u = shape_ratios(both, axes_u, size);
  for (const double value :
       {of_a.middle_axis, of_b.middle_axis, of_u.middle_axis, of_a.short_axis, of_b.short_axis,
        of_u.short_axis, of_a.normal_mean, of_b.normal_mean, of_u.normal_mean, of_a.normal_least,
        of_b.normal_least, of_u.normal_least})
    add_feature(f, value);
  add_feature(f, length(axes_a.center - axes_b.center) / axes_u.lengths[2]);
  add_feature(f, axes_u.lengths[2] / (std::max)(axes_a.lengths[2], axes_b.lengths[2]));
  add_seam_shape(first, second, axes_a, axes_b, axes_u, m_graph.seam(a, b), f);
}

/// Whether the seam is a ring, flat, as wide as the regions beside it, and at the end of their axes.
inline void Pair_features::add_seam_shape(const Region& first, const Region& second,
                                          const Axes& axes_a, const Axes& axes_b,
                                          const Axes& axes_u, const Seam& seam,
                                          std::vector<float>& f) const
{
  const double ends = 2. * seam.edges, seam_length = 0.5 * seam.shape.length;
  const Axes ring(seam.shape.position, seam.shape.position_squares, ends);
  add_feature(f, length(seam.shape.normal) / ends);
  add_feature(f, ring.lengths[0] / ring.lengths[2]);
  add_feature(f, ring.lengths[1] / ring.lengths[2]);
  add_feature(f, ring.lengths[2] / axes_u.lengths[2]);
  add_feature(f, ratio_or_missing(seam_length * axes_a.lengths[2], first.shape.area));
  add_feature(f, ratio_or_missing(seam_length * axes_b.lengths[2], second.shape.area));
  for (const Axes* axes : {&axes_a, &axes_b})
    add_feature(f, length(ring.center - axes->center) / axes->lengths[2]);
  for (const Axes* axes : {&axes_a, &axes_b})
    add_feature(f, std::abs(dot(unit_vector(ring.center - axes->center), axes->direction)));
  add_feature(f, std::abs(dot(axes_a.direction, axes_b.direction)));
}

/// Hand-made costs: two of few terms, and the weighted one. Trees meet kinds of shape that they were not
/// fitted on with far fewer wrong merges when they know them.
inline void Pair_features::add_costs(const int a, const int b, std::vector<float>& f)
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  const bool both = !first.diameters.empty() && !second.diameters.empty();
  const double distance =
      both ? earth_movers_distance(first.diameters, second.diameters, m_scale) : 0.3;
  const double blindness = 1. - m_graph.visibility(a, b);
  const double concavity = m_graph.seam(a, b).concave_share();
  const double share = (std::min)(first.size, second.size) / m_graph.total_size();
  const double leniency = std::pow((std::min)(1., share / 0.03), 0.08);
  add_feature(f, leniency * (1.33 * blindness + 0.55 * concavity + 0.145 * distance));
  add_feature(f, leniency * (0.114 * blindness + 3.05 * concavity + distance));
  add_feature(f, weighted_cost(a, b));
}

inline void Pair_features::compute(int a, int b, std::vector<float>& features)
{
  if (m_graph.region(a).size > m_graph.region(b).size) std::swap(a, b);
  features.clear();
  const Seam& seam = m_graph.seam(a, b);
  const Sight_counts of_a = count_sights(a, b), of_b = count_sights(b, a);
  const Border border_a = border(a), border_b = border(b);
  add_visibility(a, b, features);
  add_concavity(seam, border_a, border_b, features);
  add_diameters(a, b, of_a, of_b, features);
  add_sizes(a, b, of_a, border_a.length, border_b.length, features);
  add_shapes(a, b, features);
  for (const double value :
       {of_a.share(of_a.inward), of_b.share(of_b.inward), of_a.share(of_a.outward),
        of_b.share(of_b.outward), of_a.share(of_a.through_wall), of_b.share(of_b.through_wall),
        of_a.share(of_a.thin), of_b.share(of_b.thin), of_a.share(of_a.inward_self),
        of_b.share(of_b.inward_self), of_a.share(of_a.outward_self), of_b.share(of_b.outward_self),
        seam.opposite / seam.edges, m_whole_diameter, m_whole_thin})
    add_feature(features, value);
  add_costs(a, b, features);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_PAIR_FEATURES_H
