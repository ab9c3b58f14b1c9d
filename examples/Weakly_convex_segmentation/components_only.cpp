// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stops at the weakly convex components, before those of similar volume are merged.

#include "shapes/shape_generator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main()
{
  try
  {
    // The shape is a polygon soup: it needs no mesh data structure.
    const Shape_generator::Labeled_mesh shape = Shape_generator::make_mesh("table", 8000, 0);
    std::vector<Point> points;
    for (const auto& p : shape.points) points.emplace_back(p[0], p[1], p[2]);
    const auto result = CGAL::weakly_convex_segmentation_of_soup(points, shape.faces);

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
}
