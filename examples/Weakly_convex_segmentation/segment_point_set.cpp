// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments a point set with normals, in parallel where TBB is linked.

#include "shapes/shape_generator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/tags.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstdlib>
#include <exception>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

Point_set generated_points()
{
  const Shape_generator::Labeled_cloud cloud = Shape_generator::make_cloud("four_leg", 10000, 0);
  Point_set points;
  points.add_normal_map(); // without normals they are estimated
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const auto& p = cloud.points[i];
    const auto& n = cloud.normals[i];
    points.insert(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  return points;
}

int main()
{
  try
  {
    Point_set points = generated_points();
    Point_set::Property_map<int> labels = points.add_property_map<int>("label", -1).first;

    // Parallel_if_available_tag uses TBB in programs that are linked with it.
    const auto result =
        CGAL::weakly_convex_segmentation<CGAL::Parallel_if_available_tag>(points, labels);

    std::cout << points.size() << " points in " << result.number_of_segments() << " segments\n";
    std::cout << "the first point is in segment " << labels[*points.begin()] << '\n';
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "segment_point_set: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
