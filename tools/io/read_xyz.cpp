// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_xyz.h"

#include "io/text_lines.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

struct Number_table
{
  std::vector<std::string> names; // empty, or one a column
  std::vector<std::vector<double>> columns;
};

bool take_row(const Text_lines& lines, Number_table& table)
{
  const auto& words = lines.words();
  double number;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!is_number(words[i], number)) return false;
  constexpr std::size_t most_columns = 10000;
  if (words.size() > most_columns)
    lines.refuse("has more than " + std::to_string(most_columns) + " numbers");
  if (table.columns.empty()) table.columns.resize(words.size());
  if (words.size() != table.columns.size())
    lines.refuse("has " + std::to_string(words.size()) + " numbers, but those before have " +
                 std::to_string(table.columns.size()));
  for (std::size_t i = 0; i < words.size(); ++i) table.columns[i].push_back(number_of(words[i]));
  return true;
}

} // namespace

bool is_name(const std::string_view word)
{
  double number;
  return !is_number(word, number) &&
         std::all_of(word.begin(), word.end(),
                     [](const unsigned char c)
                     { return std::isalnum(c) || std::string("_.()[]/-").find(char(c)) < 8; });
}

namespace {

Number_table read_number_table(const std::string& text)
{
  Number_table table;
  Text_lines lines(text, ",;");
  std::string count;
  bool is_first = true;
  while (lines.next())
  {
    const auto& words = lines.words();
    if (words[0].substr(0, 2) == "//") continue;
    if (is_first && words.size() == 1)
      count = std::string(words[0]);
    else if (!take_row(lines, table))
    {
      if (!is_first || !std::all_of(words.begin(), words.end(), is_name))
        lines.refuse("is neither a point nor a comment of an XYZ or PWN file");
      table.names.assign(words.begin(), words.end());
    }
    is_first = false;
  }
  const std::size_t rows = table.columns.empty() ? 0 : table.columns[0].size();
  // names may contain blanks, and can't be separated then
  if (table.names.size() != table.columns.size()) table.names.clear();
  if (rows > 0 && table.columns.size() < 3)
    throw std::runtime_error("it is no XYZ or PWN file, whose lines have three numbers or more; "
                             "check it or export it again");
  if (!count.empty() && count != std::to_string(rows))
    throw std::runtime_error("its first line is neither a point nor the number of the points, " +
                             std::to_string(rows) + "; check it or export it again");
  return table;
}

// Whether three columns are colors: whole numbers up to 255, and not all of them 0 or 1.
bool are_colors(const Number_table& table, const std::size_t first)
{
  double largest = 0.;
  for (std::size_t c = first; c < first + 3; ++c)
    for (const double d : table.columns[c])
    {
      if (!(d >= 0. && d <= 255. && d == std::floor(d))) return false;
      largest = (std::max)(largest, d);
    }
  return largest > 1.;
}

bool has_normals(const Number_table& table)
{
  if (table.columns.size() < 6) return false;
  if (table.names.empty()) return !are_colors(table, 3);
  const char last = table.names[3].empty() ? ' ' : table.names[3].back();
  return (table.names[3][0] == 'n' || table.names[3][0] == 'N') && (last == 'x' || last == 'X');
}

// Names of PLY properties have no blanks or signs.
std::string column_name(const Number_table& table, const std::size_t column)
{
  std::string name;
  if (!table.names.empty())
    for (const unsigned char c : table.names[column])
      if (std::isalnum(c) || c == '_') name += static_cast<char>(std::tolower(c));
  return name.empty() ? "column_" + std::to_string(column + 1) : name;
}

void take_table(Number_table&& table, const bool normals, Shape& shape)
{
  if (table.columns.empty()) return; // no points, which is refused later
  const auto& c = table.columns;
  for (std::size_t i = 0; i < c[0].size(); ++i)
  {
    shape.points.emplace_back(c[0][i], c[1][i], c[2][i]);
    if (normals) shape.normals.emplace_back(c[3][i], c[4][i], c[5][i]);
  }
  for (std::size_t k = normals ? 6 : 3; k < c.size(); ++k)
    shape.point_properties.push_back(
        {column_name(table, k), "double", std::move(table.columns[k])});
}

} // namespace

void read_xyz(const std::string& bytes, Shape& shape)
{
  Number_table table = read_number_table(bytes);
  const bool normals = has_normals(table);
  take_table(std::move(table), normals, shape);
}

void read_pts(const std::string& bytes, Shape& shape)
{
  take_table(read_number_table(bytes), false, shape);
}

} // namespace internal
} // namespace Shape_io
