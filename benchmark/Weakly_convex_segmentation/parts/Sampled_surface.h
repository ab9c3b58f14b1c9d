// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_SAMPLED_SURFACE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_SAMPLED_SURFACE_H

#include "metrics/mesh_geometry.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

// A mesh as the measures without people need it: points spread evenly over its area, what of it is
// closest to a point, and what a ray meets first. Independent of any labels.

namespace Part_measures {

namespace SM = Segmentation_metrics;
using Vector = Eigen::Vector3d;

inline Vector vector(const SM::Point& p) { return {p[0], p[1], p[2]}; }

/// A point of the surface, in the middle of a piece of equal area.
struct Surface_sample
{
  Vector position, normal;
  std::size_t face;
};

/// The point of the surface that is closest to some point, and the face that it is of.
struct Closest_point
{
  Vector position;
  std::size_t face;
};

class Sampled_surface
{
public:
  explicit Sampled_surface(const SM::Mesh& mesh, const std::size_t number_of_samples = 6000)
  {
    m_triangles.reserve(mesh.faces.size());
    for (const auto& [a, b, c] : mesh.faces)
      add_triangle(vector(mesh.points[a]), vector(mesh.points[b]), vector(mesh.points[c]));
    for (Iterator t = m_triangles.begin(); t != m_triangles.end(); ++t)
      if (!t->is_degenerate()) m_tree.insert(Primitive(t)); // rays can't meet the others
    m_tree.build();
    place_samples(number_of_samples);
    for (const Surface_sample& s : m_samples) m_center += s.position;
    m_center /= static_cast<double>(m_samples.size());
    for (const Surface_sample& s : m_samples)
      m_extent = (std::max)(m_extent, (s.position - m_center).norm());
  }
  // the tree refers to the triangles
  Sampled_surface(const Sampled_surface&) = delete;
  Sampled_surface& operator=(const Sampled_surface&) = delete;

  std::size_t number_of_faces() const { return m_triangles.size(); }
  const std::vector<Surface_sample>& samples() const { return m_samples; }
  const Vector& normal(const std::size_t face) const { return m_normals[face]; }
  Vector centroid(const std::size_t face) const
  {
    const Triangle& t = m_triangles[face];
    return (vector_of(t[0]) + vector_of(t[1]) + vector_of(t[2])) / 3.;
  }
  const Vector& center() const { return m_center; } ///< of the area
  double extent() const { return m_extent; }        ///< the farthest that a sample is from it

  Closest_point closest(const Vector& p) const
  {
    const auto found = m_tree.closest_point_and_primitive(Point(p.x(), p.y(), p.z()));
    return {vector_of(found.first), face_of(found.second)};
  }

  /// returns how far a ray comes, or none if it meets nothing. The face that it starts on is not met.
  std::optional<double> distance_along(const Vector& from, const Vector& direction,
                                       const std::size_t start) const
  {
    const Kernel::Ray_3 ray(Point(from.x(), from.y(), from.z()),
                            Kernel::Vector_3(direction.x(), direction.y(), direction.z()));
    const auto skip = [&](const Iterator& id) { return face_of(id) == start; };
    const auto hit = m_tree.first_intersected_primitive(ray, skip);
    if (!hit) return std::nullopt;
    const Vector& n = m_normals[face_of(*hit)];
    const double slope = n.dot(direction);
    if (slope == 0.) return std::nullopt; // along the triangle
    return n.dot(vector_of((**hit)[0]) - from) / slope * direction.norm();
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Triangle = Kernel::Triangle_3;
  using Iterator = std::vector<Triangle>::const_iterator;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

  static Vector vector_of(const Point& p) { return {p.x(), p.y(), p.z()}; }
  std::size_t face_of(const Iterator i) const
  {
    return static_cast<std::size_t>(i - m_triangles.begin());
  }

  void add_triangle(const Vector& a, const Vector& b, const Vector& c)
  {
    const auto point = [](const Vector& p) { return Point(p.x(), p.y(), p.z()); };
    m_triangles.emplace_back(point(a), point(b), point(c));
    const Vector cross = (b - a).cross(c - a);
    const double length = cross.norm();
    m_normals.push_back(length > 0. ? Vector(cross / length) : Vector::Zero());
    m_area_up_to.push_back((m_area_up_to.empty() ? 0. : m_area_up_to.back()) + length / 2.);
  }

  /// The area is cut into equal pieces in the order of the faces; where in its face a sample lies is
  /// told by a sequence that fills the square evenly (of the plastic number), folded to the triangle.
  void place_samples(const std::size_t count)
  {
    constexpr double plastic = 1.32471795724474602596;
    const double step = m_area_up_to.back() / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double n = static_cast<double>(i) + 0.5;
      const auto at = std::lower_bound(m_area_up_to.begin(), m_area_up_to.end() - 1, n * step);
      const std::size_t face = static_cast<std::size_t>(at - m_area_up_to.begin());
      double u = std::fmod(n / plastic, 1.), v = std::fmod(n / (plastic * plastic), 1.);
      if (u + v > 1.)
      {
        u = 1. - u;
        v = 1. - v;
      }
      const Triangle& t = m_triangles[face];
      const Vector a = vector_of(t[0]);
      m_samples.push_back(
          {a + u * (vector_of(t[1]) - a) + v * (vector_of(t[2]) - a), m_normals[face], face});
    }
  }

  std::vector<Triangle> m_triangles;
  std::vector<Vector> m_normals;
  std::vector<double> m_area_up_to; ///< of the faces up to each
  std::vector<Surface_sample> m_samples;
  CGAL::AABB_tree<Traits> m_tree;
  Vector m_center = Vector::Zero();
  double m_extent = 0.;
};

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_SAMPLED_SURFACE_H
