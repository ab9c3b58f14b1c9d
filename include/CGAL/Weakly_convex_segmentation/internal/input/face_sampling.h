// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_FACE_SAMPLING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_FACE_SAMPLING_H

// The method works on points that lie about equally dense. One point a face (section 6) does that for
// fine meshes only: a large or long face is cut in thought, and gets a point for each piece.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/raw_shape.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

using Triangle = std::array<Coordinates, 3>;

inline double squared_distance(const Coordinates& a, const Coordinates& b)
{
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/// calls `piece(centroid)` for the pieces of a triangle, halved at its longest edge until no edge is
/// longer than `longest`: the same, in the same order, whatever the order of the corners.
template <typename Piece>
void for_each_piece(Triangle triangle, const double longest, const Piece& piece)
{
  std::sort(triangle.begin(), triangle.end());
  constexpr int most_cuts = 40; // against edges that rounding keeps from getting shorter
  std::vector<std::pair<Triangle, int>> pending = {{triangle, 0}};
  while (!pending.empty())
  {
    const auto [t, cuts] = pending.back();
    pending.pop_back();
    int edge = 0;
    double length = -1.;
    for (int e = 0; e < 3; ++e)
    {
      const double d = squared_distance(t[e], t[(e + 1) % 3]);
      if (d > length) length = d, edge = e;
    }
    Coordinates center;
    if (!(length > longest * longest) || cuts == most_cuts)
    {
      for (int c = 0; c < 3; ++c) center[c] = t[0][c] / 3. + t[1][c] / 3. + t[2][c] / 3.;
      piece(center);
      continue;
    }
    const auto &a = t[edge], &b = t[(edge + 1) % 3], &opposite = t[(edge + 2) % 3];
    for (int c = 0; c < 3; ++c) center[c] = 0.5 * a[c] + 0.5 * b[c];
    pending.push_back({{center, b, opposite}, cuts + 1});
    pending.push_back({{a, center, opposite}, cuts + 1});
  }
}

/// The fan of triangles of one face of `raw`.
template <typename Visit>
void for_each_triangle(const Raw_shape& raw, const std::size_t face, const Visit& visit)
{
  const std::size_t first = raw.first_corner[face];
  for (std::size_t i = first + 1; i + 1 < raw.first_corner[face + 1]; ++i)
    visit(Triangle{raw.corners[first], raw.corners[i], raw.corners[i + 1]});
}

/// returns the longest squared edge of the triangles of a face.
inline double longest_squared_edge(const Raw_shape& raw, const std::size_t face)
{
  double longest = 0.;
  for_each_triangle(raw, face,
                    [&](const Triangle& t)
                    {
                      for (int e = 0; e < 3; ++e)
                        longest = (std::max)(longest, squared_distance(t[e], t[(e + 1) % 3]));
                    });
  return longest;
}

/// The positions of the points of the faces that have more than one: a row each.
struct Face_samples : Compressed_rows<Coordinates>
{
  std::vector<Index> faces; ///< of the rows, ascending
};

/// returns the pieces of all faces with an edge longer than `longest`, unless they are more than
/// `most`: then, none.
inline std::optional<Face_samples> cut_faces(const Raw_shape& raw, const double longest,
                                             const std::size_t most)
{
  Face_samples samples;
  for (std::size_t f = 0; f + 1 < raw.first_corner.size(); ++f)
  {
    const double edge = longest_squared_edge(raw, f);
    if (!(edge > longest * longest)) continue;
    // at least one piece a length, so that hopeless faces are not even begun
    if (std::sqrt(edge) / longest > static_cast<double>(most)) return std::nullopt;
    for_each_triangle(raw, f,
                      [&](const Triangle& t)
                      {
                        if (samples.entries.size() > most) return;
                        for_each_piece(t, longest,
                                       [&](const Coordinates& center)
                                       { samples.entries.push_back(center); });
                      });
    if (samples.entries.size() > most) return std::nullopt;
    samples.faces.push_back(static_cast<Index>(f));
    samples.end_row();
  }
  return samples;
}

/// returns the area of all faces, half the length of their normals.
inline double total_area(const Raw_shape& raw)
{
  double area = 0.;
  for (const auto& n : raw.normals) area += 0.5 * std::hypot(n[0], n[1], n[2]);
  return area;
}

/// The points of each face: the first has the face's own index, the others follow all faces.
class Points_of_faces
{
public:
  Points_of_faces(const std::size_t faces, const Face_samples& samples)
    : m_faces(faces), m_samples(samples), m_rank(faces, none)
  {
    for (std::size_t i = 0; i < samples.faces.size(); ++i)
      m_rank[samples.faces[i]] = static_cast<Index>(i);
  }

  bool has_one(const Index face) const { return m_rank[face] == none; }
  std::vector<Index> operator[](const Index face) const
  {
    std::vector<Index> points = {face};
    if (has_one(face)) return points;
    const std::size_t rank = m_rank[face];
    for (std::size_t s = m_samples.first[rank] + 1; s < m_samples.first[rank + 1]; ++s)
      points.push_back(static_cast<Index>(m_faces + s - rank - 1));
    return points;
  }

private:
  static constexpr Index none = static_cast<Index>(-1);
  std::size_t m_faces;
  const Face_samples& m_samples;
  std::vector<Index> m_rank; ///< of the faces with several points among these
};

/// returns the point of `[first, last)` that is nearest to `p`, and its squared distance.
template <typename Iterator>
std::pair<Index, double> nearest_of(const std::vector<Coordinates>& positions, const Index p,
                                    const Iterator first, const Iterator last)
{
  std::pair<Index, double> nearest = {*first, std::numeric_limits<double>::infinity()};
  for (Iterator q = first; q != last; ++q)
  {
    const double d = squared_distance(positions[p], positions[*q]);
    if (d < nearest.second) nearest = {*q, d};
  }
  return nearest;
}

/// links the samples of a face, and those of faces that share an edge: what the mesh joins is joined,
/// though the nearest neighbors of samples may all lie at one end of a long face.
inline void link_samples(const Raw_shape& raw, const Face_samples& samples, const double longest,
                         Raw_shape& result)
{
  constexpr std::size_t most_pairs = 1000000; // of a link; the nearest neighbors do without it
  constexpr std::size_t most_earlier = 1000;  // of a face; the latest ones are near
  const Points_of_faces points(raw.positions.size(), samples);
  for (const Index face : samples.faces)
  {
    const std::vector<Index> own = points[face];
    for (std::size_t i = 1; i < own.size(); ++i) // a tree: each joins one that is there already
    {
      const auto end = own.begin() + static_cast<std::ptrdiff_t>(i);
      const auto begin = end - static_cast<std::ptrdiff_t>((std::min)(i, most_earlier));
      result.links.push_back({own[i], nearest_of(result.positions, own[i], begin, end).first});
    }
  }
  for (const auto& link : raw.links)
  {
    if (points.has_one(link[0]) && points.has_one(link[1]))
    {
      result.links.push_back(link);
      continue;
    }
    std::vector<Index> few = points[link[0]], many = points[link[1]];
    if (few.size() > many.size()) few.swap(many);
    if (few.size() * many.size() > most_pairs) continue;
    std::array<Index, 2> closest = link;
    double least = std::numeric_limits<double>::infinity();
    for (const Index p : few)
    {
      const auto [q, d] = nearest_of(result.positions, p, many.begin(), many.end());
      if (d <= longest * longest) result.links.push_back({p, q});
      if (d < least) least = d, closest = {p, q};
    }
    if (least > longest * longest) result.links.push_back(closest);
  }
}

/// adds points on the faces that are much longer than usual.
///
/// An edge is too long from `face_sampling_factor` times the square root of the mean area of a face
/// on, or of a four-thousandth of the area. At most `number_of_representatives` points are
/// added; the length grows until that holds. Returns whether `result` was made: no face too long,
/// or no corners known, and the points serve as they are.
inline bool sample_faces(const Raw_shape& raw, const Sampling_parameters& parameters,
                         Raw_shape& result)
{
  constexpr std::size_t fewest_samples = 4000; // meshes of fewer faces count as so many
  const std::size_t faces = raw.positions.size();
  const double area = total_area(raw);
  if (raw.first_corner.size() != faces + 1 || parameters.face_sampling_factor == 0. ||
      !(area > 0.) || !std::isfinite(area))
    return false;
  const double wanted = static_cast<double>((std::max)(faces, fewest_samples));
  double longest = parameters.face_sampling_factor * std::sqrt(area / wanted);
  if (!(longest * longest > 0.) || !std::isfinite(longest * longest)) return false;
  const auto cut = [&] { return cut_faces(raw, longest, parameters.number_of_representatives); };
  std::optional<Face_samples> samples = cut();
  for (int trial = 0; trial < 100 && !samples; ++trial)
  {
    longest *= 1.5;
    samples = cut();
  }
  if (!samples || samples->faces.empty()) return false;

  result.exponent = raw.exponent;
  result.positions = raw.positions;
  result.normals = raw.normals;
  result.solids = raw.solids;
  result.is_far = raw.is_far;
  result.number_of_elements = raw.number_of_elements > 0 ? raw.number_of_elements : faces;
  const auto element = [&raw](const Index f)
  { return raw.element_of.empty() ? f : raw.element_of[f]; };
  for (Index f = 0; f < faces; ++f) result.element_of.push_back(element(f));
  for (std::size_t i = 0; i < samples->size(); ++i)
  {
    const Index f = samples->faces[i];
    const auto own = (*samples)[i];
    result.positions[f] = *own.begin();
    for (const Coordinates* sample = own.begin() + 1; sample != own.end(); ++sample)
    {
      result.positions.push_back(*sample);
      result.normals.push_back(raw.normals[f]);
      result.element_of.push_back(element(f));
      if (!raw.is_far.empty()) result.is_far.push_back(raw.is_far[f]);
      if (!raw.solids.empty()) result.solids.push_back(raw.solids[f]);
    }
  }
  link_samples(raw, *samples, longest, result);
  return true;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_FACE_SAMPLING_H
