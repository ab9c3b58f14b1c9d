// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_READ_INPUT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_READ_INPUT_H

// Templates at the edge: the caller's containers are read through property maps into flat arrays once.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/polygons.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/shared_edges.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/soup_orientation.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

// declared only: who passes a point set has included its header
template <typename Point, typename Vector>
class Point_set_3;

namespace Weakly_convex_segmentation {
namespace internal {

/// Reads points and vectors through the traits.
template <typename Traits>
class Coordinate_reader
{
  Traits m_traits;

public:
  explicit Coordinate_reader(const Traits& traits) : m_traits(traits) {}
  template <typename Vector>
  Coordinates operator()(const Vector& v) const
  {
    return {CGAL::to_double(m_traits.compute_x_3_object()(v)),
            CGAL::to_double(m_traits.compute_y_3_object()(v)),
            CGAL::to_double(m_traits.compute_z_3_object()(v))};
  }
};

template <typename Range>
using Element_of = std::decay_t<decltype(*std::declval<const Range&>().begin())>;

/// returns the point map that was given or the identity.
template <typename Range, typename NamedParameters>
auto point_map_of(const Range&, const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map),
      CGAL::Identity_property_map<Element_of<Range>>());
}

/// returns the points of the vertices that were given or the mesh's own.
template <typename FaceGraph, typename NamedParameters>
auto vertex_points_of([[maybe_unused]] const FaceGraph& mesh,
                      [[maybe_unused]] const NamedParameters& np)
{
  // a mesh whose points are given need not have any
  if constexpr (is_given<NamedParameters, CGAL::internal_np::vertex_point_t>)
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point);
  else
    return get_const_property_map(CGAL::vertex_point, mesh);
}

/// brings positions of an unusual magnitude to about 1.
inline void scale_points(Raw_shape& raw, const bool parallel)
{
  raw.exponent = unusual_exponent(raw.positions, parallel);
  if (raw.exponent == 0) return;
  for (Coordinates& p : raw.positions) p = scaled(p, -raw.exponent);
}

/// reads a range of points. Without a normal map there are no normals.
template <typename PointRange, typename NamedParameters>
Raw_shape read_points(const PointRange& range, const NamedParameters& np,
                      const Run_control& control)
{
  const auto point_map = point_map_of(range, np);
  const Coordinate_reader coordinates(traits_of(np));
  Raw_shape raw;
  raw.positions =
      read_coordinates(range, control.parallel,
                       [&](const auto& element) { return coordinates(get(point_map, element)); });
  scale_points(raw, control.parallel);
  if constexpr (is_given<NamedParameters, CGAL::internal_np::normal_t>)
  {
    const auto normal_map = CGAL::parameters::get_parameter(np, CGAL::internal_np::normal_map);
    raw.normals = read_coordinates(range, control.parallel,
                                   [&](const auto& element)
                                   { return coordinates(get(normal_map, element)); });
  }
  return raw;
}

/// reads a `CGAL::Point_set_3`, with its normals if it has them.
template <typename PointSet, typename NamedParameters>
Raw_shape read_point_set(const PointSet& points, const NamedParameters& np,
                         const Run_control& control)
{
  const Coordinate_reader coordinates(traits_of(np));
  Raw_shape raw;
  raw.positions =
      read_coordinates(points, control.parallel,
                       [&](const auto& index) { return coordinates(points.point(index)); });
  scale_points(raw, control.parallel);
  if (points.has_normal_map())
  {
    raw.normals =
        read_coordinates(points, control.parallel,
                         [&](const auto& index) { return coordinates(points.normal(index)); });
  }
  return raw;
}

/// The place of each face of a mesh in the order of `faces()`, by its number in an index map.
template <typename FaceIndexMap>
class Face_places
{
  static constexpr Index none = static_cast<Index>(-1);
  FaceIndexMap m_numbers;
  std::vector<Index> m_places;

public:
  Face_places(const FaceIndexMap& numbers, const std::size_t number_of_faces)
    : m_numbers(numbers), m_places(number_of_faces, none)
  {}

  template <typename Face>
  void append(const Face& face, const std::size_t place)
  {
    const auto number = static_cast<std::size_t>(get(m_numbers, face));
    if (number >= m_places.size() || m_places[number] != none)
      throw std::invalid_argument("face_index_map gives face " + std::to_string(place) +
                                  " the number " + std::to_string(number) +
                                  ", but numbers have to differ and be less than that of faces");
    m_places[number] = static_cast<Index>(place);
  }

  template <typename Face>
  Index operator()(const Face& face) const
  {
    return m_places[static_cast<std::size_t>(get(m_numbers, face))];
  }
};

/// reads a mesh as one point a face (section 6): centroid, normal, and links between faces that
/// share an edge.
template <typename FaceGraph, typename NamedParameters>
Raw_shape read_mesh(const FaceGraph& mesh, const NamedParameters& np,
                    const Run_control& control = {})
{
  const Coordinate_reader coordinates(traits_of(np));
  const auto points = vertex_points_of(mesh, np);
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;
  Raw_shape raw;
  Face_places places(CGAL::get_initialized_face_index_map(mesh, np), num_faces(mesh));
  std::vector<Coordinates> corners;
  reserve_polygons(num_faces(mesh), raw);
  raw.links.reserve(3 * num_faces(mesh) / 2);
  for (const face_descriptor f : faces(mesh))
  {
    corners.clear();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(coordinates(get(points, v)));
    places.append(f, raw.positions.size());
    add_polygon(corners, raw);
    control.check_sometimes();
  }
  const face_descriptor none = boost::graph_traits<FaceGraph>::null_face();
  for (const auto e : edges(mesh))
  {
    const auto h = halfedge(e, mesh);
    const face_descriptor f = face(h, mesh), g = face(opposite(h, mesh), mesh);
    if (f != none && g != none) raw.links.push_back({places(f), places(g)});
    control.check_sometimes();
  }
  scale_polygons(raw);
  return raw;
}

/// returns for each soup vertex the first one at the same position: soups are welded by position.
inline std::vector<std::size_t> welded_vertices(const std::vector<Coordinates>& points,
                                                const bool parallel)
{
  std::vector<std::pair<Coordinates, std::size_t>> sorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) sorted[i] = {points[i], i};
  parallel_sort(sorted.begin(), sorted.end(), parallel, std::less<>());
  std::vector<std::size_t> welded(points.size());
  std::size_t first = 0; // of those at a position
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    if (sorted[i].first != sorted[first].first) first = i;
    welded[sorted[i].second] = sorted[first].second;
  }
  return welded;
}

/// links the polygons at each edge: if there are more than two, all with the one of lowest coordinates, so
/// that the links do not depend on the order of the polygons.
inline void link_across_edges(const std::vector<Polygon_side>& sides, Raw_shape& raw)
{
  raw.links.reserve(sides.size() / 2);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end)
  {
    Index lowest = sides[i].face;
    for (; end < sides.size() && sides[end].is_at_edge_of(sides[i]); ++end)
      if (raw.positions[sides[end].face] < raw.positions[lowest]) lowest = sides[end].face;
    for (std::size_t j = i; j < end; ++j)
      if (sides[j].face != lowest) raw.links.push_back({lowest, sides[j].face});
  }
}

/// checks the polygon of a number.
/// \throws std::invalid_argument if an index is out of range or it has under 3 corners.
template <typename Polygon>
void check_polygon(const std::size_t number, const Polygon& polygon,
                   const std::size_t number_of_points)
{
  std::size_t size = 0;
  for (const auto v : polygon)
  {
    ++size;
    const std::size_t i = static_cast<std::size_t>(v);
    if (i >= number_of_points)
      throw std::invalid_argument("polygon " + std::to_string(number) + " names point " +
                                  std::to_string(i) + ", but there are only " +
                                  std::to_string(number_of_points) + " points");
  }
  if (size < 3)
    throw std::invalid_argument("polygon " + std::to_string(number) + " has fewer than 3 corners");
}

/// reads a polygon soup as one point a polygon, with links between those that share an edge. The
/// normals are made consistent, see `orient_soup()`. Doubled polygons are marked, and have no links.
/// \throws std::invalid_argument if an index is out of range or a polygon has under 3 corners.
template <typename PointRange, typename PolygonRange, typename PointMap,
          typename Traits = Default_traits>
Raw_shape read_soup(const PointRange& points, const PolygonRange& polygons, const PointMap& map,
                    const Traits& traits = Traits(), const Run_control& control = {})
{
  control.progress(0.);
  const Coordinate_reader coordinates(traits);
  const std::vector<Coordinates> positions = read_coordinates(
      points, control.parallel, [&](const auto& p) { return coordinates(get(map, p)); });
  check_finite(positions, "position", control.parallel);
  const std::vector<std::size_t> welded = welded_vertices(positions, control.parallel);
  control.check();

  Raw_shape raw;
  std::vector<Coordinates> corners;
  std::vector<std::size_t> vertices, unwelded;
  const auto count = static_cast<std::size_t>(std::distance(polygons.begin(), polygons.end()));
  reserve_polygons(count, raw);
  vertices.reserve(3 * count);
  unwelded.reserve(3 * count);
  for (const auto& polygon : polygons)
  {
    const Index f = static_cast<Index>(raw.positions.size());
    corners.clear();
    check_polygon(f, polygon, positions.size());
    for (const auto v : polygon)
    {
      corners.push_back(positions[static_cast<std::size_t>(v)]);
      unwelded.push_back(static_cast<std::size_t>(v));
      vertices.push_back(welded[unwelded.back()]);
    }
    add_polygon(corners, raw);
    control.check_sometimes();
  }
  control.check();
  scale_polygons(raw);
  std::vector<Polygon_side> sides = sorted_sides(vertices, raw.first_corner);
  part_shared_edges(unwelded, raw, sides);
  control.check();
  raw.is_double = doubled_polygons(vertices, raw, sides);
  if (!raw.is_double.empty()) // what is left hangs together as if they were not there
  {
    sides.erase(std::remove_if(sides.begin(), sides.end(),
                               [&raw](const Polygon_side& side)
                               { return raw.is_double[side.face] != 0; }),
                sides.end());
    part_shared_edges(unwelded, raw, sides);
  }
  control.check();
  link_across_edges(sides, raw);
  orient_soup(sides, raw);
  return raw;
}

/// Ranges have begin(); triangle meshes have not.
template <typename Input, typename = void>
struct Is_range : std::false_type
{};
template <typename Input>
struct Is_range<Input, std::void_t<decltype(std::declval<const Input&>().begin())>> : std::true_type
{};
template <typename Input>
struct Is_point_set : std::false_type
{};
template <typename Point, typename Vector>
struct Is_point_set<CGAL::Point_set_3<Point, Vector>> : std::true_type
{};

/// reads any input but soups.
template <typename ConcurrencyTag, typename Input, typename NamedParameters>
Raw_shape read_input(const Input& input, const NamedParameters& np)
{
  const Run_control control = read_control<ConcurrencyTag>(np);
  control.progress(0.);
  if constexpr (Is_point_set<Input>::value)
    return read_point_set(input, np, control);
  else if constexpr (Is_range<Input>::value)
    return read_points(input, np, control);
  else
    return read_mesh(input, np, control);
}

/// returns the diameters that were given, in the order of the input; none if there are none.
template <typename Input, typename NamedParameters>
std::vector<double> read_diameters([[maybe_unused]] const Input& input,
                                   [[maybe_unused]] const NamedParameters& np)
{
  std::vector<double> diameters;
  if constexpr (is_given<NamedParameters, names::diameter_map_t>)
  {
    const auto map = CGAL::parameters::get_parameter(np, names::diameter_map_t());
    const auto add = [&](const auto& element)
    { diameters.push_back(CGAL::to_double(get(map, element))); };
    if constexpr (Is_range<Input>::value)
      for (const auto& element : input) add(element);
    else
      for (const auto f : faces(input)) add(f);
  }
  return diameters;
}

/// counts the elements of an input. Some meshes and ranges do not know their number.
template <typename Input>
std::size_t number_of_elements(const Input& input)
{
  std::size_t count = 0;
  if constexpr (Is_range<Input>::value)
    for ([[maybe_unused]] const auto& element : input) ++count;
  else
    for ([[maybe_unused]] const auto f : faces(input)) ++count;
  return count;
}

/// writes the labels back through the caller's map.
template <typename Input, typename LabelMap>
void write_labels(const Input& input, const std::vector<int>& labels, LabelMap& map)
{
  auto label = labels.begin();
  if constexpr (Is_range<Input>::value)
  {
    for (const auto& element : input) put(map, element, *label++);
  }
  else
  {
    for (const auto f : faces(input)) put(map, f, *label++);
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_READ_INPUT_H
