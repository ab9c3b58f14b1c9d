// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_DECOMPOSITION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_DECOMPOSITION_H

#include "baselines/lines_of_sight_clustering.h"
#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/Visitor.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/check_call.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The knobs of `lines_of_sight_decomposition()`.
struct Lines_of_sight_parameters
{
  /// wanted number of parts, at most `number_of_samples`; 0: as many as there are eigenvalues before
  /// the largest gap
  std::size_t number_of_segments = 0;
  /// points between which all lines of sight are cast: their number squared is the size of the
  /// matrix, its third power the time of the eigenvectors; `[2, 4000]`
  std::size_t number_of_samples = 500;
  /// the largest number of parts that the gap of the eigenvalues may give; at least 1
  std::size_t maximum_number_of_segments = 40;
  /// a line of sight may leave the surface to the outside by so many degrees: flat faces see
  /// themselves; `[0, 90]`
  double outside_tolerance = 5.;
  /// Sampling of the shape, neighbors, disks and seed; what it says of later stages is not used.
  Parameters shape;

  /// checks all ranges, also those of `shape`.
  /// \throws std::invalid_argument naming the first parameter that is out of its range.
  void check() const
  {
    internal::check_range("number_of_samples", static_cast<double>(number_of_samples), 2., 4000.);
    internal::check_range("number_of_segments", static_cast<double>(number_of_segments), 0.,
                          static_cast<double>(number_of_samples));
    internal::check_range("maximum_number_of_segments",
                          static_cast<double>(maximum_number_of_segments), 1., 1e9);
    internal::check_range("outside_tolerance", outside_tolerance, 0., 90.);
    shape.check();
  }
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The outcome of `lines_of_sight_decomposition()`.
struct Lines_of_sight_result
{
  /// label of each input element, from 0 without gaps in the order of the first element
  std::vector<int> labels;
  std::vector<Segment> segments; ///< one for each label; `Segment::diameter` is not measured
  /// eigenvalues of the normalized Laplacian of the sample's lines of sight, ascending, in `[0, 2]`
  std::vector<double> eigenvalues;
  bool has_flipped_normals = false; ///< see `Parameters::flip_inward_normals`

  /// number of parts
  std::size_t number_of_segments() const { return segments.size(); }
};

namespace internal {

inline Lines_of_sight_result decompose_by_lines_of_sight(const Raw_shape& raw,
                                                         Lines_of_sight_parameters parameters,
                                                         const Run_control& control,
                                                         const unsigned int seed)
{
  parameters.check();
  control.progress(0.);
  Shape_analysis shape;
  Raw_shape sampled;
  shape.input = orient_points(sample_faces(raw, parameters.shape, sampled) ? sampled : raw);
  shape.representatives = downsample(shape.input, parameters.shape.number_of_representatives);
  Lines_of_sight_result result;
  if (parameters.shape.flip_inward_normals && is_inside_out(shape.points()))
  {
    flip_normals(shape.representatives.points);
    result.has_flipped_normals = true;
  }
  if (!parameters.shape.use_mesh_adjacency) shape.representatives.points.links.clear();
  shape.graph = build_neighbor_graph(shape.representatives.points,
                                     parameters.shape.number_of_neighbors, control.parallel);
  shape.sight =
      std::make_unique<Line_of_sight_query>(shape.points(), shape.graph, parameters.shape);
  control.progress(0.2);

  const std::vector<Index> sample = farthest_points(shape.points(), parameters.number_of_samples);
  const Eigen::MatrixXd matrix =
      line_of_sight_matrix(*shape.sight, sample, parameters.outside_tolerance, control.parallel);
  control.progress(0.5);
  const Spectrum spectrum = laplacian_spectrum(matrix);
  result.eigenvalues.assign(spectrum.values.begin(), spectrum.values.end());
  control.progress(0.8);

  const std::size_t wanted =
      parameters.number_of_segments > 0
          ? (std::min)(parameters.number_of_segments, sample.size())
          : clusters_by_eigengap(spectrum.values, parameters.maximum_number_of_segments);
  std::vector<int> labels =
      spread_clusters(*shape.sight, sample, cluster_spectrum(spectrum, wanted, seed),
                      parameters.outside_tolerance, control.parallel);
  std::vector<int> input_labels(shape.input.size());
  for (std::size_t i = 0; i < input_labels.size(); ++i)
    input_labels[i] = labels[shape.representative(i)];
  result.labels = element_labels(shape.input, input_labels);
  const std::size_t count = number_labels(result.labels);
  relabel_representatives(shape, result.labels, labels);
  result.segments = describe_segments(shape, labels, result.labels, count);
  for (Segment& segment : result.segments) segment.diameter = 0.;
  control.progress(1.);
  return result;
}

} // namespace internal

/// \ingroup PkgWeaklyConvexSegmentationRef
/// decomposes a shape into weakly convex parts by clustering its lines of sight, in the style of
/// Asafi, Goren, Cohen-Or: *Weak Convex Decomposition by Lines-of-sight* (2013), with which
/// \cgalCite{cgal:kfkac-ssaca-14} compares itself.
///
/// Points that see each other inside of the shape belong together: the matrix of all lines of sight is
/// clustered by its spectrum. There are no patches, no surface and no volume; parts need not be
/// connected. It is here to be compared with; to cut a shape into parts, `weakly_convex_segmentation()`
/// is better. What we chose where the public text on the method leaves it open:
///   - lines of sight are cast between `number_of_samples` points, each the farthest from those before,
///     where opposite normals count as 6 % of the extent of the shape;
///   - points occlude as disks as large as the mean distance to their neighbors, but not near the ends
///     of a line (`Parameters::disk_radius_factor`, `Parameters::clearance_factor`); lines must not
///     leave the surface outwards (`outside_tolerance`);
///   - the affinity of two points is 1 in line of sight and 0 else, of a point with itself 1; the
///     Laplacian is the symmetric normalized one;
///   - the number of parts is given, or that of the eigenvalues before the largest gap from the second
///     on; shapes whose second eigenvalue is at least one half are one part;
///   - the rows of the first eigenvectors, scaled to unit length, are clustered by the best of ten runs
///     of k-means;
///   - every other point joins the nearest of the 8 nearest samples that it sees, else the nearest.
///
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result does not depend on it
/// \tparam Input a range of points, a `CGAL::Point_set_3` or a triangle mesh, as for
///   `weakly_convex_segmentation()`
/// \tparam LabelMap a model of `WritablePropertyMap` with value type `int`
///
/// \param input the shape; it is not changed
/// \param label_map receives the label of each element; it is written only when all has succeeded
/// \param parameters the knobs
/// \param np those named parameters of `weakly_convex_segmentation()` that CGAL has, but `visitor`
///
/// \returns labels in input order and what is known of each part. There are as many parts as given
///   unless the shape has fewer distinct points, or, on meshes, a part holds no whole face.
///
/// \throws std::invalid_argument if there are no elements, a coordinate is not finite, or a parameter
///   is out of its range
/// \throws Canceled if the callback returns false
///
/// Complexity: O(n log n) for n elements, and with s samples O(s n) in thinned points, s^2 lines of
/// sight and O(s^3) in memory of O(s^2). Thread safety is that of
/// `weakly_convex_segmentation()`.
template <typename ConcurrencyTag = Sequential_tag, typename Input, typename LabelMap,
          typename NamedParameters = parameters::Default_named_parameters>
Lines_of_sight_result
lines_of_sight_decomposition(const Input& input, LabelMap label_map,
                             const Lines_of_sight_parameters& parameters = {},
                             const NamedParameters& np = parameters::default_values())
{
  const auto& plain = internal::as_cgal(np);
  constexpr internal::Mistake mistake =
      internal::mistake_in_call<Input, LabelMap, std::decay_t<decltype(plain)>,
                                internal::No_name>();
  internal::refuse<mistake, Input, LabelMap, NamedParameters>();
  if constexpr (mistake == internal::Mistake::NONE)
  {
    const internal::Run_control control = internal::read_control<ConcurrencyTag>(plain);
    internal::Raw_shape raw = internal::read_input<ConcurrencyTag>(input, plain);
    if (raw.normals.empty())
      internal::estimate_normals(raw, control, parameters.shape.normal_orientation);
    Lines_of_sight_result result = internal::decompose_by_lines_of_sight(
        raw, parameters, control, internal::read_seed(plain, parameters.shape));
    internal::write_labels(input, result.labels, label_map);
    return result;
  }
  else
    return {};
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_DECOMPOSITION_H
