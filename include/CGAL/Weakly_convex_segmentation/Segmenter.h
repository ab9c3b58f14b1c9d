// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_SEGMENTER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_SEGMENTER_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/Result.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/check_call.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/oracle_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/oracles.h>
#include <CGAL/Weakly_convex_segmentation/named_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

struct Shape_analysis;

/// returns the caller's merge cost, an empty one if there is none.
template <typename NamedParameters>
Merge_cost read_merge_cost([[maybe_unused]] const NamedParameters& np)
{
  if constexpr (is_given<NamedParameters, names::merge_cost_t>)
    return Merge_cost(CGAL::parameters::get_parameter(np, names::merge_cost_t()));
  else
    return {};
}

/// `weakly_convex_segmentation()` with named parameters of CGAL's class.
template <typename ConcurrencyTag, typename Input, typename LabelMap, typename NamedParameters>
Result segment_input(const Input& input, LabelMap label_map, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgWeaklyConvexSegmentationRef
/// A shape with its patches and lines of sight, for more than one segmentation.
///
/// The constructor takes most of the time: it measures all that does not depend on thresholds. Then
/// `segment()` can be called with other thresholds; lines of sight that were cast once are kept.
/// The object does not refer to the input after construction, but to the visitor and to what the
/// callback refers to, which have to live as long. Different objects may be used from different threads at
/// once, one object by one thread at a time, also by its functions that are const. It can be moved, not
/// copied.
///
/// What does not depend on the types of the input is in member functions that are not inline. A program of
/// many sources compiles it once if all of them see
/// `extern template class CGAL::Weakly_convex_segmentation::Segmenter<CGAL::Sequential_tag>;` after this
/// header, and one has the same without `extern`. That holds for `weakly_convex_segmentation()` too.
///
/// \pre for all member functions: the object was not moved from.
///
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`
template <typename ConcurrencyTag = Sequential_tag>
class Segmenter
{
public:
  Segmenter(Segmenter&&) = default;
  Segmenter& operator=(Segmenter&&) = default;

  /// reads a range of points, a `CGAL::Point_set_3` or a mesh. Input, named parameters but `level`,
  /// exceptions and complexity are those of `weakly_convex_segmentation()`.
  template <typename Input, typename NamedParameters = parameters::Default_named_parameters>
  explicit Segmenter(const Input& input, const NamedParameters& np = parameters::default_values())
  {
    if constexpr (internal::Is_range<NamedParameters>::value)
      read_soup(input, np, parameters::default_values());
    else
      read(input, internal::as_cgal(np));
  }

  /// is the same with `Parameters` before the named parameters, which have precedence.
  template <typename Input, typename NamedParameters = parameters::Default_named_parameters>
  Segmenter(const Input& input, const Parameters& parameters,
            const NamedParameters& np = parameters::default_values())
  {
    read(input, internal::with_parameters(parameters, internal::as_cgal(np)));
  }

  /// reads a polygon soup. Input, named parameters, exceptions and complexity are those of
  /// `weakly_convex_segmentation_of_soup()`.
  template <typename PointRange, typename PolygonRange, typename NamedParameters>
  Segmenter(const PointRange& points, const PolygonRange& polygons, const NamedParameters& np)
  {
    read_soup(points, polygons, internal::as_cgal(np));
  }

  /// is the same with `Parameters` before the named parameters, which have precedence.
  template <typename PointRange, typename PolygonRange,
            typename NamedParameters = parameters::Default_named_parameters>
  Segmenter(const PointRange& points, const PolygonRange& polygons, const Parameters& parameters,
            const NamedParameters& np = parameters::default_values())
  {
    read_soup(points, polygons, internal::with_parameters(parameters, internal::as_cgal(np)));
  }

  /// segments with the given rules and thresholds. What the constructor has used (number of neighbors,
  /// representatives, patches and sets of patches, visibility, diameters, seed) stays as it was given there.
  /// \throws std::invalid_argument if a parameter is out of its range
  /// \throws Canceled if the callback returns false; the object stays usable
  ///
  /// Complexity: linear in the number of elements, besides what depends on the number of patches and the
  /// lines of sight that were not cast before.
  Result segment(const Parameters& parameters);

  /// is the same with the parameters of the constructor, but for what is named:
  /// `segmentation_parameters`, `maximum_number_of_segments`, `minimum_number_of_segments`, `minimum_segment_share` and
  /// `merge_cost`,
  /// which also holds for the segmentations to come.
  template <typename NamedParameters = parameters::Default_named_parameters>
  Result segment(const NamedParameters& np = parameters::default_values())
  {
    return segment_with(internal::as_cgal(np));
  }

  /// refines the borders of another cut through the merge tree of a result for this shape: the labels of its
  /// patches come from `Merge_tree::labels_for()` and the like. A label that would lose all of its elements keeps them.
  /// \param result what `segment()` returned; its tree and patches are those of the new result
  /// \param patch_labels one label a patch, in any order and with gaps; those of the result have none
  /// \param parameters those of border refinement count
  /// \throws std::invalid_argument if the result is not one for this shape, if there is not one label a patch,
  ///   from 0 to their number, or if a parameter is out of its range
  /// \throws Canceled if the callback returns false
  ///
  /// Complexity: linear in the number of elements, besides the minimum cuts in the bands.
  Result refine(const Result& result, const std::vector<int>& patch_labels,
                const Parameters& parameters);

  /// takes diameters of the shape that were measured elsewhere, such as by `mesh_diameters()`, for
  /// the segmentations to come.
  /// \param diameters one for each input element, in units of the input; at most 0 or not a number
  ///   where there is none
  /// \throws std::invalid_argument if there is not one an element
  ///
  /// They take the place of the diameters that the constructor measured; which parts of the shape face each
  /// other, on which the closure of the parts rests, stays as it was measured. A segmentation uses them with
  /// `Diameter_rule::GIVEN` and `WHOLE_SHAPE`; `OWN_POINTS` does not. The constructor need not measure
  /// diameters of its own with `GIVEN`.
  /// Complexity: linear in the number of elements.
  void set_diameters(const std::vector<double>& diameters);

  /// returns the number of patches of the first set, about `Parameters::number_of_patches`. Those of a result
  /// may be more, as they are cut where its segments end, or fewer, as small pieces join others.
  std::size_t number_of_patches() const;

  /// returns the convexity rank \f$ |LoS(S)| / |S|^2 \f$ (equation 1) of a subset of the input.
  /// \param subset indices of input elements, in input order
  /// \param sample_size at most so many elements, spread over the subset, are tested in pairs; at
  ///   least 1
  /// \param tolerance degrees by which a line of sight may leave the shape at its ends; 0 to 90
  /// \returns a value in `[0, 1]`; 1 for at most one element
  /// \throws std::invalid_argument if an index is not that of an element, or the sample or the tolerance is
  ///   out of its range
  ///
  /// Complexity: linear in the number of elements, and O(log n) for each of at most
  /// `sample_size`<sup>2</sup> / 2 lines of sight.
  double convexity_rank(const std::vector<std::size_t>& subset, std::size_t sample_size = 100,
                        double tolerance = 5.) const;

private:
  template <typename Tag, typename Input, typename LabelMap, typename NamedParameters>
  friend Result internal::segment_input(const Input&, LabelMap, const NamedParameters&);

  Segmenter() = default; // to be read into

  template <typename Input, typename NamedParameters>
  void read(const Input& input, const NamedParameters& np)
  {
    constexpr internal::Mistake mistake = internal::mistake_in_input<Input, NamedParameters>();
    internal::refuse<mistake, Input, NamedParameters>();
    if constexpr (mistake == internal::Mistake::NONE) read_checked(input, np);
  }

  /// reads what has no mistakes.
  template <typename Input, typename NamedParameters>
  void read_checked(const Input& input, const NamedParameters& np)
  {
    read_settings(np);
    const std::vector<double> diameters = internal::read_diameters(input, np);
    internal::Raw_shape raw = internal::read_input<ConcurrencyTag>(input, np);
    m_control.progress(0.);
    analyze(std::move(raw), internal::read_oracles(np), diameters);
  }

  template <typename NamedParameters>
  void read_settings(const NamedParameters& np)
  {
    m_control = internal::read_control<ConcurrencyTag>(np);
    m_parameters = internal::read_parameters(np);
    m_parameters.check();
    m_merge_cost = internal::read_merge_cost(np);
  }

  template <typename PointRange, typename PolygonRange, typename NamedParameters>
  void read_soup(const PointRange& points, const PolygonRange& polygons, const NamedParameters& np)
  {
    constexpr internal::Mistake mistake =
        internal::mistake_in_soup<PointRange, PolygonRange, NamedParameters>();
    internal::refuse<mistake, PointRange, PolygonRange, NamedParameters>();
    if constexpr (mistake == internal::Mistake::NONE)
    {
      read_settings(np);
      analyze(internal::read_soup(points, polygons, internal::point_map_of(points, np),
                                  internal::traits_of(np), m_control),
              internal::read_oracles(np), {});
    }
  }

  template <typename NamedParameters>
  Result segment_with(const NamedParameters& np)
  {
    constexpr internal::Mistake mistake = internal::mistake_in_thresholds<NamedParameters>();
    internal::refuse<mistake, NamedParameters>();
    if constexpr (mistake == internal::Mistake::NONE)
    {
      if constexpr (internal::is_given<NamedParameters, names::merge_cost_t>)
        m_merge_cost = internal::read_merge_cost(np);
      return segment(internal::read_parameters(np, m_parameters));
    }
    else
      return {};
  }

  /// measures what does not depend on thresholds; `diameters`: those that were given, if any.
  void analyze(internal::Raw_shape raw, internal::Oracles oracles,
               const std::vector<double>& diameters);

  Parameters m_parameters;
  internal::Merge_cost m_merge_cost; ///< of the caller, if there is one
  internal::Run_control m_control;
  std::shared_ptr<internal::Shape_analysis>
      m_shape; ///< not shared, but of a type that is not known here
};

namespace internal {

template <typename ConcurrencyTag, typename Input, typename LabelMap, typename NamedParameters>
Result segment_input(const Input& input, LabelMap label_map, const NamedParameters& np)
{
  constexpr Mistake mistake = mistake_in_call<Input, LabelMap, NamedParameters>();
  refuse<mistake, Input, LabelMap, NamedParameters>();
  if constexpr (mistake == Mistake::NONE)
  {
    Segmenter<ConcurrencyTag> segmenter;
    segmenter.read_checked(input, np);
    Result result = segmenter.segment(segmenter.m_parameters);
    if constexpr (is_given<NamedParameters, names::level_t>)
      write_labels(input, result.labels_at(CGAL::parameters::get_parameter(np, names::level_t())),
                   label_map);
    else
      write_labels(input, result.labels, label_map);
    return result;
  }
  else
    return {};
}

} // namespace internal

/// \ingroup PkgWeaklyConvexSegmentationRef
/// writes one label an element into a property map, such as what `Result::labels_for()` returns.
/// \param input a range of points, a `CGAL::Point_set_3` or a mesh, as in `weakly_convex_segmentation()`
/// \param labels of its elements, in the order of the input
/// \param label_map a model of `WritablePropertyMap` from the elements to `int`
/// \throws std::invalid_argument if there is not one label an element; then, nothing is written
/// Complexity: linear in the number of elements.
template <typename Input, typename LabelMap>
void write_labels(const Input& input, const std::vector<int>& labels, LabelMap label_map)
{
  const std::size_t elements = internal::number_of_elements(input);
  if (labels.size() != elements)
    throw std::invalid_argument("there are " + std::to_string(labels.size()) + " labels for " +
                                std::to_string(elements) + " elements");
  internal::write_labels(input, labels, label_map);
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#include <CGAL/Weakly_convex_segmentation/internal/Segmenter_impl.h>

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_SEGMENTER_H
