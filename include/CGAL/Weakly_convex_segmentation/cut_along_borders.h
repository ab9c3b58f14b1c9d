// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_CUT_ALONG_BORDERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_CUT_ALONG_BORDERS_H

// A mesh whose faces are split where the borders of its segments run smoothly, for what needs a clean cut.

#include <CGAL/Weakly_convex_segmentation/internal/borders/split_faces.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// A mesh that was cut along the borders of its segments, as a soup of polygons: for
/// `CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh()`, or to be cut into parts by `labels`.
///
/// \tparam Point the type of points
template <typename Point>
struct Cut_mesh
{
  /// How a new point is made of points of the input.
  struct Origin
  {
    std::array<std::size_t, 3>
        points; ///< corners of one face; where a point is on an edge, the last two are the same
    std::array<double, 3> weights; ///< in `[0, 1]`, of sum 1
  };
  std::vector<Point>
      points; ///< those of the input, in their order and as they were; then the new ones
  std::vector<Origin>
      origins; ///< of each new point: of number `points.size() - origins.size()` and on
  std::vector<std::vector<std::size_t>>
      polygons;            ///< indices of points; pieces of split faces are triangles
  std::vector<int> labels; ///< of each polygon
  std::vector<std::size_t>
      source_faces; ///< the face of the input that each polygon is or is a piece of, ascending
};

namespace internal {

/// returns triangles of a polygon that is about flat.
inline std::vector<std::array<Index, 3>> triangles_of(const std::vector<Double3>& corners)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  for (const Double3& corner : corners) mesh.add_vertex(Point(corner.x, corner.y, corner.z));
  std::vector<std::array<Index, 3>> result;
  const auto face = mesh.add_face(mesh.vertices());
  if (face != mesh.null_face() && CGAL::Polygon_mesh_processing::triangulate_face(face, mesh))
    for (const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      result.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
    }
  else // it has a corner twice, or no area
    for (Index i = 2; i < corners.size(); ++i) result.push_back({0, i - 1, i});
  return result;
}

/// cuts a mesh of points of any type, of which the coordinates are known.
template <typename Point>
Cut_mesh<Point> cut_polygons(const std::vector<Point>& points,
                             const std::vector<Coordinates>& coordinates,
                             const Compressed_rows<Index>& polygons, const std::vector<int>& labels)
{
  check_finite(coordinates, "position");
  const int exponent = unusual_exponent(coordinates);
  std::vector<Double3> scaled_points;
  for (const Coordinates& c : coordinates)
  {
    const Coordinates p = scaled(c, -exponent);
    scaled_points.push_back({p[0], p[1], p[2]});
  }
  Split_faces split = split_faces(scaled_points, polygons, labels, &triangles_of);
  Cut_mesh<Point> result;
  result.points = points;
  for (const Split_point& split_point : split.points)
  {
    Coordinates sum = {0., 0., 0.};
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c)
        sum[c] += split_point.weights[i] * coordinates[split_point.corners[i]][c];
    result.points.push_back(Point{sum[0], sum[1], sum[2]});
    const auto [a, b, c] = split_point.corners;
    result.origins.push_back({{a, b, c}, split_point.weights});
  }
  for (std::size_t i = 0; i < split.polygons.size(); ++i)
    result.polygons.emplace_back(split.polygons[i].begin(), split.polygons[i].end());
  result.labels = std::move(split.labels);
  result.source_faces.assign(split.sources.begin(), split.sources.end());
  return result;
}

} // namespace internal

/// \ingroup PkgWeaklyConvexSegmentationRef
/// cuts a mesh along the borders of labels of its faces: faces are split where the borders run smoothly, which edges do
/// not allow. Borders in creases, and those of parts that are too small to lose anything, stay where they are. It takes
/// a header of its own as few need it.
///
/// New points lie on edges, at a tenth of the length from an end or more, or, where three labels meet, inside of a face.
/// What was closed or manifold still is, also across corners at one position. Faces keep their orientation.
///
/// \tparam FaceGraph a model of `FaceListGraph`, of any polygons
/// \tparam LabelMap a model of `ReadablePropertyMap` with the face descriptor as key type, value type an integer
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh the mesh; it is not changed
/// \param label_map the label of each face, such as `weakly_convex_segmentation()` writes them; any numbers
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map from the vertices of the mesh to points, which can be made of three `double`}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{gives the coordinates of points}
///     \cgalParamType{a model of `WeaklyConvexSegmentationTraits`, as every kernel is}
///     \cgalParamDefault{`Weakly_convex_segmentation::Default_traits`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns a soup whose points begin with those of `vertices(mesh)`, and whose faces come in the order of `faces(mesh)`
/// \throws std::invalid_argument if a coordinate is not finite
///
/// Complexity: O(n log n) for n vertices and faces; a few times as much where small parts have to keep their borders.
template <typename FaceGraph, typename LabelMap,
          typename NamedParameters = parameters::Default_named_parameters>
auto cut_along_borders(const FaceGraph& mesh, const LabelMap& label_map,
                       const NamedParameters& np = parameters::default_values())
{
  const auto point_map = internal::vertex_points_of(mesh, np);
  const internal::Coordinate_reader coordinates_of(internal::traits_of(np));
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  std::vector<Point> points;
  std::vector<internal::Coordinates> coordinates;
  std::map<Vertex, internal::Index> numbers;
  for (const Vertex v : vertices(mesh))
  {
    numbers.emplace(v, static_cast<internal::Index>(points.size()));
    points.push_back(get(point_map, v));
    coordinates.push_back(coordinates_of(points.back()));
  }
  internal::Compressed_rows<internal::Index> polygons;
  std::vector<int> labels;
  for (const auto f : faces(mesh))
  {
    for (const Vertex v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      polygons.entries.push_back(numbers.at(v));
    polygons.end_row();
    labels.push_back(static_cast<int>(get(label_map, f)));
  }
  return internal::cut_polygons(points, coordinates, polygons, labels);
}

/// \ingroup PkgWeaklyConvexSegmentationRef
/// is the same for a polygon soup, as `weakly_convex_segmentation_of_soup()` takes it: corners at the same position are
/// cut alike, and stay apart.
///
/// \tparam PointRange a model of `ConstRange` of points, or of what the named parameter `point_map` maps to points,
///   which can be made of three `double`
/// \tparam PolygonRange a model of `ConstRange` of ranges of indices of points
/// \tparam LabelRange a model of `ConstRange` of integers
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param points the corners of the polygons
/// \param polygons indices from 0, at least 3 each
/// \param labels one a polygon, such as `Result::labels`; any numbers
/// \param np `point_map` and `geom_traits` of `weakly_convex_segmentation()`
///
/// \throws std::invalid_argument if a coordinate is not finite, a polygon has fewer than 3 corners or an index out of
///   range, or there is not one label a polygon
template <typename PointRange, typename PolygonRange, typename LabelRange,
          typename NamedParameters = parameters::Default_named_parameters>
auto cut_soup_along_borders(const PointRange& points, const PolygonRange& polygons,
                            const LabelRange& labels,
                            const NamedParameters& np = parameters::default_values())
{
  const auto point_map = internal::point_map_of(points, np);
  const internal::Coordinate_reader coordinates_of(internal::traits_of(np));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  std::vector<Point> corners;
  std::vector<internal::Coordinates> coordinates;
  for (const auto& p : points)
  {
    corners.push_back(get(point_map, p));
    coordinates.push_back(coordinates_of(corners.back()));
  }
  internal::Compressed_rows<internal::Index> rows;
  for (const auto& polygon : polygons)
  {
    internal::check_polygon(rows.size(), polygon, corners.size());
    for (const auto v : polygon) rows.entries.push_back(static_cast<internal::Index>(v));
    rows.end_row();
  }
  const std::vector<int> own(std::begin(labels), std::end(labels));
  if (own.size() != rows.size())
    throw std::invalid_argument("there are " + std::to_string(own.size()) + " labels for " +
                                std::to_string(rows.size()) +
                                " polygons; give one label a polygon");
  return internal::cut_polygons(corners, coordinates, rows, own);
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_CUT_ALONG_BORDERS_H
