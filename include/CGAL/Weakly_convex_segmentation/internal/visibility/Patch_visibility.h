// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_PATCH_VISIBILITY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_PATCH_VISIBILITY_H

// Mutual visibility of patches (section 4), and the convexity rank (section 3, equation 1).

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Line_of_sight_query.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns a stride that visits each of `count` numbers once, the first few of them spread over all.
inline std::size_t coprime_stride(const std::size_t count)
{
  std::size_t stride = count * 5 / 8 + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

/// Ratio of unoccluded rays between each pair of patches, computed when first asked for and kept.
class Patch_visibility
{
public:
  Patch_visibility(const Line_of_sight_query& sight, const Patches& patches,
                   const Visibility_parameters& parameters, const bool parallel)
    : m_sight(sight), m_most(parameters.maximum_rays_per_pair), m_parallel(parallel)
  {
    constexpr std::size_t samples_per_patch = 10; // s_vis of section 4
    for (const auto& members : patches.members)
      m_samples.push_back(spread_sample(members, samples_per_patch));
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
    const std::size_t stride = coprime_stride(rays);
    constexpr std::size_t early = 2; // rays that decide a pair if they agree
    std::size_t free = 0, ray = 0;
    Line_of_sight_query::Hint occluder = {}; // it often hides the next points too
    const std::size_t most = m_most > 0 ? (std::min)(m_most, rays) : rays;
    for (std::size_t i = 0; i < most; ++i, ray = (ray + stride) % rays)
    {
      free += m_sight.sees(from[ray % from.size()], to[ray / from.size()], occluder) ? 1 : 0;
      if (i + 1 == early && m_most > 0 && (free == 0 || free == early))
        return free == 0 ? 0.f : 1.f;
    }
    return static_cast<float>(free) / static_cast<float>(most);
  }

  const Line_of_sight_query& m_sight;
  std::size_t m_most;
  bool m_parallel;
  std::vector<std::vector<Index>> m_samples;
  std::unordered_map<std::uint64_t, float> m_known;
};

/// returns the convexity rank |LoS(S)| / |S|^2 (equation 1) of the points `subset`, from at most
/// `sample_size` of them spread over the subset. A line of sight must not leave the shape at its
/// ends by more than `tolerance` degrees. A point sees itself.
inline double convexity_rank(const Line_of_sight_query& sight, const std::vector<Index>& subset,
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

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_PATCH_VISIBILITY_H
