// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_MERGE_TREE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_MERGE_TREE_H

#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/number_labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The order in which the patches were merged.
///
/// Leaves are the patches, numbered from 0. The merges that made the segments come first; those
/// after `number_of_accepted_merges()` go on, by growing cost, until one segment is left, so that
/// a finer or coarser segmentation can be had without running again. There is one merge less than there are
/// patches. It may be read from several threads at once.
class Merge_tree
{
public:
  /// One merge of two regions, each named by one of the patches in it.
  struct Merge
  {
    int first;   ///< a patch of the first region
    int second;  ///< a patch of the second region
    double cost; ///< cost of the criterion that merged them, without a unit
  };

  /// makes a tree without patches.
  Merge_tree() = default;
  /// makes a tree of patches that are not merged yet.
  explicit Merge_tree(const std::size_t number_of_patches) : m_number_of_patches(number_of_patches)
  {}

  std::size_t number_of_patches() const { return m_number_of_patches; } ///< number of leaves
  const std::vector<Merge>& merges() const { return m_merges; }         ///< all merges, in order
  /// number of merges after which the patches had become components
  std::size_t number_of_fusions() const { return m_fusions; }
  /// number of merges after which the components had become segments
  std::size_t number_of_accepted_merges() const { return m_accepted; }

  /// returns the region of each patch after the first `number_of_merges` merges, numbered from 0 in
  /// the order of the patches.
  /// Complexity: linear in the number of patches, up to the inverse Ackermann function.
  std::vector<int> labels_after(const std::size_t number_of_merges) const;

  /// returns the region of each patch when `number_of_segments` are left (at least 1; at most as
  /// many as there are patches).
  /// \throws std::invalid_argument if there are no such regions.
  /// Complexity: that of `labels_after()`.
  std::vector<int> labels_for(const std::size_t number_of_segments) const
  {
    if (number_of_segments == 0 || number_of_segments > m_number_of_patches)
      throw std::invalid_argument("the merge tree has 1 to " + std::to_string(m_number_of_patches) +
                                  " segments, " + std::to_string(number_of_segments) +
                                  " were asked for");
    return labels_after(m_number_of_patches - number_of_segments);
  }

  /// returns the region of each patch if merging had stopped at the first merge of components, in
  /// order, that costs more than `threshold`. Merges within the segments count as no more than the threshold
  /// that the segments were made with, those beyond as more. Costs are on the scale of `Parameters::merging_threshold`.
  /// Complexity: that of `labels_after()`, and linear in the number of merges.
  std::vector<int> labels_at_cost(const double threshold) const
  {
    std::size_t i = m_fusions;
    while (i < m_merges.size() && decisive_cost(i) <= threshold) ++i;
    return labels_after(i);
  }

  /// \cond SKIP_IN_MANUAL
  void add(const int first, const int second, const double cost)
  {
    m_merges.push_back({first, second, cost});
  }
  void set_fused() { m_fusions = m_merges.size(); }
  void set_accepted(const double threshold, const std::size_t fewest_segments = 0)
  {
    m_accepted = (std::min)(m_merges.size(),
                            m_number_of_patches - (std::min)(m_number_of_patches, fewest_segments));
    m_fusions = (std::min)(m_fusions, m_accepted);
    m_threshold = threshold;
  }
  /// \endcond

private:
  /// Segments were decided at a threshold, by the costs in several sets of patches: what made them costs no
  /// more than that here, and what goes on costs more.
  double decisive_cost(const std::size_t i) const
  {
    if (i < m_accepted) return (std::min)(m_merges[i].cost, m_threshold);
    return (std::max)(m_merges[i].cost,
                      std::nextafter(m_threshold, std::numeric_limits<double>::infinity()));
  }

  std::size_t m_number_of_patches = 0;
  std::size_t m_fusions = 0;
  std::size_t m_accepted = 0;
  double m_threshold = 0.; ///< at which the segments were decided
  std::vector<Merge> m_merges;
};

inline std::vector<int> Merge_tree::labels_after(const std::size_t number_of_merges) const
{
  internal::Disjoint_sets<int> regions(m_number_of_patches);
  const std::size_t last = (std::min)(number_of_merges, m_merges.size());
  for (std::size_t i = 0; i < last; ++i) regions.join(m_merges[i].first, m_merges[i].second);
  std::vector<int> labels;
  labels.reserve(m_number_of_patches);
  for (int patch = 0; patch < static_cast<int>(m_number_of_patches); ++patch)
    labels.push_back(regions.find(patch));
  internal::number_labels(labels);
  return labels;
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_MERGE_TREE_H
