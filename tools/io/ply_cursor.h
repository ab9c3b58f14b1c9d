// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PLY_CURSOR_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PLY_CURSOR_H

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

// The numbers in the body of a PLY file, one after the other, whatever the encoding.

namespace Shape_io {
namespace internal {

enum class Ply_format
{
  ASCII,
  LITTLE_ENDIAN_BINARY,
  BIG_ENDIAN_BINARY
};

enum class Ply_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT,
  DOUBLE
};

// The common name of a type.
const char* ply_type_name(Ply_type type);

Ply_type ply_type(const std::string& name);

bool host_is_big_endian();

// What is wrong behind the header.
class Ply_body_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class Ply_cursor
{
public:
  Ply_cursor(const std::string& bytes, std::size_t position, Ply_format format);

  std::size_t number_of_bytes_left() const { return static_cast<std::size_t>(m_end - m_next); }

  double number(Ply_type type);

  // The length of a list. No list is longer than what is left of the file, which keeps a broken
  // length from asking for all the memory there is.
  std::size_t list_size(Ply_type type);

  // Throws if there are more numbers in a text: the elements are more than the header says, or their
  // lines have more columns, and then all were read in the wrong places. Binary files may be padded.
  void check_end() const;

private:
  [[noreturn]] static void ends_early();

  template <typename Number>
  Number binary_number()
  {
    if (number_of_bytes_left() < sizeof(Number)) ends_early();
    unsigned char bytes[sizeof(Number)];
    const bool swaps = (m_format == Ply_format::BIG_ENDIAN_BINARY) != host_is_big_endian();
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes[swaps ? sizeof(Number) - 1 - i : i] = static_cast<unsigned char>(m_next[i]);
    m_next += sizeof(Number);
    Number result;
    std::memcpy(&result, bytes, sizeof(Number));
    return result;
  }

  static bool is_space(const char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  double text_number();

  template <typename Integer>
  static bool holds(const double value)
  {
    return value == std::floor(value) &&
           value >= static_cast<double>(std::numeric_limits<Integer>::lowest()) &&
           value <= static_cast<double>((std::numeric_limits<Integer>::max)());
  }

  static bool holds(Ply_type type, double value);

  static double checked(double value, Ply_type type);

  const char* m_next;
  const char* m_end;
  Ply_format m_format;
};

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PLY_CURSOR_H
