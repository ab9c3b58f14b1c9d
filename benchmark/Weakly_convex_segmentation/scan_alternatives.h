// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCAN_ALTERNATIVES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCAN_ALTERNATIVES_H

#include "virtual_scanner.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

// What else is done with a scan today: a surface through the points, and a method for meshes on it.

namespace Scan_alternatives {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// returns a label a point by the shape diameter function of CGAL, with the settings that were best on
/// complete meshes (3 clusters, smoothing 0.03), on the surface that the advancing front method finds.
/// Points without a face get the label of no part.
inline std::vector<int> segment_by_sdf(const Virtual_scanner::Scan& scan)
{
  std::vector<Kernel::Point_3> points;
  for (const auto& p : scan.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::size_t, 3>> faces;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(faces));
  // normals tell which side is out, the front does not know
  std::size_t outward = 0;
  for (const auto& f : faces)
  {
    const auto n = CGAL::normal(points[f[0]], points[f[1]], points[f[2]]);
    const auto& m = scan.normals[f[0]];
    outward += n * Kernel::Vector_3(m[0], m[1], m[2]) > 0. ? 1 : 0;
  }
  if (2 * outward < faces.size())
    for (auto& f : faces) std::swap(f[1], f[2]);
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Kernel::Point_3> corners = points;
  PMP::orient_polygon_soup(corners, faces);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(corners, faces, mesh);
  auto diameters = mesh.add_property_map<Mesh::Face_index, double>("f:sdf", 0.).first;
  auto parts = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
  CGAL::sdf_values(mesh, diameters);
  CGAL::segmentation_from_sdf_values(mesh, diameters, parts, 3, 0.03);
  std::map<Kernel::Point_3, int> part_at;
  for (const auto face : mesh.faces())
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      part_at[mesh.point(vertex)] = static_cast<int>(parts[face]);
  std::vector<int> labels;
  for (const auto& p : points)
  {
    const auto found = part_at.find(p);
    labels.push_back(found == part_at.end() ? -1 : found->second);
  }
  return labels;
}

} // namespace Scan_alternatives

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCAN_ALTERNATIVES_H
