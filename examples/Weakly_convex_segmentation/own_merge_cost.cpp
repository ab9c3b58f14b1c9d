// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plugs in a merge cost: regions belong together that see each other and whose seam is not concave.

#include "shapes/shape_generator.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <iostream>
#include <limits>

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;

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

int main()
{
  const auto shape = Shape_generator::make_cloud("octopus", 6000, 0);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true); // with normals
  for (std::size_t i = 0; i < shape.points.size(); ++i)
  {
    const auto& [x, y, z] = shape.points[i];
    const auto& [nx, ny, nz] = shape.normals[i];
    cloud.insert(Kernel::Point_3(x, y, z), Kernel::Vector_3(nx, ny, nz));
  }
  auto label = cloud.add_property_map<int>("label").first;

  for (const double weight : {0.5, 1., 2.})
  {
    const auto result = CGAL::weakly_convex_segmentation(
        cloud, label, CGAL::parameters::merge_cost(Sight_and_seam_cost(weight)));
    std::cout << "weight " << weight << ": " << result.number_of_segments() << " segments\n";
  }
}
