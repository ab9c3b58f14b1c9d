// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program for a mesh of README.md, word for word; check_documentation.py compares them.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/weakly_convex_segmentation.h>
#include <iostream>

int main()
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if (!(std::cin >> mesh)) return 1; // OFF
  auto label = mesh.add_property_map<decltype(mesh)::Face_index, int>("f:label").first;
  const auto result = CGAL::weakly_convex_segmentation(mesh, label);
  std::cout << result.number_of_segments() << " parts\n";
}
