// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_PCD_FILES_H
#define TEST_PCD_FILES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

// PCD files as PCL writes them: an organised cloud with a pixel that has no measurement, colors in the
// bits of a float, and bytes of padding.

namespace Pcd_files {

struct Row
{
  std::array<float, 3> position;
  std::uint32_t rgb;
  std::array<float, 3> normal;
  std::uint16_t label;
};

inline std::vector<Row> rows()
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  return {{{0.f, 0.f, 0.f}, 0x010203, {0.f, 0.f, 1.f}, 7},
          {{1.f, 0.f, 0.f}, 0xff332211, {0.f, 1.f, 0.f}, 65535},
          {{nan, nan, nan}, 0, {nan, nan, nan}, 0},
          {{0.f, 1.f, 0.f}, 5, {1.f, 0.f, 0.f}, 3},
          {{0.f, 1.f, 1.f}, 6, {1.f, 0.f, 0.f}, 3},
          {{0.1f, 1.f, 2.f}, 7, {1.f, 0.f, 0.f}, 3}};
}

template <typename Number>
void append(std::string& bytes, const Number number)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

// the numbers of a row, one a field, with three bytes of padding
inline std::vector<std::string> fields(const Row& row)
{
  std::vector<std::string> result(9);
  for (std::size_t i = 0; i < 3; ++i)
  {
    append(result[i], row.position[i]);
    append(result[5 + i], row.normal[i]);
  }
  append(result[3], row.rgb);
  result[4].assign(3, '\0');
  append(result[8], row.label);
  return result;
}

// a plain packer: copies of what came up to 300 bytes before, else literal bytes
inline std::string compressed(const std::string& bytes)
{
  std::string result;
  for (std::size_t i = 0; i < bytes.size();)
  {
    std::size_t best = 0, back = 0;
    for (std::size_t b = 1; b <= 300 && b <= i; ++b)
    {
      std::size_t length = 0;
      while (length < 264 && i + length < bytes.size() &&
             bytes[i + length] == bytes[i + length - b])
        ++length;
      if (length > best) best = length, back = b;
    }
    if (best < 3)
    {
      result += '\0';
      result += bytes[i++];
      continue;
    }
    const std::size_t code = best - 2 < 7 ? best - 2 : 7;
    result += static_cast<char>(code << 5 | (back - 1) >> 8);
    if (code == 7) result += static_cast<char>(best - 9);
    result += static_cast<char>((back - 1) & 255);
    i += best;
  }
  return result;
}

} // namespace Pcd_files

inline std::string pcd_file(const std::string& encoding)
{
  using namespace Pcd_files;
  std::string file = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb _ "
                     "normal_x normal_y normal_z label\nSIZE 4 4 4 4 1 4 4 4 2\n"
                     "TYPE F F F F U F F F U\nCOUNT 1 1 1 1 3 1 1 1 1\nWIDTH 3\nHEIGHT 2\n"
                     "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 6\nDATA " +
                     encoding + "\n";
  std::string points;
  if (encoding == "ascii")
    for (const Row& row : rows())
    {
      float color;
      std::memcpy(&color, &row.rgb, sizeof color);
      std::ostringstream text;
      text.precision(9);
      for (const float p : row.position) text << p << ' ';
      if (row.rgb == 0xff332211)
        text << "4281541137 0 0 0"; // as newer files have it: the bits as a whole number
      else
        text << color << " 0 0 0";
      for (const float n : row.normal) text << ' ' << n;
      text << ' ' << row.label << '\n';
      points += text.str();
    }
  else
  {
    std::vector<std::string> columns(9);
    for (const Row& row : rows())
    {
      const std::vector<std::string> parts = fields(row);
      for (std::size_t f = 0; f < parts.size(); ++f)
        if (encoding == "binary")
          points += parts[f];
        else
          columns[f] += parts[f];
    }
    for (const std::string& column : columns) points += column;
  }
  if (encoding == "binary_compressed")
  {
    const std::string packed = compressed(points);
    append(file, static_cast<std::uint32_t>(packed.size()));
    append(file, static_cast<std::uint32_t>(points.size()));
    points = packed;
  }
  return file + points;
}

#endif // TEST_PCD_FILES_H
