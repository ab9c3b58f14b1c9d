// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCENES_SCENE_SCORES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCENES_SCENE_SCORES_H

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// Objects of a scene against segments, as the literature of scenes scores them:
//   Richtsfeld et al.: Segmentation of unknown objects in indoor environments. IROS 2012 (F_os, F_us);
//   Stein et al.: Object partitioning using local convexity. CVPR 2014 (overlaps).

namespace Scene_scores {

struct Scores
{
  double over_segmentation =
      0.; ///< share of the objects' points outside of their segment; 0 is best
  double under_segmentation = 0.; ///< the segments' points outside of the object, likewise
  double weighted_overlap = 0.;   ///< intersection over union, weighted by the objects' sizes
  double unweighted_overlap = 0.; ///< the same, each object alike; 1 is best

  void add(const Scores& s, const double weight)
  {
    over_segmentation += weight * s.over_segmentation;
    under_segmentation += weight * s.under_segmentation;
    weighted_overlap += weight * s.weighted_overlap;
    unweighted_overlap += weight * s.unweighted_overlap;
  }
};

/// scores segments against objects, one number a point, negative: table or none. To each object belongs
/// the segment that overlaps it most.
inline Scores score(const std::vector<int>& objects, const std::vector<int>& segments)
{
  if (objects.size() != segments.size())
    throw std::invalid_argument("objects and segments are of different clouds");
  std::map<int, double> object_sizes, segment_sizes;
  std::map<std::pair<int, int>, double> overlaps;
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    if (segments[i] >= 0) segment_sizes[segments[i]] += 1.;
    if (objects[i] < 0) continue;
    object_sizes[objects[i]] += 1.;
    if (segments[i] >= 0) overlaps[{objects[i], segments[i]}] += 1.;
  }
  Scores scores;
  double all = 0., correct = 0., wrong = 0.;
  for (const auto& [object, size] : object_sizes)
  {
    std::pair<double, int> best(0., -1);
    double best_ratio = 0.;
    for (const auto& [pair, overlap] : overlaps)
    {
      if (pair.first != object) continue;
      best = (std::max)(best, {overlap, pair.second});
      best_ratio = (std::max)(best_ratio, overlap / (size + segment_sizes[pair.second] - overlap));
    }
    all += size;
    correct += best.first;
    if (best.second >= 0) wrong += segment_sizes[best.second] - best.first;
    scores.weighted_overlap += size * best_ratio;
    scores.unweighted_overlap += best_ratio;
  }
  if (all == 0.) throw std::invalid_argument("no point belongs to an object; check the labels");
  scores.over_segmentation = 1. - correct / all;
  scores.under_segmentation = wrong / all;
  scores.weighted_overlap /= all;
  scores.unweighted_overlap /= static_cast<double>(object_sizes.size());
  return scores;
}

} // namespace Scene_scores

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCENES_SCENE_SCORES_H
