// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments only some faces of a mesh, by CGAL's Face_filtered_graph: one of the two objects in it. The
// labels go to a map of the whole mesh, in which the other faces keep what they had.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("figure.off");
  const std::string other = argc > 2 ? argv[2] : CGAL::data_file_path("dumbbell.off");
  Mesh mesh, second;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::IO::read_polygon_mesh(other, second) ||
      mesh.number_of_faces() == 0)
    throw std::runtime_error("no manifold mesh can be read from " + filename + " or " + other);
  const Face of_figure = *mesh.faces().begin();
  mesh.join(second);

  // which faces are meant; any other map from faces to numbers will do
  auto object = mesh.add_property_map<Face, std::size_t>("f:object").first;
  CGAL::Polygon_mesh_processing::connected_components(mesh, object);
  const CGAL::Face_filtered_graph<Mesh> figure(mesh, object[of_figure], object);

  auto label = mesh.add_property_map<Face, int>("f:label", -1).first;
  const auto result = CGAL::weakly_convex_segmentation(figure, label);

  std::size_t labeled = 0;
  for (const Face f : mesh.faces())
    if (label[f] >= 0) ++labeled;
  std::cout << result.number_of_segments() << " segments on " << labeled << " of "
            << mesh.number_of_faces() << " faces\n";
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "segment_part_of_mesh: " << error.what() << '\n';
  return EXIT_FAILURE;
}
