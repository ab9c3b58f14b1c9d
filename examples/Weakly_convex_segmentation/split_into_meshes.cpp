// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a mesh along the borders of its segments into several meshes.

#include "shapes/shape_generator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  const auto shape = Shape_generator::make_mesh("four_leg", 8000, 0);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const auto& [x, y, z] : shape.points) v.push_back(mesh.add_vertex({x, y, z}));
  for (const auto& f : shape.faces) mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);

  auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label").first;
  const auto result = CGAL::weakly_convex_segmentation(mesh, label);

  auto between_segments = mesh.add_property_map<Mesh::Edge_index, bool>("e:between", false).first;
  for (const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e);
    between_segments[e] =
        !mesh.is_border(e) && label[mesh.face(h)] != label[mesh.face(mesh.opposite(h))];
  }

  // A segment that is not connected along the mesh becomes several meshes.
  std::vector<Mesh> parts;
  CGAL::Polygon_mesh_processing::split_connected_components(
      mesh, parts, CGAL::parameters::edge_is_constrained_map(between_segments));

  std::size_t number_of_faces = 0;
  for (const Mesh& part : parts) number_of_faces += part.number_of_faces();
  std::cout << result.number_of_segments() << " segments, " << parts.size() << " meshes of "
            << number_of_faces << " faces in all\n";
  return number_of_faces == mesh.number_of_faces() ? EXIT_SUCCESS : EXIT_FAILURE;
}
