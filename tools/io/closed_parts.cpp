// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/closed_parts.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Shape_io {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Polygons = std::vector<std::vector<std::size_t>>;

// From the surface inwards a little, so that what is jagged there is not so within; otherwise where that crosses
// something.
constexpr Entrance entrances[] = {{.1, 3}, {.1, 0}, {.3, 3}, {.3, 0}, {1., 0}, {.02, 0}};

// A border with its caps.
struct Closed_border
{
  Border border;
  std::size_t entrance = 0; // which
  Cap_style style = {entrances[0]};
  std::vector<Cap> caps = {};
  Cap_style best_style = {}; // with the fewest caps that cross
  std::size_t least_crossing = (std::numeric_limits<std::size_t>::max)(); // their number
  bool is_exhausted = false; // nothing else is left to try
};

using Crossing_caps = std::map<std::size_t, std::set<Label_pair>>; // of borders

// The faces of a part, first its own, then those of caps.
struct Solid
{
  std::vector<std::size_t> own_faces;
  Polygons polygons = {};
  std::vector<std::pair<std::size_t, Label_pair>> caps =
      {}; // of the polygons after these: border, parts
};

void collect(const Welded_shape& shape, const std::vector<Closed_border>& borders, const int part,
             Solid& solid)
{
  solid.polygons.clear();
  solid.caps.clear();
  for (const std::size_t f : solid.own_faces) solid.polygons.push_back(shape.polygons[f]);
  for (std::size_t i = 0; i < borders.size(); ++i)
    for (const Cap& cap : borders[i].caps)
      if (cap.parts.first == part || cap.parts.second == part)
        for (const Triangle& t : cap.triangles)
        {
          solid.polygons.emplace_back(t.begin(), t.end());
          if (cap.parts.first == part)
            std::reverse(solid.polygons.back().begin(), solid.polygons.back().end());
          solid.caps.push_back({i, cap.parts});
        }
}

// The points that polygons have, and the polygons in terms of these.
std::vector<Point> take_points(const std::vector<Point>& points, Polygons& polygons)
{
  std::map<std::size_t, std::size_t> index;
  std::vector<Point> result;
  for (auto& polygon : polygons)
    for (std::size_t& corner : polygon)
    {
      const auto place = index.emplace(corner, result.size());
      if (place.second) result.push_back(points[corner]);
      corner = place.first->second;
    }
  return result;
}

// What is wrong with a solid, and the caps that cross something.
struct Verdict
{
  std::string fault = {};
  Crossing_caps crossing = {};
};

Verdict judged(const std::vector<Point>& all_points, const Solid& solid)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  Polygons triangles;
  std::vector<std::size_t> polygon_of;
  for (std::size_t p = 0; p < solid.polygons.size(); ++p)
    for (std::size_t i = 2; i < solid.polygons[p].size(); ++i)
    {
      triangles.push_back({solid.polygons[p][0], solid.polygons[p][i - 1], solid.polygons[p][i]});
      polygon_of.push_back(p);
    }
  std::vector<Point> points = take_points(all_points, triangles);
  // points at which a solid touches itself are doubled, which a printer does not see
  if (!PMP::orient_polygon_soup(points, triangles) ||
      !PMP::is_polygon_soup_a_polygon_mesh(triangles))
    return {"its surface is not a manifold"};
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  if (!CGAL::is_closed(mesh)) return {"INPUT is open there"};
  Verdict verdict;
  if (!(PMP::volume(mesh) > 0.)) verdict.fault = "its faces look inwards, or it is flat";
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> crossings;
  PMP::self_intersections(mesh, std::back_inserter(crossings));
  for (const auto& crossing : crossings)
    for (const std::size_t face : {crossing.first, crossing.second})
      if (polygon_of[face] >= solid.own_faces.size())
      {
        const auto& [border, parts] = solid.caps[polygon_of[face] - solid.own_faces.size()];
        verdict.crossing[border].insert(parts);
      }
  if (!verdict.crossing.empty()) verdict.fault = "the cap over its cut crosses it";
  return verdict;
}

// Fills between parts in the next way; after the last, all of the border begins with another entrance, and after
// the last of these with what was best, for good.
void take_next_style(const std::set<Label_pair>& crossing, Closed_border& border)
{
  if (crossing.size() < border.least_crossing)
  {
    border.least_crossing = crossing.size();
    border.best_style = border.style;
  }
  bool is_last = false;
  for (const Label_pair& parts : crossing)
  {
    Filling& filling = border.style.fillings.emplace(parts, Filling::PLANE).first->second;
    filling = static_cast<Filling>(static_cast<int>(filling) + 1);
    is_last = is_last || filling == Filling::NONE;
  }
  if (!is_last) return;
  border.is_exhausted = ++border.entrance == std::size(entrances);
  border.style = border.is_exhausted ? border.best_style : Cap_style{entrances[border.entrance]};
}

// Tries styles until no cap crosses anything; returns the fault of each part that has one.
std::map<int, std::string> close_borders(Welded_shape& shape, std::vector<Closed_border>& borders,
                                         std::map<int, Solid>& solids)
{
  const std::vector<Vector> normals = normals_of_points(shape);
  for (Closed_border& border : borders)
    border.caps = caps_of(border.border, border.style, normals, shape.points);
  std::map<int, std::string> faults;
  std::set<int> to_judge;
  for (const auto& solid : solids) to_judge.insert(solid.first);
  while (!to_judge.empty())
  {
    Crossing_caps crossing;
    for (const int part : to_judge)
    {
      collect(shape, borders, part, solids.at(part));
      const Verdict verdict = judged(shape.points, solids.at(part));
      faults[part] = verdict.fault;
      for (const auto& [i, parts] : verdict.crossing)
        crossing[i].insert(parts.begin(), parts.end());
    }
    to_judge.clear();
    for (const auto& [i, parts] : crossing)
    {
      if (borders[i].is_exhausted) continue;
      take_next_style(parts, borders[i]);
      borders[i].caps = caps_of(borders[i].border, borders[i].style, normals, shape.points);
      for (const Cap& cap : borders[i].caps) to_judge.insert({cap.parts.first, cap.parts.second});
    }
  }
  return faults;
}

} // namespace

std::vector<Closed_part> closed_parts(const Shape& shape, const std::vector<int>& labels,
                                      const std::size_t number_of_parts)
{
  const int rest = static_cast<int>(number_of_parts);
  std::vector<int> part_of(labels);
  std::replace(part_of.begin(), part_of.end(), -1, rest);
  Welded_shape welded = welded_shape(shape);
  std::vector<Closed_border> borders;
  std::vector<Border> found = part_borders(welded, part_of);
  join_hollow_cuts(found, welded.points);
  for (Border& border : found) borders.push_back({std::move(border)});
  std::map<int, Solid> solids;
  for (std::size_t f = 0; f < part_of.size(); ++f)
    if (!welded.polygons[f].empty()) solids[part_of[f]].own_faces.push_back(f);
  const std::map<int, std::string> faults = close_borders(welded, borders, solids);
  const bool has_rest = std::find(part_of.begin(), part_of.end(), rest) != part_of.end();
  std::vector<Closed_part> result(number_of_parts + (has_rest ? 1 : 0));
  for (Closed_part& part : result) part.fault = "its faces have no area"; // unless it is a solid
  for (auto& [part, solid] : solids)
  {
    Closed_part& closed = result[static_cast<std::size_t>(part)];
    collect(welded, borders, part, solid);
    closed.shape.points = take_points(welded.points, solid.polygons);
    closed.shape.polygons = std::move(solid.polygons);
    closed.source_faces = std::move(solid.own_faces);
    closed.fault = faults.at(part);
  }
  return result;
}

} // namespace Shape_io
