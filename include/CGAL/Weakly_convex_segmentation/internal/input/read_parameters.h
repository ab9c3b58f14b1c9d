// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_READ_PARAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_READ_PARAMETERS_H

// What named parameters say besides where the coordinates are. They are of CGAL's class here, see as_cgal().

#include <CGAL/Weakly_convex_segmentation/Default_traits.h>
#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

template <typename NamedParameters>
auto traits_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits), Default_traits());
}

/// reads what a run has to do with its caller.
template <typename ConcurrencyTag, typename NamedParameters>
Run_control read_control(const NamedParameters& np)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  Run_control control;
  control.parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
  if constexpr (is_given<NamedParameters, CGAL::internal_np::callback_t>)
    control.callback = CGAL::parameters::get_parameter(np, CGAL::internal_np::callback);
  if constexpr (is_given<NamedParameters, CGAL::internal_np::visitor_t>)
    control.visitor = &CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor);
  return control;
}

/// \throws std::invalid_argument if a number of segments is negative
template <typename Number>
std::size_t number_of_segments(const char* name, const Number number)
{
  if (number < Number(0))
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(number) +
                                ", give a value from 0 on");
  return static_cast<std::size_t>(number);
}

/// reads the named parameters that are members of `Parameters`.
/// \throws std::invalid_argument if a number of segments is negative
template <typename NamedParameters>
Parameters read_parameters(const NamedParameters& np, const Parameters& defaults = {})
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Parameters result =
      choose_parameter(get_parameter(np, names::segmentation_parameters_t()), defaults);
  result.seed = static_cast<unsigned int>(
      choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), result.seed));
  result.minimum_segment_share = choose_parameter(
      get_parameter(np, names::minimum_segment_share_t()), result.minimum_segment_share);
  if constexpr (is_given<NamedParameters, names::maximum_number_of_segments_t>)
    result.maximum_number_of_segments = number_of_segments(
        "maximum_number_of_segments", get_parameter(np, names::maximum_number_of_segments_t()));
  if constexpr (is_given<NamedParameters, names::minimum_number_of_segments_t>)
    result.minimum_number_of_segments = number_of_segments(
        "minimum_number_of_segments", get_parameter(np, names::minimum_number_of_segments_t()));
  return result;
}

/// adds parameters that come before the named ones, which have precedence.
template <typename NamedParameters>
auto with_parameters(const Parameters& parameters, const NamedParameters& np)
{
  if constexpr (!Is_named_parameters<NamedParameters>::value)
    return parameters; // for the check to refuse
  else if constexpr (is_given<NamedParameters, names::segmentation_parameters_t>)
    return np;
  else
    return CGAL::Named_function_parameters<Parameters, names::segmentation_parameters_t,
                                           NamedParameters>(parameters, np);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_READ_PARAMETERS_H
