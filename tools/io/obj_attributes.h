// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_OBJ_ATTRIBUTES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_OBJ_ATTRIBUTES_H

#include "io/shape.h"
#include "io/text_lines.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// What an OBJ file has of its faces besides their points, gathered line by line.

namespace Shape_io {
namespace internal {

double obj_number(const Text_lines& lines, std::string_view word);

// The index that the digits of a corner stand for; negative ones count back from the last of so many. One that
// can't be is out of range.
std::size_t obj_index(const Text_lines& lines, std::string_view corner, std::string_view digits,
                      std::size_t count);

// What stands behind the first word. Names may have blanks and a '#' in them; one between blanks begins a comment.
std::string obj_text(const Text_lines& lines);

// Texture coordinates or normals: a table, and the corners of faces that refer to it.
class Obj_corner_values
{
public:
  // A face property of that name; so many numbers a corner.
  Obj_corner_values(std::string name, std::string meaning, const std::size_t size)
    : m_name(std::move(name)), m_meaning(std::move(meaning)), m_size(size)
  {}

  void add(const Text_lines& lines);

  // `digits` are those of the corner of that number among the corners of all faces.
  void refer(const Text_lines& lines, std::string_view corner, std::string_view digits,
             std::size_t number_of_corner);

  // Throws if a corner refers to what the file has not.
  void give_to(Shape& shape) const;

  std::size_t count() const { return m_table.size() / m_size; }
  const std::vector<double>& table() const { return m_table; }

private:
  static constexpr std::size_t none = std::size_t(-1);

  std::string m_name, m_meaning;
  std::size_t m_size;
  std::vector<double> m_table;
  std::vector<std::size_t> m_indices; // of the corners up to the last one that has any
  bool m_is_beyond = false;
  std::size_t m_farthest = 0,
              m_line_of_farthest = 0; // the highest index that was beyond the table so far
};

// Names that hold for the faces behind them, up to the next.
class Obj_names
{
public:
  explicit Obj_names(std::string name) : m_name(std::move(name)) {}

  // Holds from that face on; empty: none.
  void set(const std::string& word, std::size_t face);

  void give_to(Shape& shape) const;

private:
  std::string m_name;
  std::vector<std::string> m_words;
  std::map<std::string, std::size_t> m_numbers;
  std::vector<std::pair<std::size_t, double>> m_changes; // first face, number of the word or -1
};

// The numbers behind the coordinates of a point: colors, and a weight before them.
class Obj_point_colors
{
public:
  // Of the next point.
  void add(const Text_lines& lines);

  void give_to(Shape& shape) const;

private:
  std::size_t m_number_of_points = 0, m_number_of_others = 0;
  std::vector<double> m_colors; // 3 a point, up to the last one that has any; NaN: none
};

// Statements that a shape has no place for.
class Obj_leftovers
{
public:
  void add(const std::string_view keyword) { ++m_counts[std::string(keyword)]; }

  void give_to(Shape& shape) const;

private:
  std::map<std::string, std::size_t> m_counts;
};

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_OBJ_ATTRIBUTES_H
