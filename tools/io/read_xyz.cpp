// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_xyz.h"

#include "io/text_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

// The columns of numbers of a table; others, such as names of points, are left out.
struct Number_table
{
  std::string count;              // the number of points, if the file begins with it
  std::vector<std::string> names; // empty, or one a column
  std::vector<std::vector<double>> columns;
  std::vector<char> is_text;           // of each word of a line
  std::vector<std::string> text_names; // of the columns that are left out
};

// Reads a line of points; returns false if it is none, as it has too few numbers.
bool take_row(const Text_lines& lines, Number_table& table)
{
  constexpr std::size_t fewest_numbers = 3, most_columns = 10000;
  const auto& words = lines.words();
  double number;
  if (table.columns.empty())
  {
    std::vector<char> is_text;
    for (const std::string_view word : words) is_text.push_back(is_number(word, number) ? 0 : 1);
    const auto numbers =
        static_cast<std::size_t>(std::count(is_text.begin(), is_text.end(), char(0)));
    if (numbers < words.size() && numbers < fewest_numbers) return false;
    if (words.size() > most_columns)
      lines.refuse("has more than " + std::to_string(most_columns) + " numbers");
    table.is_text = std::move(is_text);
    table.columns.resize(numbers);
  }
  if (words.size() != table.is_text.size())
    lines.refuse("has " + std::to_string(words.size()) + " numbers, but those before have " +
                 std::to_string(table.is_text.size()));
  std::size_t column = 0;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (table.is_text[i] != 0) continue;
    if (!is_number(words[i], number))
      lines.refuse("has '" + shown(words[i]) + "' where those before have a number");
    table.columns[column++].push_back(number);
  }
  return true;
}

// Gives the columns the names that a head line has for them.
void name_columns(std::vector<std::string> names, Number_table& table)
{
  if (names.size() != table.is_text.size()) names.clear(); // with blanks, they can't be separated
  for (std::size_t i = 0; i < table.is_text.size(); ++i)
  {
    if (table.is_text[i] != 0)
      table.text_names.push_back(names.empty() ? std::to_string(i + 1) : names[i]);
    else if (!names.empty())
      table.names.push_back(names[i]);
  }
}

// Whether a word is a number with a comma in the place of the point.
bool has_decimal_comma(const std::string_view word)
{
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos || comma + 1 == word.size()) return false;
  std::string with_point(word);
  with_point[comma] = '.';
  double number;
  return is_number(with_point, number);
}

// Whether the numbers of a table have decimal commas: its lines are of at least three words between blanks and
// semicolons, each of which is a whole number or has one comma in it. "1,2,3" is one word.
bool has_decimal_commas(const std::string& text)
{
  constexpr int enough = 20;
  constexpr std::size_t fewest_words = 3;
  Text_lines lines(text, ";");
  bool has_one = false;
  for (int line = 0; line < enough && lines.next(); ++line)
  {
    bool has_number = false;
    for (const std::string_view word : lines.words())
    {
      double number;
      const bool is_whole = is_number(word, number) && number == std::floor(number);
      const bool has_comma = has_decimal_comma(word);
      if (line > 0 && !is_whole && !has_comma) return false;
      has_number = has_number || is_whole || has_comma;
      has_one = has_one || has_comma;
    }
    if (has_number && line > 0 && lines.words().size() < fewest_words) return false;
  }
  return has_one;
}

} // namespace

bool is_name(const std::string_view word)
{
  double number;
  return !is_number(word, number) &&
         std::all_of(word.begin(), word.end(),
                     [](const unsigned char c) {
                       return std::isalnum(c) ||
                              std::string("_.:()[]/-\"").find(char(c)) != std::string::npos;
                     });
}

namespace {

Number_table read_number_table(const std::string& text)
{
  std::string with_points; // only where there are decimal commas: files may be large
  if (has_decimal_commas(text))
  {
    with_points = text;
    std::replace(with_points.begin(), with_points.end(), ',', '.');
  }
  Number_table table;
  Text_lines lines(with_points.empty() ? text : with_points, with_points.empty() ? ",;" : ";");
  std::vector<std::string> names;
  bool is_first = true;
  while (lines.next())
  {
    const auto& words = lines.words();
    if (words[0].substr(0, 2) == "//") continue;
    if (is_first && words.size() == 1)
      table.count = std::string(words[0]);
    else if (!take_row(lines, table))
    {
      if (!is_first || !std::all_of(words.begin(), words.end(), is_name))
        lines.refuse(
            "is neither a point nor a comment of a table of points (XYZ, PWN, TXT, ASC, CSV, "
            "PTS)");
      names.assign(words.begin(), words.end());
    }
    is_first = false;
  }
  name_columns(std::move(names), table);
  const std::size_t rows = table.columns.empty() ? 0 : table.columns[0].size();
  if (rows > 0 && table.columns.size() < 3)
    throw std::runtime_error("it is no table of points (XYZ, PWN, TXT, ASC, CSV, PTS), whose lines "
                             "have three numbers or more; check it or export it again");
  if (!table.count.empty() && table.count != std::to_string(rows))
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

// Whether three columns are of vectors of length 1, but for a few, and for zeros or NaN where there is none.
bool are_unit_vectors(const Number_table& table, const std::size_t first)
{
  constexpr double tolerance = 0.1, most_others = 0.01;
  const auto& c = table.columns;
  std::size_t others = 0, zeros = 0;
  for (std::size_t i = 0; i < c[first].size(); ++i)
  {
    const double length = std::hypot(c[first][i], c[first + 1][i], c[first + 2][i]);
    if (length == 0. || std::isnan(length))
      ++zeros;
    else if (!(std::abs(length - 1.) <= tolerance))
      ++others;
  }
  const double rows = static_cast<double>(c[first].size());
  return static_cast<double>(others) <= most_others * rows && static_cast<double>(zeros) < rows;
}

using Triple = std::array<std::size_t, 3>; // columns of x, y and z

// Finds the columns that are called by one of the names before or behind x, y and z, or before 0, 1 and 2.
std::optional<Triple> columns_called(const Number_table& table,
                                     const std::vector<std::string>& before,
                                     const std::vector<std::string>& behind,
                                     const std::vector<std::string>& numbered)
{
  std::vector<std::string> names;
  for (const std::string& name : table.names)
  {
    names.emplace_back();
    for (const unsigned char c : name)
      if (std::isalnum(c)) names.back() += static_cast<char>(std::tolower(c));
  }
  const auto find = [&names](const auto& name_of_axis) -> std::optional<Triple>
  {
    Triple found;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto column = std::find(names.begin(), names.end(), name_of_axis(axis));
      if (column == names.end()) return std::nullopt;
      found[axis] = static_cast<std::size_t>(column - names.begin());
    }
    return found;
  };
  const auto letter = [](const std::size_t axis) { return std::string(1, "xyz"[axis]); };
  for (const std::string& word : before)
    if (const auto found = find([&](const std::size_t axis) { return word + letter(axis); }))
      return found;
  for (const std::string& word : behind)
    if (const auto found = find([&](const std::size_t axis) { return letter(axis) + word; }))
      return found;
  for (const std::string& word : numbered)
    if (const auto found =
            find([&](const std::size_t axis) { return word + std::to_string(axis); }))
      return found;
  return std::nullopt;
}

std::optional<Triple> columns_of_points(const Number_table& table)
{
  return columns_called(table, {"", "coord", "coordinate", "pos", "position", "point", "p"},
                        {"coord", "coordinate", "m", "mm"}, {"points", "point", "coordinates"});
}

std::optional<Triple> columns_of_normals(const Number_table& table, const bool may_have_any_length)
{
  if (!table.names.empty())
    return columns_called(table, {"n", "normal", "normals", "norm"}, {"n", "normal"},
                          {"normals", "normal"});
  if (table.columns.size() < 6 || are_colors(table, 3)) return std::nullopt;
  if (!may_have_any_length && !are_unit_vectors(table, 3)) return std::nullopt;
  return Triple{3, 4, 5};
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

void take_table(Number_table&& table, const std::optional<Triple>& normals, Shape& shape)
{
  for (const std::string& name : table.text_names)
    shape.notes.push_back("the column " + shown(name) + ", which is not of numbers, is left out");
  if (table.columns.empty()) return; // no points, which is refused later
  const std::optional<Triple> named = columns_of_points(table);
  if (!table.names.empty() && !named)
    shape.notes.push_back("no columns are called x, y and z; the first three are taken for them");
  const Triple points = named.value_or(Triple{0, 1, 2});
  const auto& c = table.columns;
  for (std::size_t i = 0; i < c[0].size(); ++i)
  {
    shape.points.emplace_back(c[points[0]][i], c[points[1]][i], c[points[2]][i]);
    if (normals)
      shape.normals.emplace_back(c[(*normals)[0]][i], c[(*normals)[1]][i], c[(*normals)[2]][i]);
  }
  const auto is_of = [](const Triple& triple, const std::size_t column)
  { return std::find(triple.begin(), triple.end(), column) != triple.end(); };
  for (std::size_t k = 0; k < c.size(); ++k)
    if (!is_of(points, k) && !(normals && is_of(*normals, k)))
      shape.point_properties.push_back(
          {column_name(table, k), "double", std::move(table.columns[k])});
}

void read_table(const std::string& bytes, const bool may_have_any_length, Shape& shape)
{
  Number_table table = read_number_table(bytes);
  const auto normals = columns_of_normals(table, may_have_any_length || !table.count.empty());
  take_table(std::move(table), normals, shape);
}

} // namespace

void read_xyz(const std::string& bytes, Shape& shape) { read_table(bytes, false, shape); }

void read_pwn(const std::string& bytes, Shape& shape) { read_table(bytes, true, shape); }

void read_pts(const std::string& bytes, Shape& shape)
{
  Number_table table = read_number_table(bytes);
  const auto normals = table.names.empty() ? std::nullopt : columns_of_normals(table, true);
  take_table(std::move(table), normals, shape);
}

} // namespace internal
} // namespace Shape_io
