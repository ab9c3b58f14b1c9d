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

#include <CGAL/assertions.h>

#include <cstddef>
#include <optional>
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
  /// whether all normals were turned for the run, see `Parameters::flip_inward_normals`
  bool has_flipped_normals = false;
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
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_RESULT_H
