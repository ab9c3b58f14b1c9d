// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments a surface mesh, from a file or generated, and keeps the labels in a property map.

#include "shapes/shape_generator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh generated_mesh()
{
  const Shape_generator::Labeled_mesh shape = Shape_generator::make_mesh("figure", 8000, 0);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const auto& p : shape.points)
    vertices.push_back(mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2])));
  for (const auto& f : shape.faces) mesh.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
  return mesh;
}

int main(int argc, char* argv[])
{
  try
  {
    Mesh mesh;
    if (argc == 1)
      mesh = generated_mesh();
    else if (!CGAL::IO::read_polygon_mesh(argv[1], mesh))
      throw std::runtime_error("the file holds no manifold mesh");
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
}
