// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SHAPE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SHAPE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// What is read from a shape's file, with all that is needed to write it back.

namespace Shape_io {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

// Thrown when a file can't be read or written. The message is one line with cause and remedy.
class File_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// A line of the header that marks our own files.
constexpr const char* comment_of_parts = "parts of a weakly convex segmentation";

// Further numbers of each point or face, such as an intensity. A double holds every number that a
// PLY property can have, so nothing is lost.
struct Property
{
  std::string name;
  std::string type; // as in the header of a PLY file: "uchar", "float", ...
  std::vector<double> values;
  // Only of lists, such as texture coordinates: the type of their sizes, and where the values of each
  // element begin, with the end of the last.
  std::string list_size_type = {};
  std::vector<std::size_t> first = {};

  bool is_list() const { return !list_size_type.empty(); }
};

// Words that hold for faces, such as the name of a material: the face property of that name has the number of a
// word for each face, or -1.
struct Face_words
{
  std::string name; // "material", "object", "group", "smoothing"
  std::vector<std::string> words;
};

// Face properties that are lists with as many numbers for each corner, or with none for a face that has none.
constexpr const char* name_of_texture_coordinates =
    "texcoord"; // 2 a corner, as other programs write it
constexpr const char* name_of_corner_normals = "corner_normal"; // 3 a corner

// A mesh (a soup of polygons) or, when there are no polygons, a cloud of points.
struct Shape
{
  std::vector<Point> points;
  std::vector<Vector> normals; // empty, or one a point
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<Property> point_properties;
  std::vector<Property> face_properties;
  std::vector<Face_words> face_words;
  std::vector<std::string> material_files; // of OBJ: what its lines `mtllib` name
  std::vector<std::string> notes; // what of the file was not taken as one might expect, a line each
  bool is_of_parts = false;       // with labels and colors of an earlier run
  bool is_textured_obj = false;   // of an OBJ file with texture coordinates or materials
  bool is_organized = false;      // the points are the pixels of a depth image
  bool has_gaps_at_origin = false; // a point at the origin is a pixel without a measurement

  bool is_mesh() const { return !polygons.empty(); }
  // The elements are what gets a label: the faces of a mesh, the points of a cloud.
  std::size_t number_of_elements() const { return is_mesh() ? polygons.size() : points.size(); }
  const char* element_name() const { return is_mesh() ? "faces" : "points"; }
};

// Depth cameras keep a place for each pixel: where nothing was measured, all coordinates are NaN or,
// of some, 0.
enum class Gaps
{
  REFUSED,
  ALLOWED
};

template <typename Triple>
bool is_gap(const Triple& t)
{
  return std::isnan(t.x()) && std::isnan(t.y()) && std::isnan(t.z());
}

inline bool is_gap(const Shape& shape, const Point& p)
{
  return is_gap(p) || (shape.has_gaps_at_origin && p == CGAL::ORIGIN);
}

// Two pixels can't measure the same point: where several of a depth image are at the origin, which is
// where the camera itself is, nothing was measured. A program that writes NaN does not mean that.
inline bool has_repeated_origin(const std::vector<Point>& points)
{
  return std::count(points.begin(), points.end(), Point(CGAL::ORIGIN)) > 1 &&
         std::none_of(points.begin(), points.end(), is_gap<Point>);
}

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SHAPE_H
