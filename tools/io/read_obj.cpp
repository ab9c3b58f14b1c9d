// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_obj.h"

#include "io/text_lines.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

// The index of the point in `a`, `a/b`, `a//c` or `a/b/c`; negative ones count back from the last
// point so far. One that can't be is out of range, and is refused where the face is named.
std::size_t obj_corner(const Text_lines& lines, const std::string_view word,
                       const std::size_t number_of_points)
{
  const std::string_view digits = word.substr(0, word.find('/'));
  long long index = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (end.ec != std::errc() || end.ptr != digits.data() + digits.size())
    lines.refuse("has the corner '" + shown(word) + "', which is no index");
  if (index < 0) index += static_cast<long long>(number_of_points) + 1;
  return static_cast<std::size_t>(index) - 1;
}

template <typename Triple>
Triple obj_triple(const Text_lines& lines)
{
  const auto& words = lines.words();
  if (words.size() < 4) lines.refuse("has fewer than 3 coordinates");
  return Triple(number_of(words[1]), number_of(words[2]), number_of(words[3]));
}

} // namespace

void read_obj(const std::string& bytes, Shape& shape)
{
  Text_lines lines(bytes);
  std::vector<Vector> normals;
  while (lines.next())
  {
    const auto& words = lines.words();
    if (words[0] == "v")
      shape.points.push_back(obj_triple<Point>(lines));
    else if (words[0] == "vn")
      normals.push_back(obj_triple<Vector>(lines));
    else if (words[0] == "f")
    {
      shape.polygons.emplace_back();
      for (std::size_t i = 1; i < words.size(); ++i)
        shape.polygons.back().push_back(obj_corner(lines, words[i], shape.points.size()));
    }
    else if (!std::all_of(words[0].begin(), words[0].end(),
                          [](const unsigned char c) { return std::isalnum(c) || c == '_'; }))
      lines.refuse("is none of an OBJ file");
  }
  if (shape.points.empty())
    throw std::runtime_error("it is no OBJ file with points; export it again");
  // Normals belong to the corners of faces; without faces, one for each point can only be its own.
  if (!shape.is_mesh() && normals.size() == shape.points.size()) shape.normals = normals;
}

} // namespace internal
} // namespace Shape_io
