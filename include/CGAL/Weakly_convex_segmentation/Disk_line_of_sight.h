// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_DISK_LINE_OF_SIGHT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_DISK_LINE_OF_SIGHT_H

// Lines of sight between points as disks (section 3), for points other than those that are segmented.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/check_call.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/estimate_normals.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Line_of_sight_query.h>

#include <CGAL/tags.h>

#include <memory>
#include <utility>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Lines of sight inside of a shape of points: each is a disk across its normal, as large as the mean
/// distance to its neighbors, and disks are in the way (section 3 of the paper).
///
/// This is what a segmentation makes of its own points, or of their representatives. Made of other points,
/// such as all those of a dense scan, or a clean scan of the same object, it lets these be in the way. It
/// refers to nothing; copies share the disks. Queries may run in several threads at once. Points are taken as
/// they are: noise is not smoothed, and normals that point inwards are not turned.
///
/// \tparam Kernel a %CGAL kernel, or another class with `Point_3` and `Vector_3` that can be made of three
///   `double` and have `x()`, `y()` and `z()`
///
/// \cgalModels `WeaklyConvexSegmentationLineOfSight`
template <typename Kernel>
class Disk_line_of_sight
{
public:
  using Point_3 = typename Kernel::Point_3;
  using Vector_3 = typename Kernel::Vector_3;

  /// reads a range of points, a `CGAL::Point_set_3` or a mesh, each face as a point.
  /// \param input all of it is read before the constructor returns
  /// \param np `point_map`, `normal_map`, `vertex_point_map`, `face_index_map` and `geom_traits` as for
  ///   `weakly_convex_segmentation()`, and `segmentation_parameters`, of which `number_of_neighbors`
  ///   and `grazing_tolerance` count
  /// \throws std::invalid_argument if there are no points, coordinates are not finite, or a parameter is out of
  ///   its range
  ///
  /// Complexity: O(n log n) for n points, on one thread.
  template <typename Input, typename NamedParameters = parameters::Default_named_parameters>
  explicit Disk_line_of_sight(const Input& input,
                              const NamedParameters& np = parameters::default_values())
  {
    const auto& plain = internal::as_cgal(np);
    const Parameters parameters = internal::read_parameters(plain);
    parameters.check();
    internal::Raw_shape raw = internal::read_input<Sequential_tag>(input, plain);
    if (raw.normals.empty()) internal::estimate_normals(raw, {}, parameters.normal_orientation);
    m_shape = std::make_shared<const Shape>(internal::orient_points(raw), parameters);
  }

  /// returns whether no disk is between two points; near the ends of the line none is. Complexity: O(log n)
  /// on average.
  bool sees(const Point_3& p, const Point_3& q) const
  {
    return m_shape->sight.is_free(inside(p), inside(q));
  }
  /// returns how far a ray along a unit vector goes until it meets a disk from behind; infinity if it does
  /// not within the extent of the shape.
  double distance_to_exit(const Point_3& p, const Vector_3& direction) const
  {
    return m_shape->points.extent * m_shape->sight.exit(inside(p), turned(direction)).distance;
  }
  /// returns how far it goes until it meets one from the front; infinity likewise.
  double distance_to_entry(const Point_3& p, const Vector_3& direction) const
  {
    return m_shape->points.extent * m_shape->sight.entry(inside(p), turned(direction)).distance;
  }

private:
  template <typename Vector>
  static internal::Coordinates coordinates(const Vector& v)
  {
    return {to_double(v.x()), to_double(v.y()), to_double(v.z())};
  }
  internal::Vector3 inside(const Point_3& p) const
  {
    return m_shape->points.placement.point(coordinates(p));
  }
  internal::Vector3 turned(const Vector_3& v) const
  {
    return m_shape->points.placement.vector(coordinates(v));
  }

  /// The points, and the disks that are made of them.
  struct Shape
  {
    internal::Oriented_points points;
    internal::Line_of_sight_query sight;

    Shape(internal::Oriented_points&& p, const Parameters& parameters)
      : points(std::move(p)),
        sight(points, internal::build_neighbor_graph(points, parameters.number_of_neighbors, false),
              parameters)
    {}
  };

  std::shared_ptr<const Shape> m_shape;
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_DISK_LINE_OF_SIGHT_H
