// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_LINE_OF_SIGHT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_LINE_OF_SIGHT_H

// Lines of sight between the triangles of a closed mesh, in place of the disks of points.

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <limits>
#include <memory>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Lines of sight inside of a closed triangle mesh, exact: the triangles are in the way, in
/// a `CGAL::AABB_tree`.
///
/// It refers to the mesh, which has to live as long and stay as it is. Copies share the tree. Queries may run in several threads at once if the kernel
/// of the points allows it.
///
/// \tparam TriangleMesh a model of `FaceListGraph` of triangles, closed, with normals that point outwards
/// \tparam VertexPointMap a model of `ReadablePropertyMap` from its vertices to points of a %CGAL kernel
///
/// \cgalModels `WeaklyConvexSegmentationLineOfSight`
template <typename TriangleMesh,
          typename VertexPointMap =
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>
class Mesh_line_of_sight
{
public:
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using Kernel = typename Kernel_traits<Point_3>::Kernel;
  using Vector_3 = typename Kernel::Vector_3;

  /// builds the tree: O(n log n) for n faces.
  /// \param mesh the triangles
  /// \param points those of the vertices
  /// \param clearance so much of each line counts at neither end, relative to the diagonal of the bounding
  ///   box: the ends lie on the surface but for rounding, or for noise that was smoothed
  Mesh_line_of_sight(const TriangleMesh& mesh, const VertexPointMap& points,
                     const double clearance = 1e-4)
    : m_mesh(&mesh), m_points(points),
      m_tree(std::make_shared<Tree>(faces(mesh).begin(), faces(mesh).end(), mesh, points))
  {
    m_tree->build();
    const Bbox_3 box = m_tree->empty() ? Bbox_3() : Bbox_3(m_tree->bbox());
    m_clearance = clearance * std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(),
                                         box.zmax() - box.zmin());
  }
  /// takes the points of the mesh.
  explicit Mesh_line_of_sight(const TriangleMesh& mesh)
    : Mesh_line_of_sight(mesh, get(CGAL::vertex_point, mesh))
  {}

  /// returns whether the segment between two points of the surface lies inside of the mesh. Complexity:
  /// O(log n) on average.
  bool sees(const Point_3& p, const Point_3& q) const
  {
    const Vector_3 along = q - p;
    const double length = std::sqrt(to_double(along.squared_length()));
    if (length <= 2. * m_clearance) return true;
    const Vector_3 step = along * (m_clearance / length);
    if (m_tree->do_intersect(typename Kernel::Segment_3(p + step, q - step))) return false;
    return is_inside(p + step, along);
  }
  /// returns how far a ray along a unit vector goes until it leaves the mesh; infinity if it does not.
  double distance_to_exit(const Point_3& p, const Vector_3& direction) const
  {
    return distance_to(p, direction, 1.);
  }
  /// returns how far it goes until it enters the mesh from outside; infinity if it does not.
  double distance_to_entry(const Point_3& p, const Vector_3& direction) const
  {
    return distance_to(p, direction, -1.);
  }

private:
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Primitive = AABB_face_graph_triangle_primitive<TriangleMesh, VertexPointMap>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  using Tree = AABB_tree<AABB_traits_3<Kernel, Primitive>>;
#else
  using Tree = AABB_tree<AABB_traits<Kernel, Primitive>>;
#endif

  typename Kernel::Triangle_3 triangle(const Face f) const
  {
    const auto h = halfedge(f, *m_mesh);
    return {get(m_points, source(h, *m_mesh)), get(m_points, target(h, *m_mesh)),
            get(m_points, target(next(h, *m_mesh), *m_mesh))};
  }

  /// returns the normal of a face of any length.
  Vector_3 normal(const Face f) const
  {
    const typename Kernel::Triangle_3 t = triangle(f);
    return cross_product(t[1] - t[0], t[2] - t[0]);
  }

  /// returns whether the surface is left where a ray meets it first.
  bool is_inside(const Point_3& p, const Vector_3& direction) const
  {
    const auto face = m_tree->first_intersected_primitive(typename Kernel::Ray_3(p, direction));
    return face && normal(*face) * direction > 0;
  }

  double distance_to(const Point_3& p, const Vector_3& direction, const double side) const
  {
    const Point_3 start = p + m_clearance * direction;
    const auto skip = [&](const Face f) { return !(side * (normal(f) * direction) > 0); };
    const auto face =
        m_tree->first_intersected_primitive(typename Kernel::Ray_3(start, direction), skip);
    if (!face) return std::numeric_limits<double>::infinity();
    const Vector_3 n = normal(*face);
    return to_double((n * (triangle(*face)[0] - p)) / (n * direction));
  }

  const TriangleMesh* m_mesh;
  VertexPointMap m_points;
  std::shared_ptr<Tree> m_tree;
  double m_clearance;
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_LINE_OF_SIGHT_H
