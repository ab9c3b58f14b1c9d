// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Follows the stages with a visitor, then changes the granularity without running again.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

class Stage_printer : public WCS::Visitor
{
public:
  void stage_begins(WCS::Stage) override { m_start = Clock::now(); }
  void stage_ends(const WCS::Stage stage, const std::size_t size) override
  {
    const std::chrono::duration<double, std::milli> time = Clock::now() - m_start;
    std::cout << WCS::stage_name(stage) << ": " << time.count() << " ms, made " << size << '\n';
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_start;
};

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("figure.off");
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(filename, points, polygons) || polygons.empty())
    throw std::runtime_error("no polygons can be read from " + filename);

  Stage_printer printer;
  const WCS::Result result = CGAL::weakly_convex_segmentation_of_soup(
      points, polygons, CGAL::parameters::visitor(std::ref(printer)));
  std::cout << result.number_of_segments() << " segments\n";

  // From few large parts to many small ones. The borders of more than there are here are those of the patches.
  for (const std::size_t wanted : {2, 4, 8})
  {
    std::vector<std::size_t> sizes(wanted);
    for (const int label : result.labels_for(wanted)) ++sizes[label];
    std::cout << "the largest of " << wanted << " has "
              << *std::max_element(sizes.begin(), sizes.end()) << " faces\n";
  }
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "visitor_and_granularity: " << error.what() << '\n';
  return EXIT_FAILURE;
}
