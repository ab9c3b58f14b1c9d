// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_VISITOR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_VISITOR_H

#include <CGAL/Weakly_convex_segmentation/Symmetry_plane.h>

#include <cstddef>
#include <stdexcept>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The stages of the method, in order.
enum class Stage
{
  SAMPLING,   ///< representatives of the input points
  NEIGHBORS,  ///< neighbor graph
  PATCHES,    ///< over-segmentation into nearly convex patches
  VISIBILITY, ///< what lines of sight are cast against (on demand, while merging)
  SIGNATURES, ///< shape diameters
  CONSENSUS,  ///< segments that several sets of patches agree on
  FUSION,     ///< patches into weakly convex components
  MERGING,    ///< components into segments
  REFINEMENT, ///< borders of the segments
  STATISTICS  ///< convexity rank, adjacency and diameter of each segment
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// returns a lower-case name of the stage, which is never freed; `stage` has to be one of the enumeration.
inline const char* stage_name(const Stage stage)
{
  const char* const names[] = {"sampling",  "neighbors", "patches", "visibility", "signatures",
                               "agreement", "fusion",    "merging", "refinement", "statistics"};
  return names[static_cast<int>(stage)];
}

/// \ingroup PkgWeaklyConvexSegmentationRef
/// number of values of `Stage`
constexpr std::size_t number_of_stages = 10;

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Base class of visitors: derive, override what is of interest, and pass the object with the named
/// parameter `visitor(std::ref(object))`. Events come from the calling thread, in the order of the
/// stages. An exception thrown by a visitor ends the run and passes through.
///
/// \cgalModels `WeaklyConvexSegmentationVisitor`
class Visitor
{
public:
  virtual ~Visitor() = default;
  /// called when a stage begins
  virtual void stage_begins(Stage) {}
  /// called when a stage ends; `size` is the number of things that it made: representatives,
  /// neighbor edges, patches, disks, diameters, sets of patches, components, segments, moved points, segments
  virtual void stage_ends(Stage, std::size_t /* size */) {}
  /// called within the consensus if the two sides of a plane are decided together
  virtual void symmetry_found(const Symmetry_plane&) {}
  /// called for each merge with a patch of either region, counted from 0, and the cost that was paid
  virtual void merged(int /* first_patch */, int /* second_patch */, double /* cost */) {}
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Thrown when the callback asks to stop. The label map is left unchanged.
class Canceled : public std::runtime_error
{
public:
  Canceled() : std::runtime_error("the segmentation was canceled by its callback") {}
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_VISITOR_H
