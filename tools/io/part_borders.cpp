// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/part_borders.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Union_find.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Shape_io {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

void drop_repeated_corners(std::vector<std::size_t>& polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  if (polygon.size() < 3) polygon.clear();
}

// Polygons without corners are none for CGAL.
void orient(Welded_shape& shape)
{
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& polygon : shape.polygons)
    if (!polygon.empty()) polygons.push_back(polygon);
  PMP::orient_polygon_soup(shape.points, polygons);
  std::size_t next = 0;
  for (auto& polygon : shape.polygons)
    if (!polygon.empty()) polygon = polygons[next++];
}

double volume(const Welded_shape& shape)
{
  double sum = 0.;
  const Point& origin = shape.points.front();
  for (const auto& polygon : shape.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum += CGAL::volume(origin, shape.points[polygon[0]], shape.points[polygon[i - 1]],
                          shape.points[polygon[i]]);
  return sum;
}

} // namespace

Welded_shape welded_shape(const Shape& shape)
{
  Welded_shape result = {shape.points, shape.polygons};
  PMP::merge_duplicate_points_in_polygon_soup(result.points, result.polygons);
  for (auto& polygon : result.polygons) drop_repeated_corners(polygon);
  orient(result);
  if (volume(result) < 0.)
    for (auto& polygon : result.polygons) std::reverse(polygon.begin(), polygon.end());
  return result;
}

namespace {

Border all_borders(const Welded_shape& shape, const std::vector<int>& labels)
{
  std::map<Edge, int> label_of_side;
  for (std::size_t f = 0; f < labels.size(); ++f)
  {
    const auto& polygon = shape.polygons[f];
    for (std::size_t i = 0; i < polygon.size(); ++i)
      label_of_side.emplace(Edge(polygon[i], polygon[(i + 1) % polygon.size()]), labels[f]);
  }
  Border result;
  for (const auto& [edge, label] : label_of_side)
  {
    const auto other = label_of_side.find({edge.second, edge.first});
    if (other != label_of_side.end() && label < other->second)
      result[{label, other->second}].push_back(edge);
  }
  return result;
}

} // namespace

// Edges that touch each other are of one border.
std::vector<Border> part_borders(const Welded_shape& shape, const std::vector<int>& labels)
{
  const Border all = all_borders(shape, labels);
  using Union_find = CGAL::Union_find<std::size_t>;
  Union_find sets;
  std::map<std::size_t, Union_find::handle> handle;
  for (const auto& of_pair : all)
    for (const Edge& edge : of_pair.second)
    {
      for (const std::size_t v : {edge.first, edge.second})
        if (handle.count(v) == 0) handle.emplace(v, sets.make_set(v));
      sets.unify_sets(handle.at(edge.first), handle.at(edge.second));
    }
  std::map<std::size_t, Border> of_set;
  for (const auto& [pair, edges] : all)
    for (const Edge& edge : edges) of_set[*sets.find(handle.at(edge.first))][pair].push_back(edge);
  std::vector<Border> result;
  for (const auto& entry : of_set) result.push_back(entry.second);
  return result;
}

namespace {

// How many more edges of each pair begin at a point than end there; pairs with as many are left out. Not empty where
// lines of three parts begin.
using Surplus = std::map<Label_pair, int>;

std::map<std::size_t, Surplus> junctions(const Border& border)
{
  std::map<std::size_t, Surplus> result;
  for (const auto& [pair, of_pair] : border)
    for (const Edge& edge : of_pair)
    {
      ++result[edge.first][pair];
      --result[edge.second][pair];
    }
  for (auto junction = result.begin(); junction != result.end();)
  {
    Surplus& surplus = junction->second;
    for (auto entry = surplus.begin(); entry != surplus.end();)
      entry = entry->second == 0 ? surplus.erase(entry) : std::next(entry);
    junction = surplus.empty() ? result.erase(junction) : std::next(junction);
  }
  return result;
}

Surplus reversed(Surplus surplus)
{
  for (auto& entry : surplus) entry.second = -entry.second;
  return surplus;
}

// An edge that goes inside from a junction to a point takes the surplus of the junction with it.
void add_inner_edge(const std::size_t from, const std::size_t to, const Surplus& surplus,
                    Border& border)
{
  for (const auto& [pair, count] : surplus)
    for (int i = 0; i < std::abs(count); ++i)
      border[pair].push_back(count > 0 ? Edge(to, from) : Edge(from, to));
}

// Pairs of junctions at which the same parts meet, the other way around, the nearest first.
std::vector<Edge> counterparts(const std::map<std::size_t, Surplus>& all,
                               const std::vector<Point>& points)
{
  std::vector<std::pair<double, Edge>> candidates;
  for (const auto& [p, of_p] : all)
    for (const auto& [q, of_q] : all)
      if (p < q && of_p == reversed(of_q))
        candidates.push_back({CGAL::squared_distance(points[p], points[q]), Edge(p, q)});
  std::sort(candidates.begin(), candidates.end());
  std::set<std::size_t> taken;
  std::vector<Edge> result;
  for (const auto& candidate : candidates)
  {
    const Edge& edge = candidate.second;
    if (taken.count(edge.first) > 0 || taken.count(edge.second) > 0) continue;
    taken.insert({edge.first, edge.second});
    result.push_back(edge);
  }
  return result;
}

} // namespace

void close_border(Border& border, std::vector<Point>& points)
{
  std::map<std::size_t, Surplus> left = junctions(border);
  for (const auto& [p, q] : counterparts(left, points))
  {
    add_inner_edge(p, q, left.at(p), border);
    left.erase(p);
    left.erase(q);
  }
  if (left.empty()) return;
  Vector sum = CGAL::NULL_VECTOR;
  for (const auto& junction : left) sum = sum + (points[junction.first] - CGAL::ORIGIN);
  const std::size_t center = points.size();
  points.push_back(CGAL::ORIGIN + sum / static_cast<double>(left.size()));
  for (const auto& [p, surplus] : left) add_inner_edge(p, center, surplus, border);
}

// Walks along the edges, and takes a loop off whenever a point comes again.
std::vector<Loop> loops_of(const std::vector<Edge>& edges)
{
  std::map<std::size_t, std::vector<std::size_t>> next;
  for (const Edge& edge : edges) next[edge.first].push_back(edge.second);
  std::vector<Loop> loops;
  for (auto& start : next)
  {
    Loop path = {start.first};
    std::map<std::size_t, std::size_t> place = {{start.first, 0}};
    for (auto at = next.find(start.first); at != next.end() && !at->second.empty();
         at = next.find(path.back()))
    {
      const std::size_t to = at->second.back();
      at->second.pop_back();
      const auto earlier = place.find(to);
      if (earlier == place.end())
      {
        place.emplace(to, path.size());
        path.push_back(to);
        continue;
      }
      const std::size_t begin = earlier->second;
      if (path.size() - begin > 2)
        loops.emplace_back(path.begin() + std::ptrdiff_t(begin), path.end());
      for (std::size_t i = begin + 1; i < path.size(); ++i) place.erase(path[i]);
      path.resize(begin + 1);
    }
  }
  return loops;
}

} // namespace Shape_io
