// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_MOMENTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_MOMENTS_H

// Additive statistics of regions and of seams beyond those that the paper's criteria need: the
// weighted and the fitted merge cost judge by them.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Sums over the points of a region.
struct Region_moments
{
  Double3 position, normal;
  Symmetric_matrix3 position_squares, normal_squares;
  double area = 0.; ///< sum of the squared spacings, proportional to the area

  void add(const Vector3& p, const Vector3& n, const float spacing)
  {
    const Double3 x{p.x, p.y, p.z}, m{n.x, n.y, n.z};
    position += x;
    normal += m;
    position_squares += Symmetric_matrix3(x);
    normal_squares += Symmetric_matrix3(m);
    area += static_cast<double>(spacing) * spacing;
  }
  Region_moments& operator+=(const Region_moments& other)
  {
    position += other.position;
    normal += other.normal;
    position_squares += other.position_squares;
    normal_squares += other.normal_squares;
    area += other.area;
    return *this;
  }
};

/// Sums over the neighbor edges across a seam, each seen from both ends.
struct Seam_moments
{
  Double3 position, normal; ///< of the edges' ends
  Symmetric_matrix3 position_squares;
  double length = 0.; ///< sum of the spacing at the edges, proportional to the length

  void add(const Vector3& p, const Vector3& n, const float spacing)
  {
    const Double3 x{p.x, p.y, p.z};
    position += x;
    normal += Double3{n.x, n.y, n.z};
    position_squares += Symmetric_matrix3(x);
    length += static_cast<double>(spacing);
  }
  Seam_moments& operator+=(const Seam_moments& other)
  {
    position += other.position;
    normal += other.normal;
    position_squares += other.position_squares;
    length += other.length;
    return *this;
  }
};

/// Sums over the neighbor edges across a seam of the concavity seen at a fixed distance: between the
/// mean normals of either side within a radius, which does not depend on the sampling.
struct Seam_profile
{
  static constexpr std::size_t number_of_radii = 3;
  struct At_radius
  {
    double signed_sum = 0., positive_sum = 0.;        ///< radians
    double over_15 = 0., over_30 = 0., under_20 = 0.; ///< edges over 15, 30, under -20 degrees
  };
  std::array<At_radius, number_of_radii> radii;
  double edge_signed = 0.;   ///< sum of the edges' own concavity, radians
  double edge_positive = 0.; ///< sum of min(1, concavity) where positive

  /// adds one neighbor edge across the seam, with the smoothed surfaces at its ends.
  template <typename Borders>
  void add_edge(const Borders& borders, const Index i, const Neighbor& edge)
  {
    edge_signed += edge.concavity;
    edge_positive += (std::min)(1.f, (std::max)(0.f, edge.concavity));
    for (std::size_t r = 0; r < number_of_radii; ++r)
    {
      const float concavity = borders.concavity(i, edge.point, r);
      radii[r].signed_sum += concavity;
      radii[r].positive_sum += (std::max)(0.f, concavity);
      if (concavity > radians(15.)) radii[r].over_15 += 1.;
      if (concavity > radians(30.)) radii[r].over_30 += 1.;
      if (concavity < radians(-20.)) radii[r].under_20 += 1.;
    }
  }
  Seam_profile& operator+=(const Seam_profile& other)
  {
    for (std::size_t r = 0; r < number_of_radii; ++r)
    {
      radii[r].signed_sum += other.radii[r].signed_sum;
      radii[r].positive_sum += other.radii[r].positive_sum;
      radii[r].over_15 += other.radii[r].over_15;
      radii[r].over_30 += other.radii[r].over_30;
      radii[r].under_20 += other.radii[r].under_20;
    }
    edge_signed += other.edge_signed;
    edge_positive += other.edge_positive;
    return *this;
  }
};

/// Mean position and normal of the points of one patch around a point.
struct Mean_surface
{
  Vector3 position, normal;
};

/// finds the mean surface of each border point's own patch within some radii.
class Smoothed_borders
{
  using Radii = std::array<float, Seam_profile::number_of_radii>;

public:
  /// `radii`: ascending
  Smoothed_borders(const Oriented_points& points, const Neighbor_graph& graph,
                   const Patches& patches, const Radii& radii)
    : m_points(points), m_radii(radii), m_means(points.size())
  {
    for (const std::vector<Index>& members : patches.members)
      for (const Index i : members)
        if (std::any_of(graph[i].begin(), graph[i].end(),
                        [&](const Neighbor& edge)
                        { return patches.of_point[edge.point] != patches.of_point[i]; }))
          average_around(i, members);
  }

  /// returns the concavity across an edge between two patches, positive if concave, in radians.
  float concavity(const Index i, const Index j, const std::size_t radius) const
  {
    const Mean_surface &a = m_means[i][radius], &b = m_means[j][radius];
    const float turn = dot(b.normal - a.normal, b.position - a.position);
    const float bend = angle(a.normal, b.normal);
    return turn < 0.f ? bend : -bend;
  }

private:
  void average_around(const Index center, const std::vector<Index>& members)
  {
    std::array<Vector3, Seam_profile::number_of_radii> position{}, normal{};
    std::array<float, Seam_profile::number_of_radii> count{};
    for (const Index i : members)
    {
      const float d = squared_length(m_points.positions[i] - m_points.positions[center]);
      for (std::size_t r = m_radii.size(); r-- > 0 && d <= m_radii[r] * m_radii[r];)
      {
        position[r] = position[r] + m_points.positions[i];
        normal[r] = normal[r] + m_points.normals[i];
        count[r] += 1.f;
      }
    }
    for (std::size_t r = 0; r < m_radii.size(); ++r)
      m_means[center][r] = {(1.f / count[r]) * position[r],
                            normalized(normal[r], m_points.normals[center])};
  }

  const Oriented_points& m_points;
  const Radii m_radii;
  std::vector<std::array<Mean_surface, Seam_profile::number_of_radii>> m_means;
};

inline Symmetric_matrix3 covariance(const Double3& sum, const Symmetric_matrix3& squares,
                                    const double count)
{
  return squares / count - Symmetric_matrix3(sum / count);
}

/// Axes of a cloud of points by its covariance.
struct Axes
{
  Double3 center;
  Double3 lengths;   ///< standard deviations, ascending
  Double3 direction; ///< of the longest

  Axes(const Double3& sum, const Symmetric_matrix3& squares, const double count)
    : center(sum / count)
  {
    const Principal_axes axes(covariance(sum, squares, count));
    const auto deviation = [](const double variance)
    { return std::sqrt((std::max)(variance, 1e-12)); };
    lengths = {deviation(axes.values().x), deviation(axes.values().y), deviation(axes.values().z)};
    direction = axes.longest();
  }
};

/// standard deviation along the longest axis
inline double longest_axis(const Double3& sum, const Symmetric_matrix3& squares, const double count)
{
  const Principal_axes axes(covariance(sum, squares, count));
  return std::sqrt((std::max)(1e-24, axes.values().z));
}

/// Shape of a region as ratios in [0, 1].
struct Shape_ratios
{
  double middle_axis = 0., short_axis = 0.; ///< standard deviations, relative to the longest
  double normal_mean = 0.;  ///< length of the mean normal: 1 for a plane, 0 for a closed surface
  double normal_least = 0.; ///< least eigenvalue of the mean squared normals: 0 for a cylinder
};

inline Shape_ratios shape_ratios(const Region_moments& shape, const Axes& axes, const double size)
{
  const Principal_axes normal_axes(shape.normal_squares / size);
  Shape_ratios ratios;
  ratios.middle_axis = axes.lengths[1] / axes.lengths[2];
  ratios.short_axis = axes.lengths[0] / axes.lengths[2];
  ratios.normal_mean = length(shape.normal) / size;
  ratios.normal_least = (std::max)(0., normal_axes.values().x);
  return ratios;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_REGION_MOMENTS_H
