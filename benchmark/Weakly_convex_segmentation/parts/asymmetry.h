// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_ASYMMETRY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_ASYMMETRY_H

#include "metrics/segmentation_metrics.h"
#include "parts/Part_labels.h"
#include "parts/Sampled_surface.h"
#include "parts/mirror_plane.h"

#include <CGAL/Orthogonal_incremental_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// Whether the left of a symmetric shape has the parts of its right.

namespace Part_measures {

/// The faces that samples are on, and those that their mirror images are on.
struct Mirror_image
{
  Mirror_plane plane;
  std::vector<std::size_t> faces, mirrored_faces;
};

namespace internal {

/// Finds the nearest sample whose normal agrees: the closest point of a thin plate may be on its back.
class Agreeing_samples
{
public:
  explicit Agreeing_samples(const Sampled_surface& surface) : m_samples(surface.samples())
  {
    for (std::size_t i = 0; i < m_samples.size(); ++i)
    {
      const Vector& p = m_samples[i].position;
      m_tree.insert({Kernel::Point_3(p.x(), p.y(), p.z()), i});
    }
    m_tree.build();
  }

  std::optional<std::size_t> nearest_face(const Vector& p, const Vector& normal) const
  {
    constexpr int most_tried = 50;
    Search search(m_tree, Kernel::Point_3(p.x(), p.y(), p.z()));
    int tried = 0;
    for (auto it = search.begin(); it != search.end() && tried < most_tried; ++it, ++tried)
      if (const Surface_sample& s = m_samples[it->first.second]; s.normal.dot(normal) > 0.3)
        return s.face;
    return std::nullopt;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Entry = std::pair<Kernel::Point_3, std::size_t>;
  using Search_traits = CGAL::Search_traits_adapter<Entry, CGAL::First_of_pair_property_map<Entry>,
                                                    CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_incremental_neighbor_search<Search_traits>;
  const std::vector<Surface_sample>& m_samples;
  typename Search::Tree m_tree;
};

} // namespace internal

/// mirrors the samples at the plane of reflection, if the shape has one.
inline std::optional<Mirror_image> find_mirror_image(const Sampled_surface& surface)
{
  const std::optional<Mirror_plane> plane = find_mirror_plane(surface);
  if (!plane) return std::nullopt;
  Mirror_image image;
  image.plane = *plane;
  const internal::Agreeing_samples agreeing(surface);
  for (const Surface_sample& s : surface.samples())
  {
    const Vector p = plane->mirrored(s.position), n = plane->turned(s.normal);
    std::size_t face = surface.closest(p).face;
    if (surface.normal(face).dot(n) < 0.3) face = agreeing.nearest_face(p, n).value_or(face);
    image.faces.push_back(s.face);
    image.mirrored_faces.push_back(face);
  }
  return image;
}

/// returns 1 - RI between the labels of the samples and those of their mirror images: 0 if the parts are
/// the same on both sides.
inline double asymmetry(const Mirror_image& image, const Part_labels& labels)
{
  SM::Mesh_geometry samples; // each one a face of area 1
  samples.face_areas.assign(image.faces.size(), 1.);
  SM::Prepared_segmentation here, there;
  here.number_of_segments = there.number_of_segments = labels.number_of_parts;
  for (const std::size_t f : image.faces) here.labels.push_back(labels.of_face[f]);
  for (const std::size_t f : image.mirrored_faces) there.labels.push_back(labels.of_face[f]);
  return SM::rand_error(SM::make_contingency_table(samples, here, there));
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_ASYMMETRY_H
