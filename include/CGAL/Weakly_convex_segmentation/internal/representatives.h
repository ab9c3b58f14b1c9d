// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_REPRESENTATIVES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_REPRESENTATIVES_H

#include <CGAL/Weakly_convex_segmentation/internal/oriented_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

// Bounded work in the middle: everything that is not linear runs on about a fixed number of
// representatives, and the labels are carried back to the points.

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
  // ten points in a voxel tell that it is occupied as well as a hundred do
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
  const auto cell = [side](const float c)
  { return spread_bits(static_cast<std::uint64_t>((std::max)(0.f, c + 0.5f) / side)); };
  return cell(p.x) | cell(p.y) << 1 | cell(p.z) << 2;
}

/// thins the points to about `count` voxels. Opposite sides of a thin sheet in one voxel stay apart:
/// points are grouped only with normals within 60 degrees, so that thin parts do not vanish.
///
/// Complexity: linear but for the sort of one integer a point.
inline Representatives thin_points(const Oriented_points& points, const std::size_t count,
                                   const bool parallel)
{
  struct Group
  {
    Vector3 position, normal, first_normal;
    std::size_t size;
    Index next; // another group in the same voxel
  };
  constexpr Index none = static_cast<Index>(-1);
  const float side = voxel_side(points, count, parallel);
  std::vector<std::uint64_t> keys(parallel ? points.size() : 0); // one thread makes them on its way
  parallel_for(
      keys.size(), parallel,
      [&](const std::size_t i) { keys[i] = voxel_key(points.positions[i], side); }, 4096);
  std::vector<Group> groups;
  std::unordered_map<std::uint64_t, Index> first_in_voxel;
  first_in_voxel.reserve(2 * count);
  std::uint64_t last_key = 0; // the next point is often in the same voxel
  Index* last_first = nullptr;

  Representatives result;
  result.of_point.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3& n = points.normals[i];
    const std::uint64_t key = parallel ? keys[i] : voxel_key(points.positions[i], side);
    if (last_first == nullptr || key != last_key)
      last_first = &first_in_voxel.emplace(key, none).first->second; // stays when the map grows
    last_key = key;
    Index g = *last_first;
    const bool has_normal = squared_length(n) > 0.f; // points without one join any group
    while (g != none && has_normal && dot(groups[g].first_normal, n) < 0.5f) g = groups[g].next;
    if (g == none)
    {
      g = static_cast<Index>(groups.size());
      groups.push_back({{}, {}, n, 0, *last_first});
      *last_first = g;
    }
    groups[g].position = groups[g].position + points.positions[i];
    groups[g].normal = groups[g].normal + n;
    ++groups[g].size;
    result.of_point[i] = g;
  }

  Oriented_points& thinned = result.points;
  thinned.extent = points.extent;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    thinned.positions.push_back((1.f / static_cast<float>(groups[g].size)) * groups[g].position);
    thinned.normals.push_back(normalized(groups[g].normal, groups[g].first_normal));
    thinned.elements.push_back(static_cast<Index>(g));
  }
  thinned.links = renamed_links(points.links, result.of_point);
  return result;
}

/// returns the points themselves if they are few, else about `count` representatives.
inline Representatives choose_representatives(const Oriented_points& points,
                                              const std::size_t count, const bool parallel = false)
{
  if (points.size() > count + count / 4) return thin_points(points, count, parallel);
  Representatives all;
  all.points = points;
  return all;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_REPRESENTATIVES_H
