// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/write_view.h"

#include <CGAL/bounding_box.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

namespace Segment_shape {
namespace internal {

namespace {

// Words of four bytes, little endian, as base64.
class Base64_writer
{
public:
  explicit Base64_writer(std::ostream& out) : m_out(out) {}

  void write(const std::uint32_t word)
  {
    for (int shift = 0; shift < 32; shift += 8)
    {
      m_bytes[m_count++] = static_cast<unsigned char>(word >> shift);
      if (m_count == 3) flush();
    }
  }

  void write(const float number)
  {
    std::uint32_t word = 0;
    std::memcpy(&word, &number, sizeof word);
    write(word);
  }

  void flush()
  {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (m_count == 0) return;
    const unsigned int bits = m_bytes[0] << 16 | m_bytes[1] << 8 | m_bytes[2];
    char text[4] = {digits[bits >> 18], digits[bits >> 12 & 63], digits[bits >> 6 & 63],
                    digits[bits & 63]};
    std::fill(text + m_count + 1, text + 4, '=');
    m_out.write(text, 4);
    m_bytes = {};
    m_count = 0;
  }

private:
  std::ostream& m_out;
  std::array<unsigned char, 3> m_bytes = {};
  std::size_t m_count = 0;
};

// An element of the page that holds what `write` writes.
template <typename Write>
void write_data(std::ostream& out, const std::string& name, const Write& write)
{
  out << "<script type=\"text/plain\" id=\"data-" << name << "\">";
  Base64_writer writer(out);
  write(writer);
  writer.flush();
  out << "</script>\n";
}

template <typename Triples>
void write_triples(Base64_writer& writer, const Triples& triples, const double scale,
                   const std::array<double, 3>& origin)
{
  for (const auto& t : triples)
    for (int i = 0; i < 3; ++i)
      writer.write(static_cast<float>((t[i] - origin[static_cast<std::size_t>(i)]) * scale));
}

// Moves the shape to the origin and scales its box to a diagonal of 2, before it is rounded to floats.
void write_positions(std::ostream& out, const Shape_io::Shape& shape)
{
  std::vector<Shape_io::Point> points;
  for (const Shape_io::Point& p : shape.points)
    if (!Shape_io::is_gap(shape, p)) points.push_back(p);
  std::array<double, 3> center = {};
  double scale = 1.;
  if (!points.empty())
  {
    const auto box = CGAL::bounding_box(points.begin(), points.end());
    for (int i = 0; i < 3; ++i)
      center[static_cast<std::size_t>(i)] = box.min_coord(i) / 2. + box.max_coord(i) / 2.;
    const double diagonal =
        std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    if (diagonal > 0. && std::isfinite(2. / diagonal)) scale = 2. / diagonal;
  }
  write_data(out, "positions",
             [&](Base64_writer& writer) { write_triples(writer, shape.points, scale, center); });
}

// Polygons are drawn as fans, with the polygon of each triangle if there are others than triangles.
void write_triangles(std::ostream& out, const Shape_io::Shape& shape)
{
  bool has_larger = false;
  write_data(out, "triangles",
             [&](Base64_writer& writer)
             {
               for (const auto& polygon : shape.polygons)
               {
                 has_larger = has_larger || polygon.size() != 3;
                 for (std::size_t i = 2; i < polygon.size(); ++i)
                   for (const std::size_t corner : {polygon[0], polygon[i - 1], polygon[i]})
                     writer.write(static_cast<std::uint32_t>(corner));
               }
             });
  if (!has_larger) return;
  write_data(out, "elements",
             [&](Base64_writer& writer)
             {
               for (std::size_t f = 0; f < shape.polygons.size(); ++f)
                 for (std::size_t i = 2; i < shape.polygons[f].size(); ++i)
                   writer.write(static_cast<std::uint32_t>(f));
             });
}

nlohmann::ordered_json json_of_stage(const View_stage& stage, const Run& run,
                                     const Shape_io::Shape& shape)
{
  static const char digits[] = "0123456789abcdef";
  nlohmann::ordered_json colors = nlohmann::ordered_json::array();
  for (const Shape_io::Color& color : stage.parts.colors)
  {
    std::string text = "#";
    for (const unsigned char c : color) text += {digits[c / 16], digits[c % 16]};
    colors.push_back(text);
  }
  nlohmann::ordered_json result = {
      {"name", stage.name}, {"singular", stage.singular}, {"colors", colors}};
  if (stage.name == "segments") result["parts"] = json_of_segments(run, shape);
  return result;
}

// Names are anything: what is not ASCII is escaped, and < too, which could end the script.
std::string text_within_page(const nlohmann::ordered_json& json)
{
  const std::string text =
      json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  std::string result;
  for (const char c : text)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

} // namespace
} // namespace internal

View_page::View_page(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  m_text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  m_place = m_text.find(mark);
  if (m_place == std::string::npos)
    throw Shape_io::File_error("--view needs the page '" + path +
                               "', which was not made; run scripts/setup.sh view, and then "
                               "cmake --build with --target view");
}

void View_page::write(std::ostream& out, const Options& options, const Shape_io::Shape& shape,
                      const std::vector<View_stage>& stages, const Run& run) const
{
  nlohmann::ordered_json about = {{"name", run.name},
                                  {"kind", shape.is_mesh() ? "mesh" : "cloud"},
                                  {"number_of_points", shape.points.size()},
                                  {"number_of_faces", shape.polygons.size()},
                                  {"preset", options.preset},
                                  {"start", options.stage},
                                  {"stages", nlohmann::ordered_json::array()}};
  for (const View_stage& stage : stages)
    about["stages"].push_back(internal::json_of_stage(stage, run, shape));

  out.write(m_text.data(), static_cast<std::streamsize>(m_place));
  out << "<script type=\"application/json\" id=\"shape\">" << internal::text_within_page(about)
      << "</script>\n";
  write_data(out, shape, stages);
  const std::size_t rest = m_place + std::strlen(mark);
  out.write(m_text.data() + rest, static_cast<std::streamsize>(m_text.size() - rest));
}

void View_page::write_data(std::ostream& out, const Shape_io::Shape& shape,
                           const std::vector<View_stage>& stages)
{
  using internal::Base64_writer;
  internal::write_positions(out, shape);
  if (shape.is_mesh()) internal::write_triangles(out, shape);
  if (!shape.is_mesh() && !shape.normals.empty())
    internal::write_data(out, "normals",
                         [&](Base64_writer& writer)
                         { internal::write_triples(writer, shape.normals, 1., {}); });
  for (const View_stage& stage : stages)
    internal::write_data(out, stage.name,
                         [&](Base64_writer& writer)
                         {
                           for (const int label : stage.parts.labels)
                             writer.write(static_cast<std::uint32_t>(label));
                         });
}

} // namespace Segment_shape
