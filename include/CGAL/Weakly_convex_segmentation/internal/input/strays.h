// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_STRAYS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_STRAYS_H

// What lies far from a shape: all lengths are relative to its extent, so that one stray point would change what is
// near and what is thin everywhere. Strays are left out, and get the label of what is nearest to them; what is large
// enough to have parts of its own has them, but no say in the extent.

#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What a point is to a shape.
enum class Point_role : unsigned char
{
  SHAPE,
  FAR,  ///< of something else, far away
  STRAY ///< not looked at
};

/// Where most of the points are.
struct Bulk
{
  Coordinates center; ///< the median of each coordinate
  double size;        ///< about the diameter of most of the points
};

/// returns whether a shape has points so far away as no shape in one piece has, in linear time.
inline bool has_far_points(const std::vector<Coordinates>& positions)
{
  constexpr double far = 2.5; // times the mean, in squares; a straight line has 1.7
  const double n = static_cast<double>(positions.size());
  Coordinates mean = {0., 0., 0.};
  for (const Coordinates& p : positions)
    for (int c = 0; c < 3; ++c) mean[c] += p[c] / n;
  double largest = 0., sum = 0.;
  for (const Coordinates& p : positions)
  {
    double squared = 0.;
    for (int c = 0; c < 3; ++c) squared += (p[c] - mean[c]) * (p[c] - mean[c]);
    largest = (std::max)(largest, squared);
    sum += squared / n;
  }
  return largest > far * far * sum;
}

inline Bulk find_bulk(const std::vector<Coordinates>& positions)
{
  constexpr double diameter = 2.5; // of a sphere and a straight line: 1.2 and 0.9 of what they have
  const auto quantile = [](std::vector<double>& values, const double share)
  {
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  Bulk bulk{};
  std::vector<double> values(positions.size());
  for (int c = 0; c < 3; ++c)
  {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = positions[i][c];
    bulk.center[c] = quantile(values, 0.5);
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = length(positions[i] - bulk.center);
  bulk.size = diameter * quantile(values, 0.75);
  return bulk;
}

/// Points that hang together: no point of another is in a cell beside one of theirs.
struct Cluster
{
  std::size_t size = 0;
  CGAL::Bbox_3 box;
  /// distance of the points from the center of the bulk, the least
  double nearest = std::numeric_limits<double>::infinity();
  bool is_of_shape = false;
};

/// The clusters of points by a grid about the bulk.
struct Clusters
{
  std::vector<Index> of_point;
  std::vector<Cluster> clusters;
};

inline Clusters cluster_points(const std::vector<Coordinates>& positions, const Bulk& bulk)
{
  // a surface of n points has them about 1.7 / sqrt(n) of its size apart
  const double side =
      bulk.size *
      (std::min)(0.5, (std::max)(0.1, 6. / std::sqrt(static_cast<double>(positions.size()))));
  using Cell = std::array<std::int64_t, 3>;
  std::map<Cell, Index> cells;
  Clusters result;
  for (const Coordinates& p : positions)
  {
    Cell cell;
    for (int c = 0; c < 3; ++c)
      cell[c] = static_cast<std::int64_t>(
          std::floor((std::max)(-1e9, (std::min)(1e9, (p[c] - bulk.center[c]) / side))));
    result.of_point.push_back(cells.emplace(cell, static_cast<Index>(cells.size())).first->second);
  }
  Disjoint_sets<Index> sets(cells.size());
  for (const auto& [cell, number] : cells)
    for (int k = 0; k < 27; ++k)
    {
      const auto beside =
          cells.find({cell[0] + k / 9 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k % 3 - 1});
      if (beside != cells.end()) sets.join(number, beside->second);
    }
  result.clusters.resize(cells.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    result.of_point[i] = sets.find(result.of_point[i]);
    Cluster& cluster = result.clusters[result.of_point[i]];
    const Coordinates& p = positions[i];
    ++cluster.size;
    cluster.box += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
    cluster.nearest = (std::min)(cluster.nearest, length(p - bulk.center));
  }
  return result;
}

/// returns the role of each point by where it is; nothing if all are of the shape.
///
/// The shape is what reaches into the bulk, and what is large and near to that. Complexity: O(n log n), but linear
/// where no point is far away.
inline std::vector<Point_role> roles_of_positions(const std::vector<Coordinates>& positions)
{
  constexpr double large = 0.002, most = 0.3;                      // of the points
  constexpr double near = 0.5, touching = 0.1, out_of_sight = 1e4; // of the shape's diagonal
  constexpr std::size_t fewest = 5;
  if (positions.size() < 4 * fewest || !has_far_points(positions)) return {};
  const Bulk bulk = find_bulk(positions);
  if (!(bulk.size > 0.)) return {};
  Clusters found = cluster_points(positions, bulk);
  const auto is_large = [&](const Cluster& c)
  {
    return c.size >= fewest &&
           static_cast<double>(c.size) >= large * static_cast<double>(positions.size());
  };
  CGAL::Bbox_3 shape;
  for (Cluster& c : found.clusters)
  {
    if (c.size == 0 || c.nearest > bulk.size) continue;
    c.is_of_shape = true;
    shape += c.box;
  }
  for (bool has_grown = true; has_grown;)
  {
    has_grown = false;
    for (Cluster& c : found.clusters)
    {
      if (c.is_of_shape || !is_large(c) || gap(c.box, shape) > near * diagonal(shape)) continue;
      c.is_of_shape = has_grown = true;
      shape += c.box;
    }
  }
  const auto role_of = [&](const Cluster& c)
  {
    const double distance = gap(c.box, shape) / diagonal(shape);
    if (c.is_of_shape || distance <= touching) return Point_role::SHAPE;
    return is_large(c) && distance < out_of_sight ? Point_role::FAR : Point_role::STRAY;
  };
  std::vector<Point_role> roles;
  for (const Index c : found.of_point) roles.push_back(role_of(found.clusters[c]));
  const auto of_shape = std::count(roles.begin(), roles.end(), Point_role::SHAPE);
  const double others = static_cast<double>(roles.size()) - static_cast<double>(of_shape);
  if (others == 0. || others > most * static_cast<double>(roles.size())) return {};
  return roles;
}

/// returns the role of each point; nothing if all are of the shape. Doubled faces are left out as strays are.
inline std::vector<Point_role> point_roles(const Raw_shape& raw)
{
  std::vector<Point_role> roles = roles_of_positions(raw.positions);
  if (!raw.is_double.empty()) roles.resize(raw.positions.size(), Point_role::SHAPE);
  for (std::size_t f = 0; f < raw.is_double.size(); ++f)
    if (raw.is_double[f] != 0) roles[f] = Point_role::STRAY;
  return roles;
}

/// returns a shape without its strays. Its elements are those of the whole shape.
inline Raw_shape without_strays(const Raw_shape& raw, const std::vector<Point_role>& roles)
{
  constexpr Index none = static_cast<Index>(-1);
  Raw_shape rest;
  rest.exponent = raw.exponent;
  rest.number_of_elements = raw.positions.size();
  std::vector<Index> place(roles.size(), none);
  if (!raw.first_corner.empty()) rest.first_corner.push_back(0);
  for (Index i = 0; i < roles.size(); ++i)
  {
    if (roles[i] == Point_role::STRAY) continue;
    place[i] = static_cast<Index>(rest.positions.size());
    rest.element_of.push_back(i);
    rest.is_far.push_back(roles[i] == Point_role::FAR ? 1 : 0);
    rest.positions.push_back(raw.positions[i]);
    if (!raw.normals.empty()) rest.normals.push_back(raw.normals[i]);
    if (raw.first_corner.empty()) continue;
    for (std::size_t c = raw.first_corner[i]; c < raw.first_corner[i + 1]; ++c)
      rest.corners.push_back(raw.corners[c]);
    rest.first_corner.push_back(rest.corners.size());
  }
  for (const auto& [a, b] : raw.links)
    if (place[a] != none && place[b] != none) rest.links.push_back({place[a], place[b]});
  return rest;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_STRAYS_H
