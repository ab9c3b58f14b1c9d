// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_ply.h"

#include "io/ply_cursor.h"
#include "io/text_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

struct Ply_property
{
  std::string name;
  Ply_type type;
  bool is_list;
  Ply_type size_type; // of a list
};

struct Ply_element
{
  std::string name;
  std::size_t size;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
  std::size_t size = 0; // in bytes
};

Ply_format ply_format(const std::string& name)
{
  if (name == "ascii") return Ply_format::ASCII;
  if (name == "binary_little_endian") return Ply_format::LITTLE_ENDIAN_BINARY;
  if (name == "binary_big_endian") return Ply_format::BIG_ENDIAN_BINARY;
  throw std::runtime_error("its header has the unknown format '" + shown(name) +
                           "'; use ascii, binary_little_endian or binary_big_endian");
}

Ply_property ply_property(std::istream& words)
{
  std::string type, size_type, name;
  words >> type;
  const bool is_list = type == "list";
  if (is_list) words >> size_type >> type;
  if (!(words >> name))
    throw std::runtime_error("its header has a property without a name; export the shape again");
  return {name, ply_type(type), is_list, is_list ? ply_type(size_type) : Ply_type::UINT8};
}

// Takes one line of the header; returns whether more follow.
bool take_ply_header_line(const std::string& line, const std::size_t file_size, Ply_header& header)
{
  std::istringstream words(line);
  std::string keyword, name;
  words >> keyword;
  if (keyword == "format" && words >> name)
    header.format = ply_format(name);
  else if (keyword == "element")
  {
    long long size = -1;
    std::string more; // "1e3" is a 1 and more
    if (!(words >> name >> size) || words >> more || size < 0 ||
        static_cast<std::size_t>(size) > file_size)
      throw std::runtime_error("its header has a wrong number of elements in '" + shown(line, 40) +
                               "'; copy or export it again");
    header.elements.push_back({name, static_cast<std::size_t>(size), {}});
  }
  else if (keyword == "property" && !header.elements.empty())
    header.elements.back().properties.push_back(ply_property(words));
  else if (!(keyword.empty() || keyword == "ply" || keyword == "comment" || keyword == "obj_info" ||
             keyword == "end_header"))
    throw std::runtime_error("its header has the unknown line '" + shown(line, 40) +
                             "'; export the shape again");
  return keyword != "end_header";
}

Ply_header read_ply_header(const std::string& bytes)
{
  Ply_header header;
  if (bytes.compare(0, 3, "ply") != 0)
    throw std::runtime_error("it does not begin with 'ply'; give it the extension of its format");
  // lines end with a line feed, perhaps behind a carriage return, or with the latter alone, as the first one does
  const std::size_t first_end = bytes.find_first_of("\r\n");
  const bool has_returns = first_end != std::string::npos && first_end + 1 < bytes.size() &&
                           bytes[first_end] == '\r' && bytes[first_end + 1] != '\n';
  for (bool more = true; more;)
  {
    const std::size_t end = bytes.find(has_returns ? '\r' : '\n', header.size);
    if (end == std::string::npos)
      throw std::runtime_error("its header has no end; copy or export it again");
    std::string line = bytes.substr(header.size, end - header.size);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    header.size = end + 1;
    more = take_ply_header_line(line, bytes.size(), header);
  }
  return header;
}

bool is_polygon_list(const Ply_property& property)
{
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::vector<std::size_t> read_ply_polygon(Ply_cursor& cursor, const Ply_type type,
                                          const std::size_t size)
{
  std::vector<std::size_t> polygon(size);
  for (std::size_t& corner : polygon)
  {
    const double number = cursor.number(type);
    corner = corner_index(number);
  }
  return polygon;
}

// Reads an element into columns, one a property, and its polygons, if any.
std::vector<Property> read_ply_columns(Ply_cursor& cursor, const Ply_element& element,
                                       std::vector<std::vector<std::size_t>>& polygons)
{
  std::vector<Property> columns;
  for (const Ply_property& property : element.properties)
  {
    columns.push_back({property.name, ply_type_name(property.type), {}});
    if (!property.is_list) continue;
    columns.back().list_size_type = ply_type_name(property.size_type);
    columns.back().first = {0};
  }
  if (columns.empty()) return columns;

  for (std::size_t i = 0; i < element.size; ++i)
    for (std::size_t j = 0; j < columns.size(); ++j)
    {
      const Ply_property& property = element.properties[j];
      if (!property.is_list)
      {
        columns[j].values.push_back(cursor.number(property.type));
        continue;
      }
      const std::size_t size = cursor.list_size(property.size_type);
      if (is_polygon_list(property))
        polygons.push_back(read_ply_polygon(cursor, property.type, size));
      else
      {
        for (std::size_t k = 0; k < size; ++k)
          columns[j].values.push_back(cursor.number(property.type));
        columns[j].first.push_back(columns[j].values.size());
      }
    }

  std::vector<Property> result;
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (!is_polygon_list(element.properties[j])) result.push_back(std::move(columns[j]));
  return result;
}

// Whether the words of a line are the numbers of an element, neither more nor fewer.
bool is_ply_line(const std::vector<std::string_view>& words, const Ply_element& element)
{
  std::size_t next = 0;
  for (const Ply_property& property : element.properties)
  {
    double size = 1.;
    if (property.is_list && (next >= words.size() || !is_number(words[next++], size))) return false;
    if (!(size >= 0. && size <= static_cast<double>(words.size()))) return false;
    next += static_cast<std::size_t>(size);
  }
  return next == words.size();
}

// Texts have one element a line, but no reader relies on it: one number too many is found when all others have gone
// wrong. Tells which line is the first that does not hold its element, or, if none is, where the cursor was.
std::string ply_fault(const std::string& bytes, const Ply_header& header, const Ply_cursor& cursor,
                      const std::string& what)
{
  const auto number_of_lines = [&](const std::size_t end)
  {
    const auto last = bytes.begin() + static_cast<std::ptrdiff_t>(end);
    return static_cast<std::size_t>(
        (std::max)(std::count(bytes.begin(), last, '\r'), std::count(bytes.begin(), last, '\n')));
  };
  const std::size_t lines_of_header = number_of_lines(header.size);
  Text_lines lines(std::string_view(bytes).substr(header.size));
  for (const Ply_element& element : header.elements)
    for (std::size_t i = 0; i < element.size && !element.properties.empty() && lines.next(); ++i)
      if (!is_ply_line(lines.words(), element))
        return "line " + std::to_string(lines_of_header + lines.line_number()) + " has " +
               std::to_string(lines.words().size()) +
               " numbers, more or fewer than its header tells for '" + shown(element.name) +
               "'; check the file or export the shape again";
  const std::size_t position = bytes.size() - cursor.number_of_bytes_left();
  return "line " + std::to_string(number_of_lines(position) + 1) + ": " + what;
}

// Takes the named columns out of the others; returns false if one is missing.
bool take_columns(std::vector<Property>& columns, const std::array<const char*, 3>& names,
                  std::array<std::vector<double>, 3>& taken)
{
  std::array<std::vector<Property>::iterator, 3> found;
  for (std::size_t i = 0; i < 3; ++i)
  {
    found[i] = std::find_if(columns.begin(), columns.end(),
                            [&](const Property& p) { return p.name == names[i] && !p.is_list(); });
    if (found[i] == columns.end()) return false;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    taken[i] = std::move(found[i]->values);
    found[i]->name.clear();
  }
  columns.erase(std::remove_if(columns.begin(), columns.end(),
                               [](const Property& p) { return p.name.empty(); }),
                columns.end());
  return true;
}

} // namespace

void take_ply_points(std::vector<Property>&& columns, Shape& shape)
{
  std::array<std::vector<double>, 3> xyz;
  if (!take_columns(columns, {"x", "y", "z"}, xyz))
    throw std::runtime_error("its points lack x, y or z; export the shape again");
  for (std::size_t i = 0; i < xyz[0].size(); ++i)
    shape.points.emplace_back(xyz[0][i], xyz[1][i], xyz[2][i]);
  if (take_columns(columns, {"nx", "ny", "nz"}, xyz) ||
      take_columns(columns, {"normal_x", "normal_y", "normal_z"}, xyz))
    for (std::size_t i = 0; i < xyz[0].size(); ++i)
      shape.normals.emplace_back(xyz[0][i], xyz[1][i], xyz[2][i]);
  shape.point_properties = std::move(columns);
}

namespace {

void read_ply_elements(Ply_cursor& cursor, const Ply_header& header, Shape& shape)
{
  std::set<std::string> names;
  for (const Ply_element& element : header.elements)
  {
    if (!names.insert(element.name).second)
      throw std::runtime_error("it has the element '" + shown(element.name) +
                               "' twice; export the shape again");
    std::vector<std::vector<std::size_t>> polygons;
    std::vector<Property> columns = read_ply_columns(cursor, element, polygons);
    if (element.name == "camera") // as PCL writes it, with the size of the image
      for (const Property& column : columns)
        if (column.name == "viewporty")
          shape.is_organized = !column.values.empty() && column.values[0] > 1.;
    if (element.name == "vertex" || element.name == "vertices")
      take_ply_points(std::move(columns), shape);
    else if (element.name == "face" || element.name == "faces")
    {
      if (polygons.size() != element.size)
        throw std::runtime_error("its faces lack the list vertex_indices; export the shape again");
      shape.polygons = std::move(polygons);
      shape.face_properties = std::move(columns);
    }
    else if (element.name == "tristrips")
      throw std::runtime_error("it has triangle strips; export it with single triangles");
  }
  cursor.check_end();
}

} // namespace

void read_ply(const std::string& bytes, Shape& shape)
{
  const Ply_header header = read_ply_header(bytes);
  shape.is_of_parts = bytes.substr(0, header.size).find(comment_of_parts) != std::string::npos;
  Ply_cursor cursor(bytes, header.size, header.format);
  try
  {
    read_ply_elements(cursor, header, shape);
  }
  catch (const Ply_body_error& error)
  {
    if (header.format != Ply_format::ASCII) throw;
    throw std::runtime_error(ply_fault(bytes, header, cursor, error.what()));
  }
}

} // namespace internal
} // namespace Shape_io
