// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DISK_TREE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DISK_TREE_H

#include <CGAL/Weakly_convex_segmentation/internal/Vector3.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Every point as an oriented disk (section 3, "Weakly-convex parts"), in CGAL's AABB tree. The traits
// are our own: disks and boxes in single precision, and a segment whose reciprocal direction is
// computed once, take a quarter of the time of a kernel's segments and triangles.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A point's share of the surface.
struct Disk
{
  Vector3 center;
  Vector3 normal; ///< unit length
  float radius;
};

/// A segment between two points of the shape.
struct Line_of_sight
{
  Vector3 source;
  Vector3 direction;  ///< target - source, not normalized
  Vector3 reciprocal; ///< componentwise 1 / direction
  float limit = 1.f;  ///< only the part up to source + limit * direction counts

  Line_of_sight(const Vector3& from, const Vector3& to) : source(from), direction(to - from)
  {
    // a huge finite number instead of infinity keeps 0 * inf = NaN out of the slab test
    const auto inverse = [](const float d)
    { return std::abs(d) > 1e-20f ? 1.f / d : (d < 0.f ? -1e20f : 1e20f); };
    reciprocal = {inverse(direction.x), inverse(direction.y), inverse(direction.z)};
  }
};

/// Axis-aligned box.
struct Disk_box
{
  Vector3 low, high;

  /// returns where the line enters the box, or infinity if the segment misses it.
  float entry(const Line_of_sight& line) const
  {
    const float x1 = (low.x - line.source.x) * line.reciprocal.x;
    const float x2 = (high.x - line.source.x) * line.reciprocal.x;
    const float y1 = (low.y - line.source.y) * line.reciprocal.y;
    const float y2 = (high.y - line.source.y) * line.reciprocal.y;
    const float z1 = (low.z - line.source.z) * line.reciprocal.z;
    const float z2 = (high.z - line.source.z) * line.reciprocal.z;
    const float in = (std::max)((std::max)((std::min)(x1, x2), (std::min)(y1, y2)),
                                (std::max)((std::min)(z1, z2), 0.f));
    const float out = (std::min)((std::min)((std::max)(x1, x2), (std::max)(y1, y2)),
                                 (std::min)((std::max)(z1, z2), line.limit));
    return in <= out ? in : (std::numeric_limits<float>::max)();
  }
};

/// returns where the line crosses the disk, as a factor of its direction; infinity if it does not, or
/// if the disk's center is within `clearance` radii of an end: the ends lie on the surface, and disks
/// there would hide every point behind its own neighborhood.
inline float crossing(const Line_of_sight& line, const Disk& disk, const float clearance)
{
  constexpr float none = (std::numeric_limits<float>::max)();
  const float slope = dot(disk.normal, line.direction);
  if (slope == 0.f) return none;
  const Vector3 to_center = disk.center - line.source;
  const float t = dot(disk.normal, to_center) / slope;
  if (!(t > 0.f && t < line.limit)) return none;
  const float r2 = disk.radius * disk.radius;
  if (squared_length(t * line.direction - to_center) > r2) return none;
  const float cleared = clearance * clearance * r2;
  if (squared_length(to_center) < cleared) return none;
  if (squared_length(to_center - line.direction) < cleared) return none;
  return t;
}

/// Model of `AABBPrimitive`: a disk by value, so that traversal touches no other array.
struct Disk_primitive
{
  using Id = Index;
  using Datum = Disk;
  using Datum_reference = const Disk&;
  using Point = CGAL::Simple_cartesian<float>::Point_3;
  using Point_reference = Point;

  Disk disk;
  Id index;

  /// The tree makes its primitives from iterators; the index is the distance to the first disk.
  Disk_primitive(const std::vector<Disk>::const_iterator it, const Disk* first)
    : disk(*it), index(static_cast<Index>(&*it - first))
  {}
  Id id() const { return index; }
  Datum_reference datum() const { return disk; }
  Point_reference reference_point() const
  {
    return Point(disk.center.x, disk.center.y, disk.center.z);
  }
};

/// Model of `AABBTraits` for disks and lines of sight.
///
/// The bases only supply the names that `AABB_tree` mentions for distance queries, which are not used.
class Disk_tree_traits : public CGAL::Simple_cartesian<float>,
                         public CGAL::Search_traits_3<CGAL::Simple_cartesian<float>>
{
  using Kernel = CGAL::Simple_cartesian<float>;

public:
  using FT = float;
  using Point_3 = Kernel::Point_3;
  using Point = Point_3;
  using Primitive = Disk_primitive;
  using Bounding_box = Disk_box;
  using Point_and_primitive_id = std::pair<Point_3, Index>;
  using Object_and_primitive_id = Point_and_primitive_id;
  using Equal_3 = Kernel::Equal_3;
  using Squared_distance = Kernel::Compute_squared_distance_3;
  template <typename Query>
  struct Intersection_and_primitive_id
  {
    using Intersection_type = Point_3;
    using Type = Point_and_primitive_id;
  };

  explicit Disk_tree_traits(const float clearance = 2.f) : m_clearance(clearance) {}

  struct Compute_bbox
  {
    template <typename Iterator>
    Disk_box operator()(Iterator first, const Iterator last) const
    {
      constexpr float infinity = std::numeric_limits<float>::infinity();
      Disk_box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
      for (; first != last; ++first)
      {
        const Disk& d = first->disk;
        // half extent of a disk along an axis: radius * sin(angle of axis and normal)
        const auto half = [&d](const float n)
        { return d.radius * std::sqrt((std::max)(0.f, 1.f - n * n)) + 1e-7f; };
        const Vector3 h = {half(d.normal.x), half(d.normal.y), half(d.normal.z)};
        const Vector3 low = d.center - h, high = d.center + h;
        box.low = {(std::min)(box.low.x, low.x), (std::min)(box.low.y, low.y),
                   (std::min)(box.low.z, low.z)};
        box.high = {(std::max)(box.high.x, high.x), (std::max)(box.high.y, high.y),
                    (std::max)(box.high.z, high.z)};
      }
      return box;
    }
  };

  struct Split_primitives
  {
    template <typename Iterator>
    void operator()(const Iterator first, const Iterator last, const Disk_box& box) const
    {
      const Vector3 size = box.high - box.low;
      const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
      std::nth_element(first, first + (last - first) / 2, last,
                       [axis](const Disk_primitive& a, const Disk_primitive& b)
                       {
                         const float ca = a.disk.center[axis], cb = b.disk.center[axis];
                         return ca != cb ? ca < cb : a.index < b.index;
                       });
    }
  };

  class Do_intersect
  {
    float m_clearance;

  public:
    explicit Do_intersect(const float clearance) : m_clearance(clearance) {}
    bool operator()(const Line_of_sight& line, const Disk_box& box) const
    {
      return box.entry(line) < (std::numeric_limits<float>::max)();
    }
    bool operator()(const Line_of_sight& line, const Disk_primitive& primitive) const
    {
      return crossing(line, primitive.disk, m_clearance) < line.limit;
    }
  };

  Compute_bbox compute_bbox_object() const { return {}; }
  Split_primitives split_primitives_object() const { return {}; }
  Do_intersect do_intersect_object() const { return Do_intersect(m_clearance); }
  Squared_distance squared_distance_object() const { return {}; }
  Equal_3 equal_3_object() const { return {}; }

private:
  float m_clearance;
};

/// Where a ray met the surface.
struct Ray_hit
{
  static constexpr Index none = static_cast<Index>(-1);
  float distance = std::numeric_limits<float>::infinity();
  Index disk = none;

  bool found() const { return disk != none; }
};

/// Traversal that keeps the nearest disk which the line leaves the shape through (`side` 1: normal along
/// the line) or enters it through (`side` -1).
class First_hit_traversal
{
  using Node = CGAL::AABB_node<Disk_tree_traits>;
  Line_of_sight& m_line;
  const float m_clearance, m_side;
  float m_nearest;
  Index m_disk = Ray_hit::none;

public:
  using Priority = float;

  First_hit_traversal(Line_of_sight& line, const float clearance, const float side)
    : m_line(line), m_clearance(clearance), m_side(side), m_nearest(line.limit)
  {}
  bool go_further() const { return true; }
  void intersection(const Line_of_sight& line, const Disk_primitive& primitive)
  {
    if (m_side * dot(primitive.disk.normal, line.direction) <= 0.f) return;
    const float t = crossing(line, primitive.disk, m_clearance);
    if (t >= m_nearest) return;
    m_line.limit = m_nearest = t;
    m_disk = primitive.index;
  }
  bool do_intersect(const Line_of_sight& line, const Node& node) const
  {
    return node.bbox().entry(line) < m_nearest;
  }
  std::pair<bool, Priority> do_intersect_with_priority(const Line_of_sight& line,
                                                       const Node& node) const
  {
    const float t = node.bbox().entry(line);
    return {t < m_nearest, -t};
  }
  float nearest() const { return m_nearest; }
  Index disk() const { return m_disk; }
};

/// The disks of a shape, ready for lines of sight. Queries are thread safe.
class Disk_tree
{
  using Tree = CGAL::AABB_tree<Disk_tree_traits>;

public:
  Disk_tree(const std::vector<Disk>& disks, const float clearance)
    : m_clearance(clearance), m_tree(Disk_tree_traits(clearance))
  {
    m_tree.insert(disks.begin(), disks.end(), disks.data());
    m_tree.build();
  }

  std::size_t size() const { return m_tree.size(); }

  /// returns whether no disk lies between the two points.
  bool unoccluded(const Vector3& p, const Vector3& q) const
  {
    return !m_tree.do_intersect(Line_of_sight(p, q));
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
  Ray_hit first_hit(const Vector3& p, const Vector3& direction, const float reach,
                    const float side) const
  {
    // twice as long as it counts: nothing is cleared at the end of a ray, which is on no surface
    Line_of_sight line(p, p + 2.f * reach * direction);
    line.limit = 0.5f;
    First_hit_traversal traversal(line, m_clearance, side);
    m_tree.traversal_with_priority(line, traversal);
    if (traversal.disk() == Ray_hit::none) return {};
    return {2.f * reach * traversal.nearest(), traversal.disk()};
  }

  float m_clearance;
  Tree m_tree;
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_DISK_TREE_H
