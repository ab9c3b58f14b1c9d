// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Decomposes a cloud, from a file or generated, by clustering its lines of sight, and compares the
// convexity of the parts with those of the segmentation.

#include "baselines/lines_of_sight_decomposition.h"
#include "shapes/shape_generator.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/output/label_transfer.h>
#include <CGAL/Weakly_convex_segmentation/internal/output/segment_statistics.h>
#include <CGAL/tags.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
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

// the parts of the baseline, with the same statistics as those of the segmentation
std::vector<WCS::Segment> parts_by_sight(const WCS::internal::Shape_analysis& shape,
                                         const Lines_of_sight::Settings& settings)
{
  const std::vector<int> labels = Lines_of_sight::decompose(shape, settings);
  const std::vector<int> of_representatives = WCS::internal::representative_labels(shape, labels);
  const int last = *std::max_element(labels.begin(), labels.end());
  return WCS::internal::describe_segments(shape, of_representatives, labels,
                                          static_cast<std::size_t>(last) + 1, false);
}

void print(const std::string& method, const std::vector<WCS::Segment>& segments)
{
  std::cout << method << ": " << segments.size() << " segments, convexity rank "
            << mean_rank(segments) << '\n';
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
    print("segmentation", segmentation.segments);

    const auto shape = WCS::internal::analyze_shape(
        WCS::internal::read_input<CGAL::Sequential_tag>(cloud, CGAL::parameters::default_values()),
        {}, {});
    Lines_of_sight::Settings settings;
    print("lines of sight", parts_by_sight(*shape, settings));
    settings.number_of_segments = segmentation.number_of_segments();
    print("lines of sight", parts_by_sight(*shape, settings));
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "decompose_by_lines_of_sight: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
