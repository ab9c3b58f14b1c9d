// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a mesh along the borders of its segments into several meshes.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("figure.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " holds no manifold mesh\n";
    return EXIT_FAILURE;
  }

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
