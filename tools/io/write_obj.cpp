// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_obj.h"

#include "io/separate_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Shape_io {

namespace {

const Property* property_of_name(const std::vector<Property>& properties, const std::string& name)
{
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const Property& p) { return p.name == name; });
  return found == properties.end() ? nullptr : &*found;
}

// The different values at the corners of faces, in the order of the input, and their numbers.
class Corner_table
{
public:
  Corner_table(const Shape& shape, const std::string& name, const std::size_t size)
    : m_shape(shape), m_property(property_of_name(shape.face_properties, name)), m_size(size)
  {
    if (m_property && !m_property->is_list()) m_property = nullptr;
    for (std::size_t face = 0; m_property && face < shape.polygons.size(); ++face)
      if (has(face)) add(face);
  }

  void write(std::ostream& out, const std::string& keyword) const
  {
    for (std::size_t i = 0; i < m_values.size(); ++i)
      out << (i % m_size == 0 ? keyword : "") << ' ' << m_values[i]
          << (i % m_size + 1 == m_size ? "\n" : "");
  }

  bool has(const std::size_t face) const
  {
    return m_property && m_property->first[face + 1] - m_property->first[face] ==
                             m_size * m_shape.polygons[face].size();
  }

  // From 1 on, for a face that has them.
  std::size_t number(const std::size_t face, const std::size_t corner) const
  {
    return m_numbers.at(key(face, corner));
  }

private:
  using Key = std::array<std::uint64_t, 3>; // the bits: NaN is itself, too

  Key key(const std::size_t face, const std::size_t corner) const
  {
    Key result = {};
    std::memcpy(result.data(), &m_property->values[m_property->first[face] + m_size * corner],
                m_size * sizeof(double));
    return result;
  }

  void add(const std::size_t face)
  {
    for (std::size_t corner = 0; corner < m_shape.polygons[face].size(); ++corner)
    {
      if (!m_numbers.emplace(key(face, corner), m_numbers.size() + 1).second) continue;
      const auto first = m_property->values.begin() +
                         static_cast<std::ptrdiff_t>(m_property->first[face] + m_size * corner);
      m_values.insert(m_values.end(), first, first + static_cast<std::ptrdiff_t>(m_size));
    }
  }

  const Shape& m_shape;
  const Property* m_property;
  std::size_t m_size;
  std::map<Key, std::size_t> m_numbers;
  std::vector<double> m_values;
};

// The word of a kind that holds for each face.
class Words_of_faces
{
public:
  Words_of_faces(const Shape& shape, const std::string& name)
    : m_property(property_of_name(shape.face_properties, name))
  {
    for (const Face_words& words : shape.face_words)
      if (words.name == name) m_words = &words.words;
  }

  // Empty: none.
  std::string at(const std::size_t face) const
  {
    if (!m_words || !m_property || m_property->values[face] < 0.) return "";
    return (*m_words)[static_cast<std::size_t>(m_property->values[face])];
  }

private:
  const Property* m_property;
  const std::vector<std::string>* m_words = nullptr;
};

class Obj_face_writer
{
public:
  Obj_face_writer(std::ostream& out, const Shape& shape)
    : m_out(out), m_shape(shape), m_texture_coordinates(shape, name_of_texture_coordinates, 2),
      m_normals(shape, name_of_corner_normals, 3), m_materials(shape, "material"),
      m_objects(shape, "object"), m_groups(shape, "group"), m_smoothing(shape, "smoothing")
  {}

  // Normals of the points have the numbers of these; there are none of corners then.
  void write_tables() const
  {
    m_texture_coordinates.write(m_out, "vt");
    for (const Vector& n : m_shape.normals)
      m_out << "vn " << n.x() << ' ' << n.y() << ' ' << n.z() << '\n';
    if (m_shape.normals.empty()) m_normals.write(m_out, "vn");
  }

  void write_face(const std::string& part, const std::size_t face)
  {
    write_statements(part, face);
    m_out << 'f';
    const bool has_texture = m_texture_coordinates.has(face);
    const bool has_normals = !m_shape.normals.empty() || m_normals.has(face);
    for (std::size_t i = 0; i < m_shape.polygons[face].size(); ++i)
    {
      const std::size_t point = m_shape.polygons[face][i];
      m_out << ' ' << point + 1;
      if (has_texture || has_normals) m_out << '/';
      if (has_texture) m_out << m_texture_coordinates.number(face, i);
      if (has_normals)
        m_out << '/' << (m_shape.normals.empty() ? m_normals.number(face, i) : point + 1);
    }
    m_out << '\n';
  }

private:
  // Those that differ from the ones of the face before.
  void write_statements(const std::string& part, const std::size_t face)
  {
    std::string group = part;
    for (const Words_of_faces* words : {&m_objects, &m_groups})
      if (!words->at(face).empty()) group += ' ' + words->at(face);
    write_statement("g", group, m_group);
    // OBJ can't take a material back: a name that no file of materials has, as other programs use it
    const std::string material = m_materials.at(face);
    write_statement("usemtl", material.empty() && !m_material.empty() ? "None" : material,
                    m_material);
    const std::string smoothing = m_smoothing.at(face);
    write_statement("s", smoothing.empty() && !m_smooth.empty() ? "off" : smoothing, m_smooth);
  }

  void write_statement(const std::string& keyword, const std::string& words, std::string& last)
  {
    if (words == last) return;
    m_out << keyword << ' ' << words << '\n';
    last = words;
  }

  std::ostream& m_out;
  const Shape& m_shape;
  Corner_table m_texture_coordinates, m_normals;
  Words_of_faces m_materials, m_objects, m_groups, m_smoothing;
  std::string m_group, m_material, m_smooth; // of the face before
};

// Red, green and blue from 0 to 1, as OBJ has them behind the coordinates.
class Point_colors
{
public:
  explicit Point_colors(const Shape& shape)
  {
    if (shape.is_of_parts) return; // those of an earlier run's parts
    for (const char* name : {"red", "green", "blue"})
    {
      const Property* const property = property_of_name(shape.point_properties, name);
      if (!property || property->is_list()) return;
      m_channels.push_back(property);
    }
  }

  void write(std::ostream& out, const std::size_t point) const
  {
    if (m_channels.size() < 3 || std::isnan(m_channels[0]->values[point])) return;
    for (const Property* channel : m_channels)
    {
      const bool is_byte = channel->type == "uchar" || channel->type == "uint8";
      out << ' ' << channel->values[point] / (is_byte ? 255. : 1.);
    }
  }

private:
  std::vector<const Property*> m_channels;
};

} // namespace

void write_obj_groups(std::ostream& out, const Shape& shape, const std::vector<int>& labels,
                      const std::size_t number_of_parts, const std::string& kind)
{
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "# " << comment_of_parts << '\n';
  for (const std::string& file : shape.material_files) out << "mtllib " << file << '\n';
  const Point_colors colors(shape);
  for (std::size_t i = 0; i < shape.points.size() && out; ++i)
  {
    const Point& p = shape.points[i];
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z();
    colors.write(out, i);
    out << '\n';
  }
  Obj_face_writer faces(out, shape);
  faces.write_tables();
  const auto elements = elements_of_parts(labels, number_of_parts);
  for (std::size_t label = 0; label < elements.size() && out; ++label)
  {
    const std::string part = kind + "_" + std::to_string(label);
    if (!shape.is_mesh() && !elements[label].empty()) out << "g " << part << '\n';
    for (const std::size_t i : elements[label])
      if (shape.is_mesh())
        faces.write_face(part, i);
      else
        out << "p " << i + 1 << '\n';
  }
  for (std::size_t i = 0; i < shape.polygons.size() && out; ++i)
    if (labels[i] < 0) faces.write_face(kind + "_none", i);
}

} // namespace Shape_io
