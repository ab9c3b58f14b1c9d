// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/internal/alpha_expansion_refinement.h>
#include <CGAL/Weakly_convex_segmentation/internal/component_fusion.h>
#include <CGAL/Weakly_convex_segmentation/internal/component_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/cost_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/fitted_cost_table.h>
#include <CGAL/Weakly_convex_segmentation/internal/fitted_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

// The method as the paper's overview (figure 3) has it: points -> patches -> visibility -> components
// -> signatures -> segments -> borders.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// goes on merging until one region is left, so that the merge tree serves any granularity: adjacent
/// regions by cost, then the smallest region of what is not adjacent to its nearest.
inline void merge_to_one(Region_graph& graph, const Contraction_log& log, const std::size_t fewest)
{
  while (graph.number_of_regions() > fewest)
  {
    const auto& regions = graph.regions();
    int smallest = -1, nearest = -1;
    for (int r = 0; r < static_cast<int>(regions.size()); ++r)
      if (graph.is_region(r) && (smallest < 0 || regions[r].size < regions[smallest].size))
        smallest = r;
    const auto center = [&](const int r)
    { return (1.f / static_cast<float>(regions[r].size)) * regions[r].center_sum; };
    float best = std::numeric_limits<float>::infinity();
    for (int r = 0; r < static_cast<int>(regions.size()); ++r)
    {
      if (!graph.is_region(r) || r == smallest) continue;
      const float d = squared_length(center(r) - center(smallest));
      if (d < best)
      {
        best = d;
        nearest = r;
      }
    }
    graph.merge(nearest, smallest);
    constexpr double cost = (std::numeric_limits<double>::max)();
    log.tree.add(nearest, smallest, cost);
    if (log.visitor != nullptr) log.visitor->merged(nearest, smallest, cost);
  }
}

/// marks the segments in the merge tree, after more merges if there are too many, and then goes on to
/// one region. Returns the number of segments.
inline std::size_t finish_merging(Region_graph& graph,
                                  const Function_ref<double(int, int)> criterion,
                                  const Parameters& parameters, const Contraction_log& log)
{
  const std::size_t most = parameters.maximum_number_of_segments;
  if (most > 0)
  {
    contract(graph, criterion, log, most);
    merge_to_one(graph, log, most);
  }
  log.tree.set_accepted();
  const std::size_t accepted = graph.number_of_regions();
  contract(graph, criterion, log);
  merge_to_one(graph, log, 1);
  return accepted;
}

/// fusion and merging by the default's cost (sections 4 and 5).
inline void merge_by_cost(Shape_analysis& shape, Region_graph& graph, const Parameters& parameters,
                          const Run_control& control, const Contraction_log& log)
{
  Histogram_scale scale;
  scale.bins = parameters.histogram_bins;
  set_signatures(graph, shape.patches, shape.diameters, scale);
  graph.add_shapes(shape.points(), shape.graph, shape.patches, shape.diameters);
  const Region_cost cost(graph, shape.patches, shape.diameters, scale, parameters);
  control.stage(Stage::FUSION,
                [&]
                {
                  contract_by_cost(graph, cost, parameters.merging_cost,
                                   parameters.fusion_threshold, log);
                  log.tree.set_fused();
                  return graph.number_of_regions();
                });
  control.stage(
      Stage::MERGING,
      [&]
      {
        contract_by_cost(graph, cost, parameters.merging_cost, parameters.merging_threshold, log);
        absorb_small_regions(graph, cost, parameters, log);
        // no more lines of sight for what lies beyond the segments
        return finish_merging(
            graph,
            [&](const int a, const int b) { return cost.blind(a, b, parameters.merging_cost); },
            parameters, log);
      });
}

/// fusion and merging by the fitted cost (sections 4 and 5).
inline void merge_fitted(Shape_analysis& shape, Region_graph& graph, const Parameters& parameters,
                         const Run_control& control, const Contraction_log& log)
{
  const Histogram_scale scale;
  set_signatures(graph, shape.patches, shape.diameters, scale);
  graph.add_shapes(shape.points(), shape.graph, shape.patches, shape.diameters);
  graph.add_profiles(shape.points(), shape.graph, shape.patches);
  Pair_features features(graph, shape.patches, shape.diameters);
  const Fitted_cost cost(features, fitted_trees());
  control.stage(Stage::FUSION,
                [&]
                {
                  contract_fitted(graph, cost, parameters.fitted_fusion_threshold, log);
                  log.tree.set_fused();
                  return graph.number_of_regions();
                });
  control.stage(Stage::MERGING,
                [&]
                {
                  contract_fitted(graph, cost, parameters.fitted_merging_threshold, log);
                  absorb_small_regions(
                      graph, Region_cost(graph, shape.patches, shape.diameters, scale, parameters),
                      parameters, log);
                  return finish_merging(
                      graph, [&](const int a, const int b) { return cost(a, b); }, parameters, log);
                });
}

/// fusion and merging by the paper's rules (sections 4 and 5).
inline void merge_by_paper(Shape_analysis& shape, Region_graph& graph, const Parameters& parameters,
                           const Run_control& control, const Contraction_log& log)
{
  control.stage(Stage::FUSION,
                [&]
                {
                  fuse_components(graph, parameters, log);
                  log.tree.set_fused();
                  return graph.number_of_regions();
                });
  control.stage(Stage::MERGING,
                [&]
                {
                  Component_signatures signatures(shape.points(), shape.patches, parameters,
                                                  control.parallel);
                  merge_components(graph, signatures, shape.diameters, parameters, log);
                  const auto blindness = [&](const int a, const int b)
                  { return 2. - graph.visibility(a, b); };
                  return finish_merging(graph, blindness, parameters, log);
                });
}

/// contracts the patches; the outcome is the merge tree.
inline Merge_tree merge_patches(Shape_analysis& shape, const Parameters& parameters,
                                const Run_control& control)
{
  // a shape that was analyzed for other rules has no diameters yet
  if (parameters.diameter == Diameter_rule::WHOLE_SHAPE && shape.diameters.empty())
    shape.diameters = shape_diameters(*shape.sight, parameters, control.parallel);
  Merge_tree tree(shape.patches.size());
  Region_graph graph(shape.points(), shape.graph, shape.patches, *shape.visibility, parameters);
  Asking_visitor asking(control);
  const Contraction_log log{tree, &asking};
  if (parameters.merging == Merging_rule::COST)
    merge_by_cost(shape, graph, parameters, control, log);
  else if (parameters.merging == Merging_rule::FITTED)
    merge_fitted(shape, graph, parameters, control, log);
  else
    merge_by_paper(shape, graph, parameters, control, log);
  return tree;
}

/// renames labels to 0, 1, ... in the order of their first element; returns how many there are.
inline std::size_t number_labels(std::vector<int>& labels)
{
  int largest = -1;
  for (const int l : labels) largest = (std::max)(largest, l);
  std::vector<int> number(static_cast<std::size_t>(largest + 1), -1);
  int next = 0;
  for (int& l : labels)
  {
    if (number[l] < 0) number[l] = next++;
    l = number[l];
  }
  return static_cast<std::size_t>(next);
}

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

/// returns the labels of the input points in spatial order, from those of the representatives, with
/// the borders refined anew among the points themselves: only those near a border are looked at.
inline std::vector<int> carry_labels(const Shape_analysis& shape, const std::vector<int>& labels,
                                     const Parameters& parameters, const Run_control& control)
{
  std::vector<int> result(shape.input.size());
  parallel_for(
      result.size(), control.parallel,
      [&](const std::size_t i) { result[i] = labels[shape.representative(i)]; }, 4096);
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
  const std::vector<Index> near_border = points_in_band(shape, band, control.parallel);
  if (near_border.empty()) return result;
  control.check();

  Oriented_points points = sub_points(shape.input, near_border);
  if (!parameters.use_mesh_adjacency) points.links.clear();
  Neighbor_graph graph =
      build_neighbor_graph(points, parameters.number_of_neighbors, control.parallel);
  if (shape.is_smoothed) smooth_noise(radians(parameters.noise_tolerance), graph, points);
  control.check();
  std::vector<int> band_labels;
  for (const Index i : near_border) band_labels.push_back(result[i]);
  move_borders(graph, fine, band_labels, control.parallel);
  for (std::size_t j = 0; j < near_border.size(); ++j) result[near_border[j]] = band_labels[j];
  return result;
}

/// returns one label an input element from those of the points: what most of its points have, the
/// smallest of such.
inline std::vector<int> element_labels(const Oriented_points& points,
                                       const std::vector<int>& labels, const bool parallel = false)
{
  std::vector<int> result(points.number_of_elements);
  if (points.size() == points.number_of_elements)
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
  return result;
}

/// returns the patch of each input element.
inline std::vector<int> element_patches(const Shape_analysis& shape, const bool parallel = false)
{
  std::vector<int> patches(shape.input.size());
  parallel_for(
      patches.size(), parallel,
      [&](const std::size_t i) { patches[i] = shape.patches.of_point[shape.representative(i)]; },
      4096);
  return element_labels(shape.input, patches, parallel);
}

/// gives each representative the final label of one of its points.
inline void relabel_representatives(const Shape_analysis& shape,
                                    const std::vector<int>& element_labels,
                                    std::vector<int>& labels)
{
  for (std::size_t i = 0; i < shape.input.size(); ++i)
    labels[shape.representative(i)] = element_labels[shape.input.elements[i]];
}

/// fills size, convexity rank, diameter and neighbors of each segment.
inline std::vector<Segment> describe_segments(const Shape_analysis& shape,
                                              const std::vector<int>& point_labels,
                                              const std::vector<int>& element_labels,
                                              const std::size_t count, const bool parallel = false)
{
  constexpr std::size_t rank_sample = 40; // 780 lines of sight a segment
  constexpr double rank_tolerance = 5.;   // degrees: flat faces and noise are not concave
  std::vector<Segment> segments(count);
  std::vector<std::vector<Index>> members(count);
  std::vector<std::set<std::size_t>> neighbors(count);
  Histogram_scale scale;
  std::vector<Diameter_histogram> diameters(count);
  for (const int l : element_labels) ++segments[l].size;
  for (Index i = 0; i < point_labels.size(); ++i)
  {
    members[point_labels[i]].push_back(i);
    for (const Neighbor& edge : shape.graph[i])
      if (point_labels[edge.point] != point_labels[i])
        neighbors[point_labels[i]].insert(static_cast<std::size_t>(point_labels[edge.point]));
  }
  for (const Diameter_sample& s : shape.diameters)
    diameters[point_labels[s.point]].add(scale, s.diameter);
  parallel_for(
      count, parallel,
      [&](const std::size_t l)
      {
        segments[l].convexity_rank =
            convexity_rank(*shape.sight, members[l], rank_sample, rank_tolerance);
      },
      1);
  for (std::size_t l = 0; l < count; ++l)
  {
    segments[l].diameter = diameters[l].median(scale) * shape.input.extent;
    segments[l].neighbors.assign(neighbors[l].begin(), neighbors[l].end());
  }
  return segments;
}

/// refines the borders of `region_of_patch` and carries the labels to the input.
inline Result finish_segmentation(const Shape_analysis& shape, Merge_tree tree,
                                  const std::vector<int>& region_of_patch,
                                  const Parameters& parameters, const Run_control& control)
{
  Result result;
  std::vector<int> labels(shape.points().size()), input_labels;
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = region_of_patch[shape.patches.of_point[i]];
  control.stage(Stage::REFINEMENT,
                [&]
                {
                  const std::size_t moved =
                      refine_borders(shape.graph, parameters, labels, control.parallel);
                  control.check();
                  input_labels = carry_labels(shape, labels, parameters, control);
                  return moved;
                });
  control.stage(Stage::STATISTICS,
                [&]
                {
                  result.labels = element_labels(shape.input, input_labels, control.parallel);
                  const std::size_t count = number_labels(result.labels);
                  control.check();
                  relabel_representatives(shape, result.labels, labels);
                  result.segments =
                      describe_segments(shape, labels, result.labels, count, control.parallel);
                  control.check();
                  result.patches = element_patches(shape, control.parallel);
                  return count;
                });
  result.has_flipped_normals = shape.has_flipped_normals;
  result.number_of_components = tree.number_of_patches() - tree.number_of_fusions();
  result.merge_tree = std::move(tree);
  return result;
}

/// returns the region of each patch at a level of a merge tree.
inline std::vector<int> regions_at(const Merge_tree& tree, const Level level)
{
  if (level == Level::PATCHES) return tree.labels_after(0);
  if (level == Level::COMPONENTS) return tree.labels_after(tree.number_of_fusions());
  return tree.labels_after(tree.number_of_accepted_merges());
}

/// the whole method
inline Result segment_points(const Raw_points& raw, const Parameters& parameters,
                             const Run_control& control)
{
  parameters.check();
  control.progress(0.);
  const auto shape = analyze_shape(raw, parameters, control);
  Merge_tree tree = merge_patches(*shape, parameters, control);
  const std::vector<int> regions = regions_at(tree, Level::SEGMENTS);
  return finish_segmentation(*shape, std::move(tree), regions, parameters, control);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H
