// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_NAMED_PARAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_NAMED_PARAMETERS_H

// CGAL's class of named parameters has a member for each of CGAL's names, and can't be given others from
// outside. So there is a class of our own, with our names and those of CGAL's that we read. Our names are
// listed in CGAL's way, so that the list can be added to CGAL's, and this class be removed, within CGAL.

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \cond SKIP_IN_MANUAL

// the tags of our names
namespace names {

struct Name
{};

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  struct X : Name                                                                                  \
  {};
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace names

/// \endcond

/// \ingroup PkgWeaklyConvexSegmentationRef
/// A sequence of named parameters that begins with a name of this package and goes on in any order, with names
/// of this package and those of %CGAL's that it reads:
/// `%CGAL::parameters::maximum_number_of_segments(4).random_seed(1)`.
///
/// A sequence that begins with a name of %CGAL's is of %CGAL's class, which has none of ours: where both are
/// given, begin with one of ours.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
class Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base>
{
  using Plain = CGAL::Named_function_parameters<T, Tag, Base>;

  // What goes before is kept as CGAL's class, so that CGAL's functions find their way in it.
  template <typename Next, typename V>
  Named_parameters<V, Next, Plain> with(const V& value) const
  {
    return Named_parameters<V, Next, Plain>(value, *this);
  }

public:
  using Plain::Plain;

  /// \cond SKIP_IN_MANUAL

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename V>                                                                            \
  auto Z(const V& value) const                                                                     \
  {                                                                                                \
    return this->template with<names::X>(value);                                                   \
  }
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parameters_interface.h>
#undef CGAL_add_named_parameter

  // clang-format off
  template <typename V> auto callback(const V& k) const { return with<CGAL::internal_np::callback_t>(k); }
  template <typename V> auto face_index_map(const V& k) const { return with<CGAL::internal_np::face_index_t>(k); }
  template <typename V> auto geom_traits(const V& k) const { return with<CGAL::internal_np::geom_traits_t>(k); }
  template <typename V> auto normal_map(const V& k) const { return with<CGAL::internal_np::normal_t>(k); }
  template <typename V> auto point_map(const V& k) const { return with<CGAL::internal_np::point_t>(k); }
  template <typename V> auto random_seed(const V& k) const { return with<CGAL::internal_np::random_seed_t>(k); }
  template <typename V> auto vertex_point_map(const V& k) const { return with<CGAL::internal_np::vertex_point_t>(k); }
  template <typename V> auto visitor(const V& k) const { return with<CGAL::internal_np::visitor_t>(k); }
  // clang-format on
  /// \endcond
};

namespace internal {

/// returns named parameters as CGAL's class: for one that is derived, compilers differ on which of its bases a
/// function template is given (CWG issue 2303). Anything else is returned as it is.
template <typename T, typename Tag, typename Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
as_cgal(const Named_parameters<T, Tag, Base>& np)
{
  return np;
}
template <typename NamedParameters>
const NamedParameters& as_cgal(const NamedParameters& np)
{
  return np;
}

/// whether it is CGAL's class
template <typename T>
struct Is_named_parameters : std::false_type
{};
template <typename T, typename Tag, typename Base>
struct Is_named_parameters<CGAL::Named_function_parameters<T, Tag, Base>> : std::true_type
{};

template <typename NamedParameters, typename Tag>
constexpr bool is_given = !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

} // namespace internal
} // namespace Weakly_convex_segmentation

/// \cond SKIP_IN_MANUAL
namespace parameters {

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename V>                                                                            \
  auto Z(const V& value)                                                                           \
  {                                                                                                \
    return Weakly_convex_segmentation::Named_parameters<V, Weakly_convex_segmentation::names::X>(  \
        value);                                                                                    \
  }
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace parameters
/// \endcond
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_NAMED_PARAMETERS_H
