// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_RESULT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_RESULT_H

#include <CGAL/Weakly_convex_segmentation/Merge_tree.h>
#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Symmetry_plane.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/number_labels.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// What is known of one segment.
struct Segment
{
  std::size_t size = 0; ///< number of input elements (points or faces) with its label
  /// share of the pairs of its points in line of sight, `[0, 1]`, from a sample of 40 points; 1: convex
  double convexity_rank = 0.;
  double diameter = 0.; ///< median shape diameter in units of the input; 0: none measured
  std::vector<std::size_t> neighbors; ///< labels of the adjacent segments, ascending
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The outcome of a segmentation.
///
/// Labels are numbered from 0 without gaps, in the order of the first element in which they occur. Input order
/// is that of `faces(mesh)`, whatever `face_index_map` says, of the range or `Point_set_3`, or of the polygons. It is a
/// value that refers to nothing else: it may be copied, and read from several threads at once.
struct Result
{
  std::vector<int> labels;       ///< label of each input element, in input order
  std::vector<Segment> segments; ///< one for each label
  /// patch of each input element: a leaf of `merge_tree`. Where faces have several points, it is that
  /// of most of them, and a leaf may be without a face.
  std::vector<int> patches;
  Merge_tree merge_tree;                ///< how the patches were merged, down to one segment
  std::size_t number_of_components = 0; ///< number of weakly convex components before merging
  /// whether normals were turned for the run, all or some, see `Parameters::flip_inward_normals`
  bool has_flipped_normals = false;
  /// whether the given normals of a cloud seem to contradict each other, and stayed as they are, as the shape is too
  /// open to tell which are right: without them, normals are estimated, which may be better
  bool has_doubtful_normals = false;
  /// the plane whose two sides were decided together, if there is one, see `Parameters::symmetry_tolerance`
  std::optional<Symmetry_plane> symmetry_plane;

  /// number of segments
  std::size_t number_of_segments() const { return segments.size(); }

  /// returns one label an input element, in input order: the segments with their refined borders, or
  /// the patches or components as they were merged, without refinement. Labels of regions without an
  /// element, which are possible on meshes, are left out: there may be gaps.
  /// \pre `patches` are leaves of `merge_tree`, as they were returned.
  /// Complexity: linear in the number of elements.
  std::vector<int> labels_at(const Level level) const
  {
    if (level == Level::SEGMENTS) return labels;
    const std::vector<int> regions =
        merge_tree.labels_after(level == Level::COMPONENTS ? merge_tree.number_of_fusions() : 0);
    std::vector<int> result(patches.size());
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      CGAL_precondition(patches[i] >= 0 && static_cast<std::size_t>(patches[i]) < regions.size());
      result[i] = regions[static_cast<std::size_t>(patches[i])];
    }
    return result;
  }

  /// returns one label an input element, in input order, for another number of segments. Fewer are those of the
  /// result, with their refined borders, joined in the order of the merge tree; more are regions of the tree
  /// as they were merged, whose borders `Segmenter::refine()` refines.
  /// \param wanted number of segments, at least 1; regions of the tree may be without an element on meshes, then it
  ///   takes more of them
  /// \throws std::invalid_argument if the merge tree does not have so many regions
  /// Complexity: linear in the number of elements, times the number of regions without an element.
  std::vector<int> labels_for(std::size_t wanted) const;
};

namespace internal {

/// returns the patch that stands for each label: that of most of its elements.
inline std::vector<int> patches_of_labels(const std::vector<int>& labels,
                                          const std::vector<int>& patches, const std::size_t number)
{
  std::map<std::pair<int, int>, std::size_t> sizes;
  for (std::size_t i = 0; i < labels.size(); ++i) ++sizes[{labels[i], patches[i]}];
  std::vector<int> result(number, 0);
  std::vector<std::size_t> largest(number, 0);
  for (const auto& [at, size] : sizes)
  {
    const auto label = static_cast<std::size_t>(at.first);
    if (size <= largest[label]) continue;
    largest[label] = size;
    result[label] = at.second;
  }
  return result;
}

} // namespace internal

inline std::vector<int> Result::labels_for(const std::size_t wanted) const
{
  std::vector<int> result = labels;
  merge_tree.labels_for(wanted); // throws if it has not so many
  if (wanted == number_of_segments()) return result;
  const bool is_coarser = wanted < number_of_segments();
  const std::vector<int> of_label =
      internal::patches_of_labels(labels, patches, number_of_segments());
  std::size_t count = 0;
  for (std::size_t regions = wanted; count < wanted && regions <= merge_tree.number_of_patches();
       ++regions)
  {
    const std::vector<int> region = merge_tree.labels_for(regions);
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      const int patch = is_coarser ? of_label[static_cast<std::size_t>(labels[i])] : patches[i];
      result[i] = region[static_cast<std::size_t>(patch)];
    }
    count = internal::number_labels(result);
  }
  return result;
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_RESULT_H
