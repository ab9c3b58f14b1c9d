// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Follows the stages with a visitor, then changes the granularity without running again.

#include "shapes/shape_generator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
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

int main()
{
  const Shape_generator::Labeled_mesh shape = Shape_generator::make_mesh("octopus", 8000, 0);
  std::vector<Point> points;
  for (const auto& p : shape.points) points.emplace_back(p[0], p[1], p[2]);

  Stage_printer printer;
  const WCS::Result result = CGAL::weakly_convex_segmentation_of_soup(
      points, shape.faces, CGAL::parameters::visitor(std::ref(printer)));
  std::cout << result.number_of_segments() << " segments\n";

  // From few large parts to many small ones. The borders are those of the patches.
  for (const std::size_t wanted : {2, 4, 8})
  {
    const std::vector<int> segment_of_patch = result.merge_tree.labels_for(wanted);
    std::vector<std::size_t> sizes(wanted);
    for (const int patch : result.patches) ++sizes[segment_of_patch[patch]];
    std::cout << "the largest of " << wanted << " has "
              << *std::max_element(sizes.begin(), sizes.end()) << " faces\n";
  }
}
