// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_IO_READ_OFF_H
#define SHAPE_IO_READ_OFF_H

#include "byte_stream.h"
#include "shape.h"
#include "text_lines.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/read_off_points.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// OFF with colors, normals and comments, as a mesh or a cloud.

namespace Shape_io {
namespace internal {

// CGAL's readers resize a polygon to the size that the file tells before they look for its indices:
// without a limit a broken size asks for all the memory there is.
struct Bounded_polygon : std::vector<std::size_t>
{
  void resize(const std::size_t size)
  {
    if (size > 1000000)
      throw std::runtime_error("a face is said to have more than a million corners; "
                               "export the shape again");
    std::vector<std::size_t>::resize(size);
  }
};

inline void take_polygons(std::vector<Bounded_polygon>& from, Shape& shape)
{
  shape.polygons.reserve(from.size());
  for (Bounded_polygon& polygon : from) shape.polygons.push_back(std::move(polygon));
}

// The whole file, in text formats with an end to the last line and with no white space but blanks
// and line ends: that is what CGAL's readers split lines at.
inline std::string plain_text(std::string text)
{
  // Old Macs ended lines with a carriage return alone.
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
  std::replace_if(
      text.begin(), text.end(), [](const char c) { return c == '\t' || c == '\r'; }, ' ');
  text += '\n';
  return text;
}

// CGAL's reader makes room for as many points and faces as are told behind the signature: no file
// holds more of them than it has bytes.
inline void check_off_counts(const std::string& text, const std::size_t end_of_signature)
{
  Byte_stream lines(text.data() + end_of_signature, text.size() - end_of_signature);
  std::string line, word;
  for (int found = 0; found < 2 && std::getline(lines, line);)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    for (; found < 2 && words >> word; ++found)
      if (word.size() > 12 || word.find_first_not_of("0123456789") != std::string::npos ||
          std::stoull(word) > text.size())
        throw std::runtime_error("its header tells of '" + shown(word) +
                                 "' elements, which the file can't hold; copy or export it again");
  }
}

using Point_with_normal = std::pair<Point, Vector>;

inline void take_points_with_normals(const std::vector<Point_with_normal>& from, Shape& shape)
{
  shape.points.clear();
  shape.normals.clear();
  for (const Point_with_normal& p : from)
  {
    shape.points.push_back(p.first);
    shape.normals.push_back(p.second);
  }
}

// CGAL's reader of point clouds: it takes three more numbers behind a point for the normal.
inline void read_off_cloud(const std::string& text, Shape& shape)
{
  Byte_stream stream(text.data(), text.size());
  std::vector<Point_with_normal> points;
  const bool good = CGAL::IO::read_OFF(
      stream, std::back_inserter(points),
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  if (good && points.size() == shape.points.size()) take_points_with_normals(points, shape);
}

// What an OFF file begins with: (ST)(C)(N)OFF, for texture coordinates, colors and normals of the
// points.
struct Off_signature
{
  std::size_t first = 0, last = 0; // where it is in the text
  bool has_colors_or_textures = false;
  bool has_normals = false;
};

inline Off_signature off_signature(const std::string& text)
{
  Off_signature result;
  while (
      result.first < text.size() &&
      (text[result.first] == '#' || std::isspace(static_cast<unsigned char>(text[result.first]))))
    result.first = text[result.first] == '#' ? text.find('\n', result.first) : result.first + 1;
  result.first = (std::min)(result.first, text.size());
  result.last = (std::min)(text.find_first_of(" \t\r\n", result.first), text.size());
  std::string word = text.substr(result.first, result.last - result.first);
  const auto take = [&word](const std::string& flag)
  {
    const bool found = word.compare(0, flag.size(), flag) == 0;
    if (found) word.erase(0, flag.size());
    return found;
  };
  const bool has_textures = take("ST");
  result.has_colors_or_textures = take("C") || has_textures;
  result.has_normals = take("N");
  if (word != "OFF" || text.substr(result.last, 10).find("BINARY") != std::string::npos)
    throw std::runtime_error("it does not begin with OFF, NOFF or COFF, or is binary; "
                             "export the shape as text");
  return result;
}

inline void read_off(const std::string& bytes, Shape& shape)
{
  std::string text = plain_text(bytes);
  const Off_signature signature = off_signature(text);
  // CGAL's reader crashes where a color is missing: it is not told of the colors, and so passes
  // over what follows the point and its normal.
  check_off_counts(text, signature.last);
  text.replace(signature.first, signature.last - signature.first,
               signature.has_normals ? "NOFF" : "OFF");
  Byte_stream stream(text.data(), text.size());
  std::vector<Bounded_polygon> polygons;
  const bool good = CGAL::IO::read_OFF(
      stream, shape.points, polygons,
      CGAL::parameters::vertex_normal_output_iterator(std::back_inserter(shape.normals)));
  refuse_unless(good, "OFF");
  take_polygons(polygons, shape);
  if (!shape.is_mesh() && !signature.has_normals && !signature.has_colors_or_textures)
    read_off_cloud(text, shape);
}

} // namespace internal
} // namespace Shape_io

#endif // SHAPE_IO_READ_OFF_H
