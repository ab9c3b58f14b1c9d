// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ESTIMATE_NORMALS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ESTIMATE_NORMALS_H

#include <CGAL/Weakly_convex_segmentation/internal/oriented_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/run_control.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

// Normals for points that have none, by CGAL's point set processing: estimated from the neighbors,
// then oriented consistently along a minimum spanning tree.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

using Normal_kernel = CGAL::Simple_cartesian<double>;
using Point_to_orient = std::tuple<Normal_kernel::Point_3, Normal_kernel::Vector_3, std::size_t>;

/// The positions. Whoever looks one up lets the callback of the run speak: CGAL's functions take most of
/// the time of a run, and an exception is the only way out of them.
struct Asking_point_map
{
  using key_type = Point_to_orient;
  using value_type = Normal_kernel::Point_3;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;
  const Run_control* control;
  friend reference get(const Asking_point_map& map, const key_type& key)
  {
    map.control->check_sometimes();
    return std::get<0>(key);
  }
};

/// orients the normals along a minimum spanning tree, then again those of the pieces that the tree has
/// not reached: each begins at its highest point.
template <typename Points, typename NamedParameters>
void orient_normals(Points& points, const unsigned int neighbors, const NamedParameters& np)
{
  constexpr std::size_t smallest_piece = 4; // fewer have no plane
  constexpr int most_pieces = 64;           // each costs a search tree over the rest
  auto first = points.begin();
  for (int piece = 0; piece < most_pieces; ++piece)
  {
    if (static_cast<std::size_t>(points.end() - first) < smallest_piece) return;
    auto rest = CGAL::make_range(first, points.end());
    const auto unoriented = CGAL::mst_orient_normals(rest, neighbors, np); // moved to the end
    if (unoriented == first) return;
    first = unoriented;
  }
}

/// fills `raw.normals`. Points that the orientation does not reach keep their unoriented normal.
template <typename ConcurrencyTag>
void estimate_normals(Raw_points& raw, const Run_control& control)
{
  constexpr unsigned int neighbors = 12;
  std::vector<Point_to_orient> points;
  points.reserve(raw.positions.size());
  for (std::size_t i = 0; i < raw.positions.size(); ++i)
  {
    const auto& p = raw.positions[i];
    points.emplace_back(Normal_kernel::Point_3(p[0], p[1], p[2]),
                        Normal_kernel::Vector_3(0., 0., 1.), i);
  }
  if (points.size() > 3)
  {
    const auto np = CGAL::parameters::point_map(Asking_point_map{&control})
                        .normal_map(CGAL::Nth_of_tuple_property_map<1, Point_to_orient>());
    CGAL::pca_estimate_normals<ConcurrencyTag>(points, neighbors, np);
    control.check();
    orient_normals(points, neighbors, np);
  }
  raw.normals.assign(points.size(), {0., 0., 1.});
  for (const auto& [point, normal, index] : points)
    raw.normals[index] = {normal.x(), normal.y(), normal.z()};
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_ESTIMATE_NORMALS_H
