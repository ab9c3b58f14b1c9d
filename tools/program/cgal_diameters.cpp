// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/cgal_diameters.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/mesh_diameters.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Segment_shape {

std::vector<double> cgal_diameters(const Shape_io::Shape& shape,
                                   const CGAL::Weakly_convex_segmentation::Parameters& parameters)
{
  using Mesh = CGAL::Surface_mesh<Shape_io::Point>;
  Mesh mesh;
  for (const Shape_io::Point& p : shape.points) mesh.add_vertex(p);
  for (const std::vector<std::size_t>& polygon : shape.polygons)
  {
    std::vector<Mesh::Vertex_index> corners;
    for (const std::size_t v : polygon) corners.emplace_back(static_cast<Mesh::size_type>(v));
    if (corners.size() != 3 || mesh.add_face(corners) == Mesh::null_face())
      throw std::invalid_argument(
          "CGAL's diameters need a mesh of triangles, at most two at an edge and "
          "turned alike; use --diameters own");
  }
  return CGAL::Weakly_convex_segmentation::mesh_diameters(mesh, parameters);
}

} // namespace Segment_shape
