// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_DOWNSAMPLING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_DOWNSAMPLING_H

// Bounded work in the middle: everything that is not linear runs on about a fixed number of
// representatives, and the labels are carried back to the points.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A thinned shape and how the points belong to it.
struct Representatives
{
  Oriented_points points;
  std::vector<Index> of_point; ///< representative of each point; empty if they are the same
};

/// returns the number of occupied cells of the octree over every `step`-th of the points, a level from
/// the root.
inline std::array<std::size_t, 22> occupied_cells(const Oriented_points& points,
                                                  const std::size_t step, const bool parallel)
{
  const auto cell = [](const float c)
  { return spread_bits(static_cast<std::uint64_t>((std::max)(0.f, c + 0.5f) * 2097151.f)); };
  std::vector<std::uint64_t> keys((points.size() + step - 1) / step);
  parallel_for(
      keys.size(), parallel,
      [&](const std::size_t i)
      {
        const Vector3& p = points.positions[i * step];
        keys[i] = cell(p.x) | cell(p.y) << 1 | cell(p.z) << 2;
      },
      4096);
  // the points are in the order of another cube, which would count a cell at each return to it
  parallel_sort(keys.begin(), keys.end(), parallel, std::less<std::uint64_t>());
  std::array<std::size_t, 22> starting{}; // cells whose first point differs first at that level
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    int level = 0;
    if (i > 0)
      for (level = 1;
           level < 22 && (keys[i] >> (63 - 3 * level)) == (keys[i - 1] >> (63 - 3 * level));)
        ++level;
    if (level < 22) ++starting[level];
  }
  for (int level = 1; level < 22; ++level) starting[level] += starting[level - 1];
  return starting;
}

/// returns the side of a voxel grid that has about `count` occupied voxels.
inline float voxel_side(const Oriented_points& points, const std::size_t count,
                        const bool parallel = false)
{
  // ten points show that a voxel is occupied as well as a hundred do
  const auto cells = occupied_cells(
      points, (std::max)(points.size() / (10 * (std::max)(count, std::size_t(1))), std::size_t(1)),
      parallel);
  int level = 0;
  while (level < 20 && cells[level + 1] <= count) ++level;
  const double low = static_cast<double>(cells[level]);
  const double high = (std::max)(static_cast<double>(cells[level + 1]), low * 1.1);
  const double share = std::log(static_cast<double>(count) / low) / std::log(high / low);
  // not finer than 20 bits a coordinate, which the voxels' keys have room for
  return static_cast<float>(std::pow(2., -(std::min)(20., level + (std::max)(0., share))));
}

/// returns the voxel of a position.
inline std::uint64_t voxel_key(const Vector3& p, const float side)
{
  const auto cell = [side](const float c) // what is far away has negative ones, or of more bits
  {
    return spread_bits(
        static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor((c + 0.5f) / side))));
  };
  return cell(p.x) | cell(p.y) << 1 | cell(p.z) << 2;
}

/// Points that one representative stands for.
struct Point_group
{
  Vector3 position, normal; ///< sums
  Vector3 first_normal;     ///< stands in where the normals cancel out
  std::size_t size;
  Index solid;
  Index next; ///< another group in the same voxel, or -1

  void add(const Vector3& p, const Vector3& n)
  {
    position = position + p;
    normal = normal + n;
    ++size;
  }
};

/// returns a representative for each group.
inline Representatives represent_groups(const Oriented_points& points,
                                        const std::vector<Point_group>& groups,
                                        std::vector<Index> group_of_point)
{
  Representatives result;
  result.of_point = std::move(group_of_point);
  Oriented_points& thinned = result.points;
  thinned.extent = points.extent;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    thinned.positions.push_back((1.f / static_cast<float>(groups[g].size)) * groups[g].position);
    thinned.normals.push_back(normalized(groups[g].normal, groups[g].first_normal));
    thinned.elements.push_back(static_cast<Index>(g));
    if (!points.solids.empty()) thinned.solids.push_back(groups[g].solid);
  }
  if (!points.is_far.empty())
  {
    thinned.is_far.resize(groups.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      thinned.is_far[result.of_point[i]] = points.is_far[i];
  }
  thinned.links = renamed_links(points.links, result.of_point);
  return result;
}

/// thins the points to two representatives a voxel at most, one for each side of the surface by the main axis of
/// the normals in the voxel: where noise has bent the normals at random, they say no more than that.
///
/// Complexity: O(n log n).
inline Representatives thin_by_sides(const Oriented_points& points, const float side)
{
  constexpr Index none = static_cast<Index>(-1);
  struct Voxel
  {
    Symmetric_matrix3 normals;
    Vector3 axis;
    std::array<Index, 2> groups = {none, none};
  };
  std::vector<Voxel> voxels;
  std::map<std::pair<Index, std::uint64_t>, Index> voxel_at; // by solid
  std::vector<Index> of_point(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto [slot, is_new] =
        voxel_at.emplace(std::make_pair(points.solid(i), voxel_key(points.positions[i], side)),
                         static_cast<Index>(voxels.size()));
    if (is_new) voxels.emplace_back();
    of_point[i] = slot->second;
    const Vector3& n = points.normals[i];
    voxels[slot->second].normals += Symmetric_matrix3(in_double(n));
  }
  for (Voxel& voxel : voxels)
  {
    const Double3 axis = Principal_axes(voxel.normals).longest();
    voxel.axis = {static_cast<float>(axis.x), static_cast<float>(axis.y),
                  static_cast<float>(axis.z)};
  }
  std::vector<Point_group> groups;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Voxel& voxel = voxels[of_point[i]];
    Index& g = voxel.groups[dot(voxel.axis, points.normals[i]) < 0.f ? 1 : 0];
    if (g == none)
    {
      g = static_cast<Index>(groups.size());
      groups.push_back({{}, {}, points.normals[i], 0, points.solid(i), none});
    }
    groups[g].add(points.positions[i], points.normals[i]);
    of_point[i] = g;
  }
  return represent_groups(points, groups, std::move(of_point));
}

/// returns whether noise has bent the normals at random: only corners and narrow gaps of a shape have points of
/// three walls in one voxel.
inline bool has_mixed_orientations(const std::vector<Point_group>& groups,
                                   const std::unordered_map<std::uint64_t, Index>& first_in_voxel)
{
  constexpr Index none = static_cast<Index>(-1);
  constexpr double most = 0.04; // shapes without noise: up to 0.03
  std::size_t with_three = 0;
  for (const auto& voxel : first_in_voxel)
  {
    const Index second = groups[voxel.second].next;
    if (second != none && groups[second].next != none) ++with_three;
  }
  return static_cast<double>(with_three) > most * static_cast<double>(first_in_voxel.size());
}

/// thins the points to about `count` voxels. Opposite sides of a thin sheet in one voxel stay apart:
/// points are grouped only with normals within 60 degrees, so that thin parts do not vanish.
/// `despite_noise`: by sides instead if the normals point anywhere.
///
/// Complexity: linear but for the sort of one integer a point.
inline Representatives thin_points(const Oriented_points& points, const std::size_t count,
                                   const bool parallel, const bool despite_noise)
{
  constexpr Index none = static_cast<Index>(-1);
  const float side = voxel_side(points, count, parallel);
  std::vector<std::uint64_t> keys(parallel ? points.size() : 0); // one thread makes them on its way
  parallel_for(
      keys.size(), parallel,
      [&](const std::size_t i) { keys[i] = voxel_key(points.positions[i], side); }, 4096);
  std::vector<Point_group> groups;
  std::unordered_map<std::uint64_t, Index> first_in_voxel;
  first_in_voxel.reserve(2 * count);
  std::uint64_t last_key = 0; // the next point is often in the same voxel
  Index* last_first = nullptr;
  std::vector<Index> of_point(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3& n = points.normals[i];
    const std::uint64_t key = parallel ? keys[i] : voxel_key(points.positions[i], side);
    if (last_first == nullptr || key != last_key)
      last_first = &first_in_voxel.emplace(key, none).first->second; // stays when the map grows
    last_key = key;
    Index g = *last_first;
    const bool has_normal = squared_length(n) > 0.f; // points without one join any group
    const auto is_other = [&](const Point_group& group)
    { return group.solid != points.solid(i) || (has_normal && dot(group.first_normal, n) < 0.5f); };
    while (g != none && is_other(groups[g])) g = groups[g].next;
    if (g == none)
    {
      g = static_cast<Index>(groups.size());
      groups.push_back({{}, {}, n, 0, points.solid(i), *last_first});
      *last_first = g;
    }
    groups[g].add(points.positions[i], n);
    of_point[i] = g;
  }
  if (despite_noise && has_mixed_orientations(groups, first_in_voxel))
    return thin_by_sides(points, side);
  return represent_groups(points, groups, std::move(of_point));
}

/// returns the points themselves if they are few, besides what is far away, else about `count` representatives.
inline Representatives downsample(const Oriented_points& points, const std::size_t count,
                                  const bool parallel = false, const bool despite_noise = false)
{
  if (number_of_near_points(points) > count + count / 4)
    return thin_points(points, count, parallel, despite_noise);
  Representatives all;
  all.points = points;
  return all;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_POINTS_DOWNSAMPLING_H
