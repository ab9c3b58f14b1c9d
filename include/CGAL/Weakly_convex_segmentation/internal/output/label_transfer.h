// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_OUTPUT_LABEL_TRANSFER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_OUTPUT_LABEL_TRANSFER_H

// From the representatives back to the points and to the elements of the input.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/refine_borders.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/number_labels.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the input points whose representative is in the band, ascending.
inline std::vector<Index> points_in_band(const Shape_analysis& shape,
                                         const std::vector<Band_point>& band, const bool parallel)
{
  std::vector<Index> result;
  for (const std::vector<Index>&of_block :
       map_blocks(shape.input.size(), parallel,
                  [&](const std::size_t begin, const std::size_t end)
                  {
                    std::vector<Index> own;
                    for (std::size_t i = begin; i < end; ++i)
                      if (band[shape.representative(i)].other >= 0)
                        own.push_back(static_cast<Index>(i));
                    return own;
                  }))
    result.insert(result.end(), of_block.begin(), of_block.end());
  return result;
}

/// Some of the input points, with borders of their own.
struct Border_points
{
  Oriented_points points;
  Neighbor_graph graph;
  std::vector<int> labels;

  float spacing() const
  {
    return std::accumulate(graph.spacing.begin(), graph.spacing.end(), 0.f) /
           static_cast<float>((std::max)(graph.size(), std::size_t(1)));
  }
};

/// moves the borders between the labels of the chosen input points, among these alone.
inline Border_points move_borders_among(const Shape_analysis& shape,
                                        const std::vector<Index>& chosen,
                                        const Parameters& parameters, const bool keeps_links,
                                        const Run_control& control, std::vector<int>& labels)
{
  Border_points border{sub_points(shape.input, chosen), {}, {}};
  if (!keeps_links) border.points.links.clear();
  border.graph =
      build_neighbor_graph(border.points, parameters.number_of_neighbors, control.parallel,
                           parameters.extra_neighbors == Extra_neighbors::FACES_AND_LINES);
  if (shape.is_smoothed) denoise_points(border.graph, border.points);
  control.check();
  for (const Index i : chosen) border.labels.push_back(labels[i]);
  move_borders(border.graph, parameters, border.labels, control.parallel);
  for (std::size_t j = 0; j < chosen.size(); ++j) labels[chosen[j]] = border.labels[j];
  return border;
}

/// gives points the labels of the samples among them that are nearest and on the same side of a wall;
/// returns those of the points whose sample lies within `width` of a border.
inline std::vector<Index> carry_from_samples(const Shape_analysis& shape,
                                             const std::vector<Index>& near_border,
                                             const Border_points& samples, const float width,
                                             const Run_control& control, std::vector<int>& labels)
{
  constexpr std::size_t candidates = 4;
  const std::vector<Band_point> band =
      find_band(samples.graph, samples.labels, width, control.parallel);
  const Kd_tree tree(samples.points.positions);
  std::vector<char> is_near(near_border.size());
  parallel_for(
      near_border.size(), control.parallel,
      [&](const std::size_t j)
      {
        const Index i = near_border[j], none = static_cast<Index>(-1);
        Index nearest = none, facing = none;
        tree.nearest(shape.input.positions[i], candidates,
                     [&](const Index s, float)
                     {
                       if (!may_be_neighbors(samples.points.solid(s), shape.input.solid(i))) return;
                       if (nearest == none) nearest = s;
                       if (facing == none &&
                           dot(samples.points.normals[s], shape.input.normals[i]) > 0.f)
                         facing = s;
                     });
        const Index sample = facing != none ? facing : nearest;
        if (sample == none) return; // it keeps the label of its representative
        labels[i] = samples.labels[sample];
        is_near[j] = band[sample].other >= 0 ? 1 : 0;
      },
      1024);
  std::vector<Index> result;
  for (std::size_t j = 0; j < near_border.size(); ++j)
    if (is_near[j] != 0) result.push_back(near_border[j]);
  return result;
}

/// returns for each input point the label of its representative.
inline std::vector<int> labels_of_points(const Shape_analysis& shape,
                                         const std::vector<int>& labels,
                                         const bool parallel = false)
{
  std::vector<int> result(shape.input.size());
  parallel_for(
      result.size(), parallel,
      [&](const std::size_t i) { result[i] = labels[shape.representative(i)]; }, 4096);
  return result;
}

/// returns the labels of the input points in spatial order, from those of the representatives, with
/// the borders refined anew among the points themselves: only those near a border are looked at.
///
/// Where there are many points to a representative, the borders are moved among some of them first, and then
/// among all that are as near as those lie apart: else a cut of a million points takes most of the time.
inline std::vector<int> carry_labels(const Shape_analysis& shape, const std::vector<int>& labels,
                                     const Parameters& parameters, const Run_control& control)
{
  constexpr std::size_t many = 12, samples_per_representative = 6;
  std::vector<int> result = labels_of_points(shape, labels, control.parallel);
  if (shape.representatives.of_point.empty() || parameters.refinement == Refinement_rule::NONE ||
      parameters.band_width == 0.)
    return result;

  control.check();
  // the borders of the representatives are right up to their spacing: a narrower band is enough
  const float spacing =
      std::accumulate(shape.graph.spacing.begin(), shape.graph.spacing.end(), 0.f) /
      static_cast<float>(shape.graph.size());
  Parameters fine = parameters;
  fine.band_width = (std::min)(parameters.band_width, 1.5 * static_cast<double>(spacing));
  const std::vector<Band_point> band = find_band(
      shape.graph, labels, static_cast<float>(fine.band_width) + spacing, control.parallel);
  std::vector<Index> near_border = points_in_band(shape, band, control.parallel);
  control.check();

  const std::size_t density = shape.input.size() / shape.points().size();
  if (density >= many)
  {
    std::vector<Index> chosen;
    const std::size_t step = density / samples_per_representative;
    for (std::size_t j = step / 2; j < near_border.size(); j += step)
      chosen.push_back(near_border[j]);
    if (chosen.empty()) return result;
    const Border_points samples = move_borders_among(shape, chosen, fine, false, control, result);
    fine.band_width = (std::min)(fine.band_width, static_cast<double>(samples.spacing()));
    near_border =
        carry_from_samples(shape, near_border, samples, 2.f * samples.spacing(), control, result);
    control.check();
  }
  if (!near_border.empty())
    move_borders_among(shape, near_border, fine,
                       parameters.extra_neighbors != Extra_neighbors::NONE, control, result);
  return result;
}

/// gives strays the label of the element that is nearest to them.
inline void label_strays(const Oriented_points& points, std::vector<int>& labels)
{
  for (const auto& [stray, near] : points.strays) labels[stray] = labels[near];
}

/// returns one label an input element from those of the points: what most of its points have, the
/// smallest of such. Strays have that of another element.
inline std::vector<int> element_labels(const Oriented_points& points,
                                       const std::vector<int>& labels, const bool parallel = false)
{
  std::vector<int> result(points.number_of_elements);
  if (points.size() == points.number_of_elements && points.strays.empty())
  {
    parallel_for(
        points.size(), parallel,
        [&](const std::size_t i) { result[points.elements[i]] = labels[i]; }, 4096);
    return result;
  }

  std::vector<std::pair<Index, int>> votes(points.size());
  for (std::size_t i = 0; i < votes.size(); ++i) votes[i] = {points.elements[i], labels[i]};
  std::sort(votes.begin(), votes.end());
  std::vector<std::size_t> most(result.size(), 0);
  for (std::size_t first = 0, last = 0; first < votes.size(); first = last)
  {
    while (last < votes.size() && votes[last] == votes[first]) ++last;
    const auto [element, label] = votes[first];
    if (last - first > most[element]) most[element] = last - first, result[element] = label;
  }
  label_strays(points, result);
  return result;
}

/// returns the patch of each input element from those of the representatives.
inline std::vector<int> element_patches(const Shape_analysis& shape,
                                        const std::vector<int>& of_representative,
                                        const bool parallel = false)
{
  return element_labels(shape.input, labels_of_points(shape, of_representative, parallel),
                        parallel);
}

/// returns for each representative the label of the element of one of its points.
inline std::vector<int> representative_labels(const Shape_analysis& shape,
                                              const std::vector<int>& element_labels)
{
  std::vector<int> labels(shape.points().size());
  for (std::size_t i = 0; i < shape.input.size(); ++i)
    labels[shape.representative(i)] = element_labels[shape.input.elements[i]];
  return labels;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_OUTPUT_LABEL_TRANSFER_H
