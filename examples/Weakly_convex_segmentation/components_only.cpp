// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stops at the weakly convex components, before those of similar volume are merged.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main(int argc, char* argv[])
try
{
  // The shape is a polygon soup: it needs no mesh data structure.
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("figure.off");
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(filename, points, polygons) || polygons.empty())
    throw std::runtime_error("no polygons can be read from " + filename);
  const auto result = CGAL::weakly_convex_segmentation_of_soup(points, polygons);

  // The patches are the leaves of the merge tree; its first merges fused them into components.
  const auto& tree = result.merge_tree;
  const std::vector<int> component_of_patch = tree.labels_after(tree.number_of_fusions());
  std::vector<int> components; // one a face
  for (const int patch : result.patches) components.push_back(component_of_patch[patch]);

  std::cout << tree.number_of_patches() << " patches, " << result.number_of_components
            << " components, " << result.number_of_segments() << " segments\n"
            << "the first component has " << std::count(components.begin(), components.end(), 0)
            << " faces\n";
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "components_only: " << error.what() << '\n';
  return EXIT_FAILURE;
}
