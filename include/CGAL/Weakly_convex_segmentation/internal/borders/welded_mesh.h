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

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Vertices are numbered by where they lie, so that nothing depends on the order of the input.
struct Welded_mesh
{
  /// A face at an edge.
  struct Side
  {
    std::array<Index, 2> ends; ///< ascending
    Index face;
    bool is_forward; ///< the face has the ends in this order
    bool operator<(const Side& s) const
    {
      return ends < s.ends || (ends == s.ends && face < s.face);
    }
  };
  std::vector<Double3> vertices;
  std::vector<Index> vertex_of_point;
  Compressed_rows<Index> faces;   ///< the vertices of each face
  Compressed_rows<Side> at_edges; ///< the sides of each edge
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
  std::vector<Welded_mesh::Side>& sides = mesh.at_edges.entries;
  for (Index f = 0; f < mesh.faces.size(); ++f)
  {
    const auto row = mesh.faces[f];
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const Index a = row.first[i], b = row.first[(i + 1) % row.size()];
      if (a != b) sides.push_back({{(std::min)(a, b), (std::max)(a, b)}, f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i <= sides.size(); ++i)
    if (i == sides.size() || sides[i].ends != sides[i - 1].ends) mesh.at_edges.first.push_back(i);
}

/// returns a mesh of polygons of indices of points.
inline Welded_mesh weld(const std::vector<Double3>& points, const Compressed_rows<Index>& polygons)
{
  const auto place = [&](const Index i) {
    return Coordinates{points[i].x, points[i].y, points[i].z};
  };
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](const Index i, const Index j) { return place(i) < place(j); });
  Welded_mesh mesh;
  mesh.vertex_of_point.resize(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || place(order[i]) != place(order[i - 1])) mesh.vertices.push_back(points[order[i]]);
    mesh.vertex_of_point[order[i]] = static_cast<Index>(mesh.vertices.size() - 1);
  }
  mesh.faces.first = polygons.first;
  for (const Index i : polygons.entries) mesh.faces.entries.push_back(mesh.vertex_of_point[i]);
  find_edges(mesh);
  return mesh;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_WELDED_MESH_H
