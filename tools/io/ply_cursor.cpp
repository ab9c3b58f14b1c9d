// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/ply_cursor.h"

#include "io/text_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace Shape_io {
namespace internal {

const char* ply_type_name(const Ply_type type)
{
  const char* const names[] = {"char", "uchar", "short", "ushort",
                               "int",  "uint",  "float", "double"};
  return names[static_cast<int>(type)];
}

Ply_type ply_type(const std::string& name)
{
  const char* const long_names[] = {"int8",  "uint8",  "int16",   "uint16",
                                    "int32", "uint32", "float32", "float64"};
  for (int i = 0; i < 8; ++i)
    if (name == long_names[i] || name == ply_type_name(static_cast<Ply_type>(i)))
      return static_cast<Ply_type>(i);
  throw std::runtime_error("its header has the unknown type '" + shown(name) +
                           "'; use char, uchar, short, ushort, int, uint, float or double");
}

bool host_is_big_endian()
{
  const std::uint16_t one = 1;
  unsigned char first_byte;
  std::memcpy(&first_byte, &one, 1);
  return first_byte == 0;
}

Ply_cursor::Ply_cursor(const std::string& bytes, const std::size_t position,
                       const Ply_format format)
  : m_next(bytes.data() + position), m_end(bytes.data() + bytes.size()), m_format(format)
{}

double Ply_cursor::number(const Ply_type type)
{
  if (m_format == Ply_format::ASCII) return checked(text_number(), type);
  switch (type)
  {
  case Ply_type::INT8:
    return binary_number<std::int8_t>();
  case Ply_type::UINT8:
    return binary_number<std::uint8_t>();
  case Ply_type::INT16:
    return binary_number<std::int16_t>();
  case Ply_type::UINT16:
    return binary_number<std::uint16_t>();
  case Ply_type::INT32:
    return binary_number<std::int32_t>();
  case Ply_type::UINT32:
    return binary_number<std::uint32_t>();
  case Ply_type::FLOAT:
    return static_cast<double>(binary_number<float>());
  case Ply_type::DOUBLE:
    break;
  }
  return binary_number<double>();
}

std::size_t Ply_cursor::list_size(const Ply_type type)
{
  const double size = number(type);
  if (!(size >= 0. && size <= static_cast<double>(number_of_bytes_left())) ||
      size != std::floor(size))
    throw Ply_body_error(
        "a list is said to have " + std::to_string(size) +
        " entries, which is none or more than the file holds; export the shape again");
  return static_cast<std::size_t>(size);
}

void Ply_cursor::check_end() const
{
  if (m_format == Ply_format::ASCII && !std::all_of(m_next, m_end, is_space))
    throw Ply_body_error("it holds more than its header tells; export the shape again");
}

void Ply_cursor::ends_early()
{
  throw Ply_body_error("the file ends before its last element; copy or export it again");
}

double Ply_cursor::text_number()
{
  while (m_next != m_end && is_space(*m_next)) ++m_next;
  if (m_next == m_end) ends_early();
  const char* last = m_next;
  while (last != m_end && !is_space(*last)) ++last;
  const std::string_view word(m_next, static_cast<std::size_t>(last - m_next));
  double result = 0.;
  if (!is_number(word, result))
    throw Ply_body_error("'" + shown(word) +
                         "' is not a number; check the file or export the shape again");
  m_next = last;
  return result;
}

bool Ply_cursor::holds(const Ply_type type, const double value)
{
  switch (type)
  {
  case Ply_type::INT8:
    return holds<std::int8_t>(value);
  case Ply_type::UINT8:
    return holds<std::uint8_t>(value);
  case Ply_type::INT16:
    return holds<std::int16_t>(value);
  case Ply_type::UINT16:
    return holds<std::uint16_t>(value);
  case Ply_type::INT32:
    return holds<std::int32_t>(value);
  case Ply_type::UINT32:
    return holds<std::uint32_t>(value);
  default:
    return true;
  }
}

double Ply_cursor::checked(const double value, const Ply_type type)
{
  if (!holds(type, value))
    throw Ply_body_error(std::to_string(value) + " is not a number of type " + ply_type_name(type) +
                         "; check the file or export the shape again");
  return value;
}

} // namespace internal
} // namespace Shape_io
