// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_ESTIMATE_NORMALS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_ESTIMATE_NORMALS_H

// Normals for points that have none: CGAL fits planes to the neighbors, then the normals are made consistent.
//
// `CGAL::pca_estimate_normals()` and `CGAL::mst_orient_normals()` each search for the neighbors, which takes
// longer than all of this: of a million points T, the time of CGAL's search for ten neighbors, against 0.6 T
// with one search, estimation and propagation; 1.6 T with `mst_orient_normals()` at the end. Of 4,000 points
// of thin shapes without noise it turns 54 % outwards, propagation 99.9 %, of thick ones 81 % and 99.5 %; of
// 20,000, whose walls are thicker than their neighborhoods, both all (`benchmark_normals`).

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/normal_propagation.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A point's neighbors in our table, for what `CGAL::pca_estimate_normals()` does at each point: the public
/// function itself would search for them anew.
class Known_neighbors
{
  const Unoriented_points& m_shape;
  Index m_point;

public:
  using Kernel = CGAL::Simple_cartesian<double>;

  Known_neighbors(const Unoriented_points& shape, const Index point)
    : m_shape(shape), m_point(point)
  {}

  /// calls `visit` for the neighbors, as seen from the point.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    const std::vector<Vector3>& positions = m_shape.points.positions;
    for (std::size_t e = m_point * m_shape.k; e < (m_point + 1) * m_shape.k; ++e)
      if (m_shape.nearest[e] != m_point) visit(positions[m_shape.nearest[e]] - positions[m_point]);
  }

  template <typename Output>
  void get_points(const Kernel::Point_3& point, unsigned int, Kernel::FT, Output output) const
  {
    *output++ = point;
    for_each([&](const Vector3& d) { *output++ = point + Kernel::Vector_3(d.x, d.y, d.z); });
  }
};

/// sets the normal of a point to a unit vector across the plane that fits it and its neighbors best, of
/// either sign, or to zero if they are all in one place, and the roughness.
inline void fit_plane(Unoriented_points& shape, const Index i)
{
  using Kernel = Known_neighbors::Kernel;
  const Known_neighbors neighbors(shape, i);
  bool is_place = true;
  neighbors.for_each([&](const Vector3& d) { is_place = is_place && squared_length(d) == 0.f; });
  shape.points.normals[i] = {};
  if (is_place) return;
  // as seen from the point, so that no digits are lost where points are dense
  const Kernel::Vector_3 across = CGAL::internal::pca_estimate_normal(
      Kernel::Point_3(0., 0., 0.), neighbors, static_cast<unsigned int>(shape.k), Kernel::FT(0.));
  const Vector3 normal = normalized({static_cast<float>(across.x()), static_cast<float>(across.y()),
                                     static_cast<float>(across.z())});
  shape.points.normals[i] = normal;
  float n = 1.f, sum = 0.f, squares = 0.f;
  neighbors.for_each(
      [&](const Vector3& d)
      {
        const float height = dot(normal, d);
        n += 1.f;
        sum += height;
        squares += height * height;
      });
  shape.roughness[i] = (std::max)(0.f, (squares - sum * sum / n) / n);
}

/// turns normals as `CGAL::mst_orient_normals()` does. Those that it cannot turn with certainty, such as of
/// pieces apart from the highest point, stay as they are.
inline void orient_by_spanning_tree(Oriented_points& points, const std::size_t k)
{
  using Kernel = Known_neighbors::Kernel;
  std::vector<Kernel::Point_3> positions;
  std::vector<Kernel::Vector_3> normals;
  std::vector<std::size_t> indices(points.size()); // CGAL reorders what it is given
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  for (const Vector3& p : points.positions) positions.emplace_back(p.x, p.y, p.z);
  for (const Vector3& v : points.normals) normals.emplace_back(v.x, v.y, v.z);
  const auto end =
      CGAL::mst_orient_normals(indices, static_cast<unsigned int>(k),
                               CGAL::parameters::point_map(CGAL::make_property_map(positions))
                                   .normal_map(CGAL::make_property_map(normals))
                                   .geom_traits(Kernel()));
  for (auto i = indices.begin(); i != end; ++i)
  {
    const Kernel::Vector_3& v = normals[*i];
    points.normals[*i] = {static_cast<float>(v.x()), static_cast<float>(v.y()),
                          static_cast<float>(v.z())};
  }
}

/// fills `raw.normals`, the same for any order of the points. The normal is zero where points are in one
/// place and have no other neighbors.
inline void estimate_normals(Raw_shape& raw, const Run_control& control,
                             const Normal_orientation orientation = Normal_orientation::PROPAGATION)
{
  constexpr std::size_t neighbors = 12, fewest = 4; // three have a plane, but no inside
  const bool parallel = control.parallel;
  check_finite(raw.positions, "position");
  raw.normals.assign(raw.positions.size(), {0., 0., 1.});
  if (raw.positions.size() < fewest) return;
  std::vector<Index> element_of; // the normals are of the points, whatever elements these are of
  element_of.swap(raw.element_of);
  Oriented_points points = orient_points(raw, parallel, control);
  element_of.swap(raw.element_of);
  const std::size_t n = points.size();
  std::vector<float> spacing;
  std::vector<Index> nearest =
      nearest_neighbors(points, Kd_tree(points.positions), neighbors, spacing, parallel, control);
  control.check();
  Unoriented_points shape{points, std::vector<float>(n, 0.f), std::move(nearest), neighbors};
  parallel_for(n, parallel,
               [&](const std::size_t i)
               {
                 control.check_sometimes();
                 fit_plane(shape, static_cast<Index>(i));
               });
  control.check();
  orient_outwards(points, propagate_orientation(shape, parallel, control), control);
  if (orientation == Normal_orientation::MST) orient_by_spanning_tree(points, neighbors);
  control.check();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector3& v = points.normals[i];
    raw.normals[points.elements[i]] = {v.x, v.y, v.z};
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_ESTIMATE_NORMALS_H
