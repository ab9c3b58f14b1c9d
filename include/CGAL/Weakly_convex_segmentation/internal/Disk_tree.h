// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DISK_TREE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DISK_TREE_H

#include <CGAL/Weakly_convex_segmentation/internal/Disk.h>
#include <CGAL/Weakly_convex_segmentation/internal/Four.h>
#include <CGAL/Weakly_convex_segmentation/internal/Normal_bound.h>
#include <CGAL/Weakly_convex_segmentation/internal/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

// Every point as an oriented disk (section 3, "Weakly-convex parts"), in a bounding volume hierarchy of
// four children a node and four disks a leaf, so that a line of sight is tested against four at once.
// CGAL's AABB tree, with lean traits in single precision, took nearly twice as long.

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

/// The disks of a shape, ready for lines of sight. Queries are thread safe.
class Disk_tree
{
  /// Four disks; those that are missing have a negative squared radius, which no line crosses.
  struct Leaf
  {
    std::array<Four, 3> center, normal;
    Four squared_radius;
    std::array<Index, 4> index;
  };

  /// The boxes of four children and where they are: a node, or from `first_leaf` on a leaf.
  struct Node
  {
    std::array<std::array<Four, 3>, 2> bounds; ///< low and high ends
    std::array<std::uint32_t, 4> child;
    std::uint32_t bound =
        no_bound; ///< of the normals below, where there are lines that graze them all
  };
  static constexpr std::uint32_t no_bound = 0xffffffffu;
  static constexpr std::uint32_t first_leaf = 0x80000000u;

  struct Box
  {
    std::array<float, 3> low, high;
    int longest_axis() const
    {
      const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
      return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    }
  };
  struct Entry
  {
    Disk disk;
    Index index;
  };
  using Entries = std::vector<Entry>::iterator;

  /// A line with what the boxes need of it.
  struct Query
  {
    const Line_of_sight& line;
    std::array<float, 3> source, reciprocal, direction;
    std::array<int, 3> near_end; ///< which end of a box the line meets first, by axis
    float least_squared_slope;   ///< at a lower one, a line grazes a disk

    Query(const Line_of_sight& l, const float least_squared_sine)
      : line(l), source{l.source.x, l.source.y, l.source.z},
        reciprocal{l.reciprocal.x, l.reciprocal.y, l.reciprocal.z}, direction{l.direction.x,
                                                                              l.direction.y,
                                                                              l.direction.z},
        least_squared_slope(least_squared_sine * squared_length(l.direction))
    {
      for (int c = 0; c < 3; ++c) near_end[c] = reciprocal[c] < 0.f ? 1 : 0;
    }
  };

public:
  /// A leaf that may occlude the next line too, as the last one that did.
  using Hint = std::uint32_t;
  static constexpr Hint no_hint = 0;

  /// Lines of sight, but not rays, pass a disk whose plane they meet at an angle with a sine under
  /// `least_sine`.
  Disk_tree(const std::vector<Disk>& disks, const float clearance, const float least_sine = 0.f)
    : m_squared_clearance(clearance * clearance), m_least_squared_sine(least_sine * least_sine),
      m_size(disks.size())
  {
    std::vector<Entry> entries;
    entries.reserve(disks.size());
    for (const Disk& d : disks) entries.push_back({d, static_cast<Index>(entries.size())});
    m_leaves.reserve(disks.size() / 4 + 1);
    m_nodes.reserve(disks.size() / 12 + 1);
    if (entries.empty()) return;
    Box box;
    m_root = build(entries.begin(), entries.end(), box);
  }

  std::size_t size() const { return m_size; }

  /// returns whether no disk lies between the two points.
  bool unoccluded(const Vector3& p, const Vector3& q) const
  {
    Hint hint = no_hint;
    return unoccluded(p, q, hint);
  }
  /// the same for one of many lines that lie close together; `hint` begins with `no_hint` and does not
  /// change the answer.
  bool unoccluded(const Vector3& p, const Vector3& q, Hint& hint) const;

  /// returns where a ray from `p` along the unit vector `direction` first leaves the shape, within
  /// `reach`.
  Ray_hit first_exit(const Vector3& p, const Vector3& direction, const float reach) const
  {
    return first_hit(p, direction, reach, 1.f);
  }
  /// returns where the ray first enters the shape, from outside.
  Ray_hit first_entry(const Vector3& p, const Vector3& direction, const float reach) const
  {
    return first_hit(p, direction, reach, -1.f);
  }

private:
  static Box box_of(Entries first, Entries last);
  std::uint32_t build(Entries first, Entries last, Box& box);
  std::uint32_t add_leaf(Entries first, Entries last);
  std::uint32_t add_bound(Entries first, Entries last);
  Ray_hit first_hit(const Vector3& p, const Vector3& direction, float reach, float side) const;

  /// fills how far inside of each child's box the line goes, negative if it misses it, and where it
  /// enters.
  static Four overlap(const Node& node, const Query& query, const float limit, Four& entry)
  {
    std::array<Four, 3> in, out;
    for (int c = 0; c < 3; ++c)
    {
      const Four source(query.source[c]), reciprocal(query.reciprocal[c]);
      in[c] = (node.bounds[query.near_end[c]][c] - source) * reciprocal;
      out[c] = (node.bounds[1 - query.near_end[c]][c] - source) * reciprocal;
    }
    entry = maximum(maximum(maximum(in[0], in[1]), in[2]), Four(0.f));
    return minimum(minimum(minimum(out[0], out[1]), out[2]), Four(limit)) - entry;
  }

  /// returns what `crossing()` does, for the disks of a leaf, as positions along the line, and a
  /// margin that is negative where there is no crossing.
  Four crossings(const Leaf& leaf, const Query& query, Four& slope, Four& margin) const
  {
    std::array<Four, 3> to_center;
    for (int c = 0; c < 3; ++c) to_center[c] = leaf.center[c] - Four(query.source[c]);
    const std::array<Four, 3> d = {Four(query.direction[0]), Four(query.direction[1]),
                                   Four(query.direction[2])};
    slope = leaf.normal[0] * d[0] + leaf.normal[1] * d[1] + leaf.normal[2] * d[2];
    const Four t = (leaf.normal[0] * to_center[0] + leaf.normal[1] * to_center[1] +
                    leaf.normal[2] * to_center[2]) /
                   slope;
    Four off(0.f), from_source(0.f), from_target(0.f);
    const auto square = [](const Four& a) { return a * a; };
    for (int c = 0; c < 3; ++c)
    {
      off = off + square(t * d[c] - to_center[c]);
      from_source = from_source + square(to_center[c]);
      from_target = from_target + square(to_center[c] - d[c]);
    }
    const Four cleared = Four(m_squared_clearance) * leaf.squared_radius;
    margin = minimum(leaf.squared_radius - off, minimum(from_source, from_target) - cleared);
    return t;
  }

  bool occludes(const Leaf& leaf, const Query& query) const
  {
    Four slope, margin;
    const Four t = crossings(leaf, query, slope, margin);
    for (int k = 0; k < 4; ++k) // a line within the plane of a disk has no finite t
      if (t[k] > 0.f && t[k] < query.line.limit && margin[k] >= 0.f &&
          slope[k] * slope[k] >= query.least_squared_slope)
        return true;
    return false;
  }

  /// returns whether the line grazes all disks of a node.
  bool grazes(const Node& node, const Query& query) const
  {
    return node.bound != no_bound &&
           m_bounds[node.bound].squared_slope(query.line.direction) < query.least_squared_slope;
  }

  float m_squared_clearance, m_least_squared_sine;
  std::size_t m_size;
  std::uint32_t m_root = first_leaf;
  std::vector<Node> m_nodes;
  std::vector<Leaf> m_leaves;
  std::vector<Normal_bound> m_bounds;
};

inline Disk_tree::Box Disk_tree::box_of(Entries first, const Entries last)
{
  constexpr float infinity = (std::numeric_limits<float>::max)();
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (; first != last; ++first)
    for (int c = 0; c < 3; ++c)
    {
      const float n = first->disk.normal[c], center = first->disk.center[c];
      // half extent of a disk along an axis: radius * sin(angle of axis and normal)
      const float half = first->disk.radius * std::sqrt((std::max)(0.f, 1.f - n * n)) + 1e-7f;
      box.low[c] = (std::min)(box.low[c], center - half);
      box.high[c] = (std::max)(box.high[c], center + half);
    }
  return box;
}

inline std::uint32_t Disk_tree::add_leaf(const Entries first, const Entries last)
{
  Leaf leaf;
  leaf.squared_radius = Four(-1.f);
  leaf.index.fill(Ray_hit::none);
  for (int c = 0; c < 3; ++c) leaf.center[c] = leaf.normal[c] = Four(0.f);
  for (int k = 0; k < last - first; ++k)
  {
    const Entry& e = first[k];
    for (int c = 0; c < 3; ++c)
    {
      leaf.center[c][k] = e.disk.center[c];
      leaf.normal[c][k] = e.disk.normal[c];
    }
    leaf.squared_radius[k] = e.disk.radius * e.disk.radius;
    leaf.index[k] = e.index;
  }
  m_leaves.push_back(leaf);
  return first_leaf + static_cast<std::uint32_t>(m_leaves.size() - 1);
}

inline std::uint32_t Disk_tree::add_bound(const Entries first, const Entries last)
{
  if (m_least_squared_sine == 0.f) return no_bound;
  const Normal_bound bound(first, last,
                           [](const Entry& e) -> const Vector3& { return e.disk.normal; });
  if (bound.least_squared_slope() >= m_least_squared_sine) return no_bound;
  m_bounds.push_back(bound);
  return static_cast<std::uint32_t>(m_bounds.size() - 1);
}

/// halves the disks twice, each time along the longest axis of their box, with full leaves.
inline std::uint32_t Disk_tree::build(const Entries first, const Entries last, Box& box)
{
  box = box_of(first, last);
  if (last - first <= 4) return add_leaf(first, last);

  const auto halve = [](const Entries begin, const Entries end, const int axis)
  {
    if (end - begin <= 4) return end;
    const Entries middle = begin + ((end - begin) / 2 + 3) / 4 * 4;
    std::nth_element(begin, middle, end,
                     [axis](const Entry& a, const Entry& b)
                     {
                       const float ca = a.disk.center[axis], cb = b.disk.center[axis];
                       return ca != cb ? ca < cb : a.index < b.index;
                     });
    return middle;
  };
  const Entries middle = halve(first, last, box.longest_axis());
  const std::array<Entries, 5> ends = {
      first, halve(first, middle, box_of(first, middle).longest_axis()), middle,
      halve(middle, last, box_of(middle, last).longest_axis()), last};

  const std::size_t own = m_nodes.size();
  m_nodes.emplace_back();
  Node node;
  node.bound = add_bound(first, last);
  constexpr float nowhere = 1e30f; // no line enters a box whose low end is beyond its high end
  for (int k = 0; k < 4; ++k)
  {
    Box child{{nowhere, nowhere, nowhere}, {-nowhere, -nowhere, -nowhere}};
    node.child[k] = ends[k] == ends[k + 1] ? first_leaf : build(ends[k], ends[k + 1], child);
    for (int c = 0; c < 3; ++c)
    {
      node.bounds[0][c][k] = child.low[c];
      node.bounds[1][c][k] = child.high[c];
    }
  }
  m_nodes[own] = node;
  return static_cast<std::uint32_t>(own);
}

inline bool Disk_tree::unoccluded(const Vector3& p, const Vector3& q, Hint& hint) const
{
  const Line_of_sight line(p, q);
  const Query query(line, m_least_squared_sine);
  if (hint >= first_leaf && occludes(m_leaves[hint - first_leaf], query)) return false;
  std::array<std::uint32_t, 64> stack; // the tree is balanced: at most 3 a level wait
  std::size_t waiting = 0;
  if (m_size > 0) stack[waiting++] = m_root;
  while (waiting > 0)
  {
    const std::uint32_t next = stack[--waiting];
    if (next >= first_leaf)
    {
      if (!occludes(m_leaves[next - first_leaf], query)) continue;
      hint = next;
      return false;
    }
    if (grazes(m_nodes[next], query)) continue;
    Four entry;
    const Four inside = overlap(m_nodes[next], query, line.limit, entry);
    for (int k = 0; k < 4; ++k)
      if (inside[k] >= 0.f) stack[waiting++] = m_nodes[next].child[k];
  }
  return true;
}

/// returns the nearest disk that the ray leaves the shape through (`side` 1: normal along the ray) or
/// enters it through (`side` -1).
inline Ray_hit Disk_tree::first_hit(const Vector3& p, const Vector3& direction, const float reach,
                                    const float side) const
{
  // twice as long as it counts: nothing is cleared at the end of a ray, which is on no surface
  const Line_of_sight line(p, p + 2.f * reach * direction);
  const Query query(line, 0.f);
  float nearest = 0.5f;
  Index disk = Ray_hit::none;
  std::array<std::pair<float, std::uint32_t>, 64> stack;
  std::size_t waiting = 0;
  if (m_size > 0) stack[waiting++] = {0.f, m_root};
  while (waiting > 0)
  {
    const auto [from, next] = stack[--waiting];
    if (from > nearest) continue;
    if (next >= first_leaf)
    {
      const Leaf& leaf = m_leaves[next - first_leaf];
      Four slope, margin;
      const Four t = crossings(leaf, query, slope, margin);
      for (int k = 0; k < 4; ++k)
        if (t[k] > 0.f && margin[k] >= 0.f && side * slope[k] > 0.f &&
            (t[k] < nearest || (t[k] == nearest && disk != Ray_hit::none && leaf.index[k] < disk)))
        {
          nearest = t[k];
          disk = leaf.index[k];
        }
      continue;
    }
    const std::size_t bottom = waiting;
    Four entry;
    const Four inside = overlap(m_nodes[next], query, nearest, entry);
    for (int k = 0; k < 4; ++k)
    {
      if (!(inside[k] >= 0.f)) continue;
      std::size_t place = waiting++; // nearest on top
      for (; place > bottom && stack[place - 1].first < entry[k]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {entry[k], m_nodes[next].child[k]};
    }
  }
  if (disk == Ray_hit::none) return {};
  return {2.f * reach * nearest, disk};
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DISK_TREE_H
