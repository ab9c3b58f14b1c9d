// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/separate_parts.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_io {

std::vector<std::vector<std::size_t>> elements_of_parts(const std::vector<int>& labels,
                                                        const std::size_t number_of_parts)
{
  std::vector<std::vector<std::size_t>> elements(number_of_parts);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] >= 0) elements[static_cast<std::size_t>(labels[i])].push_back(i);
  return elements;
}

namespace {

std::vector<Property> chosen_values(const std::vector<Property>& properties,
                                    const std::vector<std::size_t>& chosen)
{
  std::vector<Property> result;
  for (const Property& property : properties)
  {
    result.push_back({property.name, property.type, {}, property.list_size_type});
    Property& own = result.back();
    if (property.is_list()) own.first = {0};
    for (const std::size_t i : chosen)
    {
      const std::size_t first = property.is_list() ? property.first[i] : i;
      const std::size_t last = property.is_list() ? property.first[i + 1] : i + 1;
      for (std::size_t k = first; k < last; ++k) own.values.push_back(property.values[k]);
      if (property.is_list()) own.first.push_back(own.values.size());
    }
  }
  return result;
}

} // namespace

Shape shape_of_elements(const Shape& shape, const std::vector<std::size_t>& elements)
{
  Shape part;
  std::vector<std::size_t> points;
  if (shape.is_mesh())
  {
    constexpr std::size_t unused = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> new_index(shape.points.size(), unused);
    for (const std::size_t f : elements)
      for (const std::size_t corner : shape.polygons[f]) new_index[corner] = 0;
    for (std::size_t i = 0; i < new_index.size(); ++i)
      if (new_index[i] != unused)
      {
        new_index[i] = points.size();
        points.push_back(i);
      }
    for (const std::size_t f : elements)
    {
      part.polygons.push_back(shape.polygons[f]);
      for (std::size_t& corner : part.polygons.back()) corner = new_index[corner];
    }
    part.face_properties = chosen_values(shape.face_properties, elements);
  }
  else
    points = elements;
  for (const std::size_t i : points)
  {
    part.points.push_back(shape.points[i]);
    if (!shape.normals.empty()) part.normals.push_back(shape.normals[i]);
  }
  part.point_properties = chosen_values(shape.point_properties, points);
  part.face_words = shape.face_words;
  part.material_files = shape.material_files;
  part.is_textured_obj = shape.is_textured_obj;
  part.is_of_parts = shape.is_of_parts;
  return part;
}

} // namespace Shape_io
