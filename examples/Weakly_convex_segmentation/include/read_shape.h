// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_IO_READ_SHAPE_H
#define SHAPE_IO_READ_SHAPE_H

#include "read_ply.h"
#include "shape.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/STL.h>
#include <CGAL/IO/read_off_points.h>
#include <CGAL/IO/read_xyz_points.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

// Reading of meshes (OFF, PLY, OBJ, STL) and clouds (PLY, XYZ, PWN, OFF). Points and faces keep the
// order of the file; none is moved, dropped or invented.

namespace Shape_io {
namespace internal {

// CGAL's readers print on std::cerr what is wrong, but a failure here is one line, our own.
class Silent_cerr
{
public:
  Silent_cerr() : m_saved(std::cerr.rdbuf(&m_sink)) {}
  ~Silent_cerr() { std::cerr.rdbuf(m_saved); }
  Silent_cerr(const Silent_cerr&) = delete;
  Silent_cerr& operator=(const Silent_cerr&) = delete;

private:
  struct Sink : std::streambuf
  {
    int overflow(const int c) override { return traits_type::not_eof(c); }
  };

  Sink m_sink;
  std::streambuf* m_saved;
};

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

// CGAL's STL reader finds the corners that triangles share by looking points up in a map. This type
// has an order for NaN too, so that such a point is not taken for another but found and refused.
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

using Byte_stream = boost::iostreams::stream<boost::iostreams::array_source>;

inline void refuse_unless(const bool good, const std::string& format)
{
  if (!good)
    throw std::runtime_error("it is not a sound " + format +
                             " file, or only a part of one; check it or export the shape again");
}

inline void take_polygons(std::vector<Bounded_polygon>& from, Shape& shape)
{
  shape.polygons.reserve(from.size());
  for (Bounded_polygon& polygon : from) shape.polygons.push_back(std::move(polygon));
}

// The whole file, in text formats with an end to the last line and with no white space but blanks
// and line ends: that is what CGAL's readers of OBJ and XYZ split lines at.
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
        throw std::runtime_error("its header tells of '" + word.substr(0, 20) +
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

inline void read_obj(const std::string& bytes, Shape& shape)
{
  std::string text = plain_text(bytes);
  // A backslash at the end of a line, before blanks that plain_text() may have made, continues it.
  for (std::size_t i = text.find('\\'); i != std::string::npos; i = text.find('\\', i + 1))
  {
    const std::size_t end = text.find_first_not_of(' ', i + 1);
    if (end != std::string::npos && text[end] == '\n') text[i] = text[end] = ' ';
  }
  Byte_stream stream(text.data(), text.size());
  std::vector<Bounded_polygon> polygons;
  refuse_unless(CGAL::IO::read_OBJ(stream, shape.points, polygons), "OBJ mesh with faces");
  take_polygons(polygons, shape);
}

inline void read_stl(const std::string& bytes, Shape& shape)
{
  Byte_stream stream(bytes.data(), bytes.size());
  std::vector<Stl_point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  refuse_unless(CGAL::IO::read_STL(stream, points, triangles), "STL");
  for (const Stl_point& p : points) shape.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& t : triangles) shape.polygons.emplace_back(t.begin(), t.end());
}

// CGAL's reader takes a first line that begins with a number but is no point for the number of
// points, and skips it: here it must be that number.
inline void check_xyz_count(const std::string& text, const std::size_t number_of_points)
{
  std::istringstream words(text.substr(0, text.find('\n')));
  const std::vector<std::string> first_line{std::istream_iterator<std::string>(words), {}};
  std::istringstream numbers(text);
  double x, y, z;
  const bool is_skipped = !first_line.empty() && first_line[0][0] != '#' &&
                          (first_line.size() < 3 || !(numbers >> x >> y >> z));
  if (is_skipped && (first_line.size() > 1 || first_line[0] != std::to_string(number_of_points)))
    throw std::runtime_error("its first line is neither a point nor the number of the points, " +
                             std::to_string(number_of_points) + "; check it or export it again");
}

inline void read_xyz(const std::string& bytes, Shape& shape)
{
  const std::string text = plain_text(bytes);
  Byte_stream stream(text.data(), text.size());
  std::vector<Point_with_normal> points;
  const bool good = CGAL::IO::read_XYZ(
      stream, std::back_inserter(points),
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  refuse_unless(good, "XYZ or PWN");
  check_xyz_count(text, points.size());
  take_points_with_normals(points, shape);
}

using Reader = void (*)(const std::string&, Shape&);

inline Reader reader_for(const std::string& path)
{
  static const std::pair<const char*, Reader> readers[] = {{".off", read_off}, {".ply", read_ply},
                                                           {".obj", read_obj}, {".stl", read_stl},
                                                           {".xyz", read_xyz}, {".pwn", read_xyz}};
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& reader : readers)
    if (extension == reader.first) return reader.second;
  throw std::runtime_error(
      (extension.empty() ? "it has no extension" : "'" + extension + "' is no known extension") +
      "; use .off, .ply, .obj, .stl, .xyz or .pwn");
}

inline std::string file_bytes(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw std::runtime_error("there is no such file; check its name");
  if (std::filesystem::is_directory(path, error))
    throw std::runtime_error("it is a folder; name a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("it can't be opened; check its permissions");
  std::string bytes;
  std::vector<char> block(1 << 20);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0)
    bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
  // Some editors put a byte order mark before text; a binary STL may begin with any bytes.
  const bool is_stl = reader_for(path) == read_stl;
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 && (!is_stl || bytes.compare(3, 5, "solid") == 0))
    bytes.erase(0, 3);
  if (bytes.empty()) throw std::runtime_error("the file is empty; copy or export it again");
  return bytes;
}

template <typename Triple>
bool is_finite_triple(const Triple& t)
{
  return std::isfinite(t.x()) && std::isfinite(t.y()) && std::isfinite(t.z());
}

// Refuses what no algorithm could work on, and names the first bad element.
inline void check_shape(const Shape& shape)
{
  const auto refuse = [](const std::string& kind, const std::size_t i, const std::string& what)
  { throw std::runtime_error(kind + " " + std::to_string(i) + " (counted from 0) " + what); };

  if (shape.points.empty())
    throw std::runtime_error("it holds no points; check it or export the shape again");
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    if (!is_finite_triple(shape.points[i]))
      refuse("point", i, "has a coordinate that is not finite; remove or repair it");
  for (std::size_t i = 0; i < shape.normals.size(); ++i)
    if (!is_finite_triple(shape.normals[i]))
      refuse("point", i, "has a normal that is not finite; remove the normals or repair it");
  for (std::size_t i = 0; i < shape.polygons.size(); ++i)
  {
    if (shape.polygons[i].size() < 3) refuse("face", i, "has fewer than 3 corners; remove it");
    for (const std::size_t corner : shape.polygons[i])
      if (corner >= shape.points.size())
        refuse("face", i,
               "has a corner that is not one of the " + std::to_string(shape.points.size()) +
                   " points; repair it");
  }
}

// Normals that are all zero are none: CGAL's readers give them to points that have no normal.
inline void drop_missing_normals(Shape& shape)
{
  if (std::all_of(shape.normals.begin(), shape.normals.end(),
                  [](const Vector& n) { return n == CGAL::NULL_VECTOR; }))
    shape.normals.clear();
}

} // namespace internal

// Reads the shape in the file; the extension tells the format, in capitals or not. A file with
// faces is a mesh, one without is a cloud.
// Throws File_error with one line that names the file, what is wrong, and what to do.
inline Shape read_shape(const std::string& path)
{
  Shape shape;
  try
  {
    const internal::Reader reader = internal::reader_for(path);
    const std::string bytes = internal::file_bytes(path);
    {
      const internal::Silent_cerr silence;
      reader(bytes, shape);
    }
    internal::drop_missing_normals(shape);
    internal::check_shape(shape);
  }
  catch (const std::bad_alloc&)
  {
    throw File_error("cannot read '" + path + "': there is not enough memory; take a smaller file");
  }
  catch (const std::exception& error)
  {
    throw File_error("cannot read '" + path + "': " + error.what());
  }
  return shape;
}

} // namespace Shape_io

#endif // SHAPE_IO_READ_SHAPE_H
