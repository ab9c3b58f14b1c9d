// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_BORDER_MESH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_BORDER_MESH_H

// The faces of a mesh that lie near the borders of a labeling, with their true edges and vertices: all that is
// looked at when borders are straightened. The rest of the mesh is not even welded.

#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// An edge between two faces near a border.
struct Border_edge
{
  std::array<Index, 2> ends;
  std::array<Index, 2> faces;
  float length = 0.f;
  float concavity = 0.f; ///< as of a `Neighbor`
  float cost = 0.f;      ///< of a border along it

  Index other_end(const Index v) const { return ends[0] == v ? ends[1] : ends[0]; }
};

/// The faces near borders. Faces, edges and vertices are numbered by where they lie, so that nothing depends on
/// the order of the input.
struct Border_mesh
{
  std::vector<Index> faces;     ///< of the mesh
  std::vector<char> may_change; ///< of each of these: all of its edges are known
  std::vector<float> areas;
  std::vector<Vector3> vertices;
  std::vector<Border_edge> edges;
  Compressed_rows<Index> vertices_of_face, edges_of_face, faces_of_vertex, edges_of_vertex;
};

/// returns for each face how many edges away a border is, up to `most`; others have `most` + 1.
inline std::vector<int> steps_to_border(const std::vector<std::array<Index, 2>>& links,
                                        const std::vector<int>& labels, const int most)
{
  std::vector<int> steps(labels.size(), most + 1);
  for (const auto& [f, g] : links)
    if (labels[f] != labels[g]) steps[f] = steps[g] = 0;
  for (int step = 0; step < most; ++step)
    for (const auto& [f, g] : links)
    {
      if (steps[f] == step && steps[g] > step + 1) steps[g] = step + 1;
      if (steps[g] == step && steps[f] > step + 1) steps[f] = step + 1;
    }
  return steps;
}

/// turns rows around: returns in which rows each of `size` entries is, ascending.
inline Compressed_rows<Index> rows_of_entries(const Compressed_rows<Index>& rows,
                                              const std::size_t size)
{
  Compressed_rows<Index> result;
  result.first.assign(size + 1, 0);
  for (const Index entry : rows.entries) ++result.first[entry + 1];
  result.allocate_counted();
  std::vector<std::size_t> fill(result.first.begin(), result.first.end() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const Index entry : rows[i]) result.entries[fill[entry]++] = static_cast<Index>(i);
  return result;
}

/// fills the faces within `most` steps of a border; the last step stays as it is.
inline void choose_faces(const Mesh_faces& mesh, const std::vector<int>& labels, const int most,
                         Border_mesh& border)
{
  const std::vector<int> steps = steps_to_border(mesh.links, labels, most);
  for (Index f = 0; f < labels.size(); ++f)
    if (steps[f] <= most) border.faces.push_back(f);
  std::vector<std::pair<Coordinates, Index>> places;
  for (const Index f : border.faces)
    places.push_back(
        {centroid_of(
             {mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.first_corner[f]),
              mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.first_corner[f + 1])}),
         f});
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) border.faces[i] = places[i].second;
  for (const Index f : border.faces) border.may_change.push_back(steps[f] < most ? 1 : 0);
}

/// fills the vertices: corners of the chosen faces at the same position are one.
inline void weld_vertices(const Mesh_faces& mesh, Placement placement, Border_mesh& border)
{
  placement.exponent = 0; // that of the input was taken out of the corners when they were read
  std::vector<std::pair<Coordinates, Index>> corners;
  for (const Index f : border.faces)
  {
    for (std::size_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c)
      corners.push_back({mesh.corners[c], static_cast<Index>(corners.size())});
    border.vertices_of_face.first.push_back(corners.size());
  }
  std::sort(corners.begin(), corners.end());
  border.vertices_of_face.entries.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (i == 0 || corners[i].first != corners[i - 1].first)
      border.vertices.push_back(placement.point(corners[i].first));
    border.vertices_of_face.entries[corners[i].second] =
        static_cast<Index>(border.vertices.size() - 1);
  }
  for (std::size_t f = 0; f < border.vertices_of_face.size(); ++f)
  {
    // whatever the corner that a face begins with, and the side that it is seen from
    const auto row = border.vertices_of_face[f];
    std::rotate(row.begin(), std::min_element(row.begin(), row.end()), row.end());
    if (row.begin()[1] > row.end()[-1]) std::reverse(row.begin() + 1, row.end());
  }
  border.faces_of_vertex = rows_of_entries(border.vertices_of_face, border.vertices.size());
}

/// fills the edges; of more than two faces at an edge, each is joined to the first.
inline void join_faces(Border_mesh& border)
{
  struct Side
  {
    std::array<Index, 2> ends;
    Index face;
    bool operator<(const Side& s) const
    {
      return ends < s.ends || (ends == s.ends && face < s.face);
    }
  };
  std::vector<Side> sides;
  for (Index f = 0; f < border.faces.size(); ++f)
  {
    const auto row = border.vertices_of_face[f];
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const Index a = row.first[i], b = row.first[i + 1 < row.size() ? i + 1 : 0];
      if (a != b) sides.push_back({{(std::min)(a, b), (std::max)(a, b)}, f});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, first = 0; i < sides.size(); ++i)
  {
    if (sides[i].ends != sides[first].ends) first = i;
    if (sides[i].face != sides[first].face)
      border.edges.push_back({sides[i].ends, {sides[first].face, sides[i].face}});
  }
  Compressed_rows<Index> ends, faces;
  for (const Border_edge& e : border.edges)
  {
    ends.entries.insert(ends.entries.end(), e.ends.begin(), e.ends.end());
    ends.end_row();
    faces.entries.insert(faces.entries.end(), e.faces.begin(), e.faces.end());
    faces.end_row();
  }
  border.edges_of_vertex = rows_of_entries(ends, border.vertices.size());
  border.edges_of_face = rows_of_entries(faces, border.faces.size());
}

/// returns the faces of a mesh within `most` steps of a border; those of the last step may not change.
inline Border_mesh faces_near_borders(const Mesh_faces& mesh, const std::vector<int>& labels,
                                      const Placement& placement, const int most)
{
  Border_mesh border;
  choose_faces(mesh, labels, most, border);
  weld_vertices(mesh, placement, border);
  join_faces(border);
  return border;
}

/// fills areas, lengths and angles. The side to which the faces look is that of their points.
inline void measure_faces(const Oriented_points& points, Border_mesh& border)
{
  std::vector<Index> point_of(points.number_of_elements, 0);
  for (Index i = 0; i < points.size(); ++i) point_of[points.elements[i]] = i;
  std::vector<Vector3> centers;
  for (std::size_t f = 0; f < border.faces.size(); ++f)
  {
    const auto row = border.vertices_of_face[f];
    const Vector3 first = border.vertices[*row.begin()];
    Vector3 sum, twice_area;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const Vector3 corner = border.vertices[row.first[i]];
      const Vector3 next = border.vertices[row.first[i + 1 < row.size() ? i + 1 : 0]];
      sum += corner;
      twice_area += cross(corner - first, next - first);
    }
    centers.push_back(sum / static_cast<float>(row.size()));
    border.areas.push_back(0.5f * length(twice_area));
  }
  for (Border_edge& e : border.edges)
  {
    e.length = length(border.vertices[e.ends[1]] - border.vertices[e.ends[0]]);
    const auto [f, g] = e.faces;
    e.concavity = signed_concavity(centers[f], points.normals[point_of[border.faces[f]]],
                                   centers[g], points.normals[point_of[border.faces[g]]]);
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_BORDER_MESH_H
