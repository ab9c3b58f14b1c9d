// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/Disk_tree.h>
#include <CGAL/Weakly_convex_segmentation/internal/Line_of_sight_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

// Mutual visibility of points and of patches (sections 3 and 4).
//
// The paper is silent on how near the ends of a line the disks begin to occlude, and on whether a
// line that passes outside of the shape, over a gap, counts: see `Parameters::clearance_factor` and
// `Parameters::outside_tolerance`.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the disk of every point, as large as the mean distance to its neighbors.
inline std::vector<Disk> make_disks(const Oriented_points& points, const Neighbor_graph& graph,
                                    const double radius_factor)
{
  std::vector<Disk> disks(points.size());
  for (std::size_t i = 0; i < disks.size(); ++i)
    disks[i] = {points.positions[i], points.normals[i],
                static_cast<float>(radius_factor) * graph.spacing[i]};
  return disks;
}

/// returns `count` members spread evenly: members are in spatial order, so equal steps are fair.
inline std::vector<Index> spread_sample(const std::vector<Index>& members, const std::size_t count)
{
  if (members.size() <= count) return members;
  std::vector<Index> sample(count);
  for (std::size_t i = 0; i < count; ++i)
    sample[i] = members[(2 * i + 1) * members.size() / (2 * count)];
  return sample;
}

/// Lines of sight between the points of one shape: what they see, and what faces them. The shape's disks
/// are in the way, or what the caller has in their place.
class Sight
{
public:
  Sight(const Oriented_points& points, const Neighbor_graph& graph, const Parameters& parameters,
        const Line_of_sight_functions& own = {})
    : m_points(points), m_own(own),
      m_tree(own.sees ? std::vector<Disk>()
                      : make_disks(points, graph, parameters.disk_radius_factor),
             static_cast<float>(parameters.clearance_factor),
             std::sin(radians(parameters.grazing_tolerance))),
      m_outside_slope(parameters.outside_tolerance < 90.
                          ? std::sin(radians(parameters.outside_tolerance))
                          : 2.f)
  {
    if (own.sees) m_nearest = std::make_unique<Nearest_points>(points.positions);
  }

  const Oriented_points& points() const { return m_points; }
  const Disk_tree& tree() const { return m_tree; }

  /// returns whether the segment from `i` to `j` leaves the surface inwards at both ends, up to the
  /// tolerance, and nothing is in its way.
  bool sees(const Index i, const Index j) const
  {
    Disk_tree::Hint hint = Disk_tree::no_hint;
    return sees(i, j, hint);
  }
  /// the same for one of many lines between the same parts, see `Disk_tree::unoccluded()`
  bool sees(const Index i, const Index j, Disk_tree::Hint& hint) const
  {
    return i == j || (is_within(i, j, m_outside_slope) && is_free(i, j, hint));
  }

  /// the same with a tolerance of its own, in degrees
  bool sees_inside(const Index i, const Index j, const double tolerance) const
  {
    Disk_tree::Hint hint = Disk_tree::no_hint;
    return i == j || (is_within(i, j, std::sin(radians(tolerance))) && is_free(i, j, hint));
  }

  /// returns where a ray from a point along a unit vector first leaves the shape.
  Ray_hit exit(const Index i, const Vector3& direction) const
  {
    if (!m_own.sees) return m_tree.first_exit(m_points.positions[i], direction, 1.f);
    return hit_of_own(i, direction, m_own.distance_to_exit);
  }
  /// returns where it first enters the shape, from outside.
  Ray_hit entry(const Index i, const Vector3& direction) const
  {
    if (!m_own.sees) return m_tree.first_entry(m_points.positions[i], direction, 1.f);
    return hit_of_own(i, direction, m_own.distance_to_entry);
  }

private:
  bool is_within(const Index i, const Index j, const float slope) const
  {
    if (slope > 1.f) return true;
    const Vector3 direction = m_points.positions[j] - m_points.positions[i];
    const float highest = slope * length(direction);
    return dot(m_points.normals[i], direction) <= highest &&
           -dot(m_points.normals[j], direction) <= highest;
  }

  bool is_free(const Index i, const Index j, Disk_tree::Hint& hint) const
  {
    const Vector3 &p = m_points.positions[i], &q = m_points.positions[j];
    if (!m_own.sees) return m_tree.unoccluded(p, q, hint);
    return m_own.sees(m_points.placement.position(p), m_points.placement.position(q));
  }

  /// returns the point that is nearest to where the caller's surface is met, within the extent.
  template <typename Distance>
  Ray_hit hit_of_own(const Index i, const Vector3& direction, const Distance& distance_of) const
  {
    const Vector3& p = m_points.positions[i];
    const double distance =
        distance_of(m_points.placement.position(p), m_points.placement.direction(direction)) /
        m_points.extent;
    if (!(distance > 0. && distance <= 1.)) return {};
    Ray_hit hit;
    hit.distance = static_cast<float>(distance);
    m_nearest->nearest(p + hit.distance * direction, 1,
                       [&hit](const Index nearest, float) { hit.disk = nearest; });
    return hit;
  }

  const Oriented_points& m_points;
  Line_of_sight_functions m_own;
  Disk_tree m_tree; ///< without disks where the caller has a line of sight
  std::unique_ptr<Nearest_points> m_nearest;
  float m_outside_slope;
};

/// Ratio of unoccluded rays between each pair of patches, computed when first asked for and kept.
class Patch_visibility
{
public:
  Patch_visibility(const Sight& sight, const Patches& patches, const Parameters& parameters,
                   const bool parallel)
    : m_sight(sight), m_early(parameters.rays_for_early_decision),
      m_most(parameters.maximum_rays_per_pair), m_parallel(parallel)
  {
    for (const auto& members : patches.members)
      m_samples.push_back(spread_sample(members, parameters.samples_per_patch));
  }

  std::size_t number_of_patches() const { return m_samples.size(); }

  /// returns the ratio of the sampled lines between the patches that are unoccluded, in [0, 1].
  double operator()(const int a, const int b)
  {
    const auto [slot, is_new] = m_known.emplace(key(a, b), 0.f);
    if (is_new) slot->second = cast(static_cast<std::size_t>((std::min)(a, b)), (std::max)(a, b));
    return slot->second;
  }

  /// computes all that is not known yet of `pairs`, on several threads if there are.
  void prepare(const std::vector<std::pair<int, int>>& pairs)
  {
    std::vector<std::pair<int, int>> missing;
    for (const auto& [a, b] : pairs)
      if (m_known.emplace(key(a, b), -1.f).second)
        missing.push_back({(std::min)(a, b), (std::max)(a, b)});
    std::vector<float> ratios(missing.size());
    parallel_for(
        missing.size(), m_parallel,
        [&](const std::size_t i) { ratios[i] = cast(missing[i].first, missing[i].second); }, 4);
    for (std::size_t i = 0; i < missing.size(); ++i)
      m_known[key(missing[i].first, missing[i].second)] = ratios[i];
  }

  /// takes a ratio that was computed before.
  void remember(const int a, const int b, const float ratio) { m_known[key(a, b)] = ratio; }

  /// number of pairs of patches that were asked for so far
  std::size_t known_pairs() const { return m_known.size(); }

private:
  static std::uint64_t key(const int a, const int b)
  {
    return static_cast<std::uint64_t>((std::min)(a, b)) << 32 |
           static_cast<std::uint64_t>((std::max)(a, b));
  }

  /// Most pairs see each other fully or not at all: they are decided by the first rays, which a
  /// stride coprime to the count spreads over both patches.
  float cast(const std::size_t a, const std::size_t b) const
  {
    const std::vector<Index>&from = m_samples[a], &to = m_samples[b];
    const std::size_t rays = from.size() * to.size();
    std::size_t stride = rays * 5 / 8 + 1;
    while (common_divisor(stride, rays) != 1) ++stride;
    std::size_t free = 0, ray = 0;
    Disk_tree::Hint occluder = Disk_tree::no_hint; // it often hides the next points too
    const std::size_t most = m_most > 0 ? (std::min)(m_most, rays) : rays;
    for (std::size_t i = 0; i < most; ++i, ray = (ray + stride) % rays)
    {
      free += m_sight.sees(from[ray % from.size()], to[ray / from.size()], occluder) ? 1 : 0;
      if (i + 1 == m_early && (free == 0 || free == m_early)) return free == 0 ? 0.f : 1.f;
    }
    return static_cast<float>(free) / static_cast<float>(most);
  }

  static std::size_t common_divisor(std::size_t a, std::size_t b)
  {
    while (b != 0) a = std::exchange(b, a % b);
    return a;
  }

  const Sight& m_sight;
  std::size_t m_early, m_most;
  bool m_parallel;
  std::vector<std::vector<Index>> m_samples;
  std::unordered_map<std::uint64_t, float> m_known;
};

/// returns the convexity rank |LoS(S)| / |S|^2 (equation 1) of the points `subset`, from at most
/// `sample_size` of them spread over the subset. A line of sight must not leave the shape at its
/// ends by more than `tolerance` degrees. A point sees itself.
inline double convexity_rank(const Sight& sight, const std::vector<Index>& subset,
                             const std::size_t sample_size, const double tolerance)
{
  if (subset.empty()) return 1.;
  const std::vector<Index> sample = spread_sample(subset, sample_size);
  std::size_t pairs = sample.size();
  for (std::size_t i = 0; i < sample.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (sight.sees_inside(sample[i], sample[j], tolerance)) pairs += 2;
  return static_cast<double>(pairs) / static_cast<double>(sample.size() * sample.size());
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_H
