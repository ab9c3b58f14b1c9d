// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/consensus.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Merge_strategy.h>
#include <CGAL/Weakly_convex_segmentation/internal/output/label_transfer.h>
#include <CGAL/Weakly_convex_segmentation/internal/output/segment_statistics.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

// The method as the paper's overview (figure 3) has it: points -> patches -> visibility -> components
// -> signatures -> segments -> borders. With several sets of patches each is contracted to segments
// first; then the first set is contracted anew, to the segments that most of them agree on.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The merge tree of the first set of patches and, for each representative, a patch whose region it
/// belongs to: its own one, but where the segmentations agree on a border within the patch.
struct Contraction
{
  Merge_tree tree;
  std::vector<int> patch_of_point;
};

/// merges two regions for which there is no cost.
inline void merge_and_tell(Region_graph& graph, const int a, const int b,
                           const Contraction_log& log)
{
  graph.merge(a, b);
  log.tell(a, b, (std::numeric_limits<double>::max)());
}

/// goes on merging what is not adjacent until `fewest` regions are left: the smallest region with its
/// nearest, so that the merge tree serves any granularity.
inline void merge_nonadjacent(Region_graph& graph, const Contraction_log& log,
                              const std::size_t fewest)
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
    merge_and_tell(graph, nearest, smallest, log);
  }
}

/// merges what has one label in spite of the thresholds, and parts of it that do not touch at last.
inline void merge_agreed(Region_graph& graph, Merge_strategy& rules, const Contraction_log& log)
{
  contract(
      graph, [&](const int a, const int b) { return rules.cost_above_threshold(a, b); }, log);
  std::map<int, int> first_with_label;
  for (int r = 0; r < static_cast<int>(graph.regions().size()); ++r)
  {
    if (!graph.is_region(r)) continue;
    const auto [first, is_new] = first_with_label.emplace(log.apart[r], r);
    if (!is_new) merge_and_tell(graph, first->second, r, log);
  }
}

/// marks the segments in the merge tree, after more merges if there are too many, and then goes on to
/// one region. Returns the number of segments.
inline std::size_t finish_merging(Region_graph& graph, Merge_strategy& rules,
                                  const Parameters& parameters, const Contraction_log& log)
{
  const auto cost = [&](const int a, const int b) { return rules.cost_above_threshold(a, b); };
  const std::size_t most = parameters.maximum_number_of_segments;
  if (most > 0)
  {
    contract(graph, cost, log, most);
    merge_nonadjacent(graph, log, most);
  }
  log.tree.set_accepted();
  const std::size_t accepted = graph.number_of_regions();
  contract(graph, cost, log);
  merge_nonadjacent(graph, log, 1);
  return accepted;
}

/// Asks the callback at each merge of a set of patches, whose merges nobody else is told of.
class Silent_visitor : public Visitor
{
  const Run_control& m_control;

public:
  explicit Silent_visitor(const Run_control& control) : m_control(control) {}
  void merged(int, int, double) override { m_control.check_on_any_thread(); }
};

/// returns the segments of the representatives that one set of patches leads to. Their borders are
/// refined: else what sets agree on would be cut along the borders of many patches.
inline std::vector<int> segments_of_set(const Shape_analysis& shape, const Patch_set& set,
                                        const Parameters& parameters, const Run_control& control,
                                        const Merge_cost& own_cost)
{
  Region_graph graph(shape.points(), shape.graph, set.patches, *set.visibility, parameters);
  Merge_tree tree(set.patches.size());
  Silent_visitor asking(control);
  const Contraction_log log{tree, &asking};
  const auto rules =
      make_strategy(shape, set.patches, graph, parameters, control.parallel, own_cost);
  rules->fuse(log);
  rules->merge(log);
  const std::vector<int> regions = graph.labels();
  std::vector<int> labels;
  labels.reserve(shape.points().size());
  for (const int p : set.patches.of_point) labels.push_back(regions[p]);
  refine_borders(shape.graph, parameters, labels, control.parallel);
  return labels;
}

/// returns what most of the sets of patches agree on: the segments of the representatives.
inline std::vector<int> agree(const Shape_analysis& shape, const Parameters& parameters,
                              const Run_control& control, const Merge_cost& own_cost)
{
  std::vector<std::vector<int>> segmentations(shape.patch_sets.size());
  parallel_for(
      segmentations.size(), control.parallel,
      [&](const std::size_t s) {
        segmentations[s] =
            segments_of_set(shape, shape.patch_sets[s], parameters, control, own_cost);
      },
      1);
  return consensus_labels(segmentations, parameters.minimum_segment_share *
                                             static_cast<double>(shape.points().size()));
}

/// finds what the sets of patches agree on, if there are several: returns a label for each patch of the
/// first, and sets the patches of the points.
inline std::vector<int> agreed_patch_labels(const Shape_analysis& shape,
                                            const Parameters& parameters,
                                            const Run_control& control, const Merge_cost& own_cost,
                                            std::vector<int>& patch_of_point)
{
  std::vector<int> of_patches;
  control.stage(Stage::CONSENSUS,
                [&]
                {
                  if (shape.patch_sets.size() == 1) return std::size_t(1);
                  const std::vector<int> labels = agree(shape, parameters, control, own_cost);
                  of_patches = patch_labels(shape.patches(), labels);
                  patch_of_point = patches_of_labels(shape.patches(), of_patches, labels);
                  return shape.patch_sets.size();
                });
  return of_patches;
}

/// contracts the patches.
inline Contraction contract_patches(Shape_analysis& shape, const Parameters& parameters,
                                    const Run_control& control, const Merge_cost& own_cost = {})
{
  // a shape that was analyzed for other rules has no diameters yet
  sample_diameters(shape, parameters, control.parallel);
  const Patches& patches = shape.patches();
  Contraction result{Merge_tree(patches.size()), patches.of_point};
  const std::vector<int> apart =
      agreed_patch_labels(shape, parameters, control, own_cost, result.patch_of_point);
  Region_graph graph(shape.points(), shape.graph, patches, shape.visibility(), parameters);
  const auto rules = make_strategy(shape, patches, graph, parameters, control.parallel, own_cost);
  Asking_visitor asking(control);
  Contraction_log log{result.tree, &asking}, within{result.tree, &asking, apart};
  if (!apart.empty())
  {
    // for Merge_tree::labels_at_cost() what is agreed on costs no more than the threshold, the rest more
    within.highest = rules->merging_threshold();
    log.lowest =
        std::nextafter(rules->merging_threshold(), std::numeric_limits<double>::infinity());
  }
  control.stage(Stage::FUSION,
                [&]
                {
                  rules->fuse(within);
                  result.tree.set_fused();
                  return graph.number_of_regions();
                });
  control.stage(Stage::MERGING,
                [&]
                {
                  rules->merge(within);
                  if (!apart.empty()) merge_agreed(graph, *rules, within);
                  return finish_merging(graph, *rules, parameters, log);
                });
  return result;
}

/// refines the borders of the regions of the patches and carries the labels to the input.
inline Result finish_segmentation(const Shape_analysis& shape, Contraction contraction,
                                  const std::vector<int>& region_of_patch,
                                  const Parameters& parameters, const Run_control& control)
{
  Result result;
  std::vector<int> labels(shape.points().size()), input_labels;
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = region_of_patch[contraction.patch_of_point[i]];
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
  result.merge_tree = std::move(contraction.tree);
  result.number_of_components =
      result.merge_tree.number_of_patches() - result.merge_tree.number_of_fusions();
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
inline Result segment_points(Raw_shape raw, const Parameters& parameters,
                             const Run_control& control)
{
  parameters.check();
  control.progress(0.);
  const auto shape = analyze_shape(std::move(raw), parameters, control);
  Contraction contraction = contract_patches(*shape, parameters, control);
  const std::vector<int> regions = regions_at(contraction.tree, Level::SEGMENTS);
  return finish_segmentation(*shape, std::move(contraction), regions, parameters, control);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H
