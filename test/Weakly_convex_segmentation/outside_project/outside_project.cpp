// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a user outside of the project writes: one include, a mesh, a property map for the labels.

#include <CGAL/weakly_convex_segmentation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace WCS = CGAL::Weakly_convex_segmentation;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

// Two balls that grow into each other: a tube of triangles about the x axis, closed by two fans.
Mesh make_dumbbell(const int rings, const int sectors)
{
  const double pi = std::acos(-1.);
  Mesh mesh;
  const auto first_tip = mesh.add_vertex({-1.9, 0., 0.});
  for (int i = 1; i < rings; ++i)
  {
    const double x = -1.9 + 3.8 * i / rings;
    const double from_center = std::abs(x) - 0.9;
    const double radius = std::sqrt(1. - from_center * from_center);
    for (int j = 0; j < sectors; ++j)
    {
      const double angle = 2. * pi * j / sectors;
      mesh.add_vertex({x, radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  const auto last_tip = mesh.add_vertex({1.9, 0., 0.});

  const auto at = [sectors](const int ring, const int sector)
  { return Mesh::Vertex_index(1 + (ring - 1) * sectors + sector % sectors); };
  for (int j = 0; j < sectors; ++j)
  {
    mesh.add_face(first_tip, at(1, j + 1), at(1, j));
    mesh.add_face(last_tip, at(rings - 1, j), at(rings - 1, j + 1));
    for (int i = 1; i + 1 < rings; ++i)
    {
      mesh.add_face(at(i, j), at(i, j + 1), at(i + 1, j));
      mesh.add_face(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
    }
  }
  return mesh;
}

// A contract, which is checked in a Debug build such as this one.
bool refuses_what_was_moved_from(const Mesh& mesh)
{
  WCS::Segmenter<> first(mesh);
  const WCS::Segmenter<> second = std::move(first);
  if (second.number_of_patches() == 0) return false;
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  try
  {
    first.segment();
  }
  catch (const CGAL::Precondition_exception&)
  {
    return true;
  }
  return false;
}

int main()
{
  Mesh mesh = make_dumbbell(60, 48);
  auto label = mesh.add_property_map<Face, int>("f:label", -1).first;

  const WCS::Result result = CGAL::weakly_convex_segmentation(
      mesh, label, CGAL::parameters::maximum_number_of_segments(2).random_seed(1));

  std::cout << result.number_of_segments() << " segments of " << mesh.number_of_faces()
            << " faces\n";
  for (const Face face : mesh.faces())
    if (label[face] < 0 || label[face] >= static_cast<int>(result.number_of_segments()))
    {
      std::cerr << "face " << face << " has the label " << label[face] << '\n';
      return EXIT_FAILURE;
    }
  if (!refuses_what_was_moved_from(mesh))
  {
    std::cerr << "an object that was moved from is not refused\n";
    return EXIT_FAILURE;
  }
  const bool succeeded = result.number_of_segments() >= 1 && result.number_of_segments() <= 2 &&
                         result.labels.size() == mesh.number_of_faces();
  return succeeded ? EXIT_SUCCESS : EXIT_FAILURE;
}
