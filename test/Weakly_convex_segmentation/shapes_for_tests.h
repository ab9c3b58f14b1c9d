// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_SHAPES_FOR_TESTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_SHAPES_FOR_TESTS_H

#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include "shapes/shape_generator.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Points and meshes that more than one test of the stages needs, and how far two labelings are apart.

namespace Shapes_for_tests {

using CGAL::Weakly_convex_segmentation::internal::Index;
using CGAL::Weakly_convex_segmentation::internal::Raw_shape;
using Coordinates = std::array<double, 3>;

/// a number in [0, 1) that is the same with every standard library
inline double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.; }

inline Coordinates plus(const Coordinates& a, const Coordinates& b, const double factor = 1.)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

inline Coordinates cross_product(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline void add_point(Raw_shape& raw, const Coordinates& position, const Coordinates& normal)
{
  raw.positions.push_back(position);
  raw.normals.push_back(normal);
}

/// one point a face, as the library reads a mesh, with links between faces that share an edge
inline Raw_shape points_of_mesh(const Shape_generator::Labeled_mesh& mesh)
{
  Raw_shape raw;
  std::map<std::pair<std::size_t, std::size_t>, Index> first_at_edge;
  for (const auto& f : mesh.faces)
  {
    const Index index = static_cast<Index>(raw.positions.size());
    const Coordinates &a = mesh.points[f[0]], &b = mesh.points[f[1]], &c = mesh.points[f[2]];
    const Coordinates sum = plus(plus(a, b), c);
    add_point(raw, {sum[0] / 3., sum[1] / 3., sum[2] / 3.},
              cross_product(plus(b, a, -1.), plus(c, a, -1.)));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto slot = first_at_edge.emplace(std::minmax(f[i], f[(i + 1) % 3]), index);
      if (!slot.second) raw.links.push_back({slot.first->second, index});
    }
  }
  return raw;
}

/// the same with the corners of the faces
inline Raw_shape faces_of_mesh(const Shape_generator::Labeled_mesh& mesh)
{
  Raw_shape raw;
  for (const auto& f : mesh.faces)
    CGAL::Weakly_convex_segmentation::internal::add_polygon(
        {mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]}, raw);
  raw.links = points_of_mesh(mesh).links;
  return raw;
}

/// the mesh with each coordinate of its vertices changed by at most `size`
inline Shape_generator::Labeled_mesh shaken(Shape_generator::Labeled_mesh mesh, const double size,
                                            const unsigned int seed)
{
  std::mt19937 random(seed);
  for (auto& p : mesh.points)
    for (double& c : p) c += size * (2. * uniform(random) - 1.);
  return mesh;
}

/// Points in rings about the x axis, as the faces of a turned part lie: pairs of rings 0.02 apart with
/// 0.2 to the next pair, 120 points each. `radius`: that at an x from 0 to `length`.
template <typename Radius>
Raw_shape rings(const double length, const Radius& radius)
{
  Raw_shape raw;
  const int pairs = static_cast<int>(length / 0.2);
  for (int ring = 0; ring < 2 * pairs; ++ring)
    for (int i = 0; i < 120; ++i)
    {
      const double x = 0.2 * (ring / 2) + 0.02 * (ring % 2);
      const double turn = 6.283185307179586 * (i + 0.5 * (ring % 2)) / 120.;
      const Coordinates n = {0., std::cos(turn), std::sin(turn)};
      add_point(raw, plus({x, 0., 0.}, n, radius(x)), n);
    }
  return raw;
}

/// a rectangle of `columns` x `rows` points with one normal, `corner` + i * `u` + j * `v`
inline void add_rectangle(Raw_shape& raw, const Coordinates& corner, const Coordinates& u,
                          const Coordinates& v, const int columns, const int rows,
                          const Coordinates& normal)
{
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) add_point(raw, plus(plus(corner, u, i), v, j), normal);
}

/// points spread evenly over a sphere (a spiral) with outward normals
inline void add_sphere(Raw_shape& raw, const Coordinates& center, const double radius,
                       const std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = 1. - 2. * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double r = std::sqrt(1. - z * z), turn = 2.399963229728653 * static_cast<double>(i);
    const Coordinates n = {r * std::cos(turn), r * std::sin(turn), z};
    add_point(raw, plus(center, n, radius), n);
  }
}

/// Two walls at a right angle that share the edge x = z = 0: the floor x > 0 with its normal upwards,
/// the wall z > 0 with its normal to +x (seen from there the edge is concave). `step` apart, across
/// the edge too, `n` x `n` points each.
inline Raw_shape concave_corner(const int n, const double step)
{
  Raw_shape raw;
  const double half = std::sqrt(0.5) * step;
  add_rectangle(raw, {half, 0., 0.}, {step, 0., 0.}, {0., step, 0.}, n, n, {0., 0., 1.});
  add_rectangle(raw, {0., 0., half}, {0., 0., step}, {0., step, 0.}, n, n, {1., 0., 0.});
  return raw;
}

/// the share of the pairs of elements that are together in one labeling and apart in the other
inline double rand_distance(const std::vector<int>& a, const std::vector<int>& b)
{
  std::map<std::pair<int, int>, double> both;
  std::map<int, double> first, second;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    both[{a[i], b.at(i)}] += 1.;
    first[a[i]] += 1.;
    second[b[i]] += 1.;
  }
  const auto pairs = [](const double n) { return 0.5 * n * (n - 1.); };
  double apart = 0.;
  for (const auto& entry : first) apart += pairs(entry.second);
  for (const auto& entry : second) apart += pairs(entry.second);
  for (const auto& entry : both) apart -= 2. * pairs(entry.second);
  return apart / pairs(static_cast<double>(a.size()));
}

} // namespace Shapes_for_tests

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_SHAPES_FOR_TESTS_H
