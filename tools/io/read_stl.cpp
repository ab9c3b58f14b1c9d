// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_stl.h"

#include "io/ply_cursor.h"
#include "io/text_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace Shape_io {
namespace internal {

namespace {

// An order for NaN too, so that such a point is not taken for another but found and refused.
struct Stl_point : std::array<double, 3>
{
  friend bool operator<(const Stl_point& a, const Stl_point& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (std::isnan(a[i]) != std::isnan(b[i])) return std::isnan(b[i]);
      if (a[i] < b[i] || b[i] < a[i]) return a[i] < b[i];
    }
    return false;
  }
};

// Adds triangles corner by corner.
class Stl_triangles
{
public:
  explicit Stl_triangles(Shape& shape) : m_shape(shape) {}

  void add(const std::array<Stl_point, 3>& corners)
  {
    m_shape.polygons.emplace_back();
    for (const Stl_point& p : corners)
    {
      const auto [place, is_new] = m_index.emplace(p, m_shape.points.size());
      if (is_new) m_shape.points.emplace_back(p[0], p[1], p[2]);
      m_shape.polygons.back().push_back(place->second);
    }
  }

private:
  Shape& m_shape;
  std::map<Stl_point, std::size_t> m_index;
};

constexpr std::size_t stl_header_size = 84, stl_triangle_size = 50;

// The number of triangles that the header of a binary file gives.
std::size_t stl_count(const std::string& bytes)
{
  Ply_cursor cursor(bytes, stl_header_size - 4, Ply_format::LITTLE_ENDIAN_BINARY);
  return static_cast<std::size_t>(cursor.number(Ply_type::UINT32));
}

// Whether the word is the given one, in capitals or not.
bool is_stl_word(const std::string_view word, const std::string_view lower)
{
  return word.size() == lower.size() &&
         std::equal(word.begin(), word.end(), lower.begin(),
                    [](const unsigned char a, const char b) { return std::tolower(a) == b; });
}

// Binary files may begin with the word, too.
bool is_text_stl(const std::string& bytes)
{
  return is_stl_word(std::string_view(bytes).substr(0, 5), "solid") &&
         (bytes.size() < stl_header_size ||
          bytes.size() != stl_header_size + stl_triangle_size * stl_count(bytes));
}

void read_binary_stl(const std::string& bytes, Shape& shape)
{
  if (bytes.size() < stl_header_size)
    throw std::runtime_error(
        "it is not a sound STL file, or only a part of one; check it or export "
        "the shape again");
  // what is less than a triangle may follow
  const std::size_t held = (bytes.size() - stl_header_size) / stl_triangle_size;
  const std::size_t count = stl_count(bytes);
  if (count != held)
    throw std::runtime_error("it tells of " + std::to_string(count) + " triangles, but holds " +
                             std::to_string(held) + "; copy or export it again");
  Stl_triangles triangles(shape);
  for (std::size_t i = 0; i < count; ++i)
  {
    constexpr std::size_t size_of_normal = 12;
    Ply_cursor cursor(bytes, stl_header_size + i * stl_triangle_size + size_of_normal,
                      Ply_format::LITTLE_ENDIAN_BINARY);
    std::array<Stl_point, 3> corners;
    for (Stl_point& p : corners)
      for (double& c : p) c = cursor.number(Ply_type::FLOAT);
    triangles.add(corners);
  }
}

// The words of a triangle in a text, one after the other.
class Stl_facet
{
public:
  bool is_begun() const { return m_next > 0; }

  // Returns whether the triangle is complete. Throws if the word is not the next one.
  bool take(const std::string_view word, const Text_lines& lines)
  {
    // empty: a number
    static const std::array<std::string_view, 21> pattern = {
        "facet",  "normal", "", "", "",       "outer", "loop", "vertex", "",        "",        "",
        "vertex", "",       "", "", "vertex", "",      "",     "",       "endloop", "endfacet"};
    const std::string_view wanted = pattern[m_next];
    if (!wanted.empty() && !is_stl_word(word, wanted))
      lines.refuse("has '" + shown(word) + "' where a triangle needs '" + std::string(wanted) +
                   "'");
    // normals are not used, and some programs write words for those of triangles without area
    if (wanted.empty() && m_next >= first_corner)
    {
      m_corners[m_coordinate / 3][m_coordinate % 3] = number_of(word);
      ++m_coordinate;
    }
    if (++m_next < pattern.size()) return false;
    m_next = m_coordinate = 0;
    return true;
  }

  const std::array<Stl_point, 3>& corners() const { return m_corners; }

private:
  static constexpr std::size_t first_corner = 8;

  std::array<Stl_point, 3> m_corners{};
  std::size_t m_next = 0, m_coordinate = 0;
};

void read_text_stl(const std::string& bytes, Shape& shape)
{
  Stl_triangles triangles(shape);
  Stl_facet facet;
  bool is_closed = true;
  Text_lines lines(bytes);
  while (lines.next())
  {
    const std::string_view first = lines.words()[0];
    const bool ends = is_stl_word(first, "endsolid");
    if (!facet.is_begun() && (ends || is_stl_word(first, "solid"))) // a name of any words follows
    {
      is_closed = ends;
      continue;
    }
    for (const std::string_view word : lines.words())
      if (facet.take(word, lines)) triangles.add(facet.corners());
  }
  if (facet.is_begun() || !is_closed)
    throw std::runtime_error("it ends before its last 'endsolid'; copy or export it again");
}

} // namespace

void read_stl(const std::string& bytes, Shape& shape)
{
  if (is_text_stl(bytes))
    read_text_stl(bytes, shape);
  else
    read_binary_stl(bytes, shape);
  if (shape.polygons.empty())
    throw std::runtime_error("it holds no triangles; check it or export the shape again");
}

} // namespace internal
} // namespace Shape_io
