// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Decomposes a cloud, from a file or generated, by clustering its lines of sight, and compares the
// convexity of the parts with those of the segmentation.

#include "shapes/shape_generator.h"

#include "baselines/lines_of_sight_decomposition.h"
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3>;

Cloud generated_cloud()
{
  const Shape_generator::Labeled_cloud shape = Shape_generator::make_cloud("figure", 8000);
  Cloud cloud(true); // with normals
  for (std::size_t i = 0; i < shape.points.size(); ++i)
  {
    const auto &p = shape.points[i], &v = shape.normals[i];
    cloud.insert(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(v[0], v[1], v[2]));
  }
  return cloud;
}

// mean convexity rank of the parts, weighted by their sizes
double mean_rank(const std::vector<WCS::Segment>& segments)
{
  double ranks = 0., sizes = 0.;
  for (const WCS::Segment& segment : segments)
  {
    ranks += static_cast<double>(segment.size) * segment.convexity_rank;
    sizes += static_cast<double>(segment.size);
  }
  return ranks / sizes;
}

int main(int argc, char* argv[])
{
  try
  {
    Cloud cloud;
    if (argc == 1)
      cloud = generated_cloud();
    else if (!CGAL::IO::read_point_set(argv[1], cloud))
      throw std::runtime_error("the file holds no points");
    auto labels = cloud.add_property_map<int>("label", -1).first;

    const auto segmentation = CGAL::weakly_convex_segmentation(cloud, labels);
    std::cout << "segmentation: " << segmentation.number_of_segments()
              << " segments, convexity rank " << mean_rank(segmentation.segments) << '\n';

    const auto by_gap = WCS::lines_of_sight_decomposition(cloud, labels);
    std::cout << "lines of sight: " << by_gap.number_of_segments() << " segments, convexity rank "
              << mean_rank(by_gap.segments) << '\n';

    WCS::Lines_of_sight_parameters told;
    told.number_of_segments = segmentation.number_of_segments();
    const auto as_many = WCS::lines_of_sight_decomposition(cloud, labels, told);
    std::cout << "lines of sight: " << as_many.number_of_segments() << " segments, convexity rank "
              << mean_rank(as_many.segments) << '\n';
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "lines_of_sight_decomposition: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
