// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a mesh along the smoothed borders of its segments into a mesh a segment.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/cut_along_borders.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("figure.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.number_of_faces() == 0)
    throw std::runtime_error("no manifold mesh can be read from " + filename);

  auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label").first;
  const auto result = CGAL::weakly_convex_segmentation(mesh, label);

  // Faces are split where the borders run smoothly, which edges do not allow.
  const auto cut = CGAL::Weakly_convex_segmentation::cut_along_borders(mesh, label);
  std::vector<std::vector<std::vector<std::size_t>>> polygons(result.number_of_segments());
  for (std::size_t i = 0; i < cut.polygons.size(); ++i)
    polygons[static_cast<std::size_t>(cut.labels[i])].push_back(cut.polygons[i]);

  std::vector<Mesh> parts;
  for (auto& of_part : polygons)
  {
    auto points = cut.points;
    PMP::orient_polygon_soup(points,
                             of_part); // a part that touches itself in a point becomes manifold
    parts.emplace_back();
    PMP::polygon_soup_to_polygon_mesh(points, of_part, parts.back());
    PMP::remove_isolated_vertices(parts.back());
  }

  std::size_t number_of_faces = 0;
  for (const Mesh& part : parts) number_of_faces += part.number_of_faces();
  std::cout << result.number_of_segments() << " segments, " << parts.size() << " meshes of "
            << number_of_faces << " faces in all\n";
  return number_of_faces == cut.polygons.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch (const std::exception& error)
{
  std::cerr << "split_into_meshes: " << error.what() << '\n';
  return EXIT_FAILURE;
}
