// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments only some faces of a mesh, by CGAL's Face_filtered_graph: one of the two objects in it. The
// labels go to a map of the whole mesh, in which the other faces keep what they had.

#include "shapes/shape_generator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

// adds a generated shape, moved along the x-axis, and returns one of its faces
Face add_shape(Mesh& mesh, const std::string& name, double offset)
{
  const auto shape = Shape_generator::make_mesh(name, 8000, 0);
  std::vector<Mesh::Vertex_index> v;
  for (const auto& [x, y, z] : shape.points) v.push_back(mesh.add_vertex({x + offset, y, z}));
  Face face;
  for (const auto& f : shape.faces) face = mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
  return face;
}

int main()
{
  Mesh mesh;
  add_shape(mesh, "table", 0.);
  const Face of_horse = add_shape(mesh, "four_leg", 10.);

  // which faces are meant; any other map from faces to numbers will do
  auto object = mesh.add_property_map<Face, std::size_t>("f:object").first;
  CGAL::Polygon_mesh_processing::connected_components(mesh, object);
  const CGAL::Face_filtered_graph<Mesh> horse(mesh, object[of_horse], object);

  auto label = mesh.add_property_map<Face, int>("f:label", -1).first;
  const auto result = CGAL::weakly_convex_segmentation(horse, label);

  std::size_t labeled = 0;
  for (const Face f : mesh.faces())
    if (label[f] >= 0) ++labeled;
  std::cout << result.number_of_segments() << " segments on " << labeled << " of "
            << mesh.number_of_faces() << " faces\n";
}
