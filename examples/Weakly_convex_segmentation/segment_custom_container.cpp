// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments points that lie in a container of one's own: the elements are indices, and property maps
// give the point and the normal of an index and take its label.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/property_map.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented = std::pair<Point, Vector>;

struct Sample
{
  Point position;
  Vector normal;
  int part;
};

// writes the label of a sample
struct Part_map
{
  using key_type = std::size_t;
  using value_type = int;
  using reference = int;
  using category = boost::writable_property_map_tag;
  std::vector<Sample>* samples;
  friend void put(const Part_map& map, key_type i, int label) { (*map.samples)[i].part = label; }
};

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("octopus.ply");
  std::vector<Oriented> read;
  if (!CGAL::IO::read_points(
          filename, std::back_inserter(read),
          CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
              .normal_map(CGAL::Second_of_pair_property_map<Oriented>())) ||
      read.empty())
    throw std::runtime_error("no points can be read from " + filename);
  std::vector<Sample> samples;
  for (const auto& [position, normal] : read) samples.push_back({position, normal, -1});

  // maps that are only read can be made of functions
  const auto positions = boost::make_function_property_map<std::size_t, Point>(
      [&](std::size_t i) { return samples[i].position; });
  const auto normals = boost::make_function_property_map<std::size_t, Vector>(
      [&](std::size_t i) { return samples[i].normal; });

  // any range of indices: only what is in it is segmented
  std::vector<std::size_t> indices(samples.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  const auto result = CGAL::weakly_convex_segmentation(
      indices, Part_map{&samples}, CGAL::parameters::point_map(positions).normal_map(normals));

  std::cout << result.number_of_segments() << " segments, the first sample is in "
            << samples.front().part << '\n';
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "segment_custom_container: " << error.what() << '\n';
  return EXIT_FAILURE;
}
