// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/obj_attributes.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace Shape_io {
namespace internal {

double obj_number(const Text_lines& lines, const std::string_view word)
{
  double number = 0.;
  if (!is_number(word, number)) lines.refuse("has '" + shown(word) + "', which is not a number");
  return number;
}

std::size_t obj_index(const Text_lines& lines, const std::string_view corner,
                      const std::string_view digits, const std::size_t count)
{
  long long index = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (end.ec != std::errc() || end.ptr != digits.data() + digits.size())
    lines.refuse("has the corner '" + shown(corner) + "', which is no index");
  if (index < 0) index += static_cast<long long>(count) + 1;
  return static_cast<std::size_t>(index) - 1;
}

std::string obj_text(const Text_lines& lines)
{
  constexpr const char* blanks = " \t\v\f";
  const std::string_view line = lines.text();
  std::string text;
  if (line.find_first_of("\r\n") != std::string_view::npos) // it goes on in the next line
    for (std::size_t i = 1; i < lines.words().size(); ++i)
      text += ' ' + std::string(lines.words()[i]);
  else
    text = line.substr(line.find_first_not_of(blanks) + lines.words()[0].size());
  for (std::size_t i = text.find('#'); i != std::string::npos; i = text.find('#', i + 1))
    if (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t') &&
        (i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\t'))
    {
      text.erase(i);
      break;
    }
  text.erase(0, (std::min)(text.find_first_not_of(blanks), text.size()));
  // a backslash at the end would join it with the next line when it is written
  text.erase(text.find_last_not_of(" \t\v\f\\") + 1);
  return text;
}

void Obj_corner_values::add(const Text_lines& lines)
{
  for (std::size_t i = 1; i <= m_size; ++i)
    m_table.push_back(i < lines.words().size() ? obj_number(lines, lines.words()[i]) : 0.);
}

void Obj_corner_values::refer(const Text_lines& lines, const std::string_view corner,
                              const std::string_view digits, const std::size_t number_of_corner)
{
  m_indices.resize(number_of_corner, none);
  m_indices.push_back(obj_index(lines, corner, digits, count()));
  if (m_indices.back() < count() || (m_is_beyond && m_indices.back() <= m_farthest)) return;
  m_is_beyond = true; // unless the table goes on behind the face
  m_farthest = m_indices.back();
  m_line_of_farthest = lines.line_number();
}

void Obj_corner_values::give_to(Shape& shape) const
{
  if (m_is_beyond && m_farthest >= count())
    throw std::runtime_error("line " + std::to_string(m_line_of_farthest) +
                             " has a corner with an index of " + m_meaning +
                             " that is none of the " + std::to_string(count()) +
                             "; repair it or export the shape again");
  Property property = {m_name, "float", {}, "uchar", {0}};
  std::size_t corner = 0, number_of_torn = 0;
  const auto index = [&](const std::size_t i)
  { return i < m_indices.size() ? m_indices[i] : none; };
  for (const auto& polygon : shape.polygons)
  {
    std::size_t number = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) number += index(corner + i) != none ? 1 : 0;
    if (number == polygon.size())
      for (std::size_t i = 0; i < number; ++i)
        for (std::size_t k = 0; k < m_size; ++k)
          property.values.push_back(m_table[m_size * index(corner + i) + k]);
    else if (number > 0)
      ++number_of_torn;
    corner += polygon.size();
    if (m_size * number > 255) property.list_size_type = "int";
    property.first.push_back(property.values.size());
  }
  if (number_of_torn > 0)
    shape.notes.push_back(std::to_string(number_of_torn) + " faces have " + m_meaning +
                          " at some of their corners only; they are left out there");
  if (!property.values.empty())
    shape.face_properties.push_back(std::move(property));
  else if (count() > 0 && number_of_torn == 0 && shape.normals.empty())
    shape.notes.push_back("no face refers to the " + m_meaning + "; they are left out");
}

void Obj_names::set(const std::string& word, const std::size_t face)
{
  double number = -1.;
  if (!word.empty())
  {
    const auto [place, is_new] = m_numbers.emplace(word, m_words.size());
    if (is_new) m_words.push_back(word);
    number = static_cast<double>(place->second);
  }
  m_changes.emplace_back(face, number);
}

void Obj_names::give_to(Shape& shape) const
{
  if (m_words.empty() || !shape.is_mesh()) return;
  Property property = {m_name, "int", std::vector<double>(shape.polygons.size(), -1.)};
  for (std::size_t i = 0; i < m_changes.size(); ++i)
  {
    const std::size_t end =
        i + 1 < m_changes.size() ? m_changes[i + 1].first : shape.polygons.size();
    for (std::size_t face = m_changes[i].first; face < end; ++face)
      property.values[face] = m_changes[i].second;
  }
  shape.face_properties.push_back(std::move(property));
  shape.face_words.push_back({m_name, m_words});
}

void Obj_point_colors::add(const Text_lines& lines)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  const auto& words = lines.words(); // v x y z, perhaps w, perhaps r g b
  const std::size_t number = words.size() - 4;
  if (number == 3 || number == 4)
  {
    m_colors.resize(3 * m_number_of_points, missing);
    for (std::size_t i = words.size() - 3; i < words.size(); ++i)
      m_colors.push_back(obj_number(lines, words[i]));
  }
  if ((number == 1 || number == 4) ? obj_number(lines, words[4]) != 1. : number == 2 || number > 4)
    ++m_number_of_others;
  ++m_number_of_points;
}

void Obj_point_colors::give_to(Shape& shape) const
{
  if (m_number_of_others > 0)
    shape.notes.push_back(std::to_string(m_number_of_others) +
                          " points have more numbers (w), which are left out");
  if (m_colors.empty()) return;
  const char* const names[] = {"red", "green", "blue"};
  for (std::size_t k = 0; k < 3; ++k)
  {
    Property property = {
        names[k], "float",
        std::vector<double>(shape.points.size(), std::numeric_limits<double>::quiet_NaN())};
    for (std::size_t i = 0; 3 * i < m_colors.size(); ++i) property.values[i] = m_colors[3 * i + k];
    shape.point_properties.push_back(std::move(property));
  }
}

void Obj_leftovers::give_to(Shape& shape) const
{
  constexpr std::size_t most = 5;
  std::string list;
  std::size_t number = 0;
  for (const auto& [keyword, count] : m_counts)
    if ((shape.is_mesh() || keyword != "p") && ++number <= most) // points of a cloud are points
      list += (list.empty() ? "" : ", ") + shown(keyword) + " (" + std::to_string(count) + ")";
  if (!list.empty())
    shape.notes.push_back("lines that are left out: " + list + (number > most ? " and more" : ""));
}

} // namespace internal
} // namespace Shape_io
