// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_GROUP_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_GROUP_H

// The primitive of the AABB tree of disks: four disks that lie together, so that a line of sight is
// tested against all of them at once. A primitive of one disk takes 1.13 times as long for a whole run.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Float4.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Disk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Where a ray met the surface.
struct Ray_hit
{
  static constexpr Index none = static_cast<Index>(-1);
  float distance = std::numeric_limits<float>::infinity();
  Index disk = none;

  bool found() const { return disk != none; }
};

/// A line with what the tests of boxes and disks need of it.
struct Disk_query
{
  Line_of_sight line;
  Float4 source, reciprocal; ///< the fourth number is that of the position along the line
  float squared_clearance;   ///< relative to the squared radius of a disk
  float least_squared_slope; ///< at a lower one, the line grazes a disk

  Disk_query(const Line_of_sight& l, const float clearance, const float least_squared_sine)
    : line(l), source(l.source.x, l.source.y, l.source.z, 0.f),
      reciprocal(l.reciprocal.x, l.reciprocal.y, l.reciprocal.z, l.limit),
      squared_clearance(clearance * clearance),
      least_squared_slope(least_squared_sine * squared_length(l.direction))
  {}
};

/// The box of disks. In the fourth dimension it reaches from 0 to 1: there, the test of the slabs
/// limits a line to its length.
struct Disk_box
{
  static constexpr std::uint32_t no_bound = 0xffffffffu;

  Float4 low{infinity(), infinity(), infinity(), 0.f};
  Float4 high{-infinity(), -infinity(), -infinity(), 1.f};
  std::uint32_t bound = no_bound; ///< of the normals, where there are lines that graze them all

  static constexpr float infinity() { return (std::numeric_limits<float>::max)(); }

  void extend(const Disk_box& other)
  {
    low = minimum(low, other.low);
    high = maximum(high, other.high);
  }

  int longest_axis() const
  {
    const Float4 size = high - low;
    return size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
  }

  /// returns whether the line meets the box, and sets where it enters.
  bool meets(const Disk_query& query, float& entry) const
  {
    const Float4 a = (low - query.source) * query.reciprocal;
    const Float4 b = (high - query.source) * query.reciprocal;
    entry = largest(minimum(a, b));
    return smallest(maximum(a, b)) >= entry;
  }
};

/// Up to four disks. Those that are missing have a negative squared radius, which no line crosses.
class Disk_group
{
public:
  using Id = Index;

  /// takes the disks with the indices `[first, last)`, at least one.
  template <typename Iterator>
  Disk_group(const std::vector<Disk>& disks, const Iterator first, const Iterator last)
    : m_squared_radius(-1.f)
  {
    m_index.fill(Ray_hit::none);
    for (int c = 0; c < 3; ++c) m_center[c] = m_normal[c] = Float4(0.f);
    for (int k = 0; k < last - first; ++k)
    {
      const Disk& disk = disks[first[k]];
      m_index[k] = first[k];
      m_squared_radius[k] = disk.radius * disk.radius;
      for (int c = 0; c < 3; ++c)
      {
        const float n = m_normal[c][k] = disk.normal[c];
        const float center = m_center[c][k] = disk.center[c];
        // half extent of a disk along an axis: radius * sin(angle of axis and normal)
        const float half = disk.radius * std::sqrt((std::max)(0.f, 1.f - n * n)) + 1e-7f;
        m_box.low[c] = (std::min)(m_box.low[c], center - half);
        m_box.high[c] = (std::max)(m_box.high[c], center + half);
      }
    }
  }

  Id id() const { return m_index[0]; }
  const Disk_box& box() const { return m_box; }

  void add_normals_to(std::vector<Vector3>& normals) const
  {
    for (int k = 0; k < 4; ++k)
      if (m_index[k] != Ray_hit::none)
        normals.push_back({m_normal[0][k], m_normal[1][k], m_normal[2][k]});
  }

  /// returns whether one of the disks hides the end of the line. A disk does not if its center is within the
  /// clearance of an end: the ends lie on the surface, and disks there would hide every point behind its
  /// own neighborhood. Nor does one that the line grazes.
  bool occludes(const Disk_query& query) const
  {
    Float4 slope, margin;
    const Float4 t = crossings(query, slope, margin);
    if (largest(margin) < 0.f) return false; // most are
    for (int k = 0; k < 4; ++k)              // a line within the plane of a disk has no finite t
      if (t[k] > 0.f && t[k] < query.line.limit && margin[k] >= 0.f &&
          slope[k] * slope[k] >= query.least_squared_slope)
        return true;
    return false;
  }

  /// looks for a disk that the line meets nearer than `nearest`: from behind for `side` 1, from the
  /// front for -1. Of those that are equally near, the one of the lowest index counts.
  void find_nearest(const Disk_query& query, const float side, float& nearest, Index& disk) const
  {
    Float4 slope, margin;
    const Float4 t = crossings(query, slope, margin);
    if (largest(margin) < 0.f) return;
    for (int k = 0; k < 4; ++k)
      if (t[k] > 0.f && margin[k] >= 0.f && side * slope[k] > 0.f &&
          (t[k] < nearest || (t[k] == nearest && disk != Ray_hit::none && m_index[k] < disk)))
      {
        nearest = t[k];
        disk = m_index[k];
      }
  }

private:
  /// returns where the line crosses the disks' planes, as factors of its direction, and a margin that is
  /// negative where it misses the disk or an end is too near.
  Float4 crossings(const Disk_query& query, Float4& slope, Float4& margin) const
  {
    const Line_of_sight& line = query.line;
    std::array<Float4, 3> to_center;
    for (int c = 0; c < 3; ++c) to_center[c] = m_center[c] - Float4(line.source[c]);
    const std::array<Float4, 3> d = {Float4(line.direction.x), Float4(line.direction.y),
                                     Float4(line.direction.z)};
    slope = m_normal[0] * d[0] + m_normal[1] * d[1] + m_normal[2] * d[2];
    const Float4 t =
        (m_normal[0] * to_center[0] + m_normal[1] * to_center[1] + m_normal[2] * to_center[2]) /
        slope;
    Float4 off(0.f), from_source(0.f), from_target(0.f);
    const auto square = [](const Float4& a) { return a * a; };
    for (int c = 0; c < 3; ++c)
    {
      off = off + square(t * d[c] - to_center[c]);
      from_source = from_source + square(to_center[c]);
      from_target = from_target + square(to_center[c] - d[c]);
    }
    const Float4 cleared = Float4(query.squared_clearance) * m_squared_radius;
    margin = minimum(m_squared_radius - off, minimum(from_source, from_target) - cleared);
    return t;
  }

  std::array<Float4, 3> m_center, m_normal;
  Float4 m_squared_radius;
  std::array<Index, 4> m_index;
  Disk_box m_box; // CGAL does not test boxes of single primitives
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_GROUP_H
