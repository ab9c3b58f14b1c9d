// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/Segmenter.h>
#include <CGAL/Weakly_convex_segmentation/Visitor.h>
#include <CGAL/Weakly_convex_segmentation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// segments a range of points, or a triangle mesh, into its parts.
///
/// The method is that of \cgalCite{cgal:kfkac-ssaca-14}: nearly convex patches are fused into weakly
/// convex components where they see each other inside of the shape, components of similar volume are
/// merged, and the borders refined.
///
/// \tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag` where TBB is linked; the result does not depend on it. With
///   the latter, the maps of a range of points are read by several threads at once.
/// \tparam Input one of
///   - a model of `ConstRange` of points: the value type is the key type of the maps;
///   - a `CGAL::Point_set_3`, with or without normals: its index is the key type of `LabelMap`;
///   - a triangle mesh, model of `FaceListGraph` and `EdgeListGraph`: the key type of `LabelMap` is its face
///     descriptor; each face counts as one oriented point, long ones as several (`Parameters::face_sampling_factor`).
/// \tparam LabelMap a model of `WritablePropertyMap` with value type `int`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param input the shape, of at most 2^32 - 2 elements, in any unit of length; it is not changed
/// \param label_map receives the label of each element, numbered from 0 without gaps in the order of the
///   first element of each; it is written only when all has succeeded
/// \param np optional named parameters. Where names of this package and of %CGAL are given, begin with one of
///   this package. Those that mean nothing for an input are refused by the compiler.
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{segmentation_parameters}
///     \cgalParamDescription{the knobs of the algorithm: a preset or values of your own; parameters below have
///       precedence over its members}
///     \cgalParamType{`Weakly_convex_segmentation::Parameters`}
///     \cgalParamDefault{`Weakly_convex_segmentation::Parameters()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_segments}
///     \cgalParamDescription{takes the place of `Parameters::maximum_number_of_segments`; 0: no limit}
///     \cgalParamType{an integer, at least 0}
///     \cgalParamDefault{that of `segmentation_parameters`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_number_of_segments}
///     \cgalParamDescription{takes the place of `Parameters::minimum_number_of_segments`: with the maximum, the
///       number that is wanted}
///     \cgalParamType{an integer, at least 0}
///     \cgalParamDefault{that of `segmentation_parameters`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_segment_share}
///     \cgalParamDescription{takes the place of `Parameters::minimum_segment_share`}
///     \cgalParamType{`double`, in `[0, 1]`}
///     \cgalParamDefault{that of `segmentation_parameters`}
///   \cgalParamNEnd
///   \cgalParamNBegin{level}
///     \cgalParamDescription{which labels `label_map` receives, see `Weakly_convex_segmentation::Result::labels_at()`;
///       the result has all of them in any case}
///     \cgalParamType{`Weakly_convex_segmentation::Level`}
///     \cgalParamDefault{`Weakly_convex_segmentation::Level::SEGMENTS`}
///   \cgalParamNEnd
///   \cgalParamNBegin{line_of_sight}
///     \cgalParamDescription{tells which points see each other inside of the shape}
///     \cgalParamType{a model of `WeaklyConvexSegmentationLineOfSight`}
///     \cgalParamDefault{the points occlude as disks, as `Weakly_convex_segmentation::Disk_line_of_sight`}
///   \cgalParamNEnd
///   \cgalParamNBegin{patch_clustering}
///     \cgalParamDescription{makes the patches}
///     \cgalParamType{a model of `WeaklyConvexSegmentationPatchClustering`}
///     \cgalParamDefault{`Weakly_convex_segmentation::Spectral_patch_clustering`}
///   \cgalParamNEnd
///   \cgalParamNBegin{merge_cost}
///     \cgalParamDescription{decides which patches become components and segments, in place of
///       `Parameters::merging`}
///     \cgalParamType{a model of `WeaklyConvexSegmentationMergeCost`}
///     \cgalParamDefault{what `Parameters::merging` says}
///   \cgalParamNEnd
///   \cgalParamNBegin{diameter_map}
///     \cgalParamDescription{diameters of the shape at the elements, in units of the input, such as those of
///       `CGAL::sdf_values()`; at most 0 or not a number where there is none. It is for ranges, point sets
///       and meshes, not for soups, and has no effect with `Diameter_rule::OWN_POINTS`, as in the preset
///       `paper`.}
///     \cgalParamType{a model of `ReadablePropertyMap` with the key type of `LabelMap`, value type `double`}
///     \cgalParamDefault{measured along lines of sight}
///   \cgalParamNEnd
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{a property map from the elements of a range to points}
///     \cgalParamType{a model of `ReadablePropertyMap`, value type `Point_3`}
///     \cgalParamDefault{`CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{normal_map}
///     \cgalParamDescription{a property map from the elements of a range to outward normals of any
///       length}
///     \cgalParamType{a model of `ReadablePropertyMap`, value type `Vector_3`}
///     \cgalParamDefault{normals are estimated from the nearest points as by `pca_estimate_normals()`, and
///       turned outwards as `Parameters::normal_orientation` says}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map from the vertices of a mesh to points}
///     \cgalParamType{a model of `ReadablePropertyMap`, value type `Point_3`}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_index_map}
///     \cgalParamDescription{a property map from the faces of a mesh to numbers, each another one from 0 to
///       `num_faces(mesh) - 1`; results do not depend on it}
///     \cgalParamType{a model of `ReadablePropertyMap`, value type an integer}
///     \cgalParamDefault{an automatically indexed internal map, which is initialized if it is not}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{gives the coordinates of points and vectors, which are converted to `double`}
///     \cgalParamType{a model of `WeaklyConvexSegmentationTraits`, as every kernel is}
///     \cgalParamDefault{`Weakly_convex_segmentation::Default_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{called with the progress, which grows from 0 to 1, by the calling thread, after each stage
///       and within long ones; false stops the run}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{its functions are called at the stages and merges}
///     \cgalParamType{`std::ref()` of a model of `WeaklyConvexSegmentationVisitor`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{takes the place of `Parameters::seed`}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{that of `segmentation_parameters`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns labels in input order, what is known of each segment, and the merge tree
///
/// \throws std::invalid_argument if there are no elements or too many, a coordinate is not finite, a
///   parameter is out of its range, or `face_index_map` has a number twice
/// \throws Weakly_convex_segmentation::Canceled if the callback returns false
///
/// Whatever else the callback, the visitor or a property map throws passes through.
///
/// Complexity: O(n log n) for n elements in the neighbor search; all that is not near linear runs on
/// `Parameters::number_of_representatives` points.
///
/// Thread safety: the function may run in several threads at once, if each has a label map, callback and
/// visitor of its own. With `Parallel_tag`, the maps of a range are read, and what is given for
/// `line_of_sight`, `patch_clustering` and `merge_cost` is called, by several threads at once; labels are
/// written by the calling thread alone.
template <typename ConcurrencyTag = Sequential_tag, typename Input, typename LabelMap,
          typename NamedParameters = parameters::Default_named_parameters>
Weakly_convex_segmentation::Result
weakly_convex_segmentation(const Input& input, LabelMap label_map,
                           const NamedParameters& np = parameters::default_values())
{
  return Weakly_convex_segmentation::internal::segment_input<ConcurrencyTag>(
      input, label_map, Weakly_convex_segmentation::internal::as_cgal(np));
}

/// \ingroup PkgWeaklyConvexSegmentationRef
/// is the same with `Weakly_convex_segmentation::Parameters` before the named parameters, which have
/// precedence where both give a value.
template <typename ConcurrencyTag = Sequential_tag, typename Input, typename LabelMap,
          typename NamedParameters = parameters::Default_named_parameters>
Weakly_convex_segmentation::Result
weakly_convex_segmentation(const Input& input, LabelMap label_map,
                           const Weakly_convex_segmentation::Parameters& parameters,
                           const NamedParameters& np = parameters::default_values())
{
  using namespace Weakly_convex_segmentation::internal;
  return segment_input<ConcurrencyTag>(input, label_map, with_parameters(parameters, as_cgal(np)));
}

/// \ingroup PkgWeaklyConvexSegmentationRef
/// segments a polygon soup: polygons of 3 or more corners, in any orientation, that need not form a
/// surface. Vertices at the same position count as one. For the run, polygons are turned to agree with
/// most of their piece, and closed pieces that are inside out are turned to the outside.
///
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result does not depend on it
/// \tparam PointRange a model of `ConstRange` of points, or of what the named parameter `point_map` maps to
///   points
/// \tparam PolygonRange a model of `ConstRange` of ranges of indices of points
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param points the corners of the polygons; points that none names are allowed,
///   but have to be finite, too
/// \param polygons indices from 0, at least 3 each; neither they nor the points are changed
/// \param np `segmentation_parameters`, `maximum_number_of_segments`, `minimum_number_of_segments`,
///   `minimum_segment_share`, `line_of_sight`, `patch_clustering`, `merge_cost`, `point_map`, `geom_traits`, `callback`, `visitor` and
///   `random_seed` of `weakly_convex_segmentation()`
///
/// \returns a result with one label a polygon, in the order of `polygons`
///
/// \throws std::invalid_argument as `weakly_convex_segmentation()`, and for polygons with fewer than
///   3 corners or with an index out of range
/// \throws Weakly_convex_segmentation::Canceled if the callback returns false
///
/// Complexity and thread safety are those of `weakly_convex_segmentation()`.
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename PolygonRange,
          typename NamedParameters = parameters::Default_named_parameters>
Weakly_convex_segmentation::Result
weakly_convex_segmentation_of_soup(const PointRange& points, const PolygonRange& polygons,
                                   const NamedParameters& np = parameters::default_values())
{
  return Weakly_convex_segmentation::Segmenter<ConcurrencyTag>(points, polygons, np).segment();
}

/// \ingroup PkgWeaklyConvexSegmentationRef
/// is the same with `Weakly_convex_segmentation::Parameters` before the named parameters, which have
/// precedence where both give a value.
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename PolygonRange,
          typename NamedParameters = parameters::Default_named_parameters>
Weakly_convex_segmentation::Result
weakly_convex_segmentation_of_soup(const PointRange& points, const PolygonRange& polygons,
                                   const Weakly_convex_segmentation::Parameters& parameters,
                                   const NamedParameters& np = parameters::default_values())
{
  return Weakly_convex_segmentation::Segmenter<ConcurrencyTag>(points, polygons, parameters, np)
      .segment();
}

} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_H
