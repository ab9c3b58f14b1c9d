// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgWeaklyConvexSegmentationConcepts
\cgalConcept

What the named parameter `geom_traits` of `CGAL::weakly_convex_segmentation()` asks for: how the coordinates of
the caller's points and vectors are read.

Coordinates are read once, before the first stage, and converted by `CGAL::to_double()`. Nothing else is done
with points and vectors: a model has no predicates and no constructions, and names no types. The types of
points and vectors are those of the property maps; vectors are read only where normals are given.

A model is copy constructible. The member functions, and the function objects that they return, are constant.
With `CGAL::Parallel_tag` they are called by several threads at once if the input is a range of points.

\cgalHasModel all models of `Kernel`
\cgalHasModel `CGAL::Weakly_convex_segmentation::Default_traits`
*/
class WeaklyConvexSegmentationTraits
{
public:
  /// returns a function object that returns the *x*-coordinate of a point or of a vector.
  ///
  /// \post `CGAL::to_double()` takes what the function object returns. If it is not finite, it is refused with a
  ///   `std::invalid_argument`.
  ///
  /// Complexity: O(1), once for each point and for each normal; for a mesh once for each corner of each face.
  unspecified_type compute_x_3_object() const;
  /// returns the same for the *y*-coordinate.
  unspecified_type compute_y_3_object() const;
  /// returns the same for the *z*-coordinate.
  unspecified_type compute_z_3_object() const;
};
