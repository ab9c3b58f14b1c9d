// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgWeaklyConvexSegmentationConcepts
\cgalConcept

What the named parameter `visitor` of `CGAL::weakly_convex_segmentation()` asks for: an object that is told
of the stages of a run and of each merge, to measure, to log or to draw. It is passed by
`std::ref()` and has to live as long as the function runs, or as the
`CGAL::Weakly_convex_segmentation::Segmenter` that was constructed with it.

A model derives publicly from `CGAL::Weakly_convex_segmentation::Visitor`, whose functions do nothing, and
overrides those of interest: the library keeps a pointer to that base, so that its code does not depend on
the visitor's type.

All functions are called from the thread that called the library, also with `CGAL::Parallel_tag`. In a run of
`CGAL::weakly_convex_segmentation()` each value of `CGAL::Weakly_convex_segmentation::Stage` begins and ends
once, in the order in which they are declared, and none within another. A
`CGAL::Weakly_convex_segmentation::Segmenter` runs those up to the signatures when it is constructed,
`segment()` the others, and `refine()` the last two. An exception thrown by a function ends the run, passes
through to the caller, and leaves the label map unchanged.

\cgalHasModel `CGAL::Weakly_convex_segmentation::Visitor`

\sa `CGAL::Weakly_convex_segmentation::Canceled`
*/
class WeaklyConvexSegmentationVisitor
{
public:
  /// is called before a stage begins.
  void stage_begins(CGAL::Weakly_convex_segmentation::Stage stage);

  /// is called after a stage has ended. `size` is the number of things that it made, see
  /// `CGAL::Weakly_convex_segmentation::Visitor::stage_ends()`.
  void stage_ends(CGAL::Weakly_convex_segmentation::Stage stage, std::size_t size);

  /// is called within the stage `CONSENSUS` if the shape has a plane of reflection, whose two sides are decided
  /// together then.
  void symmetry_found(const CGAL::Weakly_convex_segmentation::Symmetry_plane& plane);

  /// is called for each merge of two regions, in the order in which the merge tree keeps them, between the
  /// beginning and the end of the stages `FUSION` and `MERGING`. Each region is named by one of its patches.
  /// Merges after the segments are found, which make the merge tree whole, are told of too. `cost` is what
  /// the merge was charged, without a unit; the largest finite `double` where the regions are not adjacent.
  void merged(int first_patch, int second_patch, double cost);
};
