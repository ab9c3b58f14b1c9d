// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_ORIENTED_POINTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_ORIENTED_POINTS_H

// Input of the method (section 3): an oriented point cloud, or a triangle mesh as one oriented point
// a face (section 6).

#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/pca_frame.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// How the frame of the method lies in the input.
struct Placement
{
  Frame frame;
  Double3 center; ///< in the turned input
  double scale = 1.;
  int exponent = 0;

  /// returns where a point of the method's frame lies in the input.
  Coordinates position(const Vector3& p) const
  {
    const Double3 turned{center.x + scale * p.x, center.y + scale * p.y, center.z + scale * p.z};
    return scaled(frame.inverse(turned), exponent);
  }
  /// returns where a point of the input lies in the method's frame.
  Vector3 point(const Coordinates& p) const
  {
    const Coordinates q = frame(scaled(p, -exponent));
    return {static_cast<float>((q[0] - center.x) / scale),
            static_cast<float>((q[1] - center.y) / scale),
            static_cast<float>((q[2] - center.z) / scale)};
  }
  /// returns a unit vector of the input as one of the method's frame.
  Vector3 vector(const Coordinates& v) const
  {
    const Coordinates w = frame(v);
    return {static_cast<float>(w[0]), static_cast<float>(w[1]), static_cast<float>(w[2])};
  }
  /// returns a unit vector of the method's frame as one of the input.
  Coordinates direction(const Vector3& v) const { return frame.inverse({v.x, v.y, v.z}); }
};

/// Points in the frame of the method: centered at the centroid, extent 1, in spatial order; as they lie in
/// the input, or turned with the shape's own axes.
struct Oriented_points
{
  std::vector<Vector3> positions;
  std::vector<Vector3> normals; ///< unit length
  std::vector<Index> elements;  ///< input element of each point
  /// input elements without a point, and the element each takes its label from
  std::vector<std::array<Index, 2>> strays;
  std::vector<std::array<Index, 2>> links; ///< pairs of points known to be neighbors
  std::vector<Index> solids;               ///< of each point, see `find_solids()`; or empty
  std::vector<char> is_far;                ///< of each point: of something else, far away; or empty
  double extent = 1.;                      ///< in units of the input
  Placement placement;
  std::size_t number_of_elements = 0; ///< of the input; several points may share one

  std::size_t size() const { return positions.size(); }
  /// the closed piece of a mesh that a point is of, or 0
  Index solid(const std::size_t i) const { return solids.empty() ? 0 : solids[i]; }
};

inline std::size_t number_of_near_points(const Oriented_points& points)
{
  return points.size() -
         static_cast<std::size_t>(std::count(points.is_far.begin(), points.is_far.end(), char(1)));
}

/// returns the points that are of the shape itself, ascending.
inline std::vector<Index> near_points(const Oriented_points& points)
{
  std::vector<Index> result;
  for (Index i = 0; i < points.size(); ++i)
    if (points.is_far.empty() || points.is_far[i] == 0) result.push_back(i);
  return result;
}

/// returns whether points of two solids may be neighbors. What is of none joins what it touches.
inline bool may_be_neighbors(const Index solid, const Index other)
{
  return solid == other || solid == 0 || other == 0;
}

/// spreads the low 21 bits of `v` so that two zero bits follow each.
inline std::uint64_t spread_bits(std::uint64_t v)
{
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffull;
  v = (v | v << 16) & 0x1f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  v = (v | v << 2) & 0x1249249249249249ull;
  return v;
}

/// returns the input indices along a Morton curve. Neighbors in space become neighbors in memory,
/// and nothing that follows depends on the order of the input (but for exact duplicates).
inline std::vector<Index> spatial_order(const Raw_shape& raw, const Frame& frame,
                                        const Bounding_cube& cube, const bool parallel)
{
  struct Keyed
  {
    std::uint64_t key;
    Index index;
  };
  std::vector<Keyed> keyed(raw.positions.size());
  parallel_for(
      keyed.size(), parallel,
      [&](const std::size_t i)
      {
        const Coordinates p = cube.within(frame(raw.positions[i]));
        std::array<std::uint64_t, 3> cell;
        for (int c = 0; c < 3; ++c) cell[c] = static_cast<std::uint64_t>(p[c] * 2097151.);
        keyed[i].key = spread_bits(cell[0]) | spread_bits(cell[1]) << 1 | spread_bits(cell[2]) << 2;
        keyed[i].index = static_cast<Index>(i);
      },
      4096);
  parallel_sort(keyed.begin(), keyed.end(), parallel,
                [&raw](const Keyed& a, const Keyed& b)
                {
                  if (a.key != b.key) return a.key < b.key;
                  if (raw.positions[a.index] != raw.positions[b.index])
                    return raw.positions[a.index] < raw.positions[b.index];
                  if (raw.normals[a.index] != raw.normals[b.index])
                    return raw.normals[a.index] < raw.normals[b.index];
                  return a.index < b.index;
                });
  std::vector<Index> order(keyed.size());
  parallel_for(
      order.size(), parallel, [&](const std::size_t i) { order[i] = keyed[i].index; }, 4096);
  return order;
}

/// returns where the points lie in the cube, in the order given: they are spread over memory, and gathered once.
inline std::vector<Coordinates> places_within(const Raw_shape& raw, const Frame& frame,
                                              const std::vector<Index>& order,
                                              const Bounding_cube& cube, const bool parallel)
{
  std::vector<Coordinates> places(order.size());
  parallel_for(
      order.size(), parallel,
      [&](const std::size_t i) { places[i] = cube.within(frame(raw.positions[order[i]])); }, 4096);
  return places;
}

/// The sphere about the centroid that holds all points but those far away, within a bounding cube.
struct Bounding_ball
{
  Coordinates center = {0., 0., 0.};
  double radius = 0.;
};

/// returns the ball of places, without those far away: `is_far(i)`. The sum over the points is in the order given, so
/// that it does not depend on that of the input.
template <typename Is_far>
Bounding_ball bounding_ball(const std::vector<Coordinates>& places, const Is_far& is_far,
                            const bool parallel)
{
  const auto for_each = [&](const std::size_t begin, const std::size_t end, const auto& visit)
  {
    for (std::size_t i = begin; i < end; ++i)
      if (!is_far(i)) visit(places[i]);
  };
  struct Sum
  {
    Coordinates position = {0., 0., 0.};
    double count = 0.;
  };
  const auto sum_of = [&](const std::size_t begin, const std::size_t end)
  {
    Sum own;
    for_each(begin, end,
             [&own](const Coordinates& p)
             {
               for (int c = 0; c < 3; ++c) own.position[c] += p[c];
               own.count += 1.;
             });
    return own;
  };
  Bounding_ball ball;
  double count = 0.;
  for (const Sum& sum : map_blocks(places.size(), parallel, sum_of))
  {
    for (int c = 0; c < 3; ++c) ball.center[c] += sum.position[c];
    count += sum.count;
  }
  for (double& c : ball.center) c /= count;
  const auto largest_of = [&](const std::size_t begin, const std::size_t end)
  {
    double largest = 0.;
    for_each(begin, end,
             [&](const Coordinates& p)
             {
               double squared = 0.;
               for (int c = 0; c < 3; ++c)
                 squared += (p[c] - ball.center[c]) * (p[c] - ball.center[c]);
               largest = (std::max)(largest, squared);
             });
    return largest;
  };
  for (const double squared : map_blocks(places.size(), parallel, largest_of))
    ball.radius = (std::max)(ball.radius, std::sqrt(squared));
  return ball;
}

/// returns the links after renaming their ends by `new_index`, each once, the smaller end first.
inline std::vector<std::array<Index, 2>>
renamed_links(const std::vector<std::array<Index, 2>>& links, const std::vector<Index>& new_index)
{
  std::vector<std::array<Index, 2>> result;
  result.reserve(links.size());
  for (const auto& link : links)
  {
    const Index a = new_index[link[0]], b = new_index[link[1]];
    if (a != b) result.push_back({(std::min)(a, b), (std::max)(a, b)});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// returns the positions without those far away; nothing if there are none.
inline std::vector<Coordinates> near_positions(const Raw_shape& raw)
{
  std::vector<Coordinates> result;
  for (std::size_t i = 0; i < raw.is_far.size(); ++i)
    if (raw.is_far[i] == 0) result.push_back(raw.positions[i]);
  return result;
}

/// fills what is known of the points besides where they are, in their order.
inline void take_along(const Raw_shape& raw, const std::vector<Index>& order,
                       Oriented_points& points)
{
  if (!raw.links.empty())
  {
    std::vector<Index> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Index>(i);
    points.links = renamed_links(raw.links, rank);
  }
  if (!raw.is_far.empty())
    for (const Index i : order) points.is_far.push_back(raw.is_far[i]);
  if (!raw.solids.empty())
    for (const Index i : order) points.solids.push_back(raw.solids[i]);
  points.elements = order;
  points.number_of_elements = order.size();
  if (!raw.element_of.empty())
  {
    for (Index& element : points.elements) element = raw.element_of[element];
    points.number_of_elements = raw.number_of_elements;
  }
}

/// brings the input into the frame of the method.
///
/// The extent is measured from the centroid: unlike a bounding box it does not change under
/// rotation. With `along_axes` the positions do not either, see `pca_frame()`. Complexity:
/// O(n log n) for the spatial sort.
/// \throws std::invalid_argument if there are no points, too many for 32 bits, or coordinates that
/// are not finite.
inline Oriented_points orient_points(const Raw_shape& raw, const bool parallel = false,
                                     const Run_control& control = {}, const bool along_axes = false)
{
  const std::size_t n = raw.positions.size();
  if (n == 0) throw std::invalid_argument("there are no points to segment");
  if (n >= std::numeric_limits<Index>::max())
    throw std::invalid_argument("there are 2^32 points or more; thin the shape first");
  check_finite(raw.positions, "position", parallel);
  check_finite(raw.normals, "normal", parallel);

  const std::vector<Coordinates> near = near_positions(raw);
  const std::vector<Coordinates>& of_shape = near.empty() ? raw.positions : near;
  const Frame frame = along_axes ? pca_frame(of_shape, parallel) : Frame();
  const Bounding_cube cube = bounding_cube(raw.positions, frame, parallel);
  Oriented_points points;
  const std::vector<Index> order = spatial_order(raw, frame, cube, parallel);
  control.check();

  const std::vector<Coordinates> places = places_within(raw, frame, order, cube, parallel);
  const Bounding_ball ball = bounding_ball(
      places, [&](const std::size_t i) { return !raw.is_far.empty() && raw.is_far[order[i]] != 0; },
      parallel);
  const double diameter = ball.radius > 0. ? 2. * ball.radius : 1. / cube.unit();
  points.extent = diameter * cube.unit();

  control.check();
  points.positions.resize(n);
  points.normals.resize(n);
  parallel_for(
      n, parallel,
      [&](const std::size_t i)
      {
        const auto coordinate = [&](const int c)
        { return static_cast<float>((places[i][c] - ball.center[c]) / diameter); };
        points.positions[i] = {coordinate(0), coordinate(1), coordinate(2)};
        const Coordinates v = frame(raw.normals[order[i]]);
        const double l = std::hypot(v[0], v[1], v[2]);
        if (l > 0.)
          points.normals[i] = {static_cast<float>(v[0] / l), static_cast<float>(v[1] / l),
                               static_cast<float>(v[2] / l)};
      },
      4096);
  const auto middle = [&](const int c) { return cube.corner[c] + ball.center[c] * cube.unit(); };
  points.placement = {frame, {middle(0), middle(1), middle(2)}, points.extent, raw.exponent};
  points.extent = std::ldexp(points.extent, raw.exponent);
  if (!std::isfinite(points.extent)) refuse_extent();
  take_along(raw, order, points);
  return points;
}

/// returns the chosen points, in the same frame, with the links among them.
inline Oriented_points sub_points(const Oriented_points& points, const std::vector<Index>& chosen)
{
  constexpr Index none = static_cast<Index>(-1);
  Oriented_points result;
  result.extent = points.extent;
  result.placement = points.placement;
  std::vector<Index> rank(points.links.empty() ? 0 : points.size(), none);
  result.elements.reserve(chosen.size());
  result.positions.reserve(chosen.size());
  result.normals.reserve(chosen.size());
  for (const Index i : chosen)
  {
    if (!rank.empty()) rank[i] = static_cast<Index>(result.size());
    result.elements.push_back(static_cast<Index>(result.size()));
    result.positions.push_back(points.positions[i]);
    result.normals.push_back(points.normals[i]);
    if (!points.solids.empty()) result.solids.push_back(points.solids[i]);
  }
  for (const auto& link : points.links)
    if (rank[link[0]] != none && rank[link[1]] != none)
      result.links.push_back({rank[link[0]], rank[link[1]]});
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_ORIENTED_POINTS_H
