// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgWeaklyConvexSegmentationConcepts
\cgalConcept

What the named parameter `line_of_sight` of `CGAL::weakly_convex_segmentation()` asks for: an object that tells
which points see each other inside of the shape, and how far it is from a point to the opposite side.

All points, vectors and distances are in the coordinates of the input. The points are those that the method
works on: points of the input, centroids of faces or of pieces of them. They lie on the surface but for
rounding to single precision, relative to the extent of the shape, and but for the smoothing of noise
(`CGAL::Weakly_convex_segmentation::Sampling_parameters::denoise`). So a model should not count what is very near
to the beginning or the end of a line. How near is up to the model.

A model is copy constructible. It is copied when it is passed, and a
`CGAL::Weakly_convex_segmentation::Segmenter` keeps a copy: large data should be shared by the copies, and what
a copy refers to has to live as long as the function runs or the segmenter is used. With `CGAL::Parallel_tag` the
member functions of one object are called by several threads at once.

`sees()` is what visibility and convexity ranks rest on. The distances are what the shape diameters and the
closure of regions rest on. With `CGAL::Weakly_convex_segmentation::Diameter_rule::OWN_POINTS`, as in the
`paper` preset, they are not asked for.

The same question has to have the same answer throughout a run, so that the result does not depend on the number
of threads. Exceptions end the run and pass through to the caller.

\cgalHasModel `CGAL::Weakly_convex_segmentation::Disk_line_of_sight`
\cgalHasModel `CGAL::Weakly_convex_segmentation::Mesh_line_of_sight`

\sa `CGAL::Weakly_convex_segmentation::Parameters`
*/
class WeaklyConvexSegmentationLineOfSight
{
public:
  /// A point, which can be constructed from three `double`: its coordinates.
  typedef unspecified_type Point_3;
  /// A vector, which can be constructed from three `double`: its coordinates.
  typedef unspecified_type Vector_3;

  /// returns whether the line segment between two points lies inside of the shape; where surface is missing,
  /// whether none that is known is in its way.
  ///
  /// \pre `p` and `q` are on the surface, up to rounding and smoothing. They may coincide.
  /// \post `sees(p, q)` is the same as `sees(q, p)`: a pair is asked for in one order only.
  ///
  /// Complexity: O(log n) expected, for n elements of the surface. It is called for at most
  /// `CGAL::Weakly_convex_segmentation::Visibility_parameters::maximum_rays_per_pair` lines of each pair of patches whose
  /// visibility is asked for, and for the convexity ranks of the segments.
  bool sees(const Point_3& p, const Point_3& q) const;

  /// returns how far a ray goes until it first leaves the shape; infinity if it does not.
  ///
  /// The return type is `double` or another type that `CGAL::to_double()` takes.
  ///
  /// \pre `p` is on the surface, up to rounding and smoothing; `direction` has unit length and lies
  ///   in a cone about the reversed normal. Where normals are wrong it may point outwards.
  /// \post A distance over the extent of the shape, one of at most 0, and one that is not a number count as
  ///   infinity.
  ///
  /// Complexity: O(log n) expected. It is called for
  /// 2,000 points at most, with 10 directions and the reversed normal.
  double distance_to_exit(const Point_3& p, const Vector_3& direction) const;

  /// returns how far a ray goes until it first enters the shape, from outside; infinity if it does not. It
  /// tells of walls on the other side of a gap or of a cavity.
  ///
  /// \pre `p` is on the surface, up to rounding and smoothing; `direction` is the unit normal.
  /// \post that of `distance_to_exit()`
  ///
  /// Complexity: O(log n) expected. It is called once for each of the points above, with the normal.
  double distance_to_entry(const Point_3& p, const Vector_3& direction) const;
};
