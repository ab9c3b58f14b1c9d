// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_ABSORB_STRIPS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_ABSORB_STRIPS_H

// Segments that are left over between others and that nobody would name: webs between fingers, rims of joints. Each
// set of patches has some, where parts meet; the consensus keeps those on which the sets agree. They are told by
// their outline alone. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/internal/borders/seam_cuts.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/disjoint_sets.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What a segment has in common with another.
struct Common_border
{
  double length = 0., cost = 0.; ///< less where the surface is concave
};

/// The area of a segment and the borders around it.
///
/// Points have ten neighbors and more, at a mean distance s. Where they are spread evenly, each stands for an area
/// of s^2 / 1.6, and 5.6 edges go from one side of a border of length s to the other (measured on random points).
struct Outline
{
  double area = 0., length = 0.;
  double crease_length = 0.;         ///< where the surface is folded, either way
  bool has_inside = false;           ///< whether there are points without a neighbor beyond
  std::map<int, Common_border> with; ///< by the label of the other segment
};

inline Outline outline_of(const Neighbor_graph& graph, const std::vector<int>& labels,
                          const std::vector<Index>& points)
{
  constexpr float fold = radians(35.);
  constexpr double points_of_square = 1.6, edges_of_length = 5.6;
  Outline outline;
  for (const Index i : points)
  {
    const double spacing = graph.spacing[i], of_edge = spacing / edges_of_length;
    outline.area += spacing * spacing / points_of_square;
    const double before = outline.length;
    for (const Neighbor& edge : graph[i])
    {
      if (labels[edge.point] == labels[i]) continue;
      outline.length += of_edge;
      if (std::abs(edge.concavity) > fold) outline.crease_length += of_edge;
      Common_border& border = outline.with[labels[edge.point]];
      border.length += of_edge;
      border.cost += of_edge * border_cost(edge.concavity);
    }
    outline.has_inside = outline.has_inside || outline.length == before;
  }
  return outline;
}

/// Finds the closed lines around a segment.
class Border_loops
{
public:
  Border_loops(const Neighbor_graph& graph, const std::vector<int>& labels,
               const std::vector<Index>& points)
    : m_graph(graph), m_labels(labels)
  {
    for (const Index i : points)
      for (const Neighbor& edge : graph[i])
        if (labels[edge.point] != labels[i])
          m_nodes[{i, labels[edge.point]}] = {}; // numbered below, in order
    int count = 0;
    for (auto& node : m_nodes) node.second = count++;
  }

  /// Points that are neighbors, or have a neighbor beyond in common, are on one line; so are the sides of a point
  /// where two other segments meet. Two lines that come near each other stay two: on a thin body the roots of two
  /// wings do. Where points lie very unevenly, a line may count as several.
  std::size_t count() const
  {
    Disjoint_sets<int> lines(m_nodes.size());
    const auto join = [&](const int node, const Index i, const int beyond)
    {
      const auto other = m_nodes.find({i, beyond});
      if (other != m_nodes.end()) lines.join(node, other->second);
    };
    for (const auto& [node, number] : m_nodes)
    {
      const auto& [i, beyond] = node;
      for (const Neighbor& edge : m_graph[i])
      {
        if (m_labels[edge.point] == m_labels[i]) join(number, edge.point, beyond);
        if (m_labels[edge.point] != beyond) continue;
        for (const Neighbor& next : m_graph[edge.point])
        {
          const int label = m_labels[next.point];
          if (label == m_labels[i])
            join(number, next.point, beyond);
          else if (label != beyond)
            join(number, i, label);
        }
      }
    }
    std::set<int> names;
    for (const auto& node : m_nodes) names.insert(lines.find(node.second));
    return names.size();
  }

private:
  const Neighbor_graph& m_graph;
  const std::vector<int>& m_labels;
  std::map<std::pair<Index, int>, int> m_nodes; ///< border points and what is beyond: their numbers
};

/// returns whether a segment around which one line goes is a strip: that line is long for its area and shared with
/// several others. What lies between creases, as a bevel, is seen and a part.
inline bool is_strip(const Outline& outline)
{
  constexpr double pi = 3.14159265358979323846;
  // of the squared length to that of a disk; 2 where it is one to four
  constexpr double least_ratio = 1.25;
  constexpr double most_crease = 0.4, least_common = 0.2; // shares of the line
  if (outline.length == 0. || outline.crease_length > most_crease * outline.length) return false;
  if (outline.length * outline.length < least_ratio * 4. * pi * outline.area) return false;
  const auto is_neighbor = [&](const auto& border)
  { return border.second.length > least_common * outline.length; };
  return std::count_if(outline.with.begin(), outline.with.end(), is_neighbor) > 1;
}

/// The points of each segment, by its label.
using Points_of_segments = std::map<int, std::vector<Index>>;

/// returns the neighbor that a strip, or what is all border, has the costliest border with, if that is larger; -1 for
/// other segments.
inline int home_of_strip(const Neighbor_graph& graph, const std::vector<int>& labels,
                         const Points_of_segments& segments, const int label)
{
  constexpr double most_size = 0.3; // of the neighbor's
  const std::vector<Index>& points = segments.at(label);
  const Outline outline = outline_of(graph, labels, points);
  if (outline.with.empty()) return -1;
  if (outline.has_inside && (!is_strip(outline) || Border_loops(graph, labels, points).count() > 1))
    return -1;
  const int home =
      std::max_element(outline.with.begin(), outline.with.end(),
                       [](const auto& a, const auto& b) { return a.second.cost < b.second.cost; })
          ->first;
  const auto others = static_cast<double>(segments.at(home).size());
  return static_cast<double>(points.size()) > most_size * others ? -1 : home;
}

/// gives strips, and what is all border, smallest first, to the neighbor that they have the costliest border with, if
/// that is larger; and likewise their mirror images, with the image of each label that has one.
///
/// Complexity: O(n log n) in the number of points.
inline void absorb_strips(const Neighbor_graph& graph, std::vector<int>& labels,
                          const std::map<int, int>& images = {})
{
  constexpr double most_across = 0.1; // of one of two sides; a bird's trunk has more of a wing
  Points_of_segments segments;
  for (std::size_t i = 0; i < labels.size(); ++i)
    segments[labels[i]].push_back(static_cast<Index>(i));
  std::vector<std::pair<std::size_t, int>> by_size;
  for (const auto& [label, points] : segments) by_size.emplace_back(points.size(), label);
  std::sort(by_size.begin(), by_size.end());
  const auto join = [&](const int from, const int into)
  {
    for (const Index i : segments[from]) labels[i] = into;
    segments[into].insert(segments[into].end(), segments[from].begin(), segments[from].end());
    segments[from].clear();
  };
  for (const auto& [size, label] : by_size)
  {
    const int home = segments[label].empty() ? -1 : home_of_strip(graph, labels, segments, label);
    if (home < 0) continue;
    const auto image = images.find(label), image_of_home = images.find(home);
    const bool are_two = image != images.end() && image_of_home != images.end();
    const bool is_across = are_two && image->second == label && image_of_home->second != home;
    if (is_across &&
        static_cast<double>(size) >= most_across * static_cast<double>(segments[home].size()))
      continue;
    join(label, home);
    if (are_two && image->second != home && image->second != image_of_home->second &&
        !segments[image->second].empty() && !segments[image_of_home->second].empty())
      join(image->second, image_of_home->second);
  }
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_ABSORB_STRIPS_H
