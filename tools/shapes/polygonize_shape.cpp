// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/polygonize_shape.h"

#include "shapes/surface_nets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Shape_generator {
namespace internal {

namespace {

// Sums and numbers of the neighbors of each vertex in the net; for vertices on sharp edges only of
// the neighbors that are on sharp edges too.
std::vector<std::pair<Point, int>> sum_neighbors(const Quad_mesh& mesh)
{
  std::vector<std::pair<Point, int>> result(mesh.points.size(), {Point{0, 0, 0}, 0});
  for (const std::array<std::size_t, 4>& quad : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t v = quad[i], next = quad[(i + 1) % 4];
      if (mesh.fixed[v] && !mesh.fixed[next]) continue;
      result[v].first = add(result[v].first, mesh.points[next]);
      ++result[v].second;
    }
  return result;
}

// Spreads the vertices evenly over the surface, those on sharp edges along their edge.
void smooth(const Implicit_shape& shape, double cell_size, Quad_mesh& mesh)
{
  const std::size_t n = mesh.points.size();
  for (std::size_t v = 0; v < n; ++v)
    if (!mesh.fixed[v]) mesh.points[v] = shape.project(mesh.points[v], cell_size / 2);
  for (int iteration = 0; iteration < 6; ++iteration)
  {
    const std::vector<std::pair<Point, int>> sums = sum_neighbors(mesh);
    for (std::size_t v = 0; v < n; ++v)
    {
      if (sums[v].second == 0) continue;
      Point move = subtract(scale(sums[v].first, 1. / sums[v].second), mesh.points[v]);
      if (mesh.fixed[v])
      {
        const double along = dot(move, mesh.creases[v]);
        mesh.points[v] = add(mesh.points[v], scale(mesh.creases[v], 0.6 * along));
        continue;
      }
      const Point normal = normalized(shape.gradient(mesh.points[v]));
      move = subtract(move, scale(normal, dot(move, normal)));
      mesh.points[v] = shape.project(add(mesh.points[v], scale(move, 0.6)), cell_size / 4);
    }
  }
}

// The cosine of the smallest angle: the smaller, the better.
double worst_cosine(const std::vector<Point>& points, const Triangle& t)
{
  double result = -1;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point& apex = points[t[i]];
    result = (std::max)(result, dot(normalized(subtract(points[t[(i + 1) % 3]], apex)),
                                    normalized(subtract(points[t[(i + 2) % 3]], apex))));
  }
  return result;
}

// Cuts each quad along the diagonal that is nearer to the surface and gives the better angles; at
// sharp edges only the surface counts.
std::vector<Triangle> cut_quads(const Implicit_shape& shape, double cell_size,
                                const Quad_mesh& mesh)
{
  std::vector<Triangle> result;
  for (const std::array<std::size_t, 4>& q : mesh.quads)
  {
    const std::array<std::array<Triangle, 2>, 2> choices = {
        {{{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}}, {{{q[1], q[2], q[3]}, {q[1], q[3], q[0]}}}}};
    std::array<double, 2> cost;
    for (std::size_t i = 0; i < 2; ++i)
    {
      cost[i] = (std::max)(worst_cosine(mesh.points, choices[i][0]),
                           worst_cosine(mesh.points, choices[i][1]));
      const Point middle = scale(add(mesh.points[q[i]], mesh.points[q[i + 2]]), 0.5);
      const double error = std::abs(shape.distance(middle)) / cell_size;
      cost[i] += 3 * error + (shape.is_sharp() && error > 0.02 ? 2 : 0);
    }
    const std::array<Triangle, 2>& best = choices[cost[0] <= cost[1] ? 0 : 1];
    result.insert(result.end(), best.begin(), best.end());
  }
  return result;
}

// Whether two sheets of the net touch in an edge, which then has four faces.
bool is_pinched(const Quad_mesh& mesh)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const std::array<std::size_t, 4>& quad : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i) edges.push_back({quad[i], quad[(i + 1) % 4]});
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

// For each face the faces at its edges, or an empty result if some edge does not have exactly one
// face on each side.
std::vector<Triangle> face_neighbors(const std::vector<Triangle>& faces)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of_edge;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      if (!face_of_edge.insert({{faces[f][i], faces[f][(i + 1) % 3]}, f}).second) return {};
  std::vector<Triangle> result(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto opposite = face_of_edge.find({faces[f][(i + 1) % 3], faces[f][i]});
      if (opposite == face_of_edge.end()) return {};
      result[f][i] = opposite->second;
    }
  return result;
}

// Sets of neighboring faces that have the same label.
std::vector<std::vector<std::size_t>> connected_pieces(const std::vector<Triangle>& neighbors,
                                                       const std::vector<int>& labels)
{
  std::vector<std::vector<std::size_t>> result;
  std::vector<bool> seen(labels.size(), false);
  for (std::size_t seed = 0; seed < labels.size(); ++seed)
  {
    if (seen[seed]) continue;
    std::vector<std::size_t> piece = {seed};
    seen[seed] = true;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (std::size_t neighbor : neighbors[piece[i]])
        if (!seen[neighbor] && labels[neighbor] == labels[seed])
        {
          seen[neighbor] = true;
          piece.push_back(neighbor);
        }
    result.push_back(piece);
  }
  return result;
}

// Gives the faces that the rounding of part boundaries to whole faces has cut off from their part
// to a part next to them.
void remove_label_islands(const std::vector<Triangle>& neighbors, std::vector<int>& labels)
{
  std::map<int, std::size_t> largest;
  const std::vector<std::vector<std::size_t>> pieces = connected_pieces(neighbors, labels);
  for (const std::vector<std::size_t>& piece : pieces)
    largest[labels[piece[0]]] = (std::max)(largest[labels[piece[0]]], piece.size());
  for (const std::vector<std::size_t>& piece : pieces)
  {
    const int label = labels[piece[0]];
    if (10 * piece.size() >= largest[label]) continue;
    std::map<int, std::size_t> votes;
    for (std::size_t f : piece)
      for (std::size_t neighbor : neighbors[f])
        if (labels[neighbor] != label) ++votes[labels[neighbor]];
    int winner = label;
    for (const auto& vote : votes)
      if (winner == label || vote.second > votes[winner]) winner = vote.first;
    for (std::size_t f : piece) labels[f] = winner;
  }
}

// A face that is between two others of another part joins it, which makes boundaries less jagged.
void straighten_label_boundaries(const std::vector<Triangle>& neighbors, std::vector<int>& labels)
{
  for (int iteration = 0; iteration < 3; ++iteration)
    for (std::size_t f = 0; f < labels.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        if (labels[neighbors[f][i]] == labels[neighbors[f][(i + 1) % 3]])
          labels[f] = labels[neighbors[f][i]];
}

// The cell size whose surface net has about the wanted number of triangles.
double find_cell_size(const Implicit_shape& shape, std::size_t number_of_faces, const Point& shift)
{
  const Point extent = subtract(shape.box().upper, shape.box().lower);
  double cell_size = (std::max)({extent[0], extent[1], extent[2]}) / 48;
  for (int iteration = 0; iteration < 6; ++iteration)
  {
    const Distance_grid grid(shape, cell_size, shift);
    double count = 0;
    grid.for_each_crossing([&count](std::size_t, std::size_t) { count += 2; });
    const double ratio = count / double(number_of_faces);
    if (ratio > 0.95 && ratio < 1.05) break;
    cell_size *= std::sqrt((std::max)(ratio, 0.1));
  }
  return cell_size;
}

} // namespace

Polygonized_shape polygonize(const std::string& name, const Implicit_shape& shape,
                             std::size_t number_of_faces, unsigned seed)
{
  std::mt19937 generator(seed);
  // Now and then a grid meets the surface in a way that pinches the net or makes a needle of a
  // face; another position of the grid then helps.
  for (int attempt = 0; attempt < 20; ++attempt)
  {
    Point shift = {0.5, 0.5, 0.5};
    for (std::size_t a = 0; a < 3 && (seed != 0 || attempt > 0); ++a) shift[a] = uniform(generator);
    const double cell_size = find_cell_size(shape, number_of_faces, shift);
    Quad_mesh net = surface_net(shape, Distance_grid(shape, cell_size, shift));
    if (is_pinched(net)) continue;
    smooth(shape, cell_size, net);
    Polygonized_shape result = {net.points, cut_quads(shape, cell_size, net), {}};
    const std::vector<Triangle> neighbors = face_neighbors(result.faces);
    if (neighbors.empty()) continue;
    if (connected_pieces(neighbors, std::vector<int>(result.faces.size(), 0)).size() != 1) continue;
    if (std::any_of(result.faces.begin(), result.faces.end(),
                    [&](const Triangle& t) { return worst_cosine(result.points, t) > 0.999; }))
      continue;
    for (const Triangle& t : result.faces)
      result.labels.push_back(shape.nearest_part(
          scale(add(add(net.points[t[0]], net.points[t[1]]), net.points[t[2]]), 1. / 3)));
    straighten_label_boundaries(neighbors, result.labels);
    remove_label_islands(neighbors, result.labels);
    return result;
  }
  throw std::runtime_error("Shape_generator: the grid for " + std::to_string(number_of_faces) +
                           " faces is too coarse for the shape " + name + "; ask for more faces");
}

} // namespace internal
} // namespace Shape_generator
