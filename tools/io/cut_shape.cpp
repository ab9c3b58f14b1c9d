// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/cut_shape.h"

#include "io/ply_cursor.h"

#include <CGAL/Weakly_convex_segmentation/cut_along_borders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Shape_io {

namespace {

using Cut_mesh = CGAL::Weakly_convex_segmentation::Cut_mesh<Point>;
using Origin = Cut_mesh::Origin;

bool is_real(const Property& property)
{
  return property.type == "float" || property.type == "double" || property.type == "float32" ||
         property.type == "float64";
}

// The value at a new point, from those at the points that it is made of; of integers, that of the nearest.
template <typename Value_at>
double value_at(const Origin& origin, const bool is_real, const Value_at& at)
{
  if (!is_real)
  {
    const auto most = std::max_element(origin.weights.begin(), origin.weights.end());
    return at(origin.points[static_cast<std::size_t>(most - origin.weights.begin())]);
  }
  double sum = 0.;
  for (std::size_t i = 0; i < 3; ++i)
    if (origin.weights[i] > 0.) sum += origin.weights[i] * at(origin.points[i]);
  return sum;
}

void add_values_at(const std::vector<Origin>& origins, Property& property)
{
  for (const Origin& origin : origins)
  {
    if (!property.is_list())
    {
      property.values.push_back(value_at(origin, is_real(property),
                                         [&](const std::size_t p) { return property.values[p]; }));
      continue;
    }
    // lists may differ in length
    const auto p = static_cast<std::size_t>(
        value_at(origin, false, [](const std::size_t i) { return static_cast<double>(i); }));
    for (std::size_t k = property.first[p], end = property.first[p + 1]; k < end; ++k)
      property.values.push_back(property.values[k]);
    property.first.push_back(property.values.size());
  }
}

Vector normal_at(const Origin& origin, const std::vector<Vector>& normals)
{
  Vector sum = CGAL::NULL_VECTOR;
  double length = 0.;
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum = sum + origin.weights[i] * normals[origin.points[i]];
    length += origin.weights[i] * std::sqrt(normals[origin.points[i]].squared_length());
  }
  const double own = std::sqrt(sum.squared_length());
  return own > 0. ? (length / own) * sum : sum;
}

// The values of a list that has as many for each corner of its face, at a corner of a piece of that face.
void add_values_of_corner(const Shape& shape, const Cut_mesh& cut, const std::size_t face,
                          const std::size_t corner, const Property& property,
                          std::vector<double>& values)
{
  const std::vector<std::size_t>& polygon = shape.polygons[face];
  const std::size_t first = property.first[face];
  const std::size_t step = (property.first[face + 1] - first) / polygon.size();
  const Origin origin = corner < shape.points.size()
                            ? Origin{{corner, corner, corner}, {1., 0., 0.}}
                            : cut.origins[corner - shape.points.size()];
  for (std::size_t k = 0; k < step; ++k)
    values.push_back(value_at(origin, is_real(property),
                              [&](const std::size_t p)
                              {
                                const auto at = std::find(polygon.begin(), polygon.end(), p);
                                const auto i = static_cast<std::size_t>(at - polygon.begin());
                                return property.values[first + i * step + k];
                              }));
}

Property property_of_pieces(const Shape& shape, const Cut_mesh& cut, const Property& property)
{
  Property result = {property.name, property.type, {}, property.list_size_type};
  if (property.is_list()) result.first = {0};
  for (std::size_t i = 0; i < cut.polygons.size(); ++i)
  {
    const std::size_t face = cut.source_faces[i];
    if (!property.is_list())
    {
      result.values.push_back(property.values[face]);
      continue;
    }
    const std::size_t first = property.first[face], last = property.first[face + 1];
    if (cut.polygons[i] != shape.polygons[face] &&
        (last - first) % shape.polygons[face].size() == 0)
      for (const std::size_t corner : cut.polygons[i])
        add_values_of_corner(shape, cut, face, corner, property, result.values);
    else
      for (std::size_t k = first; k < last; ++k) result.values.push_back(property.values[k]);
    result.first.push_back(result.values.size());
  }
  return result;
}

std::vector<Property> properties_of_pieces(const Shape& shape, const Cut_mesh& cut)
{
  const std::string name = "source_face";
  std::vector<Property> result(1);
  result[0] = {name, "int", {cut.source_faces.begin(), cut.source_faces.end()}};
  for (const Property& property : shape.face_properties)
  {
    result.push_back(property_of_pieces(shape, cut, property));
    if (property.name == name) result.back().name = "input_" + name;
  }
  return result;
}

} // namespace

void check_can_be_cut(const Shape& shape)
{
  if (!shape.is_mesh())
    throw std::invalid_argument("a cloud of points has no faces that could be cut; give a mesh, or "
                                "leave out --cut");
}

Cut_shape cut_shape(const Shape& shape, const Parts& parts)
{
  const Cut_mesh cut = CGAL::Weakly_convex_segmentation::cut_soup_along_borders(
      shape.points, shape.polygons, parts.labels);
  Cut_shape result;
  result.source_faces = cut.source_faces;
  result.shape.points = cut.points;
  result.shape.polygons = cut.polygons;
  result.shape.normals = shape.normals;
  if (!shape.normals.empty())
    for (const Origin& origin : cut.origins)
      result.shape.normals.push_back(normal_at(origin, shape.normals));
  result.shape.point_properties = shape.point_properties;
  for (Property& property : result.shape.point_properties) add_values_at(cut.origins, property);
  result.shape.face_properties = properties_of_pieces(shape, cut);
  result.shape.face_words = shape.face_words;
  result.shape.material_files = shape.material_files;
  result.shape.is_textured_obj = shape.is_textured_obj;
  result.parts.labels = cut.labels;
  for (const std::size_t face : cut.source_faces)
    result.parts.quality.push_back(parts.quality[face]);
  result.parts.colors = parts.colors;
  return result;
}

} // namespace Shape_io
