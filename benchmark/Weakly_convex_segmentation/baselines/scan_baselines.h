// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_SCAN_BASELINES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_SCAN_BASELINES_H

#include "scanner/virtual_scanner.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/mesh_segmentation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// What else is done with a scan today: a surface through the points, and a method for meshes on it.

namespace Scan_baselines {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// of segment_by_sdf(); the defaults are those that were best on complete meshes. Of seven settings tried on
/// scans others were better by 0.004 to 0.017, which ones depends on the number of views.
struct Sdf_settings
{
  std::size_t clusters = 3;
  double smoothing = 0.03;
  double cell = 0.01; ///< side of the cells to which points are thinned, in diagonals; 0: none
};

struct Cloud
{
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
};

/// returns the means of what is in the same cell of a grid, a usual step before a reconstruction.
inline Cloud thinned(const Virtual_scanner::Scan& scan, const double share)
{
  Cloud all;
  CGAL::Bbox_3 box;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const auto &p = scan.points[i], &n = scan.normals[i];
    all.points.emplace_back(p[0], p[1], p[2]);
    all.normals.emplace_back(n[0], n[1], n[2]);
    box += all.points.back().bbox();
  }
  const double side = share * std::hypot(box.x_span(), box.y_span(), box.z_span());
  if (!(side > 0.)) return all;
  struct Sum
  {
    Kernel::Vector_3 position = CGAL::NULL_VECTOR, normal = CGAL::NULL_VECTOR;
    double count = 0.;
  };
  std::map<std::array<long, 3>, Sum> cells;
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    const auto index = [&](const int c)
    { return static_cast<long>(std::floor(all.points[i][c] / side)); };
    Sum& sum = cells[{index(0), index(1), index(2)}];
    sum.position += all.points[i] - CGAL::ORIGIN;
    sum.normal += all.normals[i];
    sum.count += 1.;
  }
  Cloud result;
  for (const auto& cell : cells)
  {
    result.points.push_back(CGAL::ORIGIN + cell.second.position / cell.second.count);
    result.normals.push_back(cell.second.normal);
  }
  return result;
}

/// returns the surface that the advancing front method finds; normals tell which side is out.
inline Mesh reconstructed(Cloud& cloud)
{
  std::vector<std::array<std::size_t, 3>> faces;
  CGAL::advancing_front_surface_reconstruction(cloud.points.begin(), cloud.points.end(),
                                               std::back_inserter(faces));
  std::size_t outward = 0;
  for (const auto& f : faces)
    outward += CGAL::normal(cloud.points[f[0]], cloud.points[f[1]], cloud.points[f[2]]) *
                           cloud.normals[f[0]] >
                       0.
                   ? 1
                   : 0;
  if (2 * outward < faces.size())
    for (auto& f : faces) std::swap(f[1], f[2]);
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::orient_polygon_soup(cloud.points, faces);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(cloud.points, faces, mesh);
  if (mesh.number_of_faces() == 0) throw std::runtime_error("the reconstruction has no face");
  return mesh;
}

/// returns a label a point by the shape diameter function of CGAL on a reconstruction: that of the
/// nearest corner of its mesh.
inline std::vector<int> segment_by_sdf(const Virtual_scanner::Scan& scan,
                                       const Sdf_settings& settings)
{
  Cloud cloud = thinned(scan, settings.cell);
  Mesh mesh = reconstructed(cloud);
  auto diameters = mesh.add_property_map<Mesh::Face_index, double>("f:sdf", 0.).first;
  auto parts = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
  CGAL::sdf_values(mesh, diameters);
  CGAL::segmentation_from_sdf_values(mesh, diameters, parts, settings.clusters, settings.smoothing);
  namespace internal = CGAL::Weakly_convex_segmentation::internal;
  std::vector<internal::Vector3> corners;
  std::vector<int> part_of_corner;
  for (const auto vertex : mesh.vertices())
  {
    if (mesh.is_isolated(vertex)) continue;
    for (const auto face : CGAL::faces_around_target(mesh.halfedge(vertex), mesh))
    {
      if (face == Mesh::null_face()) continue;
      const auto& p = mesh.point(vertex);
      corners.push_back(
          {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
      part_of_corner.push_back(static_cast<int>(parts[face]));
      break;
    }
  }
  const internal::Kd_tree tree(corners);
  std::vector<int> labels;
  for (const auto& p : scan.points)
    tree.nearest(internal::Vector3{static_cast<float>(p[0]), static_cast<float>(p[1]),
                                   static_cast<float>(p[2])},
                 1,
                 [&](const internal::Index nearest, float)
                 { labels.push_back(part_of_corner[nearest]); });
  return labels;
}

} // namespace Scan_baselines

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_SCAN_BASELINES_H
