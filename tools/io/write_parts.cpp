// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

// The numbers of a PLY file; the binary ones are little endian.
class Ply_writer
{
public:
  Ply_writer(std::ostream& stream, const Encoding encoding) : m_stream(stream), m_encoding(encoding)
  {}

  template <typename Number>
  void write(const Number number)
  {
    if (m_encoding == Encoding::ASCII) return write_text(number);
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    if (host_is_big_endian()) std::reverse(std::begin(bytes), std::end(bytes));
    m_stream.write(reinterpret_cast<const char*>(bytes), sizeof(Number));
  }

  void write(const double number, const Ply_type type)
  {
    switch (type)
    {
    case Ply_type::INT8:
      return write(static_cast<std::int8_t>(number));
    case Ply_type::UINT8:
      return write(static_cast<std::uint8_t>(number));
    case Ply_type::INT16:
      return write(static_cast<std::int16_t>(number));
    case Ply_type::UINT16:
      return write(static_cast<std::uint16_t>(number));
    case Ply_type::INT32:
      return write(static_cast<std::int32_t>(number));
    case Ply_type::UINT32:
      return write(static_cast<std::uint32_t>(number));
    case Ply_type::FLOAT:
      return write(static_cast<float>(number));
    case Ply_type::DOUBLE:
      return write(number);
    }
  }

  void write(const Color& color)
  {
    for (const unsigned char channel : color) write(channel);
  }

  void end_element()
  {
    if (m_encoding == Encoding::BINARY) return;
    m_stream << '\n';
    m_is_first = true;
  }

private:
  template <typename Number>
  void write_text(const Number number)
  {
    if (!m_is_first) m_stream << ' ';
    m_is_first = false;
    m_stream.precision(std::numeric_limits<Number>::max_digits10);
    // not as a letter if the type is one of char's
    if constexpr (sizeof(Number) == 1)
      m_stream << static_cast<int>(number);
    else
      m_stream << number;
  }

  std::ostream& m_stream;
  Encoding m_encoding;
  bool m_is_first = true;
};

template <typename Triple>
void write_triple(Ply_writer& writer, const Triple& triple, const Ply_type type)
{
  for (int i = 0; i < 3; ++i) writer.write(triple[i], type);
}

// A property of the input, and its name in the output.
struct Kept_property
{
  const Property* property;
  std::string name;
};

// The properties of the input but for coordinates and normals. What has a name of ours gets one before it, unless it is of
// an earlier run of ours.
std::vector<Kept_property> kept_properties(const std::vector<Property>& properties,
                                           const bool are_of_earlier_run)
{
  const std::set<std::string> triples = {"x",  "y",        "z",        "nx",      "ny",
                                         "nz", "normal_x", "normal_y", "normal_z"};
  std::set<std::string> names = {"red", "green", "blue", "alpha", "label", "quality"};
  const std::set<std::string> ours = names;
  names.insert(triples.begin(), triples.end());
  std::set<std::string> given;
  for (const Property& property : properties) given.insert(property.name);
  std::vector<Kept_property> result;
  for (const Property& property : properties)
  {
    std::string name = property.name;
    if (triples.count(name) != 0 || (are_of_earlier_run && ours.count(name) != 0)) continue;
    while (names.count(name) != 0 || (name != property.name && given.count(name) != 0))
      name = "input_" + name;
    names.insert(name);
    result.push_back({&property, name});
  }
  return result;
}

void write_kept(Ply_writer& writer, const std::vector<Kept_property>& properties,
                const std::size_t i)
{
  for (const auto& [property, name] : properties)
  {
    const Ply_type type = ply_type(property->type);
    if (!property->is_list())
    {
      writer.write(property->values[i], type);
      continue;
    }
    const std::size_t first = property->first[i], last = property->first[i + 1];
    writer.write(static_cast<double>(last - first), ply_type(property->list_size_type));
    for (std::size_t k = first; k < last; ++k) writer.write(property->values[k], type);
  }
}

void declare_part_properties(std::ostream& out, const std::vector<Kept_property>& kept)
{
  for (const auto& [property, name] : kept)
    out << "property " << (property->is_list() ? "list " + property->list_size_type + ' ' : "")
        << property->type << ' ' << name << '\n';
  out << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property int label\nproperty float quality\n";
}

// A label of -1 stands for none: a point of a mesh that no face has.
void write_part(Ply_writer& writer, const Parts& parts, const int label, const double quality)
{
  writer.write(label < 0 ? Color{128, 128, 128} : parts.colors[static_cast<std::size_t>(label)]);
  writer.write(static_cast<std::int32_t>(label));
  writer.write(static_cast<float>(quality));
  writer.end_element();
}

// For each point of a mesh a face of the label that most of its faces have, the first such; for a
// point without faces the number of faces.
std::vector<std::size_t> faces_of_points(const Shape& shape, const std::vector<int>& labels)
{
  std::vector<std::vector<std::size_t>> faces(shape.points.size());
  for (std::size_t i = 0; i < shape.polygons.size(); ++i)
    for (const std::size_t corner : shape.polygons[i]) faces[corner].push_back(i);

  std::vector<std::size_t> result(shape.points.size(), shape.polygons.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    std::map<int, std::size_t> counts;
    for (const std::size_t face : faces[i]) ++counts[labels[face]];
    std::size_t best = 0;
    for (const std::size_t face : faces[i])
      if (counts[labels[face]] > best)
      {
        best = counts[labels[face]];
        result[i] = face;
      }
  }
  return result;
}

void write_points(std::ostream& out, Ply_writer& writer, const Shape& shape, const Parts& parts,
                  const std::vector<Kept_property>& kept)
{
  const Ply_type type = type_of_coordinates(shape.points);
  const Ply_type normal_type = type_of_coordinates(shape.normals);
  const std::vector<std::size_t> faces =
      shape.is_mesh() ? faces_of_points(shape, parts.labels) : std::vector<std::size_t>();
  for (std::size_t i = 0; i < shape.points.size() && out; ++i)
  {
    const std::size_t element = shape.is_mesh() ? faces[i] : i;
    const bool is_isolated = element == parts.labels.size();
    write_triple(writer, shape.points[i], type);
    if (!shape.normals.empty()) write_triple(writer, shape.normals[i], normal_type);
    write_kept(writer, kept, i);
    write_part(writer, parts, is_isolated ? -1 : parts.labels[element],
               is_isolated ? 0. : parts.quality[element]);
  }
}

bool has_large_polygon(const Shape& shape)
{
  return std::any_of(shape.polygons.begin(), shape.polygons.end(),
                     [](const std::vector<std::size_t>& p) { return p.size() > 255; });
}

void write_faces(std::ostream& out, Ply_writer& writer, const Shape& shape, const Parts& parts,
                 const std::vector<Kept_property>& kept)
{
  const Ply_type size_type = has_large_polygon(shape) ? Ply_type::INT32 : Ply_type::UINT8;
  for (std::size_t i = 0; i < shape.polygons.size() && out; ++i)
  {
    writer.write(static_cast<double>(shape.polygons[i].size()), size_type);
    for (const std::size_t corner : shape.polygons[i])
      writer.write(static_cast<std::int32_t>(corner));
    write_kept(writer, kept, i);
    write_part(writer, parts, parts.labels[i], parts.quality[i]);
  }
}

// What the numbers of the properties of those names stand for, and the files of the materials: PLY has no other
// place.
void write_words(std::ostream& out, const Shape& shape)
{
  for (const std::string& file : shape.material_files) out << "comment mtllib " << file << '\n';
  for (const Face_words& kind : shape.face_words)
    for (std::size_t i = 0; i < kind.words.size(); ++i)
      out << "comment " << kind.name << ' ' << i << ' ' << kind.words[i] << '\n';
}

void declare_coordinates(std::ostream& out, const Ply_type type, const std::string& prefix)
{
  for (const char axis : {'x', 'y', 'z'})
    out << "property " << ply_type_name(type) << ' ' << prefix << axis << '\n';
}

} // namespace
} // namespace internal

void write_parts(std::ostream& out, const Shape& shape, const Parts& parts, const Encoding encoding)
{
  const auto of_points = internal::kept_properties(shape.point_properties, shape.is_of_parts);
  const auto of_faces = internal::kept_properties(shape.face_properties, shape.is_of_parts);
  // before anything is written: a file that can't be flushed for another locale is of no use after
  out.imbue(std::locale::classic());
  out << "ply\nformat " << (encoding == Encoding::ASCII ? "ascii" : "binary_little_endian")
      << " 1.0\ncomment " << comment_of_parts << '\n';
  internal::write_words(out, shape);
  out << "element vertex " << shape.points.size() << '\n';
  internal::declare_coordinates(out, internal::type_of_coordinates(shape.points), "");
  if (!shape.normals.empty())
    internal::declare_coordinates(out, internal::type_of_coordinates(shape.normals), "n");
  internal::declare_part_properties(out, of_points);
  if (shape.is_mesh())
  {
    out << "element face " << shape.polygons.size() << "\nproperty list "
        << (internal::has_large_polygon(shape) ? "int" : "uchar") << " int vertex_indices\n";
    internal::declare_part_properties(out, of_faces);
  }
  out << "end_header\n";
  internal::Ply_writer writer(out, encoding);
  internal::write_points(out, writer, shape, parts, of_points);
  internal::write_faces(out, writer, shape, parts, of_faces);
}

std::string renamed_properties(const Shape& shape)
{
  std::set<std::string> renamed;
  for (const std::vector<Property>* properties : {&shape.point_properties, &shape.face_properties})
    for (const auto& [property, name] : internal::kept_properties(*properties, shape.is_of_parts))
      if (name != property->name) renamed.insert(property->name + " as " + name);
  std::string list;
  for (const std::string& words : renamed) list += (list.empty() ? "" : ", ") + words;
  return list;
}

bool is_written_by_us(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string first, format, comment;
  if (!std::getline(file, first)) return false;
  if (first == std::string("# ") + comment_of_parts) return true;
  return first == "ply" && std::getline(file, format) && std::getline(file, comment) &&
         comment == std::string("comment ") + comment_of_parts;
}

void write_labels(std::ostream& out, const std::vector<int>& labels)
{
  for (const int label : labels) out << label << '\n';
}

} // namespace Shape_io
