// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments a surface mesh and keeps the labels in a property map.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("figure.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.number_of_faces() == 0)
    throw std::runtime_error("no manifold mesh can be read from " + filename);
  auto labels = mesh.add_property_map<Mesh::Face_index, int>("f:label", -1).first;
  const auto result = CGAL::weakly_convex_segmentation(mesh, labels);

  std::cout << result.number_of_segments() << " segments\n";
  for (const auto& segment : result.segments)
    std::cout << segment.size << " faces, convexity rank " << segment.convexity_rank << '\n';
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "segment_mesh: " << error.what() << '\n';
  return EXIT_FAILURE;
}
