// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_WRITE_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_WRITE_PARTS_H

#include "io/part_colors.h"
#include "io/ply_cursor.h"
#include "io/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

// Writing of a shape with its parts.

namespace Shape_io {

enum class Encoding
{
  BINARY,
  ASCII
};

// What is known of the parts.
struct Parts
{
  std::vector<int> labels;     // of each element of the shape
  std::vector<double> quality; // of each element: the convexity rank of its segment
  std::vector<Color> colors;   // of each label
};

namespace internal {

// float where it holds every coordinate, double otherwise: no point moves.
template <typename Triple>
Ply_type type_of_coordinates(const std::vector<Triple>& triples)
{
  const auto is_float = [](const double d)
  { return std::abs(d) <= (std::numeric_limits<float>::max)() && double(float(d)) == d; };
  const bool all = std::all_of(triples.begin(), triples.end(),
                               [&](const Triple& t)
                               { return is_float(t.x()) && is_float(t.y()) && is_float(t.z()); });
  return all ? Ply_type::FLOAT : Ply_type::DOUBLE;
}

} // namespace internal

// Writes the shape as PLY: its points and faces as they were read, each with a color, an int
// `label` and a float `quality`, and all other properties of the input, the words of faces as
// comments. A point of a mesh takes the label that most of its faces have.
void write_parts(std::ostream& out, const Shape& shape, const Parts& parts,
                 Encoding encoding = Encoding::BINARY);

// The properties of the input that write_parts() keeps under another name, as it has one of that name: "label as
// input_label" and so on; empty if there are none.
std::string renamed_properties(const Shape& shape);

// Whether the file is one of the PLY or OBJ files that are written here, by its head.
bool is_written_by_us(const std::string& path);

// Writes one label a line, in the order of the input.
void write_labels(std::ostream& out, const std::vector<int>& labels);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_WRITE_PARTS_H
