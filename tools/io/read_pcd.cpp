// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_pcd.h"

#include "io/ply_cursor.h"
#include "io/read_ply.h"
#include "io/text_lines.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

struct Pcd_field
{
  std::string name;
  std::size_t size = 4;
  char type = 'F';
  std::size_t count = 1;
};

struct Pcd_header
{
  std::vector<Pcd_field> fields;
  std::size_t width = 0, height = 1, points = 0;
  bool has_points = false;
  std::string data;         // "ascii", "binary" or "binary_compressed"
  std::size_t position = 0; // of the first point
};

std::size_t pcd_count(const std::string_view word, const std::size_t most)
{
  const double number = number_of(word);
  if (!(number >= 0. && number <= static_cast<double>(most)) ||
      number != static_cast<double>(static_cast<std::size_t>(number)))
    throw std::runtime_error("its header has the number '" + shown(word) +
                             "', more than the file can hold; copy or export it again");
  return static_cast<std::size_t>(number);
}

void take_pcd_line(const std::vector<std::string_view>& words, const std::size_t most,
                   Pcd_header& header)
{
  const std::string_view key = words[0];
  const bool is_of_fields = key == "SIZE" || key == "TYPE" || key == "COUNT";
  if (words.size() < 2 || (is_of_fields && words.size() != header.fields.size() + 1))
    throw std::runtime_error("its header lacks a word after '" + shown(key) +
                             "'; export the cloud again");
  for (std::size_t i = 1; i < words.size(); ++i)
    if (key == "FIELDS" || key == "COLUMNS")
      header.fields.push_back({std::string(words[i])});
    else if (key == "SIZE")
      header.fields[i - 1].size = pcd_count(words[i], 8);
    else if (key == "TYPE")
      header.fields[i - 1].type = words[i][0];
    else if (key == "COUNT")
      header.fields[i - 1].count = pcd_count(words[i], 10000);
  if (key == "WIDTH") header.width = pcd_count(words[1], most);
  if (key == "HEIGHT") header.height = pcd_count(words[1], most);
  if (key == "POINTS") header.points = pcd_count(words[1], most);
  if (key == "POINTS") header.has_points = true;
  if (key == "DATA") header.data = std::string(words[1]);
}

Pcd_header read_pcd_header(const std::string& bytes)
{
  // compressed points may take less than a byte
  constexpr std::size_t most_points_per_byte = 300;
  Pcd_header header;
  while (header.data.empty())
  {
    const std::size_t end = bytes.find('\n', header.position);
    if (end == std::string::npos)
      throw std::runtime_error("its header has no line DATA; copy or export it again");
    Text_lines line(std::string_view(bytes).substr(header.position, end - header.position));
    header.position = end + 1;
    if (line.next()) take_pcd_line(line.words(), most_points_per_byte * bytes.size(), header);
  }
  if (!header.has_points) header.points = header.width * header.height;
  return header;
}

// What libraries know as LZF: runs of literal bytes, and copies of what came before.
std::string expand_lzf(const char* from, const std::size_t size, const std::size_t expanded)
{
  const auto fail = []
  { throw std::runtime_error("its compressed points are damaged; copy or export it again"); };
  std::string result;
  result.reserve(expanded);
  for (const char* const end = from + size; from != end;)
  {
    std::size_t control = static_cast<unsigned char>(*from++);
    const auto left = [&] { return static_cast<std::size_t>(end - from); };
    if (control < 32)
    {
      if (left() < control + 1) fail();
      result.append(from, control + 1);
      from += control + 1;
    }
    else
    {
      std::size_t length = control >> 5;
      if (left() < (length == 7 ? 2u : 1u)) fail();
      if (length == 7) length += static_cast<unsigned char>(*from++);
      const std::size_t back = ((control & 31) << 8) + static_cast<unsigned char>(*from++) + 1;
      if (back > result.size()) fail();
      for (std::size_t i = 0; i < length + 2; ++i) result += result[result.size() - back];
    }
    if (result.size() > expanded) fail();
  }
  if (result.size() != expanded) fail();
  return result;
}

// A column of numbers of a file, and how they are stored there.
struct Pcd_column
{
  Property property;
  Ply_type type = Ply_type::FLOAT;
  bool is_64_bit_integer = false, is_padding = false, is_color = false;
};

Ply_type pcd_type(const Pcd_field& field)
{
  const std::string sizes = "1248";
  const std::size_t k = sizes.find(static_cast<char>('0' + field.size));
  if (field.type == 'F' && (field.size == 4 || field.size == 8))
    return field.size == 4 ? Ply_type::FLOAT : Ply_type::DOUBLE;
  if ((field.type != 'I' && field.type != 'U') || k == std::string::npos)
    throw std::runtime_error("its field '" + shown(field.name) +
                             "' has an unknown type or size; use F, I "
                             "or U of 1, 2, 4 or 8 bytes");
  if (field.size == 8) return Ply_type::DOUBLE;
  return static_cast<Ply_type>(2 * static_cast<int>(k) + (field.type == 'U' ? 1 : 0));
}

std::vector<Pcd_column> pcd_columns(const Pcd_header& header)
{
  constexpr std::size_t most_columns = 10000;
  std::vector<Pcd_column> columns;
  for (const Pcd_field& field : header.fields)
    for (std::size_t i = 0; i < field.count; ++i)
    {
      if (columns.size() == most_columns)
        throw std::runtime_error("it tells of more than 10000 numbers a point; export it again");
      Pcd_column column;
      column.type = pcd_type(field);
      column.is_64_bit_integer = field.size == 8 && field.type != 'F';
      column.is_padding = field.name == "_";
      // colors lie in the bits of a float or integer
      column.is_color = field.size == 4 && (field.name == "rgb" || field.name == "rgba");
      column.property.name = field.count == 1 ? field.name : field.name + "_" + std::to_string(i);
      column.property.type = ply_type_name(column.is_color ? Ply_type::UINT32 : column.type);
      columns.push_back(std::move(column));
    }
  return columns;
}

// Text has a color as a whole number or, from old programs, as the tiny float of the same bits.
double color_in_text(const double number)
{
  const float packed = static_cast<float>(number);
  if (!(std::abs(packed) < 1.f))
    return number >= 0. && number < 4294967296. ? std::floor(number) : 0.;
  std::uint32_t bits;
  std::memcpy(&bits, &packed, sizeof bits);
  return bits;
}

double pcd_number(Ply_cursor& cursor, const Pcd_column& column, const bool is_text)
{
  if (is_text)
    return column.is_color ? color_in_text(cursor.number(Ply_type::DOUBLE))
                           : cursor.number(column.type);
  if (!column.is_64_bit_integer)
    return cursor.number(column.is_color ? Ply_type::UINT32 : column.type);
  const double low = cursor.number(Ply_type::UINT32);
  return low + 4294967296. * cursor.number(Ply_type::INT32);
}

std::size_t bytes_of_point(const Pcd_header& header)
{
  std::size_t size = 0;
  for (const Pcd_field& field : header.fields) size += field.size * field.count;
  return size;
}

std::string expanded_points(const std::string& bytes, const Pcd_header& header)
{
  Ply_cursor sizes(bytes, header.position, Ply_format::LITTLE_ENDIAN_BINARY);
  const auto packed = static_cast<std::size_t>(sizes.number(Ply_type::UINT32));
  const auto expanded = static_cast<std::size_t>(sizes.number(Ply_type::UINT32));
  if (packed > sizes.number_of_bytes_left() || expanded > 300 * packed ||
      expanded != header.points * bytes_of_point(header))
    throw std::runtime_error("its compressed points have a wrong size; copy or export it again");
  return expand_lzf(bytes.data() + header.position + 8, packed, expanded);
}

} // namespace

void read_pcd(const std::string& bytes, Shape& shape)
{
  const Pcd_header header = read_pcd_header(bytes);
  const bool is_text = header.data == "ascii", is_compressed = header.data == "binary_compressed";
  if (!is_text && !is_compressed && header.data != "binary")
    throw std::runtime_error("its points are stored as '" + shown(header.data) +
                             "'; use ascii, binary or binary_compressed");
  std::vector<Pcd_column> columns = pcd_columns(header);
  const std::string expanded = is_compressed ? expanded_points(bytes, header) : std::string();
  Ply_cursor cursor(is_compressed ? expanded : bytes, is_compressed ? 0 : header.position,
                    is_text ? Ply_format::ASCII : Ply_format::LITTLE_ENDIAN_BINARY);
  if (header.points * (is_text ? 2 * columns.size() : bytes_of_point(header)) >
      cursor.number_of_bytes_left() + 2)
    throw std::runtime_error("the file ends before its last point; copy or export it again");
  if (is_compressed) // column by column
    for (Pcd_column& column : columns)
      for (std::size_t i = 0; i < header.points; ++i)
        column.property.values.push_back(pcd_number(cursor, column, is_text));
  else
    for (std::size_t i = 0; i < header.points; ++i)
      for (Pcd_column& column : columns)
        column.property.values.push_back(pcd_number(cursor, column, is_text));
  cursor.check_end();
  std::vector<Property> properties;
  for (Pcd_column& column : columns)
    if (!column.is_padding) properties.push_back(std::move(column.property));
  take_ply_points(std::move(properties), shape);
  shape.is_organized = header.width > 1 && header.height > 1;
}

} // namespace internal
} // namespace Shape_io
