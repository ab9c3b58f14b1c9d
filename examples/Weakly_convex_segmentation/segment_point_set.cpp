// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments a point set, in parallel where TBB is linked.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/tags.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("octopus.ply");
  Point_set points; // without normals in the file they are estimated
  if (!CGAL::IO::read_point_set(filename, points) || points.empty())
    throw std::runtime_error("no points can be read from " + filename);
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
