// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_OVERLAY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_OVERLAY_H

// The classes of points that no vote tells apart, and what the votes say about each two of them: the consensus
// decides about classes, of which there are few, not about points.

#include <CGAL/Weakly_convex_segmentation/internal/consensus/votes.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The coarsest partition of which each class lies in one segment of each of some segmentations.
struct Overlay
{
  std::vector<int> of_point;
  std::vector<std::vector<int>> labels; ///< of each class, one a segmentation
  std::vector<double> sizes;            ///< points in each class
};

inline Overlay overlay(const std::vector<Votes>& votes)
{
  Overlay result;
  std::map<std::vector<int>, int> number;
  std::vector<int> labels(votes.size());
  for (std::size_t i = 0; i < votes.front().labels.size(); ++i)
  {
    for (std::size_t s = 0; s < labels.size(); ++s) labels[s] = votes[s].labels[i];
    const auto [slot, is_new] = number.emplace(labels, static_cast<int>(result.sizes.size()));
    if (is_new)
    {
      result.labels.push_back(labels);
      result.sizes.push_back(0.);
    }
    result.of_point.push_back(slot->second);
    result.sizes[slot->second] += 1.;
  }
  return result;
}

/// calls `add(first, second, probability)` for the classes of each two regions that are together in the votes of one
/// set: a point of the one with a point of the other.
template <typename Add>
void for_each_together(const Overlay& classes, const std::vector<Votes>& votes,
                       const std::size_t set, const Add& add)
{
  std::map<int, std::vector<int>> of_region;
  for (int c = 0; c < static_cast<int>(classes.sizes.size()); ++c)
    of_region[classes.labels[c][set]].push_back(c);
  for (const auto& [region, members] : of_region)
  {
    add(members, members, 1.);
    if (votes[set].together.empty()) continue;
    for (const auto& [other, probability] : votes[set].together[region])
    {
      const auto found = of_region.find(other); // refined borders may leave a region no point
      if (found != of_region.end()) add(members, found->second, probability);
    }
  }
}

/// returns how many pairs of points of each two classes are together, a mean over the votes.
inline Eigen::MatrixXd pairs_together(const Overlay& classes, const std::vector<Votes>& votes)
{
  const auto count = static_cast<Eigen::Index>(classes.sizes.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  const auto add =
      [&](const std::vector<int>& first, const std::vector<int>& second, const double probability)
  {
    for (const int a : first)
      for (const int b : second)
        result(b, a) +=
            probability * (classes.sizes[a] * classes.sizes[b]); // symmetric to the last bit
  };
  for (std::size_t s = 0; s < votes.size(); ++s) for_each_together(classes, votes, s, add);
  return result / static_cast<double>(votes.size());
}

/// How many points of one class have their mirror images in another, where there are any.
using Class_images = std::map<std::pair<int, int>, double>;

inline Class_images images_of_classes(const Overlay& classes, const std::vector<Index>& image)
{
  Class_images result;
  for (std::size_t i = 0; i < image.size(); ++i)
    result[{classes.of_point[i], classes.of_point[image[i]]}] += 1.;
  return result;
}

/// returns the classes in groups that no vote has anything to say about together, as those of pieces apart: a shape of
/// many pieces is decided piece by piece.
inline std::vector<std::vector<int>> independent_classes(const Overlay& classes,
                                                         const std::vector<Votes>& votes,
                                                         const Class_images& images)
{
  const int count = static_cast<int>(classes.sizes.size());
  Disjoint_sets<int> sets(static_cast<std::size_t>(count));
  for (std::size_t s = 0; s < votes.size(); ++s)
  {
    std::map<int, int> class_of_region;
    for (int c = 0; c < count; ++c)
      sets.join(class_of_region.emplace(classes.labels[c][s], c).first->second, c);
    for (const auto& [region, c] : class_of_region)
      if (!votes[s].together.empty())
        for (const auto& [other, probability] : votes[s].together[region])
        {
          const auto found = class_of_region.find(other);
          if (found != class_of_region.end() && probability > 0.) sets.join(c, found->second);
        }
  }
  for (const auto& [pair, points] : images) sets.join(pair.first, pair.second);
  std::map<int, std::vector<int>> groups;
  for (int c = 0; c < count; ++c) groups[sets.find(c)].push_back(c);
  std::vector<std::vector<int>> result;
  for (auto& [name, members] : groups) result.push_back(std::move(members));
  return result;
}

/// returns some of the classes alone, without the points.
inline Overlay chosen_classes(const Overlay& classes, const std::vector<int>& chosen)
{
  Overlay result;
  for (const int c : chosen)
  {
    result.labels.push_back(classes.labels[c]);
    result.sizes.push_back(classes.sizes[c]);
  }
  return result;
}

/// returns where the mirror images of the points of each class of a group lie: how many of a row's class in a
/// column's. It is empty if there are no images.
inline Eigen::MatrixXd mirrored_classes(const std::vector<int>& group, const Class_images& images)
{
  const auto count = images.empty() ? 0 : static_cast<Eigen::Index>(group.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index a = 0; a < count; ++a)
    for (auto at = images.lower_bound({group[a], 0});
         at != images.end() && at->first.first == group[a]; ++at)
    {
      const auto b = std::lower_bound(group.begin(), group.end(), at->first.second);
      result(a, b - group.begin()) = at->second;
    }
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_CONSENSUS_OVERLAY_H
