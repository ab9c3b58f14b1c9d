// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plugs in a merge cost: regions belong together that see each other and whose seam is not concave.

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weakly_convex_segmentation/Region_pair.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

// A model of WeaklyConvexSegmentationMergeCost.
class Sight_and_seam_cost
{
  double m_concavity_weight;

public:
  explicit Sight_and_seam_cost(const double concavity_weight) : m_concavity_weight(concavity_weight)
  {}
  double operator()(const WCS::Region_pair& pair, const double limit) const
  {
    const double seam = m_concavity_weight * pair.concave_share();
    if (seam > limit) return std::numeric_limits<double>::infinity(); // spares the lines of sight
    return seam + 1. - pair.visibility();
  }
  double fusion_threshold() const { return 0.3; }   // the highest cost of patches in a component
  double merging_threshold() const { return 0.75; } // and of components in a segment
};

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("octopus.ply");
  Point_set points; // without normals in the file they are estimated
  if (!CGAL::IO::read_point_set(filename, points) || points.empty())
    throw std::runtime_error("no points can be read from " + filename);
  auto label = points.add_property_map<int>("label").first;

  for (const double weight : {0.5, 1., 2.})
  {
    const auto result = CGAL::weakly_convex_segmentation(
        points, label, CGAL::parameters::merge_cost(Sight_and_seam_cost(weight)));
    std::cout << "weight " << weight << ": " << result.number_of_segments() << " segments\n";
  }
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "own_merge_cost: " << error.what() << '\n';
  return EXIT_FAILURE;
}
