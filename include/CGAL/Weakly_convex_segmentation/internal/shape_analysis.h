// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SHAPE_ANALYSIS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SHAPE_ANALYSIS_H

// The first half of the pipeline: all that is measured on a shape before any merging, and that does not
// depend on thresholds.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Patch_clustering.h>
#include <CGAL/Weakly_convex_segmentation/internal/diameters/shape_diameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/denoise_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/face_sampling.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/solids.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/strays.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/oracles.h>
#include <CGAL/Weakly_convex_segmentation/internal/patches/patches.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/denoise_points.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/downsampling.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/estimate_normals.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/normal_consistency.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/normal_direction.h>
#include <CGAL/Weakly_convex_segmentation/internal/visibility/Patch_visibility.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// Patches, and what they see of each other.
struct Patch_set
{
  Patches patches;
  std::unique_ptr<Patch_visibility> visibility;
};

/// What is known of a shape before any merging: all that does not depend on thresholds.
struct Shape_analysis
{
  Oracles oracles;
  Oriented_points input;
  Mesh_faces faces;
  bool has_flipped_normals = false;  ///< those of the input pointed inwards, or some of them
  bool has_doubtful_normals = false; ///< they contradict each other
  Representatives representatives;
  Neighbor_graph graph;
  bool is_smoothed = false;          ///< the representatives had too much noise
  std::vector<Patch_set> patch_sets; ///< the first is what the merge tree is about
  std::unique_ptr<Line_of_sight_query> sight;
  std::vector<Diameter_sample> diameters; ///< through the whole shape
  bool has_diameters = false; ///< measured or given; else the samples tell only what they face

  const Oriented_points& points() const { return representatives.points; }
  const Patches& patches() const { return patch_sets.front().patches; }
  Patch_visibility& visibility() const { return *patch_sets.front().visibility; }
  std::size_t representative(const std::size_t input_point) const
  {
    return representatives.of_point.empty() ? input_point : representatives.of_point[input_point];
  }
};

/// samples the diameters of the shape (section 5), unless that has been done; returns how many there are.
inline std::size_t sample_diameters(Shape_analysis& shape, const Diameter_parameters& parameters,
                                    const bool parallel)
{
  const bool is_whole = parameters.diameter == Diameter_rule::WHOLE_SHAPE;
  const bool is_given = parameters.diameter == Diameter_rule::GIVEN;
  if ((is_whole && !shape.has_diameters) || (is_given && shape.diameters.empty()))
  {
    shape.diameters = shape_diameters(*shape.sight, parameters, parallel);
    shape.has_diameters = is_whole;
  }
  return shape.diameters.size();
}

/// returns the clustering that makes the patches: the caller's or ours.
inline Patch_clustering clustering_of(const Oracles& oracles, const Patch_parameters& parameters)
{
  if (oracles.patch_clustering) return oracles.patch_clustering;
  return Spectral_patch_clustering(parameters.spectral_dimensions);
}

/// brings the input into the frame of the method, and thins it where it is large (sections 3 and 6).
inline std::size_t take_samples(Raw_shape raw, const Sampling_parameters& parameters,
                                const Run_control& control, Shape_analysis& shape)
{
  Raw_shape sampled, smoothed;
  if (parameters.denoise && denoise_mesh(raw, control, smoothed)) raw = std::move(smoothed);
  if (parameters.pieces != Piece_rule::JOINED) raw.solids = find_solids(raw);
  const bool has_more = sample_faces(raw, parameters, sampled);
  control.check();
  shape.input = orient_points(has_more ? sampled : raw, control.parallel, control, true);
  if (shape.faces.first_corner.empty())
    shape.faces = {std::move(raw.first_corner), std::move(raw.corners), std::move(raw.links)};
  control.check();
  shape.representatives = downsample(shape.input, parameters.number_of_representatives,
                                     control.parallel, parameters.denoise);
  control.check();
  if (parameters.flip_inward_normals && is_inside_out(shape.points()))
  {
    flip_normals(shape.input);
    flip_normals(shape.representatives.points);
    shape.has_flipped_normals = true;
  }
  if (parameters.extra_neighbors == Extra_neighbors::NONE)
    shape.representatives.points.links.clear();
  return shape.points().size();
}

/// joins representatives to their neighbors.
inline Neighbor_graph join_neighbors(Oriented_points& points, const Sampling_parameters& parameters,
                                     const Run_control& control)
{
  return build_neighbor_graph(points, parameters.number_of_neighbors, control.parallel,
                              parameters.extra_neighbors == Extra_neighbors::FACES_AND_LINES);
}

/// turns normals of a cloud that contradict each other, where it is closed enough to tell which are right. That is
/// decided on the representatives.
inline void mend_normals(const Sampling_parameters& parameters, const Run_control& control,
                         Shape_analysis& shape)
{
  const auto winding = [&](const Oriented_points& points)
  { return mean_winding(points, shape.graph, control.parallel); };
  const double given = winding(shape.points());
  if (has_closed_winding(given)) return;
  control.check();
  Oriented_points consistent = shape.points();
  const double turned = make_consistent(consistent, control);
  const Normals_found found = judge_normals(given, winding(consistent), turned);
  shape.has_doubtful_normals = found == Normals_found::DOUBTFUL;
  if (found != Normals_found::TURNED) return;
  make_consistent(shape.input, control);
  shape.has_flipped_normals = true;
  shape.representatives = downsample(shape.input, parameters.number_of_representatives,
                                     control.parallel, parameters.denoise);
  shape.graph = join_neighbors(shape.representatives.points, parameters, control);
}

/// joins the representatives to their neighbors, and takes the noise from them. `has_given_normals`: those of a cloud
inline std::size_t find_neighbors(const Sampling_parameters& parameters, const Run_control& control,
                                  const bool has_given_normals, Shape_analysis& shape)
{
  Oriented_points& points = shape.representatives.points;
  shape.graph = join_neighbors(points, parameters, control);
  if (has_given_normals && parameters.flip_inward_normals) mend_normals(parameters, control, shape);
  shape.is_smoothed = parameters.denoise && denoise_points(shape.graph, points) > 0;
  return shape.graph.entries.size() / 2;
}

/// over-segments the representatives (section 4).
inline std::size_t make_patches(const Patch_parameters& parameters, const Run_control& control,
                                Shape_analysis& shape)
{
  for (Patches& patches :
       extract_patch_sets(shape.points(), shape.graph, parameters, control.parallel,
                          clustering_of(shape.oracles, parameters)))
    shape.patch_sets.push_back({std::move(patches), nullptr});
  return shape.patches().size();
}

/// makes what lines of sight are cast against; they are cast on demand (sections 3 and 4).
inline std::size_t prepare_visibility(const Visibility_parameters& parameters,
                                      const Run_control& control, Shape_analysis& shape)
{
  shape.sight = std::make_unique<Line_of_sight_query>(shape.points(), shape.graph, parameters,
                                                      shape.oracles.line_of_sight);
  control.check();
  for (Patch_set& set : shape.patch_sets)
    set.visibility =
        std::make_unique<Patch_visibility>(*shape.sight, set.patches, parameters, control.parallel);
  return shape.points().size();
}

/// gives strays the nearest of the other elements.
inline void attach_strays(const std::vector<Coordinates>& positions,
                          const std::vector<Point_role>& roles, Oriented_points& points)
{
  constexpr float farthest = 1e6f; // from where on the direction alone matters
  if (roles.empty()) return;
  const Kd_tree tree(points.positions);
  for (Index i = 0; i < roles.size(); ++i)
  {
    if (roles[i] != Point_role::STRAY) continue;
    Vector3 p = points.placement.point(positions[i]);
    if (!(squared_length(p) < farthest * farthest)) p = {};
    tree.nearest(p, 1,
                 [&](const Index near, float) {
                   points.strays.push_back({i, points.elements[near]});
                 });
  }
}

/// runs the stages up to the shape diameters.
inline std::unique_ptr<Shape_analysis> analyze_shape(Raw_shape raw, const Parameters& parameters,
                                                     const Run_control& control,
                                                     Oracles oracles = {})
{
  auto shape = std::make_unique<Shape_analysis>();
  shape->oracles = std::move(oracles);
  const std::vector<Point_role> roles = point_roles(raw);
  std::vector<Coordinates> positions;
  if (!roles.empty())
  {
    check_finite(raw.normals, "normal");
    Raw_shape rest = without_strays(raw, roles);
    shape->faces = {std::move(raw.first_corner), std::move(raw.corners), std::move(raw.links)};
    positions = std::move(raw.positions);
    raw = std::move(rest);
  }
  const bool has_given_normals =
      !raw.normals.empty() && raw.first_corner.empty() && shape->faces.first_corner.empty();
  if (raw.normals.empty()) estimate_normals(raw, control, parameters.normal_orientation);
  const auto sample = [&]
  {
    take_samples(std::move(raw), parameters, control, *shape);
    attach_strays(positions, roles, shape->input);
    return shape->points().size();
  };
  control.begin_stages(raw.positions.size(), has_given_normals);
  control.stage(Stage::SAMPLING, sample);
  control.stage(Stage::NEIGHBORS,
                [&] { return find_neighbors(parameters, control, has_given_normals, *shape); });
  control.stage(Stage::PATCHES, [&] { return make_patches(parameters, control, *shape); });
  control.stage(Stage::VISIBILITY, [&] { return prepare_visibility(parameters, control, *shape); });
  control.stage(Stage::SIGNATURES,
                [&] { return sample_diameters(*shape, parameters, control.parallel); });
  return shape;
}

/// replaces the diameters of the samples by given ones. A representative has that of the first of its points
/// with one. What the samples face stays what was measured here: the closure of regions rests on it.
inline void use_diameters(Shape_analysis& shape, const std::vector<double>& of_elements,
                          const bool parallel)
{
  Diameter_parameters parameters;
  parameters.diameter = Diameter_rule::GIVEN;
  sample_diameters(shape, parameters, parallel);
  shape.has_diameters = true;
  std::vector<float> given(shape.points().size(), 0.f);
  for (std::size_t i = 0; i < shape.input.size(); ++i)
  {
    const double d = of_elements[shape.input.elements[i]];
    float& of_representative = given[shape.representative(i)];
    if (d > 0. && of_representative == 0.f)
      of_representative = static_cast<float>(d / shape.input.extent);
  }
  for (Diameter_sample& sample : shape.diameters) sample.diameter = given[sample.point];
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SHAPE_ANALYSIS_H
