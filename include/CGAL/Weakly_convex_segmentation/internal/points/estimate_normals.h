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
// of thin shapes without noise it turns 54 % outwards, propagation 99.9 %, of thick ones 81 % and 99.3 %; of
// 20,000, whose walls are thicker than their neighborhoods, both all (`benchmark_normals`).
//
// Of walls as thin as the points are apart, a dozen neighbors have no plane: where that shows, more are asked. Of a plate
// of .5 to 2 spacings 97 % and more look outwards then, instead of half; of 58 other clouds of 4,000 and 8,000 points,
// half of them noisy, 99.2 % instead of 98.3 %.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Kd_tree.h>
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
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Known neighbors of a point, for what `CGAL::pca_estimate_normals()` does at each point: the public function
/// itself would search for them anew.
class Known_neighbors
{
public:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Row = Compressed_rows<Index>::Row<const Index*>;

private:
  const std::vector<Vector3>& m_positions;
  Index m_point;
  Row m_neighbors;

public:
  Known_neighbors(const std::vector<Vector3>& positions, const Index point, const Row neighbors)
    : m_positions(positions), m_point(point), m_neighbors(neighbors)
  {}

  /// calls `visit` for the neighbors, as seen from the point.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    for (const Index i : m_neighbors)
      if (i != m_point) visit(m_positions[i] - m_positions[m_point]);
  }

  template <typename Output>
  void get_points(const Kernel::Point_3& point, unsigned int, Kernel::FT, Output output) const
  {
    *output++ = point;
    for_each([&](const Vector3& d) { *output++ = point + Kernel::Vector_3(d.x, d.y, d.z); });
  }

  bool are_in_one_place() const
  {
    bool result = true;
    for_each([&](const Vector3& d) { result = result && squared_length(d) == 0.f; });
    return result;
  }

  /// returns a unit vector across the plane that fits the point and its neighbors best, of either sign.
  Vector3 normal() const
  {
    // as seen from the point, so that no digits are lost where points are dense
    const Kernel::Vector_3 across = CGAL::internal::pca_estimate_normal(
        Kernel::Point_3(0., 0., 0.), *this, static_cast<unsigned int>(m_neighbors.size()),
        Kernel::FT(0.));
    return normalized({static_cast<float>(across.x()), static_cast<float>(across.y()),
                       static_cast<float>(across.z())});
  }
};

/// Mean squares of the distances of a point and its neighbors from the plane through them all.
struct Roughness
{
  float all = 0.f;
  float share =
      0.f; ///< of `all` in that of the distances from any other plane, the least: 1 if it is none
  float center = 0.f; ///< height of the plane over the point

  Roughness(const Known_neighbors& neighbors, const Vector3& normal)
  {
    const Vector3 axis =
        std::abs(normal.x) < 0.7f ? Vector3{1.f, 0.f, 0.f} : Vector3{0.f, 1.f, 0.f};
    const Vector3 u = normalized(cross(normal, axis)), v = cross(normal, u);
    float n = 1.f, uu = 0.f, uv = 0.f, vv = 0.f, squares = 0.f;
    Vector3 sum;
    const auto add = [&](const Vector3& d)
    {
      const Vector3 p{dot(normal, d), dot(u, d), dot(v, d)};
      n += 1.f;
      sum = sum + p;
      squares += p.x * p.x;
      uu += p.y * p.y;
      uv += p.y * p.z;
      vv += p.z * p.z;
    };
    neighbors.for_each(add);
    const Vector3 mean = (1.f / n) * sum;
    center = mean.x;
    all = (std::max)(0.f, (squares - sum.x * mean.x) / n);
    uu = uu / n - mean.y * mean.y, uv = uv / n - mean.y * mean.z, vv = vv / n - mean.z * mean.z;
    const float least = 0.5f * (uu + vv) - std::hypot(0.5f * (uu - vv), uv);
    share = least > all ? all / least : 1.f;
  }

  /// returns that of the points on this point's side of the plane, from another plane through these.
  float of_own_side(const Known_neighbors& neighbors, const Vector3& normal) const
  {
    float n = 1.f, sum = 0.f, squares = 0.f; // the point itself is at height 0
    const auto add = [&](const Vector3& d)
    {
      const float height = dot(normal, d);
      if ((height > center) != (0.f > center)) return;
      n += 1.f;
      sum += height;
      squares += height * height;
    };
    neighbors.for_each(add);
    return (std::max)(0.f, (squares - sum * sum / n) / n);
  }
};

/// sets the normal of a point to a unit vector across the plane that fits it and its neighbors best, of
/// either sign, or to zero if they are all in one place, and the roughness; returns `Roughness::share`.
inline float fit_plane(Unoriented_points& shape, const Index i)
{
  const Index* const row = &shape.nearest[i * shape.k];
  const Known_neighbors neighbors(shape.points.positions, i, {row, row + shape.k});
  shape.points.normals[i] = {};
  if (neighbors.are_in_one_place()) return 0.f;
  const Vector3 normal = neighbors.normal();
  const Roughness roughness(neighbors, normal);
  shape.points.normals[i] = normal;
  shape.roughness[i] = roughness.all;
  return roughness.share;
}

/// fits the plane of a point to more neighbors if its nearest ones are not flat, and more are flatter: as those of a wall
/// about as thin as they are apart, whose plane is no more theirs than others.
inline void fit_wide_plane(Unoriented_points& shape, const Kd_tree& tree, const Index i,
                           const float share)
{
  constexpr std::size_t more = 96;
  constexpr float flat = 0.15f, flatter = 0.75f;
  constexpr float two_sheets =
      0.2f; // share of the variance in the sheets; .36 in halves of one with noise
  if (share < flat) return;
  const std::vector<Vector3>& positions = shape.points.positions;
  std::vector<Index> nearest;
  tree.nearest(positions[i], more, [&nearest](const Index j, float) { nearest.push_back(j); });
  const Known_neighbors neighbors(positions, i, {nearest.data(), nearest.data() + nearest.size()});
  const Vector3 normal = neighbors.normal();
  const Roughness roughness(neighbors, normal);
  if (!(roughness.share < flatter * share)) return;
  shape.points.normals[i] = normal;
  const float own_side = roughness.of_own_side(neighbors, normal);
  shape.roughness[i] = own_side < two_sheets * roughness.all ? own_side : roughness.all;
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
  const Kd_tree tree(points.positions);
  std::vector<Index> nearest =
      nearest_neighbors(points, tree, neighbors, spacing, parallel, control);
  control.check();
  Unoriented_points shape{points, std::vector<float>(n, 0.f), std::move(nearest), neighbors};
  parallel_for(n, parallel,
               [&](const std::size_t i)
               {
                 control.check_sometimes();
                 const Index point = static_cast<Index>(i);
                 const float share = fit_plane(shape, point);
                 if (orientation == Normal_orientation::PROPAGATION)
                   fit_wide_plane(shape, tree, point, share);
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
