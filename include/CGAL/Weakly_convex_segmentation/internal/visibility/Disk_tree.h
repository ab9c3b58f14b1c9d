// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_TREE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_TREE_H

// Every point as an oriented disk (section 3, "Weakly-convex parts"), in CGAL's AABB tree: its build and
// its traversals, with traits of our own for groups of disks.
//
// A node's box also bounds the normals below it: along a wire or a flat sheet a line grazes thousands of
// disks, of which it meets none.

#include <CGAL/Weakly_convex_segmentation/internal/visibility/Disk_group.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Slope_bound.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Object.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What `CGAL::AABB_tree` asks of its traits for the traversals that are used here. The bases are there for
/// the tree of points of its distance queries, which is never built: the kernel for %CGAL 5, the search
/// traits for %CGAL 6.
struct Disk_tree_traits : Simple_cartesian<float>, Search_traits_3<Simple_cartesian<float>>
{
  using FT = float;
  using Point = Point_3;
  using Bounding_box = Disk_box;
  using Point_and_primitive_id = std::pair<Point, Disk_group::Id>;
  using Object_and_primitive_id = std::pair<Object, Disk_group::Id>;
  template <typename Query>
  struct Intersection_and_primitive_id
  {
    using Type = Point_and_primitive_id;
  };
  struct Primitive : Disk_group
  {
    using Disk_group::Disk_group;
    using Point = Disk_tree_traits::Point;
    using Datum = Disk_group;
    const Datum& datum() const { return *this; }
    Point reference_point() const { return {box().low[0], box().low[1], box().low[2]}; }
  };

  /// Bounds the disks of a node and, if lines may graze disks, their normals.
  struct Compute_bbox
  {
    std::vector<Slope_bound>* normal_bounds;
    float least_squared_sine;

    template <typename Iterator>
    Disk_box operator()(const Iterator first, const Iterator last) const
    {
      Disk_box box;
      for (Iterator it = first; it != last; ++it) box.extend(it->box());
      if (least_squared_sine == 0.f) return box;
      std::vector<Vector3> normals;
      normals.reserve(4 * static_cast<std::size_t>(last - first));
      for (Iterator it = first; it != last; ++it) it->add_normals_to(normals);
      const Slope_bound bound(normals);
      if (bound.least_squared_slope() >= least_squared_sine) return box;
      box.bound = static_cast<std::uint32_t>(normal_bounds->size());
      normal_bounds->push_back(bound);
      return box;
    }
  };

  /// Halves the groups of a node along the longest axis of its box.
  struct Split_primitives
  {
    template <typename Iterator>
    void operator()(const Iterator first, const Iterator last, const Disk_box& box) const
    {
      const int axis = box.longest_axis();
      const auto key = [axis](const Primitive& p)
      { return std::make_pair(p.box().low[axis] + p.box().high[axis], p.id()); };
      std::nth_element(first, first + (last - first) / 2, last,
                       [&](const Primitive& a, const Primitive& b) { return key(a) < key(b); });
    }
  };

  std::vector<Slope_bound>* normal_bounds; ///< receives the bounds that nodes refer to
  float least_squared_sine;

  Disk_tree_traits(std::vector<Slope_bound>& bounds, const float squared_sine)
    : normal_bounds(&bounds), least_squared_sine(squared_sine)
  {}
  Compute_bbox compute_bbox_object() const { return {normal_bounds, least_squared_sine}; }
  Split_primitives split_primitives_object() const { return {}; }
};

/// The disks of a shape, ready for lines of sight. Queries are thread safe.
class Disk_tree
{
  using Tree = AABB_tree<Disk_tree_traits>;
  using Node = AABB_node<Disk_tree_traits>;
  using Primitive = Disk_tree_traits::Primitive;

public:
  /// A group that may occlude the next line too, as the last one that did.
  using Hint = const Disk_group*;
  static constexpr Hint no_hint = nullptr;

  /// Lines of sight, but not rays, pass a disk whose plane they meet at an angle with a sine under
  /// `least_sine`. No line is occluded within `clearance` radii of a disk's center from its ends.
  Disk_tree(const std::vector<Disk>& disks, const float clearance, const float least_sine = 0.f)
    : m_clearance(clearance), m_least_squared_sine(least_sine * least_sine), m_size(disks.size()),
      m_tree(Disk_tree_traits(m_normal_bounds, m_least_squared_sine))
  {
    std::vector<Index> order(disks.size());
    std::iota(order.begin(), order.end(), Index(0));
    sort_into_groups(disks, order.begin(), order.end());
    for (auto first = order.cbegin(); first != order.cend();)
    {
      const auto last = first + (std::min)(order.cend() - first, std::ptrdiff_t(4));
      m_tree.insert(Primitive(disks, first, last));
      first = last;
    }
    m_tree.build();
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
  bool unoccluded(const Vector3& p, const Vector3& q, Hint& hint) const
  {
    const Disk_query query(Line_of_sight(p, q), m_clearance, m_least_squared_sine);
    if (hint != no_hint && hint->occludes(query)) return false;
    Any_hit any{m_normal_bounds};
    m_tree.traversal(query, any);
    if (any.group == no_hint) return true;
    hint = any.group;
    return false;
  }

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
  /// Traversal traits: stops at a group that occludes the line.
  struct Any_hit
  {
    const std::vector<Slope_bound>& normal_bounds;
    Hint group = no_hint;

    bool go_further() const { return group == no_hint; }
    void intersection(const Disk_query& query, const Primitive& primitive)
    {
      float entry;
      if (primitive.box().meets(query, entry) && primitive.occludes(query)) group = &primitive;
    }
    bool do_intersect(const Disk_query& query, const Node& node) const
    {
      float entry;
      const Disk_box& box = node.bbox();
      if (!box.meets(query, entry)) return false;
      return box.bound == Disk_box::no_bound ||
             normal_bounds[box.bound].squared_slope(query.line.direction) >=
                 query.least_squared_slope;
    }
  };

  /// Traversal traits: keeps the nearest disk, and visits near nodes first.
  struct Nearest_hit
  {
    using Priority = float;
    float side, nearest;
    Index disk = Ray_hit::none;

    bool go_further() const { return true; }
    void intersection(const Disk_query& query, const Primitive& primitive)
    {
      if (meets(query, primitive.box()).first) primitive.find_nearest(query, side, nearest, disk);
    }
    bool do_intersect(const Disk_query& query, const Node& node) const
    {
      return meets(query, node.bbox()).first;
    }
    std::pair<bool, Priority> do_intersect_with_priority(const Disk_query& query,
                                                         const Node& node) const
    {
      return meets(query, node.bbox());
    }

  private:
    std::pair<bool, Priority> meets(const Disk_query& query, const Disk_box& box) const
    {
      float entry;
      const bool is_met = box.meets(query, entry) && entry <= nearest;
      return {is_met, -entry};
    }
  };

  /// returns the nearest disk that the ray leaves the shape through (`side` 1: normal along the ray) or
  /// enters it through (`side` -1).
  Ray_hit first_hit(const Vector3& p, const Vector3& direction, const float reach,
                    const float side) const
  {
    // twice as long as it counts: nothing is cleared at the end of a ray, which is on no surface
    Line_of_sight line(p, p + 2.f * reach * direction);
    line.limit = 0.5f;
    Nearest_hit hit{side, line.limit};
    m_tree.traversal_with_priority(Disk_query(line, m_clearance, 0.f), hit);
    if (hit.disk == Ray_hit::none) return {};
    return {2.f * reach * hit.nearest, hit.disk};
  }

  /// brings disks that lie together into runs of four, all full but the last.
  template <typename Iterator>
  static void sort_into_groups(const std::vector<Disk>& disks, const Iterator first,
                               const Iterator last)
  {
    if (last - first <= 4) return;
    Disk_box box;
    for (Iterator it = first; it != last; ++it)
    {
      const Vector3& c = disks[*it].center;
      const Float4 center(c.x, c.y, c.z, 0.f);
      box.low = minimum(box.low, center);
      box.high = maximum(box.high, center);
    }
    const int axis = box.longest_axis();
    const Iterator middle = first + ((last - first) / 2 + 3) / 4 * 4;
    std::nth_element(first, middle, last,
                     [&](const Index a, const Index b)
                     {
                       const float ca = disks[a].center[axis], cb = disks[b].center[axis];
                       return ca != cb ? ca < cb : a < b;
                     });
    sort_into_groups(disks, first, middle);
    sort_into_groups(disks, middle, last);
  }

  float m_clearance, m_least_squared_sine;
  std::size_t m_size;
  std::vector<Slope_bound> m_normal_bounds;
  Tree m_tree;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_VISIBILITY_DISK_TREE_H
