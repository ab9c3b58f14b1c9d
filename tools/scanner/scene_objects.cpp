// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanner/scene_objects.h"

#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/linear_least_squares_fitting_3.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Scene_objects {

WCS::Parameters with_depth_noise(WCS::Parameters preset)
{
  preset.grazing_tolerance = 20.;
  return preset;
}

namespace {

using Cell = std::array<std::int64_t, 3>;

struct Cell_hash
{
  std::size_t operator()(const Cell& c) const
  {
    std::uint64_t h = 0;
    for (const std::int64_t i : c) h = (h ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(h ^ h >> 32);
  }
};

using Grid = std::unordered_map<Cell, std::size_t, Cell_hash>;

Cell cell_at(const Point& p, const double side)
{
  const auto index = [side](const double x)
  { return static_cast<std::int64_t>(std::floor(x / side)); };
  return {index(p.x()), index(p.y()), index(p.z())};
}

// Throws std::runtime_error if cells could not be numbered, or their neighbors.
void check_extent(const std::vector<Point>& points, const Options& options)
{
  constexpr double most_cells = 1e15;
  const double side = (std::min)(options.cell, options.gap);
  for (const Point& p : points)
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(p[i]) / side < most_cells))
        throw std::runtime_error("a coordinate is more than 10^15 cells from the origin; scale the "
                                 "scene, or set --cell and --gap");
}

// One point a cell: the mean of its points.
void thin(const std::vector<Point>& points, const double side, Scene& scene)
{
  Grid grid;
  std::vector<std::size_t> counts;
  for (const Point& p : points)
  {
    const auto [it, is_new] = grid.emplace(cell_at(p, side), scene.cells.size());
    if (is_new)
    {
      scene.cells.emplace_back(CGAL::ORIGIN, CGAL::NULL_VECTOR);
      counts.push_back(0);
    }
    scene.cell_of.push_back(it->second);
    scene.cells[it->second].first += p - CGAL::ORIGIN;
    ++counts[it->second];
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    scene.cells[i].first =
        CGAL::ORIGIN + (scene.cells[i].first - CGAL::ORIGIN) / static_cast<double>(counts[i]);
}

void orient_to_sensor(Scene& scene, const Options& options)
{
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      scene.cells, options.normal_neighbors,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
  for (Oriented& cell : scene.cells)
    if (cell.second * (options.viewpoint - cell.first) < 0.) cell.second = -cell.second;
}

// The plane with the most points.
Kernel::Plane_3 supporting_plane(std::vector<Oriented> cells, const Options& options)
{
  using Traits =
      CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, std::vector<Oriented>,
                                                     CGAL::First_of_pair_property_map<Oriented>,
                                                     CGAL::Second_of_pair_property_map<Oriented>>;
  using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
  CGAL::get_default_random() = CGAL::Random(0); // the same plane in every run
  Ransac ransac;
  ransac.set_input(cells);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;
  parameters.min_points = cells.size() / 20;
  parameters.epsilon = 0.5 * options.plane_distance;
  parameters.cluster_epsilon = 5. * options.cell;
  parameters.normal_threshold = 0.85;
  parameters.probability = 0.01;
  ransac.detect(parameters);
  std::vector<Point> inliers;
  for (const auto& shape : ransac.shapes())
  {
    if (shape->indices_of_assigned_points().size() <= inliers.size()) continue;
    inliers.clear();
    for (const std::size_t i : shape->indices_of_assigned_points())
      inliers.push_back(cells[i].first);
  }
  if (inliers.empty())
    throw std::runtime_error("there is no plane that objects could stand on; segment the cloud as "
                             "one shape with segment_shape");
  Kernel::Plane_3 plane;
  CGAL::linear_least_squares_fitting_3(inliers.begin(), inliers.end(), plane,
                                       CGAL::Dimension_tag<0>());
  return plane.has_on_negative_side(options.viewpoint) ? plane.opposite() : plane;
}

double height(const Kernel::Plane_3& plane, const Point& p)
{
  const Vector n = plane.orthogonal_vector();
  return (p - plane.point()) * n / std::sqrt(n.squared_length());
}

// Pieces of what stands on the plane; a gap without points parts two of them.
std::vector<std::vector<std::size_t>> separated_pieces(const Scene& scene, const Options& options)
{
  std::unordered_map<Cell, std::vector<std::size_t>, Cell_hash> grid;
  std::vector<char> waits(scene.cells.size(), 0);
  for (std::size_t i = 0; i < scene.cells.size(); ++i)
  {
    const double h = height(scene.plane, scene.cells[i].first);
    if (h < options.plane_distance || h > options.highest) continue;
    waits[i] = 1;
    grid[cell_at(scene.cells[i].first, options.gap)].push_back(i);
  }
  std::vector<std::vector<std::size_t>> pieces;
  for (std::size_t i = 0; i < waits.size(); ++i)
  {
    if (waits[i] == 0) continue;
    std::vector<std::size_t> piece = {i};
    waits[i] = 0;
    for (std::size_t next = 0; next < piece.size(); ++next)
    {
      const Point& p = scene.cells[piece[next]].first;
      const Cell c = cell_at(p, options.gap);
      for (std::int64_t n = 0; n < 27; ++n)
      {
        const auto found = grid.find({c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1});
        if (found == grid.end()) continue;
        for (const std::size_t j : found->second)
        {
          if (waits[j] == 0 ||
              CGAL::squared_distance(p, scene.cells[j].first) > options.gap * options.gap)
            continue;
          waits[j] = 0;
          piece.push_back(j);
        }
      }
    }
    if (piece.size() >= options.smallest) pieces.push_back(std::move(piece));
  }
  return pieces;
}

void segment_piece(const std::vector<std::size_t>& piece, const Options& options, Scene& scene)
{
  std::vector<Oriented> points;
  for (const std::size_t i : piece) points.push_back(scene.cells[i]);
  WCS::Segmenter<CGAL::Sequential_tag> segmenter(
      points, options.parameters,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
  const WCS::Result result = segmenter.segment(options.parameters);
  const int object = static_cast<int>(scene.parts_of.size());
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    scene.object[piece[i]] = object;
    scene.part[piece[i]] = scene.number_of_parts + result.labels[i];
  }
  scene.parts_of.push_back(result.number_of_segments());
  scene.number_of_parts += static_cast<int>(result.number_of_segments());
}

} // namespace

Pieces_on_plane find_pieces(const std::vector<Point>& points, const Options& options)
{
  Pieces_on_plane result;
  Scene& scene = result.scene;
  check_extent(points, options);
  thin(points, options.cell, scene);
  if (scene.cells.size() < 100)
    throw std::runtime_error("the scene has only " + std::to_string(scene.cells.size()) +
                             " points that are apart; is its unit the meter? set --cell");
  orient_to_sensor(scene, options);
  scene.plane = supporting_plane(scene.cells, options);
  scene.object.assign(scene.cells.size(), -1);
  scene.part.assign(scene.cells.size(), -1);
  result.pieces = separated_pieces(scene, options);
  if (result.pieces.empty())
    throw std::runtime_error("nothing stands on the plane that was found; is the sensor at the "
                             "viewpoint? set --viewpoint");
  return result;
}

Scene segment_pieces(Pieces_on_plane found, const Options& options)
{
  for (const auto& piece : found.pieces) segment_piece(piece, options, found.scene);
  return std::move(found.scene);
}

Scene segment_scene(const std::vector<Point>& points, const Options& options)
{
  return segment_pieces(find_pieces(points, options), options);
}

} // namespace Scene_objects
