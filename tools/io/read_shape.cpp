// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_shape.h"

#include "io/gunzip.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_pcd.h"
#include "io/read_ply.h"
#include "io/read_scene.h"
#include "io/read_stl.h"
#include "io/read_xyz.h"
#include "io/text_lines.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iostream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

// nullptr: read_scene() reads it.
constexpr std::pair<const char*, Reader> readers[] = {
    {".off", read_off}, {".ply", read_ply}, {".obj", read_obj}, {".stl", read_stl},
    {".gltf", nullptr}, {".glb", nullptr},  {".3mf", nullptr},  {".dae", nullptr},
    {".fbx", nullptr},  {".pcd", read_pcd}, {".xyz", read_xyz}, {".pwn", read_pwn},
    {".txt", read_xyz}, {".asc", read_xyz}, {".csv", read_xyz}, {".pts", read_pts}};

// What the name of a file tells of its format.
struct Format
{
  std::string extension; // in small letters; of the file that is compressed if it is one
  Reader reader = nullptr;
  bool is_compressed = false;
};

std::string small_extension(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

[[noreturn]] void refuse_extension(const std::string& extension)
{
  for (const char* const scan : {".las", ".laz", ".e57"})
    if (extension == scan)
      throw std::runtime_error("'" + extension +
                               "' is not read, as no package of Debian 12 has a "
                               "library for it; convert it to PLY, for instance with CloudCompare");
  std::string list;
  for (const auto& reader : readers)
    list += (list.empty()                       ? ""
             : &reader == std::end(readers) - 1 ? " or "
                                                : ", ") +
            std::string(reader.first);
  throw std::runtime_error(
      (extension.empty() ? "it has no extension" : "'" + extension + "' is no known extension") +
      "; use " + list + ", each also with .gz behind it");
}

Format format_of(const std::string& path)
{
  Format format;
  std::filesystem::path name(path);
  format.extension = small_extension(name);
  format.is_compressed = format.extension == ".gz";
  if (format.is_compressed) format.extension = small_extension(name.replace_extension());
  for (const auto& reader : readers)
    if (format.extension == reader.first)
    {
      format.reader = reader.second;
      return format;
    }
  refuse_extension(format.extension);
}

} // namespace

Reader reader_for_bytes(const std::string& bytes)
{
  const auto begins_with = [&](const std::string& word)
  { return bytes.compare(0, word.size(), word) == 0; };
  if (begins_with("ply")) return read_ply;
  if (begins_with("glTF")) return read_glb;
  if (begins_with("PK\3\4")) return read_3mf;
  if (begins_with("# .PCD") || begins_with("VERSION")) return read_pcd;
  if (begins_with("solid")) return read_stl;
  if (bytes.find('\0') != std::string::npos)
    return read_stl; // the only other binary one without a mark
  Text_lines lines(bytes, ",;");
  double number;
  if (!lines.next() || is_number(lines.words()[0], number)) return read_xyz;
  const std::string word(lines.words()[0]);
  if (word.compare(0, 2, "//") == 0) return read_xyz;
  const std::string kind = word.substr(0, word.find_last_not_of("0123456789") + 1);
  if (kind.size() >= 3 && kind.compare(kind.size() - 3, 3, "OFF") == 0) return read_off;
  if (lines.words().size() >= 3 && is_name(word) && word != "v" && word != "vn" && word != "vt" &&
      word != "f")
    return read_xyz; // names of columns
  return read_obj;
}

namespace {

template <typename Stream>
std::string stream_bytes(Stream& stream)
{
  std::string bytes;
  std::vector<char> block(1 << 20);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0)
    bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) throw std::runtime_error("it can't be read to its end; copy it anew");
  if (bytes.empty()) throw std::runtime_error("the file is empty; copy or export it again");
  return bytes;
}

std::string file_bytes(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw std::runtime_error("there is no such file; check its name");
  if (std::filesystem::is_directory(path, error))
    throw std::runtime_error("it is a folder; name a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("it can't be opened; check its permissions");
  return stream_bytes(file);
}

// Some editors put a byte order mark before text; a binary STL may begin with any bytes.
void drop_byte_order_mark(std::string& bytes, const bool is_stl)
{
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 && (!is_stl || bytes.compare(3, 5, "solid") == 0))
    bytes.erase(0, 3);
}

// The folder is where the file lies; empty, as is the extension: it came through standard input.
void read_bytes(std::string& bytes, Format format, const std::string& folder, Shape& shape)
{
  if (format.is_compressed || (format.extension.empty() && is_gzip(bytes))) bytes = gunzip(bytes);
  drop_byte_order_mark(bytes, format.reader == read_stl);
  if (format.extension.empty()) format.reader = reader_for_bytes(bytes);
  if (format.reader)
    format.reader(bytes, shape);
  else
    read_scene(bytes, format.extension, folder, shape);
}

template <typename Triple>
bool is_finite_triple(const Triple& t)
{
  return std::isfinite(t.x()) && std::isfinite(t.y()) && std::isfinite(t.z());
}

} // namespace

void check_shape(const Shape& shape, const Gaps gaps)
{
  const bool allows_gaps = gaps == Gaps::ALLOWED && !shape.is_mesh();
  const auto refuse = [](const std::string& kind, const std::size_t i, const std::string& what)
  { throw std::runtime_error(kind + " " + std::to_string(i) + " (counted from 0) " + what); };

  if (shape.points.empty())
    throw std::runtime_error("it holds no points; check it or export the shape again");
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    if (!is_finite_triple(shape.points[i]) && !(allows_gaps && is_gap(shape.points[i])))
      refuse("point", i, "has a coordinate that is not finite; remove or repair it");
  if (allows_gaps && std::all_of(shape.points.begin(), shape.points.end(),
                                 [&](const Point& p) { return is_gap(shape, p); }))
    throw std::runtime_error("none of its points has coordinates; check it or export it again");
  for (std::size_t i = 0; i < shape.normals.size(); ++i)
    if (!is_finite_triple(shape.normals[i]) && !(allows_gaps && is_gap(shape.normals[i])))
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

void drop_missing_normals(Shape& shape)
{
  if (std::all_of(shape.normals.begin(), shape.normals.end(),
                  [](const Vector& n) { return n == CGAL::NULL_VECTOR || is_gap(n); }))
    shape.normals.clear();
}

} // namespace internal

Shape read_shape(const std::string& path, const Gaps gaps)
{
  Shape shape;
  const bool is_standard_input = path == "-";
  const std::string where = is_standard_input ? "standard input" : "'" + path + "'";
  try
  {
    // first what is there: a folder has no extension either
    std::string bytes =
        is_standard_input ? internal::stream_bytes(std::cin) : internal::file_bytes(path);
    const internal::Format format =
        is_standard_input ? internal::Format() : internal::format_of(path);
    const auto folder = std::filesystem::path(path).parent_path();
    internal::read_bytes(bytes, format,
                         is_standard_input ? ""
                         : folder.empty()  ? "."
                                           : folder.string(),
                         shape);
    internal::drop_missing_normals(shape);
    shape.has_gaps_at_origin = gaps == Gaps::ALLOWED && !shape.is_mesh() && shape.is_organized &&
                               has_repeated_origin(shape.points);
    internal::check_shape(shape, gaps);
  }
  catch (const std::bad_alloc&)
  {
    throw File_error("cannot read " + where + ": there is not enough memory; take a smaller file");
  }
  catch (const std::exception& error)
  {
    throw File_error("cannot read " + where + ": " + error.what());
  }
  return shape;
}

} // namespace Shape_io
