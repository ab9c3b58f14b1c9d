// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SPLIT_FACES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SPLIT_FACES_H

// Splits the faces of a labeled mesh along smooth borders. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/internal/borders/soft_labels.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/welded_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// A point of a face: a weighted mean of up to three corners.
struct Split_point
{
  std::array<Index, 3> corners; ///< points of the input
  std::array<double, 3> weights;
};

struct Split_faces
{
  std::vector<Split_point> points; ///< numbered after those of the input
  Compressed_rows<Index> polygons;
  std::vector<int> labels;    ///< of the polygons
  std::vector<Index> sources; ///< the face that each polygon is, or is a piece of
};

/// Returns triangles of corners, numbered from 0, of a polygon of four or more.
using Triangulate =
    std::function<std::vector<std::array<Index, 3>>(const std::vector<Double3>& corners)>;

/// A border crosses an edge where the labels of its ends have equal shares, and goes through an end if that is near:
/// for the faces on both sides alike, as this depends on nothing else. A face whose corners have one label gets that.
class Face_splitter
{
  using Triangle = std::array<Index, 3>;

public:
  Face_splitter(const std::vector<Double3>& points, const Welded_mesh& mesh,
                const Soft_labels& soft, const Triangulate& triangulate)
    : m_input(points), m_points(points), m_mesh(mesh), m_soft(soft), m_triangulate(triangulate)
  {}

  void add_face(const Index face, const std::vector<Index>& corners, const int own_label)
  {
    m_face = face;
    m_face_label = own_label;
    const int label = label_in_face(corners.front());
    if (std::all_of(corners.begin(), corners.end(),
                    [&](const Index p) { return label_in_face(p) == label; }))
    {
      add_polygon(corners, label);
      return;
    }
    if (corners.size() == 3) return add_triangle({corners[0], corners[1], corners[2]});
    std::vector<Double3> places;
    for (const Index p : corners) places.push_back(m_input[p]);
    for (const Triangle& t : m_triangulate(places))
      add_triangle({corners[t[0]], corners[t[1]], corners[t[2]]});
  }

  Split_faces result;

private:
  Index vertex(const Index point) const { return m_mesh.vertex_of_point[point]; }

  int label_in_face(const Index point) const
  {
    const Index v = vertex(point);
    return m_soft.is_held[v] != 0 ? m_face_label : main_label(m_soft.shares[v]);
  }

  /// splits a triangle into the pieces of its labels.
  void add_triangle(Triangle t)
  {
    std::array<int, 3> label = {label_in_face(t[0]), label_in_face(t[1]), label_in_face(t[2])};
    for (int turn = 0; turn < 2 && label[0] != label[1];
         ++turn) // the third has another, or all have
    {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(label.begin(), label.begin() + 1, label.end());
    }
    const auto [a, b, c] = t;
    if (label[0] == label[1] && label[1] == label[2]) return add_piece({a, b, c}, label[0]);
    const Index bc = crossing(b, c), ca = crossing(c, a);
    if (label[0] == label[1])
    {
      add_piece({a, b, bc, ca}, label[0]);
      add_piece({bc, c, ca}, label[2]);
      return;
    }
    const Index ab = crossing(a, b);
    const Index inner = meeting(t, {ab, bc, ca});
    add_piece({a, ab, inner, ca}, label[0]);
    add_piece({b, bc, inner, ab}, label[1]);
    add_piece({c, ca, inner, bc}, label[2]);
  }

  /// returns the point where the border crosses an edge between corners of different labels, which may be an end.
  Index crossing(const Index p, const Index q)
  {
    if (vertex(p) > vertex(q)) return crossing(q, p);
    const double share = share_of_crossing(vertex(p), vertex(q));
    constexpr double near = 0.1; // of the edge: nearer to an end there would be slivers
    if (share < near) return p;
    if (share > 1. - near) return q;
    const auto [at, is_new] = m_crossings.emplace(std::make_pair(p, q), next_point());
    if (is_new) add_point({{p, q, q}, {1. - share, share, 0.}});
    return at->second;
  }

  /// returns how far along the edge from one vertex to another both labels have equal shares.
  double share_of_crossing(const Index v, const Index w) const
  {
    const Shares &at_v = m_soft.shares[v], &at_w = m_soft.shares[w];
    const int label_of_v = main_label(at_v), label_of_w = main_label(at_w);
    if (m_soft.is_held[v] != 0 && share_of(at_v, label_of_w) > 0.) return 0.;
    if (m_soft.is_held[w] != 0 && share_of(at_w, label_of_v) > 0.) return 1.;
    const double lead_of_v = share_of(at_v, label_of_v) - share_of(at_v, label_of_w);
    const double lead_of_w = share_of(at_w, label_of_w) - share_of(at_w, label_of_v);
    const double sum = lead_of_v + lead_of_w;
    return sum > 0. ? lead_of_v / sum : 0.5;
  }

  /// returns the point where three labels meet: a corner if two borders end there.
  Index meeting(const Triangle& t, const Triangle& crossings)
  {
    for (int i = 0; i < 3; ++i)
      if (crossings[i] == crossings[(i + 1) % 3]) return crossings[i];
    std::array<double, 3> weights = {0., 0., 0.};
    for (const Index crossing : crossings)
      for (int i = 0; i < 3; ++i) weights[i] += weight_of_corner(t[i], crossing) / 3.;
    add_point({t, weights});
    return next_point() - 1;
  }

  double weight_of_corner(const Index corner, const Index point) const
  {
    if (point < m_input.size()) return point == corner ? 1. : 0.;
    const Split_point& split = result.points[point - m_input.size()];
    return split.corners[0] == corner ? split.weights[0]
                                      : (split.corners[1] == corner ? split.weights[1] : 0.);
  }

  Index next_point() const { return static_cast<Index>(m_points.size()); }

  void add_point(const Split_point& point)
  {
    Double3 place;
    for (int i = 0; i < 3; ++i) place += point.weights[i] * m_input[point.corners[i]];
    m_points.push_back(place);
    result.points.push_back(point);
  }

  /// adds a piece of up to four corners, of which neighbors may be the same.
  void add_piece(std::vector<Index> corners, const int label)
  {
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) return;
    if (corners.size() == 3) return add_polygon(corners, label);
    // of the two ways to halve it, the one without a sliver
    const auto halves = [&](const int i)
    {
      const Index a = corners[i], b = corners[i + 1], c = corners[i + 2], d = corners[(i + 3) % 4];
      return std::make_pair(std::vector<Index>{a, b, c}, std::vector<Index>{a, c, d});
    };
    const auto smaller = [&](const auto& pair)
    { return (std::min)(area(pair.first), area(pair.second)); };
    const auto pair = smaller(halves(0)) >= smaller(halves(1)) ? halves(0) : halves(1);
    add_polygon(pair.first, label);
    add_polygon(pair.second, label);
  }

  double area(const std::vector<Index>& triangle) const
  {
    return length(
        twice_area({m_points[triangle[0]], m_points[triangle[1]], m_points[triangle[2]]}));
  }

  void add_polygon(const std::vector<Index>& corners, const int label)
  {
    auto& entries = result.polygons.entries;
    entries.insert(entries.end(), corners.begin(), corners.end());
    result.polygons.end_row();
    result.labels.push_back(label);
    result.sources.push_back(m_face);
  }

  const std::vector<Double3>& m_input;
  std::vector<Double3> m_points; ///< with those of the result
  const Welded_mesh& m_mesh;
  const Soft_labels& m_soft;
  const Triangulate& m_triangulate;
  std::map<std::pair<Index, Index>, Index> m_crossings; ///< by the ends of the edge
  Index m_face = 0;
  int m_face_label = 0;
};

/// returns the labels that have lost a fifth of their area or more by the split.
inline std::set<int> shrunken_labels(const Welded_mesh& mesh, const std::vector<int>& labels,
                                     const std::vector<Double3>& points, const Split_faces& split)
{
  constexpr double most = 0.2;
  const auto place = [&](const Index p)
  {
    if (p < points.size()) return points[p];
    const Split_point& own = split.points[p - points.size()];
    Double3 sum;
    for (int i = 0; i < 3; ++i) sum += own.weights[i] * points[own.corners[i]];
    return sum;
  };
  std::map<int, std::array<double, 2>> areas;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    areas[labels[f]][0] += length(twice_area(corners_of(mesh, f)));
  for (std::size_t i = 0; i < split.labels.size(); ++i)
  {
    std::vector<Double3> corners;
    for (const Index p : split.polygons[i]) corners.push_back(place(p));
    areas[split.labels[i]][1] += length(twice_area(corners));
  }
  std::set<int> result;
  for (const auto& [label, area] : areas)
    if (area[1] <= (1. - most) * area[0]) result.insert(label);
  return result;
}

/// splits the faces of a mesh along the smoothed borders of their labels, any numbers. Faces that no border crosses
/// stay as they are, others become triangles. Where a label would lose much of its area, as of a single face, its
/// borders stay.
///
/// Complexity: O(n log n) for n corners of faces, for each time that a label would.
inline Split_faces split_faces(const std::vector<Double3>& points,
                               const Compressed_rows<Index>& polygons,
                               const std::vector<int>& labels, const Triangulate& triangulate)
{
  const Welded_mesh mesh = weld(points, polygons);
  std::set<int> kept;
  while (true)
  {
    const Soft_labels soft = soft_labels(mesh, labels, kept);
    Face_splitter splitter(points, mesh, soft, triangulate);
    for (Index f = 0; f < polygons.size(); ++f)
      splitter.add_face(f, {polygons[f].begin(), polygons[f].end()}, labels[f]);
    const std::size_t before = kept.size();
    for (const int label : shrunken_labels(mesh, labels, points, splitter.result))
      kept.insert(label);
    if (kept.size() == before) return std::move(splitter.result);
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SPLIT_FACES_H
