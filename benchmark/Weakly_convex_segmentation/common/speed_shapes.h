// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SPEED_SHAPES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SPEED_SHAPES_H

#include "shapes/shape_generator.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Clouds of any size in random order, made in a moment: an ordinary shape, and those that might take
// longer; and the time of CGAL's neighbor search, the unit of time.

namespace Speed_shapes {

using Kernel = CGAL::Simple_cartesian<double>;
using Oriented_point = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Cloud = std::vector<Oriented_point>;

inline double unit_random(std::mt19937& random)
{
  return static_cast<double>(random()) / 4294967296.;
}

/// points spread evenly over the surface of a figure of capsules
inline Cloud ordinary(const std::size_t size)
{
  const Shape_generator::Labeled_mesh mesh = Shape_generator::make_mesh("figure", 40000);
  std::vector<double> area_before = {0.};
  const auto corner = [&](const std::size_t f, const std::size_t c)
  {
    const auto& p = mesh.points[mesh.faces[f][c]];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  std::vector<Kernel::Vector_3> normals;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Kernel::Vector_3 n =
        CGAL::cross_product(corner(f, 1) - corner(f, 0), corner(f, 2) - corner(f, 0));
    area_before.push_back(area_before.back() + std::sqrt(n.squared_length()));
    normals.push_back(n);
  }
  std::mt19937 random(0);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double at = unit_random(random) * area_before.back();
    const std::size_t f = static_cast<std::size_t>(
        std::upper_bound(area_before.begin() + 1, area_before.end() - 1, at) - area_before.begin() -
        1);
    const double u = std::sqrt(unit_random(random)), v = unit_random(random);
    cloud.push_back({corner(f, 0) + u * (1. - v) * (corner(f, 1) - corner(f, 0)) +
                         u * v * (corner(f, 2) - corner(f, 0)),
                     normals[f]});
  }
  return cloud;
}

/// adds an evenly covered sphere; a negative radius turns the normals inwards
inline void add_sphere(Cloud& cloud, const Kernel::Point_3& center, const double radius,
                       const std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    const double z = 1. - (2. * static_cast<double>(i) + 1.) / static_cast<double>(size);
    const double r = std::sqrt(1. - z * z), turn = 2.39996322972865332 * static_cast<double>(i);
    const Kernel::Vector_3 n(r * std::cos(turn), r * std::sin(turn), z);
    cloud.push_back({center + std::abs(radius) * n, radius < 0. ? -n : n});
  }
}

inline Cloud hollow_sphere(const std::size_t size)
{
  Cloud cloud;
  add_sphere(cloud, {0., 0., 0.}, 1., size / 2);
  add_sphere(cloud, {0., 0., 0.}, -0.95, size - size / 2);
  return cloud;
}

inline Cloud separate_pieces(const std::size_t size)
{
  constexpr std::size_t pieces = 5000, row = 18;
  Cloud cloud;
  for (std::size_t i = 0; i < pieces; ++i)
    add_sphere(cloud,
               {3. * static_cast<double>(i % row), 3. * static_cast<double>(i / row % row),
                3. * static_cast<double>(i / (row * row))},
               1., size / pieces);
  return cloud;
}

/// a sheet without thickness, seen from one side
inline Cloud flat_sheet(const std::size_t size)
{
  std::mt19937 random(0);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double x = unit_random(random), y = unit_random(random);
    cloud.push_back({{x, y, 0.}, {0., 0., 1.}});
  }
  return cloud;
}

/// a straight wire, a thousand times as long as thick
inline Cloud straight_wire(const std::size_t size)
{
  std::mt19937 random(0);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double turn = 6.283185307179586 * unit_random(random), x = 100. * unit_random(random);
    const Kernel::Vector_3 n(0., std::cos(turn), std::sin(turn));
    cloud.push_back({Kernel::Point_3(x, 0., 0.) + 0.05 * n, n});
  }
  return cloud;
}

inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

inline double seconds_of(double (*clock)(), const std::function<void()>& work)
{
  const double begin = clock();
  work();
  return clock() - begin;
}

inline double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// CGAL's defaults, points in the order of the input: the floor that any such method pays.
inline void search_neighbors(const Cloud& cloud)
{
  using Traits = CGAL::Search_traits_3<Kernel>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  std::vector<Kernel::Point_3> points;
  for (const Oriented_point& p : cloud) points.push_back(p.first);
  Search::Tree tree(points.begin(), points.end());
  double sum = 0.;
  for (const Kernel::Point_3& p : points)
    for (const auto& found : Search(tree, p, 11)) sum += found.second;
  if (sum < 0.) throw std::logic_error("squared distances are positive");
}

} // namespace Speed_shapes

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SPEED_SHAPES_H
