// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

// The properties of the input but for those that the output has of its own.
std::vector<const Property*> kept_properties(const std::vector<Property>& properties)
{
  std::set<std::string> names = {"x",     "y",        "z",        "nx",       "ny",
                                 "nz",    "normal_x", "normal_y", "normal_z", "red",
                                 "green", "blue",     "alpha",    "label",    "quality"};
  std::vector<const Property*> result;
  for (const Property& property : properties)
    if (names.insert(property.name).second) result.push_back(&property);
  return result;
}

void write_kept(Ply_writer& writer, const std::vector<const Property*>& properties,
                const std::size_t i)
{
  for (const Property* const property : properties)
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

void declare_part_properties(std::ostream& out, const std::vector<const Property*>& kept)
{
  for (const Property* const property : kept)
    out << "property " << (property->is_list() ? "list " + property->list_size_type + ' ' : "")
        << property->type << ' ' << property->name << '\n';
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
                  const std::vector<const Property*>& kept)
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
                 const std::vector<const Property*>& kept)
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

void declare_coordinates(std::ostream& out, const Ply_type type, const std::string& prefix)
{
  for (const char axis : {'x', 'y', 'z'})
    out << "property " << ply_type_name(type) << ' ' << prefix << axis << '\n';
}

} // namespace
} // namespace internal

void write_parts(std::ostream& out, const Shape& shape, const Parts& parts, const Encoding encoding)
{
  const std::vector<const Property*> of_points = internal::kept_properties(shape.point_properties);
  const std::vector<const Property*> of_faces = internal::kept_properties(shape.face_properties);
  // before anything is written: a file that can't be flushed for another locale is of no use after
  out.imbue(std::locale::classic());
  out << "ply\nformat " << (encoding == Encoding::ASCII ? "ascii" : "binary_little_endian")
      << " 1.0\ncomment " << comment_of_parts << "\nelement vertex " << shape.points.size() << '\n';
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

void write_labels(std::ostream& out, const std::vector<int>& labels)
{
  for (const int label : labels) out << label << '\n';
}

} // namespace Shape_io
