// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_CHECK_CALL_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_CHECK_CALL_H

// What is wrong with a call is found before anything else is compiled: one error that says so, in place of
// pages about the insides of the library.

#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What a compiler can see to be wrong with the arguments of a call. Each has its text in `refuse()`.
enum class Mistake
{
  NONE,
  NO_NAMED_PARAMETERS,
  NO_SHAPE,
  NO_POLYGONS,
  POINT_MAPS_OF_MESH,
  MESH_MAPS_OF_POINTS,
  MAPS_OF_POINT_SET,
  UNKNOWN_NAME,
  NO_POINTS,
  NO_NORMALS,
  NO_VERTEX_POINTS,
  NO_LABEL_MAP
};

/// stops the compilation with the text of a mistake, once for each kind of arguments.
template <Mistake mistake, typename... Arguments>
constexpr void refuse()
{
  static_assert(mistake != Mistake::NO_NAMED_PARAMETERS,
                "the last argument is neither Parameters nor named parameters");
  static_assert(mistake != Mistake::NO_SHAPE,
                "the input is neither a range of points nor a mesh (a model of FaceListGraph and "
                "EdgeListGraph, whose header for the BGL is included)");
  static_assert(mistake != Mistake::NO_POLYGONS,
                "the polygons are not a range of ranges of indices of points");
  static_assert(mistake != Mistake::POINT_MAPS_OF_MESH,
                "point_map and normal_map are for points: a mesh has a vertex_point_map");
  static_assert(mistake != Mistake::MESH_MAPS_OF_POINTS,
                "vertex_point_map and face_index_map are for meshes: points have a point_map and a "
                "normal_map");
  static_assert(mistake != Mistake::MAPS_OF_POINT_SET,
                "point_map and normal_map are not for a CGAL::Point_set_3, which has its own");
  static_assert(
      mistake != Mistake::UNKNOWN_NAME,
      "one of the named parameters is not read here, see the documentation of the function");
  static_assert(
      mistake != Mistake::NO_POINTS,
      "the elements of the range, or what point_map gives for them, are not points: give a "
      "point_map, and geom_traits for points without x(), y() and z()");
  static_assert(mistake != Mistake::NO_NORMALS,
                "normal_map does not give vectors for the elements of the range");
  static_assert(mistake != Mistake::NO_VERTEX_POINTS,
                "vertex_point_map does not give points for the vertices of the mesh");
  static_assert(
      mistake != Mistake::NO_LABEL_MAP,
      "the label map is not a WritablePropertyMap from the elements (faces of a mesh, indices "
      "of a CGAL::Point_set_3, values of a range) to int");
}

/// whether named parameters, as CGAL's class, are these names only
template <typename NamedParameters, typename... Names>
struct Has_only : std::true_type // the end of a sequence
{};
template <typename T, typename Tag, typename Base, typename... Names>
struct Has_only<CGAL::Named_function_parameters<T, Tag, Base>, Names...>
  : std::bool_constant<(std::is_same_v<Tag, CGAL::internal_np::all_default_t> ||
                        ((std::is_base_of_v<Names, Tag> || std::is_same_v<Names, Tag>) || ...)) &&
                       Has_only<Base, Names...>::value>
{};

/// Vertices or elements that a property map can be asked for; those of a map without a key type may be any.
template <typename Map, typename Key, typename = void>
struct Has_key : std::true_type
{};
template <typename Map, typename Key>
struct Has_key<Map, Key, std::void_t<typename boost::property_traits<Map>::key_type>>
  : std::disjunction<
        std::is_void<typename boost::property_traits<Map>::key_type>,
        std::is_convertible<const Key&, typename boost::property_traits<Map>::key_type>>
{};

/// whether coordinates can be read of what a map has for a key
template <typename Traits, typename Map, typename Key, typename = void>
struct Gives_coordinates : std::false_type
{};
template <typename Traits, typename Map, typename Key>
struct Gives_coordinates<
    Traits, Map, Key,
    std::void_t<decltype(CGAL::to_double(std::declval<const Traits&>().compute_z_3_object()(
        get(std::declval<const Map&>(), std::declval<const Key&>()))))>> : Has_key<Map, Key>
{};

/// What a map that names its types says of labels; one that does not is taken at its `put()`.
template <typename Map, typename = void>
struct Has_int_values : std::true_type
{};
template <typename Map>
struct Has_int_values<Map, std::void_t<typename boost::property_traits<Map>::category>>
  : std::conjunction<std::is_convertible<typename boost::property_traits<Map>::category,
                                         boost::writable_property_map_tag>,
                     std::is_convertible<int, typename boost::property_traits<Map>::value_type>>
{};

/// whether labels can be written for a key
template <typename Map, typename Key, typename = void>
struct Takes_labels : std::false_type
{};
template <typename Map, typename Key>
struct Takes_labels<Map, Key,
                    std::void_t<decltype(put(std::declval<Map&>(), std::declval<const Key&>(), 0))>>
  : std::conjunction<Has_key<Map, Key>, Has_int_values<Map>>
{};

template <typename Input, typename = void>
struct Is_mesh : std::false_type
{};
template <typename Input>
struct Is_mesh<Input, std::void_t<decltype(faces(std::declval<const Input&>())),
                                  decltype(edges(std::declval<const Input&>())),
                                  typename boost::graph_traits<Input>::face_descriptor>>
  : std::true_type
{};

/// What the key of a label map is.
template <typename Input, bool is_range = Is_range<Input>::value>
struct Key_of
{
  using type = Element_of<Input>;
};
template <typename Mesh>
struct Key_of<Mesh, false>
{
  using type = typename boost::graph_traits<Mesh>::face_descriptor;
};

template <typename NP, typename... Names>
constexpr bool has_any = (is_given<NP, Names> || ...);

/// whether the named parameters are those that are read for any input, or these
template <typename NP, typename... Names>
constexpr bool has_no_others =
    Has_only<NP, names::Name, CGAL::internal_np::callback_t, CGAL::internal_np::visitor_t,
             CGAL::internal_np::random_seed_t, CGAL::internal_np::geom_traits_t, Names...>::value;

template <typename Traits, typename Range, typename NP>
constexpr Mistake mistake_in_points()
{
  namespace np = CGAL::internal_np;
  using Element = Element_of<Range>;
  using Point_map = decltype(point_map_of(std::declval<const Range&>(), std::declval<const NP&>()));
  if constexpr (has_any<NP, np::vertex_point_t, np::face_index_t>)
    return Mistake::MESH_MAPS_OF_POINTS;
  else if constexpr (!has_no_others<NP, np::point_t, np::normal_t>)
    return Mistake::UNKNOWN_NAME;
  else if constexpr (!Gives_coordinates<Traits, Point_map, Element>::value)
    return Mistake::NO_POINTS;
  else if constexpr (is_given<NP, np::normal_t>)
  {
    using Normal_map =
        decltype(CGAL::parameters::get_parameter(std::declval<const NP&>(), np::normal_map));
    return Gives_coordinates<Traits, Normal_map, Element>::value ? Mistake::NONE
                                                                 : Mistake::NO_NORMALS;
  }
  else
    return Mistake::NONE;
}

template <typename NP>
constexpr Mistake mistake_in_point_set()
{
  namespace np = CGAL::internal_np;
  if constexpr (has_any<NP, np::point_t, np::normal_t>)
    return Mistake::MAPS_OF_POINT_SET;
  else if constexpr (has_any<NP, np::vertex_point_t, np::face_index_t>)
    return Mistake::MESH_MAPS_OF_POINTS;
  else
    return has_no_others<NP> ? Mistake::NONE : Mistake::UNKNOWN_NAME;
}

template <typename Traits, typename Mesh, typename NP>
constexpr Mistake mistake_in_mesh()
{
  namespace np = CGAL::internal_np;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Points = decltype(vertex_points_of(std::declval<const Mesh&>(), std::declval<const NP&>()));
  if constexpr (has_any<NP, np::point_t, np::normal_t>)
    return Mistake::POINT_MAPS_OF_MESH;
  else if constexpr (!has_no_others<NP, np::vertex_point_t, np::face_index_t>)
    return Mistake::UNKNOWN_NAME;
  else
    return Gives_coordinates<Traits, Points, Vertex>::value ? Mistake::NONE
                                                            : Mistake::NO_VERTEX_POINTS;
}

/// for a `Segmenter`, and with `level` for where there is a label map
template <typename Input, typename NP, bool has_level = false>
constexpr Mistake mistake_in_input()
{
  if constexpr (!Is_named_parameters<NP>::value)
    return Mistake::NO_NAMED_PARAMETERS;
  else
  {
    using Traits = decltype(traits_of(std::declval<const NP&>()));
    if constexpr (!has_level && is_given<NP, names::level_t>)
      return Mistake::UNKNOWN_NAME;
    else if constexpr (Is_point_set<Input>::value)
      return mistake_in_point_set<NP>();
    else if constexpr (Is_range<Input>::value)
      return mistake_in_points<Traits, Input, NP>();
    else if constexpr (Is_mesh<Input>::value)
      return mistake_in_mesh<Traits, Input, NP>();
    else
      return Mistake::NO_SHAPE;
  }
}

template <typename Input, typename LabelMap, typename NP>
constexpr Mistake mistake_in_call()
{
  constexpr Mistake mistake = mistake_in_input<Input, NP, true>();
  if constexpr (mistake != Mistake::NONE)
    return mistake;
  else
    return Takes_labels<LabelMap, typename Key_of<Input>::type>::value ? Mistake::NONE
                                                                       : Mistake::NO_LABEL_MAP;
}

template <typename Polygons, typename = void>
struct Is_range_of_polygons : std::false_type
{};
template <typename Polygons>
struct Is_range_of_polygons<Polygons, std::void_t<Element_of<Element_of<Polygons>>>>
  : std::is_convertible<Element_of<Element_of<Polygons>>, std::size_t>
{};

template <typename PointRange, typename PolygonRange, typename NP>
constexpr Mistake mistake_in_soup()
{
  if constexpr (!Is_range_of_polygons<PolygonRange>::value)
    return Mistake::NO_POLYGONS;
  else if constexpr (!Is_range<PointRange>::value)
    return Mistake::NO_POINTS;
  else if constexpr (!Is_named_parameters<NP>::value)
    return Mistake::NO_NAMED_PARAMETERS;
  else if constexpr (has_any<NP, CGAL::internal_np::normal_t, names::diameter_map_t>)
    return Mistake::UNKNOWN_NAME;
  else
    return mistake_in_input<PointRange, NP>();
}

/// for `Segmenter::segment()`
template <typename NP>
constexpr Mistake mistake_in_thresholds()
{
  if constexpr (!Is_named_parameters<NP>::value)
    return Mistake::NO_NAMED_PARAMETERS;
  else
    return Has_only<NP, names::segmentation_parameters_t, names::maximum_number_of_segments_t,
                    names::minimum_number_of_segments_t, names::minimum_segment_share_t,
                    names::merge_cost_t>::value
               ? Mistake::NONE
               : Mistake::UNKNOWN_NAME;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_CHECK_CALL_H
