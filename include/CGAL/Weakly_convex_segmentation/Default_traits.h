// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_DEFAULT_TRAITS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_DEFAULT_TRAITS_H

// How coordinates are read, where the named parameter `geom_traits` is not given.

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Calls the member functions `x()`, `y()` and `z()`, which points and vectors of all %CGAL kernels have, of
/// one kernel or of several.
///
/// \cgalModels `WeaklyConvexSegmentationTraits`
struct Default_traits
{
  struct Compute_x_3
  {
    template <typename Vector>
    auto operator()(const Vector& v) const -> decltype(v.x())
    {
      return v.x();
    }
  };
  struct Compute_y_3
  {
    template <typename Vector>
    auto operator()(const Vector& v) const -> decltype(v.y())
    {
      return v.y();
    }
  };
  struct Compute_z_3
  {
    template <typename Vector>
    auto operator()(const Vector& v) const -> decltype(v.z())
    {
      return v.z();
    }
  };
  Compute_x_3 compute_x_3_object() const { return {}; }
  Compute_y_3 compute_y_3_object() const { return {}; }
  Compute_z_3 compute_z_3_object() const { return {}; }
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_DEFAULT_TRAITS_H
