// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_FUZZ_READERS_H
#define TEST_FUZZ_READERS_H

#include "../pcd_files.h"
#include "io/gunzip.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_pcd.h"
#include "io/read_ply.h"
#include "io/read_scene.h"
#include "io/read_stl.h"
#include "io/read_xyz.h"
#include "io/separate_parts.h"
#include "io/shape_io.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What bytes say as a file of each format, and the one thing that fuzzers and the bounded replay do
// with it: it is read or refused, and what was read is the same after it was written.

namespace Fuzz_readers {

using Shape_io::Gaps;
using Shape_io::Shape;

inline void require(const bool holds)
{
  if (!holds) std::abort();
}

/// Text of floats has the digits that make the same float again, not the same double.
inline bool is_same(const double a, const double b, const bool as_float)
{
  return a == b || (as_float && static_cast<float>(a) == static_cast<float>(b));
}

template <typename Triple>
bool are_equal(const std::vector<Triple>& a, const std::vector<Triple>& b, const bool is_text)
{
  const bool as_float =
      is_text && Shape_io::internal::type_of_coordinates(a) == Shape_io::internal::Ply_type::FLOAT;
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!is_same(a[i][c], b[i][c], as_float) &&
          !(Shape_io::is_gap(a[i]) && Shape_io::is_gap(b[i])))
        return false;
  return true;
}

/// reads as `read_shape()` does.
/// \returns false if the bytes are refused
inline bool read(const Shape_io::internal::Reader reader, const std::string& bytes, Shape& shape)
{
  namespace IO = Shape_io::internal;
  try
  {
    reader(bytes, shape);
    IO::drop_missing_normals(shape);
    IO::check_shape(shape, Gaps::ALLOWED);
  }
  catch (const std::bad_alloc&)
  {
    std::abort(); // small files ask for little memory
  }
  catch (const std::length_error&)
  {
    std::abort();
  }
  catch (const std::exception& error)
  {
    require(std::string(error.what()).size() > 10);
    return false;
  }
  return true;
}

inline void write_and_read(const Shape& shape)
{
  Shape_io::Parts parts;
  parts.labels.assign(shape.number_of_elements(), 0);
  if (shape.number_of_elements() > 1) parts.labels[0] = shape.is_mesh() ? 1 : -1;
  parts.quality.assign(shape.number_of_elements(), 1.);
  parts.colors.assign(2, {1, 2, 3});
  for (const auto encoding : {Shape_io::Encoding::ASCII, Shape_io::Encoding::BINARY})
  {
    std::ostringstream out;
    Shape_io::write_parts(out, shape, parts, encoding);
    Shape again;
    require(read(Shape_io::internal::read_ply, out.str(), again));
    const bool is_text = encoding == Shape_io::Encoding::ASCII;
    require(are_equal(shape.points, again.points, is_text));
    require(are_equal(shape.normals, again.normals, is_text));
    require(shape.polygons == again.polygons);
  }
  std::ostringstream out;
  Shape_io::write_obj_groups(out, shape, parts.labels, 2);
  Shape again;
  if (read(Shape_io::internal::read_obj, out.str(), again))
    require(are_equal(shape.points, again.points, false) &&
            again.polygons.size() == shape.polygons.size());
  else // OBJ has no integers of that size, and no gaps in meshes: nothing else may fail
    std::abort();
}

constexpr std::size_t number_of_kinds = 9;

/// By the first bytes, but none of scenes: assimp crashes on what is damaged, and is tried in a process of its own
/// (test_more_formats).
inline Shape_io::internal::Reader reader_of_any(const std::string& bytes)
{
  namespace IO = Shape_io::internal;
  const IO::Reader reader = IO::reader_for_bytes(bytes);
  return reader == IO::read_glb || reader == IO::read_3mf ? IO::read_stl : reader;
}

inline void read_compressed(const std::string& bytes, Shape& shape)
{
  const std::string all = Shape_io::internal::gunzip(bytes);
  reader_of_any(all)(all, shape);
}

/// the first byte tells the format, the others are the file.
/// \returns whether the file was read
inline bool run(const std::uint8_t* data, const std::size_t size)
{
  namespace IO = Shape_io::internal;
  if (size == 0) return false;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (bytes.empty()) return false;
  const IO::Reader readers[number_of_kinds] = {IO::read_off, IO::read_ply,         IO::read_obj,
                                               IO::read_stl, IO::read_pcd,         IO::read_xyz,
                                               IO::read_pts, reader_of_any(bytes), read_compressed};
  Shape shape;
  if (!read(readers[data[0] % number_of_kinds], bytes, shape)) return false;
  write_and_read(shape);
  return true;
}

/// small sound files of each kind, each with the byte of its format in front
inline std::vector<std::string> seeds()
{
  const std::string triangle = "0 0 0\n1 0 0\n0 1 0.5\n";
  const std::string ply =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar q\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property short s\nproperty list uchar uchar t\nend_header\n";
  std::string binary = "ply\nformat binary_little_endian 1.0\n" + ply;
  for (int i = 0; i < 3; ++i)
  {
    for (const float f : {float(i), float(i * i), 0.5f}) Pcd_files::append(binary, f);
    binary += '\7';
  }
  std::string corners(1, '\3');
  for (int i = 0; i < 3; ++i) Pcd_files::append(corners, i);
  std::string stl(80, 'x');
  Pcd_files::append(stl, 1);
  for (int i = 0; i < 12; ++i) Pcd_files::append(stl, float(i * i));
  std::string big = "ply\nformat binary_big_endian 1.0\n" + ply;
  big += binary.substr(binary.find("end_header\n") + 11) +
         std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13);
  const auto of_kind = [](const char kind, const std::string& bytes) { return kind + bytes; };
  std::vector<std::string> result = {
      of_kind(0, "OFF\n3 1 0\n" + triangle + "3 0 1 2\n"),
      of_kind(0, "# c\nCOFF 3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2 9 9 9\n"),
      of_kind(0, "NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0 0 1 0\n"),
      of_kind(1, "ply\nformat ascii 1.0\ncomment c\n" + ply +
                     "0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2 -7 2 8 9\n"),
      of_kind(1, binary + corners + std::string("\7\0\1\5", 4)),
      of_kind(1, big + std::string("\7\0\1\5", 4)),
      of_kind(2, "# c\nv 0 0 0\nv 1 0 0 1\nvn 0 0 1\nv 0 1 0\nvt 1 0\ng a\nf 1/1/1 2//1 -1\nf 1 2 "
                 "\\\n3\n"),
      of_kind(2, "mtllib a.mtl\nv 0 0 0 1 0 0.5\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nvt 1 0 0.5\no b\ns "
                 "1\nusemtl a #1\n"
                 "f 1/1/1 2/-1/1 3/1/1\nusemtl\ng c d\nf 1//1 2//1 3//1\n"),
      of_kind(2, "v 0 0 0\nv 1 0 0\nvn 0 0 1\nvn 0 1 0\n"), of_kind(3, stl + std::string(2, '\0')),
      of_kind(3,
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
              "endloop\nendfacet\nendsolid a\n"),
      of_kind(5, "2\n0 0 0 0 0 1 9\n1 0 0 0 1 0 7\n"),
      of_kind(5, "x,y,z,intensity\n0,0,0,1\nnan,nan,nan,2\n"),
      of_kind(6, "2\n0 0 0 -12 1 2 3\n0 0 1 5 1 2 3\n"),
      // what the fuzzer found: twice normals, the first of them none
      of_kind(4, "FIELDS x y z normal_x normal_y normal_z normal_x normal_y normal_z\nPOINTS 1\n"
                 "DATA ascii\n1 2 3 0 0 0 0 0 1\n"),
      of_kind(0, "OFF\n3 1 0\n" + triangle + "3 0 1 2 -31 -31 -31\n"),
      of_kind(7, "//X Y Z R G B\n2\n0 0 0 1 2 3\n1 2 3 4 5 6\n")};
  if (Shape_io::internal::can_gunzip()) // "1 2 3" and a line end, stored as it is
    result.push_back(of_kind(8, std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff\1\6\0\xf9\xff"
                                            "1 2 3\n\x4b\xa0\xf4\xc9\6\0\0\0",
                                            29)));
  for (const std::string encoding : {"ascii", "binary", "binary_compressed"})
    result.push_back(of_kind(4, pcd_file(encoding)));
  return result;
}

} // namespace Fuzz_readers

#endif // TEST_FUZZ_READERS_H
