// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_off.h"

#include "io/text_lines.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

// What an OFF file begins with: (ST)(C)(N)OFF, for texture coordinates, colors and normals of the
// points.
struct Off_signature
{
  bool has_colors_or_textures = false;
  bool has_normals = false;
  std::string first_count; // the number of points, where there is no blank before it
};

Off_signature off_signature(const std::vector<std::string_view>& words)
{
  Off_signature result;
  std::string word(words.empty() ? "" : words[0]);
  const auto take = [&word](const std::string& flag)
  {
    const bool found = word.compare(0, flag.size(), flag) == 0;
    if (found) word.erase(0, flag.size());
    return found;
  };
  const bool has_textures = take("ST");
  result.has_colors_or_textures = take("C") || has_textures;
  result.has_normals = take("N");
  if (word.compare(0, 3, "OFF") == 0 && word.size() > 3 &&
      word.find_first_not_of("0123456789", 3) == std::string::npos)
  {
    result.first_count = word.substr(3);
    word.erase(3);
  }
  if (word != "OFF" || (words.size() > 1 && words[1] == "BINARY"))
    throw std::runtime_error("it does not begin with OFF, NOFF or COFF, or is binary; "
                             "export the shape as text");
  return result;
}

// A number of points, faces or corners: no file holds more of them than it has bytes.
std::size_t off_count(const std::string_view word, const std::size_t most)
{
  const double number = number_of(word);
  const auto count = static_cast<std::size_t>((std::max)(0., (std::min)(number, 1e15)));
  if (static_cast<double>(count) != number || count > most)
    throw std::runtime_error("it tells of '" + shown(word) +
                             "' elements, which the file can't hold; copy or export it again");
  return count;
}

void next_off_line(Text_lines& lines)
{
  if (!lines.next())
    throw std::runtime_error(
        "it is not a sound OFF file, or only a part of one; check it or export "
        "the shape again");
}

// The words behind the signature, on one or several lines: numbers of points, faces and edges.
std::vector<std::size_t> off_counts(Text_lines& lines, const Off_signature& signature,
                                    const std::size_t most)
{
  std::vector<std::size_t> counts;
  if (!signature.first_count.empty()) counts.push_back(off_count(signature.first_count, most));
  for (std::size_t i = 1; i < lines.words().size(); ++i)
    counts.push_back(off_count(lines.words()[i], most));
  while (counts.size() < 2)
  {
    next_off_line(lines);
    for (const std::string_view word : lines.words()) counts.push_back(off_count(word, most));
  }
  if (counts.size() > 3) lines.refuse("has more than the numbers of points, faces and edges");
  return counts;
}

// Three more numbers behind a point are its normal if the signature says so; in a cloud also if it
// says nothing.
void read_off_points(Text_lines& lines, const std::size_t count, const bool may_have_normals,
                     Shape& shape)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    next_off_line(lines);
    const auto& words = lines.words();
    if (words.size() < 3) lines.refuse("has fewer than 3 coordinates");
    shape.points.emplace_back(number_of(words[0]), number_of(words[1]), number_of(words[2]));
    if (may_have_normals && words.size() >= 6)
      shape.normals.emplace_back(number_of(words[3]), number_of(words[4]), number_of(words[5]));
  }
  if (shape.normals.size() != shape.points.size()) shape.normals.clear();
}

void read_off_face(Text_lines& lines, Shape& shape)
{
  next_off_line(lines);
  const auto& words = lines.words();
  const std::size_t corners = off_count(words[0], words.size());
  if (corners >= words.size()) lines.refuse("has fewer corners than it tells");
  shape.polygons.emplace_back();
  for (std::size_t i = 1; i <= corners; ++i)
    shape.polygons.back().push_back(corner_index(number_of(words[i])));
}

} // namespace

void read_off(const std::string& bytes, Shape& shape)
{
  Text_lines lines(bytes);
  lines.next();
  const Off_signature signature = off_signature(lines.words());
  const std::vector<std::size_t> counts = off_counts(lines, signature, bytes.size());
  const bool is_plain_cloud = counts[1] == 0 && !signature.has_colors_or_textures;
  read_off_points(lines, counts[0], signature.has_normals || is_plain_cloud, shape);
  for (std::size_t i = 0; i < counts[1]; ++i) read_off_face(lines, shape);
  if (lines.next()) lines.refuse("is one more than it tells of");
}

} // namespace internal
} // namespace Shape_io
