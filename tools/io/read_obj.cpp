// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_obj.h"

#include "io/obj_attributes.h"
#include "io/text_lines.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

bool is_obj_keyword(const std::string_view word)
{
  return std::all_of(word.begin(), word.end(),
                     [](const unsigned char c) { return std::isalnum(c) || c == '_'; });
}

// Takes line by line.
class Obj_lines
{
public:
  Obj_lines(const std::string& bytes, Shape& shape)
    : m_shape(shape), m_is_of_parts(bytes.find(comment_of_parts) == 2)
  {}

  void take(const Text_lines& lines)
  {
    const std::string_view keyword = lines.words()[0];
    const std::size_t face = m_shape.polygons.size();
    if (keyword == "v")
      take_point(lines);
    else if (keyword == "vt")
      m_texture_coordinates.add(lines);
    else if (keyword == "vn")
      take_normal(lines);
    else if (keyword == "f")
      take_face(lines);
    else if (keyword == "usemtl")
      m_materials.set(obj_text(lines), face);
    else if (keyword == "o")
      m_objects.set(obj_text(lines), face);
    else if (keyword == "g")
      m_groups.set(without_our_part(obj_text(lines)), face);
    else if (keyword == "s")
      take_smoothing(obj_text(lines), face);
    else if (keyword == "mtllib")
      take_material_file(obj_text(lines));
    else if (is_obj_keyword(keyword))
      m_leftovers.add(keyword);
    else
      lines.refuse("is none of an OBJ file");
  }

  void finish()
  {
    // Normals belong to the corners of faces; without faces, one for each point can only be its own.
    const std::vector<double>& n = m_normals.table();
    if (!m_shape.is_mesh() && m_normals.count() == m_shape.points.size())
      for (std::size_t i = 0; i < n.size(); i += 3)
        m_shape.normals.emplace_back(n[i], n[i + 1], n[i + 2]);
    m_colors.give_to(m_shape);
    m_texture_coordinates.give_to(m_shape);
    m_shape.is_textured_obj = !m_shape.face_properties.empty() || !m_shape.material_files.empty();
    m_normals.give_to(m_shape);
    m_materials.give_to(m_shape);
    m_shape.is_textured_obj = m_shape.is_textured_obj || !m_shape.face_words.empty();
    for (const Obj_names* names : {&m_objects, &m_groups, &m_smoothing}) names->give_to(m_shape);
    m_leftovers.give_to(m_shape);
  }

private:
  void take_point(const Text_lines& lines)
  {
    const auto& words = lines.words();
    if (words.size() < 4) lines.refuse("has fewer than 3 coordinates");
    m_shape.points.emplace_back(obj_number(lines, words[1]), obj_number(lines, words[2]),
                                obj_number(lines, words[3]));
    m_colors.add(lines);
  }

  void take_normal(const Text_lines& lines)
  {
    if (lines.words().size() < 4) lines.refuse("has fewer than 3 coordinates");
    m_normals.add(lines);
  }

  // Corners are `a`, `a/b`, `a//c` or `a/b/c`: indices of a point, of texture coordinates and of a normal.
  void take_face(const Text_lines& lines)
  {
    const auto& words = lines.words();
    m_shape.polygons.emplace_back();
    for (std::size_t i = 1; i < words.size(); ++i, ++m_number_of_corners)
    {
      const std::string_view word = words[i];
      const std::size_t first = (std::min)(word.find('/'), word.size());
      m_shape.polygons.back().push_back(
          obj_index(lines, word, word.substr(0, first), m_shape.points.size()));
      if (first == word.size()) continue;
      const std::size_t second = (std::min)(word.find('/', first + 1), word.size());
      const std::string_view texture = word.substr(first + 1, second - first - 1);
      const std::string_view normal = word.substr((std::min)(second + 1, word.size()));
      if (!texture.empty()) m_texture_coordinates.refer(lines, word, texture, m_number_of_corners);
      if (!normal.empty()) m_normals.refer(lines, word, normal, m_number_of_corners);
    }
  }

  void take_smoothing(const std::string& group, const std::size_t face)
  {
    m_smoothing.set(group == "off" || group == "0" ? "" : group, face);
  }

  void take_material_file(const std::string& name)
  {
    auto& files = m_shape.material_files;
    if (!name.empty() && std::find(files.begin(), files.end(), name) == files.end())
      files.push_back(name);
  }

  // The name of our group comes first; it is that of an earlier run.
  std::string without_our_part(const std::string& names) const
  {
    if (!m_is_of_parts || names.compare(0, 5, "part_") != 0) return names;
    return names.substr((std::min)(names.find(' '), names.size() - 1) + 1);
  }

  Shape& m_shape;
  bool m_is_of_parts;
  std::size_t m_number_of_corners = 0;
  Obj_point_colors m_colors;
  Obj_corner_values m_texture_coordinates{name_of_texture_coordinates, "texture coordinates", 2};
  Obj_corner_values m_normals{name_of_corner_normals, "normals", 3};
  Obj_names m_materials{"material"}, m_objects{"object"}, m_groups{"group"},
      m_smoothing{"smoothing"};
  Obj_leftovers m_leftovers;
};

} // namespace

void read_obj(const std::string& bytes, Shape& shape)
{
  Text_lines lines(bytes);
  Obj_lines obj(bytes, shape);
  while (lines.next()) obj.take(lines);
  if (shape.points.empty())
    throw std::runtime_error("it is no OBJ file with points; export it again");
  obj.finish();
}

} // namespace internal
} // namespace Shape_io
