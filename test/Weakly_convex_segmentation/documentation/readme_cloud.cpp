// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program for a cloud of README.md, word for word; check_documentation.py compares them.

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>
#include <iostream>

int main()
{
  CGAL::Point_set_3<CGAL::Simple_cartesian<double>::Point_3> cloud;
  if (!(std::cin >> cloud)) return 1; // PLY, XYZ, OFF
  auto label = cloud.add_property_map<int>("label").first;
  const auto result = CGAL::weakly_convex_segmentation(cloud, label);
  std::cout << result.number_of_segments() << " parts\n";
}
