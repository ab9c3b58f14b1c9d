// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H

// The method as the paper's overview (figure 3) has it: points -> patches -> visibility -> components
// -> signatures -> segments -> borders.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/absorb_strips.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/connected_parts.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/mirrored_borders.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/refine_borders.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/straighten_borders.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/consensus.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/mirror.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/turn.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/turned_parts.h>
#include <CGAL/Weakly_convex_segmentation/internal/consensus/votes.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/oracle_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/learned_cost_table.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/merge_patches.h>
#include <CGAL/Weakly_convex_segmentation/internal/output/label_transfer.h>
#include <CGAL/Weakly_convex_segmentation/internal/output/segment_statistics.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/cut_patches.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Labels of the representatives, and of what they were made of.
struct Representative_labels
{
  std::vector<int> patches; ///< leaves of the merge tree
  std::vector<int> segments;
};

/// returns what a set of patches says: a cut by the cost, or the probabilities of its merges.
inline Votes votes_of_set(const Shape_analysis& shape, const Patch_set& set,
                          const Parameters& parameters, const Run_control& control,
                          const Merge_cost& own_cost, const Boosted_trees& trees)
{
  if (own_cost.cost || parameters.merging != Merging_rule::FITTED)
    return {segments_of_patches(shape, set, parameters, control, own_cost)};
  return votes_of_merges(judge_patches(shape, set, parameters, control, trees),
                         set.patches.of_point);
}

/// returns a plane of the method's frame as one of the input.
inline Symmetry_plane in_input(const Mirror& mirror, const Placement& placement)
{
  const Double3 &n = mirror.plane.normal, foot = mirror.plane.offset * n;
  return {placement.position(in_single(foot)), placement.direction(in_single(n)),
          mirror.fit.residual};
}

/// The motions that take a shape to itself, nearly.
struct Symmetries
{
  Mirror mirror;
  Turn turn;
};

/// returns the shape's plane of reflection and its smallest turn, if it has them.
inline Symmetries symmetries_of(const Shape_analysis& shape, const Parameters& parameters,
                                const Run_control& control)
{
  if (parameters.symmetry_tolerance == 0. || shape.patch_sets.size() == 1) return {};
  const Motion_judge judge(shape.points(), shape.graph.spacing);
  Symmetries found{find_mirror(judge, parameters.symmetry_tolerance, control.parallel),
                   find_turn(judge, parameters.symmetry_tolerance, control.parallel)};
  control.check();
  if (!found.mirror.image.empty() && control.visitor != nullptr)
    control.visitor->symmetry_found(in_input(found.mirror, shape.input.placement));
  return found;
}

inline std::size_t number_of_labels(const std::vector<int>& labels)
{
  return std::set<int>(labels.begin(), labels.end()).size();
}

inline int first_unused(const std::vector<int>& labels)
{
  return 1 + *std::max_element(labels.begin(), labels.end());
}

inline bool is_number_asked(const Merging_parameters& parameters)
{
  return parameters.minimum_number_of_segments > 0 || parameters.maximum_number_of_segments > 0;
}

/// returns the labels at a share of the votes, or at one where their number is as it is asked for: the next larger
/// number where none is, as the merge tree can join them, but has no better way to divide them.
template <typename Labels_at>
std::vector<int> consensus_of_number(const Labels_at& labels_at, double share,
                                     const Merging_parameters& parameters)
{
  constexpr int rounds = 12;
  std::vector<int> labels = labels_at(share);
  const std::size_t most = parameters.maximum_number_of_segments,
                    fewest = parameters.minimum_number_of_segments;
  const std::size_t before = number_of_labels(labels);
  const bool has_too_many = most > 0 && before > most;
  if (!has_too_many && before >= fewest) return labels;
  const std::size_t wanted = has_too_many ? most : fewest;
  double low = has_too_many ? 0. : share, high = has_too_many ? share : 1.;
  for (int round = 0; round < rounds && number_of_labels(labels) != wanted; ++round)
  {
    share = 0.5 * (low + high);
    std::vector<int> other = labels_at(share);
    const std::size_t number = number_of_labels(other);
    (number < wanted ? low : high) = share;
    const std::size_t best = number_of_labels(labels);
    if (best < wanted ? number > best : number >= wanted && number < best)
      labels = std::move(other);
  }
  return labels;
}

/// returns the segment of each representative: what the sets of patches agree on. Its borders are those of many
/// patches, and are refined before strips are looked for; once is enough for that.
inline std::vector<int> decide_segments(const Shape_analysis& shape, const Parameters& parameters,
                                        const Run_control& control, const Merge_cost& own_cost,
                                        const Symmetries& symmetries,
                                        const Boosted_trees& trees = learned_trees())
{
  const std::size_t sets = shape.patch_sets.size();
  std::vector<Votes> votes(sets);
  const auto decide = [&](const std::size_t s)
  { votes[s] = votes_of_set(shape, shape.patch_sets[s], parameters, control, own_cost, trees); };
  parallel_for(sets, control.parallel, decide, 1);
  const bool are_cuts = votes.front().together.empty();
  if (sets == 1 && are_cuts) return std::move(votes.front().labels);
  const double least = are_cuts ? least_share_of_cuts : 1. - parameters.merging_threshold;
  const double minimum_size =
      parameters.minimum_segment_share * static_cast<double>(shape.points().size());
  const std::vector<Index>& mirrored = symmetries.mirror.image;
  std::vector<int> labels = consensus_of_number(
      [&](const double share) { return consensus_labels(votes, share, minimum_size, mirrored); },
      least, parameters);
  if (sets > 1) refine_borders(shape.graph, parameters, labels, control.parallel, 1);
  absorb_strips(shape.graph, labels, images_of_labels(labels, mirrored));
  const auto connect_parts = [&]
  {
    Torn_parts(shape.points().links, labels).join_small(minimum_size);
    Torn_parts(shape.points().links, labels).divide(first_unused(labels));
  };
  connect_parts();
  if (symmetries.turn.order == 1 || is_number_asked(parameters)) return labels;
  decide_places_alike(symmetries.turn, labels);
  connect_parts();
  return labels;
}

/// gives segments that have lost all of their elements what they had before.
inline void keep_segments(const std::vector<int>& before, std::vector<int>& labels)
{
  const std::set<int> there(labels.begin(), labels.end());
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (there.count(before[i]) == 0) labels[i] = before[i];
}

/// refines the borders, alike on both sides of a mirror, and carries the labels to the input; `keeps_all`: no segment
/// may vanish.
inline Result finish_segmentation(const Shape_analysis& shape, Representative_labels labels,
                                  Merge_tree tree, const Parameters& parameters,
                                  const Run_control& control, const bool keeps_all,
                                  const Mirror& mirror = {})
{
  Result result;
  const auto refine = [&]
  {
    const std::vector<int> unrefined = labels.segments;
    refine_borders(shape.graph, parameters, labels.segments, control.parallel);
    match_borders(shape.graph, shape.points(), mirror, parameters, labels.segments);
    const std::size_t moved = number_of_changes(unrefined, labels.segments);
    control.check();
    result.labels = element_labels(
        shape.input, carry_labels(shape, labels.segments, parameters, control), control.parallel);
    if (parameters.refinement == Refinement_rule::SEAM_CUTS && parameters.band_width > 0.)
    {
      straighten_borders(shape.faces, shape.input, parameters, control, result.labels);
      Torn_parts(shape.faces.links, result.labels)
          .join_small(parameters.minimum_segment_share * static_cast<double>(result.labels.size()));
    }
    if (parameters.pieces == Piece_rule::WHOLE) join_pieces(shape.faces.links, result.labels);
    label_strays(shape.input, result.labels);
    if (keeps_all)
      keep_segments(element_labels(shape.input, labels_of_points(shape, unrefined)), result.labels);
    return moved;
  };
  const auto describe = [&]
  {
    const std::size_t count = number_labels(result.labels);
    control.check();
    labels.segments = representative_labels(shape, result.labels);
    result.segments =
        describe_segments(shape, labels.segments, result.labels, count, control.parallel);
    control.check();
    result.patches = element_patches(shape, labels.patches, control.parallel);
    return count;
  };
  control.stage(Stage::REFINEMENT, refine);
  control.stage(Stage::STATISTICS, describe);
  result.has_flipped_normals = shape.has_flipped_normals;
  result.has_doubtful_normals = shape.has_doubtful_normals;
  result.merge_tree = std::move(tree);
  result.number_of_components =
      result.merge_tree.number_of_patches() - result.merge_tree.number_of_fusions();
  return result;
}

/// segments an analyzed shape.
inline Result segment_shape(Shape_analysis& shape, const Parameters& parameters,
                            const Run_control& control, const Merge_cost& own_cost = {})
{
  parameters.check();
  // a shape that was analyzed for other rules has no diameters yet
  sample_diameters(shape, parameters, control.parallel);
  Symmetries symmetries;
  std::vector<int> segments;
  const auto decide = [&]
  {
    symmetries = symmetries_of(shape, parameters, control);
    segments = decide_segments(shape, parameters, control, own_cost, symmetries);
    if (parameters.pieces == Piece_rule::WHOLE) join_pieces(shape.points().links, segments);
    return shape.patch_sets.size();
  };
  control.stage(Stage::CONSENSUS, decide);
  Cut_patches patches = cut_patches(shape.graph, shape.patches(), segments);
  Merge_tree tree = merge_within_segments(shape, patches, parameters, control, own_cost);
  const std::vector<int> region = tree.labels_after(tree.number_of_accepted_merges());
  for (std::size_t i = 0; i < segments.size(); ++i)
    segments[i] = region[patches.patches.of_point[i]];
  const Mirror& mirror = symmetries.mirror;
  Result result = finish_segmentation(
      shape, {std::move(patches.patches.of_point), std::move(segments)}, std::move(tree),
      parameters, control, parameters.minimum_number_of_segments > 0, mirror);
  if (!mirror.image.empty()) result.symmetry_plane = in_input(mirror, shape.input.placement);
  return result;
}

/// the whole method
inline Result segment_points(Raw_shape raw, const Parameters& parameters,
                             const Run_control& control)
{
  parameters.check();
  control.progress(0.);
  const auto shape = analyze_shape(std::move(raw), parameters, control);
  return segment_shape(*shape, parameters, control);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_PIPELINE_H
