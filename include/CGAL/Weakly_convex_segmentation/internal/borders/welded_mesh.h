// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_WELDED_MESH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_WELDED_MESH_H

// A mesh whose corners at one position are one vertex, as faces are split along borders in it.

#include <CGAL/Weakly_convex_segmentation/internal/input/denoise_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/soup_orientation.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Vertices are numbered by where they lie, so that nothing depends on the order of the input.
struct Welded_mesh
{
  std::vector<Double3> vertices;
  std::vector<Index> vertex_of_point;
  Compressed_rows<Index> faces;           ///< the vertices of each face
  Compressed_rows<Polygon_side> at_edges; ///< the sides of each edge
};

/// returns twice the area of a polygon, as a vector along its normal.
inline Double3 twice_area(const std::vector<Double3>& corners)
{
  Double3 sum;
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return sum;
}

inline std::vector<Double3> corners_of(const Welded_mesh& mesh, const Index face)
{
  std::vector<Double3> result;
  for (const Index v : mesh.faces[face]) result.push_back(mesh.vertices[v]);
  return result;
}

/// returns the angle between two vectors in radians; 0 if one has no direction.
inline double angle_between(const Double3& a, const Double3& b)
{
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// fills the edges.
inline void find_edges(Welded_mesh& mesh)
{
  std::vector<Polygon_side>& sides = mesh.at_edges.entries;
  sides = sorted_sides({mesh.faces.entries.begin(), mesh.faces.entries.end()}, mesh.faces.first);
  for (std::size_t i = 1; i <= sides.size(); ++i)
    if (i == sides.size() || sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high)
      mesh.at_edges.first.push_back(i);
}

/// returns a mesh of polygons of indices of points.
inline Welded_mesh weld(const std::vector<Double3>& points, const Compressed_rows<Index>& polygons)
{
  std::vector<Coordinates> places;
  for (const Double3& p : points) places.push_back({p.x, p.y, p.z});
  Mesh_vertices vertices;
  weld_corners(places, false, vertices);
  Welded_mesh mesh;
  for (const Coordinates& p : vertices.positions) mesh.vertices.push_back({p[0], p[1], p[2]});
  mesh.vertex_of_point = std::move(vertices.of_corner);
  mesh.faces.first = polygons.first;
  for (const Index i : polygons.entries) mesh.faces.entries.push_back(mesh.vertex_of_point[i]);
  find_edges(mesh);
  return mesh;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_WELDED_MESH_H
