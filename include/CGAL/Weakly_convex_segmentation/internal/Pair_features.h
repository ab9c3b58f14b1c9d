// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PAIR_FEATURES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PAIR_FEATURES_H

#include <CGAL/Weakly_convex_segmentation/internal/Region_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// What the fitted merge cost knows of a pair of adjacent regions. All of it comes from sums that add up
// under merging; lengths are relative to the extent of the shape, so nothing depends on scale or pose.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A feature's name and whether the willingness to merge may only rise (1) or fall (-1) with it.
struct Feature_name
{
  const char* name;
  int monotone;
};

/// Features of pairs of regions of one graph; `a` is the smaller region, `u` the union.
class Pair_features
{
public:
  static const std::vector<Feature_name>& names()
  {
    static const std::vector<Feature_name> list = {{"visibility", 1},
                                                   {"blind_share", -1},
                                                   {"inside_a", 0},
                                                   {"inside_b", 0},
                                                   {"inside_u", 1},
                                                   {"visibility_drop", 1},
                                                   {"edge_concave", -1},
                                                   {"edge_positive", -1},
                                                   {"edge_signed", -1},
                                                   {"near_signed", -1},
                                                   {"near_positive", -1},
                                                   {"near_over_15", -1},
                                                   {"near_over_30", -1},
                                                   {"near_under_20", 0},
                                                   {"far_signed", -1},
                                                   {"far_positive", -1},
                                                   {"far_over_15", -1},
                                                   {"far_over_30", -1},
                                                   {"far_under_20", 0},
                                                   {"far_minus_near", 0},
                                                   {"emd", -1},
                                                   {"diameter_step", -1},
                                                   {"diameter_a", 0},
                                                   {"diameter_b", 0},
                                                   {"diameter_spread_a", 0},
                                                   {"diameter_spread_b", 0},
                                                   {"diameter_spread_u", 0},
                                                   {"share_a", -1},
                                                   {"share_b", 0},
                                                   {"seam_to_size_a", 1},
                                                   {"seam_to_size_b", 1},
                                                   {"seam_to_border_a", 1},
                                                   {"seam_to_border_b", 1},
                                                   {"seam_to_diameter", 0},
                                                   {"middle_a", 0},
                                                   {"middle_b", 0},
                                                   {"middle_u", 0},
                                                   {"short_a", 0},
                                                   {"short_b", 0},
                                                   {"short_u", 0},
                                                   {"normal_mean_a", 0},
                                                   {"normal_mean_b", 0},
                                                   {"normal_mean_u", 0},
                                                   {"normal_least_a", 0},
                                                   {"normal_least_b", 0},
                                                   {"normal_least_u", 0},
                                                   {"center_distance", 0},
                                                   {"long_growth", 0},
                                                   {"inward_ab", 1},
                                                   {"inward_ba", 1},
                                                   {"outward_ab", 0},
                                                   {"outward_ba", 0},
                                                   {"wall_ab", 1},
                                                   {"wall_ba", 1},
                                                   {"thin_a", 0},
                                                   {"thin_b", 0},
                                                   {"opposite", 0},
                                                   {"whole_diameter", 0},
                                                   {"whole_thin", 0},
                                                   {"fusion_cost", -1},
                                                   {"merging_cost", -1}};
    return list;
  }

  Pair_features(Region_graph& graph, const Patches& patches,
                const std::vector<Diameter_sample>& samples)
    : m_graph(graph), m_patches(patches), m_samples(samples)
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

  /// fills `features` for two adjacent regions, in the order of the names.
  void compute(int a, int b, std::vector<float>& features);

private:
  static constexpr float wall = 0.025f; ///< thickness of a wall, relative to the extent
  static double missing() { return std::numeric_limits<double>::quiet_NaN(); }

  /// Logarithms of the diameters of a region, and what its samples face.
  struct Sight_counts
  {
    double samples = 0., measured = 0., sum = 0., squares = 0.;
    double inward = 0., outward = 0., through_wall = 0., thin = 0.;

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
        if (faces(s.inwards, other))
        {
          counts.inward += 1.;
          counts.through_wall += thin ? 1. : 0.;
        }
      }
      if (s.outwards.found() && faces(s.outwards, other)) counts.outward += 1.;
    }
    return counts;
  }
  bool faces(const Ray_hit& hit, const int region) const
  {
    return m_graph.region_of(m_patches.of_point[hit.disk]) == region;
  }

  double border_length(const int region) const
  {
    double sum = 0.;
    for (const auto& entry : m_graph.seams(region)) sum += entry.second.profile.length;
    return sum;
  }

  void add_visibility(int a, int b, std::vector<float>& f);
  void add_concavity(const Seam& seam, std::vector<float>& f) const;
  void add_diameters(int a, int b, const Sight_counts& of_a, const Sight_counts& of_b,
                     std::vector<float>& f) const;
  void add_sizes(int a, int b, const Sight_counts& of_a, std::vector<float>& f) const;
  void add_shapes(int a, int b, std::vector<float>& f) const;
  void add_costs(int a, int b, std::vector<float>& f);

  Region_graph& m_graph;
  const Patches& m_patches;
  const std::vector<Diameter_sample>& m_samples;
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

inline void Pair_features::add_concavity(const Seam& seam, std::vector<float>& f) const
{
  add_feature(f, seam.concave_share());
  add_feature(f, seam.profile.edge_positive / seam.edges);
  add_feature(f, seam.profile.edge_signed / seam.edges);
  for (const auto& at : seam.profile.radii)
    for (const double sum : {at.signed_sum, at.positive_sum, at.over_15, at.over_30, at.under_20})
      add_feature(f, sum / seam.edges);
  add_feature(f,
              (seam.profile.radii[1].signed_sum - seam.profile.radii[0].signed_sum) / seam.edges);
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

inline void Pair_features::add_sizes(const int a, const int b, const Sight_counts& of_a,
                                     std::vector<float>& f) const
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  const double seam = m_graph.seam(a, b).profile.length;
  const auto ratio = [](const double x, const double y) { return y > 0. ? x / y : missing(); };
  add_feature(f, first.size / m_graph.total_size());
  add_feature(f, second.size / m_graph.total_size());
  add_feature(f, ratio(seam, std::sqrt(first.shape.area)));
  add_feature(f, ratio(seam, std::sqrt(second.shape.area)));
  add_feature(f, ratio(seam, border_length(a)));
  add_feature(f, ratio(seam, border_length(b)));
  add_feature(f, of_a.measured > 0. ? seam / std::exp(of_a.mean()) : missing());
}

inline void Pair_features::add_shapes(const int a, const int b, std::vector<float>& f) const
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  Region_shape both = first.shape;
  both += second.shape;
  const Shape_ratios of_a = shape_ratios(first.shape, first.size);
  const Shape_ratios of_b = shape_ratios(second.shape, second.size);
  const Shape_ratios of_u = shape_ratios(both, first.size + second.size);
  for (const double value :
       {of_a.middle_axis, of_b.middle_axis, of_u.middle_axis, of_a.short_axis, of_b.short_axis,
        of_u.short_axis, of_a.normal_mean, of_b.normal_mean, of_u.normal_mean, of_a.normal_least,
        of_b.normal_least, of_u.normal_least})
    add_feature(f, value);
  const Eigen::Vector3d between =
      first.shape.position / first.size - second.shape.position / second.size;
  add_feature(f, between.norm() / of_u.long_axis);
  add_feature(f, of_u.long_axis / (std::max)(of_a.long_axis, of_b.long_axis));
}

/// The hand-made costs of both stages. Trees meet kinds of shape that they were not fitted on with far
/// fewer wrong merges when they know them; fixed here, so that a change of the default moves no table.
inline void Pair_features::add_costs(const int a, const int b, std::vector<float>& f)
{
  const Region &first = m_graph.region(a), &second = m_graph.region(b);
  const bool both = !first.diameters.empty() && !second.diameters.empty();
  const double distance =
      both ? earth_movers_distance(first.diameters, second.diameters, Histogram_scale()) : 0.3;
  const double blindness = 1. - m_graph.visibility(a, b);
  const double concavity = m_graph.seam(a, b).concave_share();
  const double share = (std::min)(first.size, second.size) / m_graph.total_size();
  const double leniency = std::pow((std::min)(1., share / 0.03), 0.08);
  add_feature(f, leniency * (1.33 * blindness + 0.55 * concavity + 0.145 * distance));
  add_feature(f, leniency * (0.114 * blindness + 3.05 * concavity + distance));
}

inline void Pair_features::compute(int a, int b, std::vector<float>& features)
{
  if (m_graph.region(a).size > m_graph.region(b).size) std::swap(a, b);
  features.clear();
  const Seam& seam = m_graph.seam(a, b);
  const Sight_counts of_a = count_sights(a, b), of_b = count_sights(b, a);
  add_visibility(a, b, features);
  add_concavity(seam, features);
  add_diameters(a, b, of_a, of_b, features);
  add_sizes(a, b, of_a, features);
  add_shapes(a, b, features);
  for (const double value :
       {of_a.share(of_a.inward), of_b.share(of_b.inward), of_a.share(of_a.outward),
        of_b.share(of_b.outward), of_a.share(of_a.through_wall), of_b.share(of_b.through_wall),
        of_a.share(of_a.thin), of_b.share(of_b.thin), seam.opposite / seam.edges, m_whole_diameter,
        m_whole_thin})
    add_feature(features, value);
  add_costs(a, b, features);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PAIR_FEATURES_H
