// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_SCENE_OBJECTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_SCENE_OBJECTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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
#include <map>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

// From one view of a depth camera to objects and their parts: thinning, normals towards the sensor, the
// plane that all stands on split off (as section 6 of the paper does), separated pieces, parts of each.

namespace Scene_objects {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented = std::pair<Point, Vector>;

// A preset for one view of a depth camera: its errors, of some millimeters, are large beside the distance between
// points, so lines over a flat face cross its disks at steeper angles than the preset allows for.
inline WCS::Parameters with_depth_noise(WCS::Parameters preset)
{
  preset.grazing_tolerance = 20.;
  return preset;
}

// Lengths in the unit of the scene; the defaults are for meters and tabletops.
struct Options
{
  Point viewpoint{0., 0., 0.};
  double cell = 0.004;            // side of the cells that the points are thinned to
  unsigned normal_neighbors = 24; // nearest points that a normal comes from
  double plane_distance = 0.01;   // up to here points belong to the plane
  double highest = 0.6;           // what is farther above the plane is no object on it
  double gap = 0.014;             // pieces farther apart than this are different objects
  std::size_t smallest = 80;      // pieces of fewer cells are no objects
  // on noisy one-sided data the fitted cost cuts far less too often than the default's
  WCS::Parameters parameters = with_depth_noise(WCS::Parameters::fitted());
};

struct Scene
{
  std::vector<Oriented> cells;       // thinned points with normals
  std::vector<std::size_t> cell_of;  // of each point of the input
  Kernel::Plane_3 plane;             // its normal points to the sensor's side
  std::vector<int> object;           // of each cell; -1: plane or background
  std::vector<int> part;             // of each cell; -1: plane or background
  std::vector<std::size_t> parts_of; // number of parts of each object
  int number_of_parts = 0;
};

namespace internal {

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

inline Cell cell_at(const Point& p, const double side)
{
  const auto index = [side](const double x)
  { return static_cast<std::int64_t>(std::floor(x / side)); };
  return {index(p.x()), index(p.y()), index(p.z())};
}

// Throws std::runtime_error if cells could not be numbered, or their neighbors.
inline void check_extent(const std::vector<Point>& points, const Options& options)
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
inline void thin(const std::vector<Point>& points, const double side, Scene& scene)
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

inline void orient_to_sensor(Scene& scene, const Options& options)
{
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      scene.cells, options.normal_neighbors,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
  for (Oriented& cell : scene.cells)
    if (cell.second * (options.viewpoint - cell.first) < 0.) cell.second = -cell.second;
}

// The plane with the most points.
inline Kernel::Plane_3 supporting_plane(std::vector<Oriented> cells, const Options& options)
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

inline double height(const Kernel::Plane_3& plane, const Point& p)
{
  const Vector n = plane.orthogonal_vector();
  return (p - plane.point()) * n / std::sqrt(n.squared_length());
}

// Pieces of what stands on the plane; a gap without points parts two of them.
inline std::vector<std::vector<std::size_t>> separated_pieces(const Scene& scene,
                                                              const Options& options)
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

inline void segment_piece(const std::vector<std::size_t>& piece, const Options& options,
                          Scene& scene)
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

} // namespace internal

// What is there before parts are looked for.
struct Pieces_on_plane
{
  Scene scene;                                  // without objects
  std::vector<std::vector<std::size_t>> pieces; // of its cells
};

// Finds the plane and the separated pieces on it.
// Throws std::runtime_error if there is no plane or nothing stands on it.
inline Pieces_on_plane find_pieces(const std::vector<Point>& points, const Options& options)
{
  Pieces_on_plane result;
  Scene& scene = result.scene;
  internal::check_extent(points, options);
  internal::thin(points, options.cell, scene);
  if (scene.cells.size() < 100)
    throw std::runtime_error("the scene has only " + std::to_string(scene.cells.size()) +
                             " points that are apart; is its unit the meter? set --cell");
  internal::orient_to_sensor(scene, options);
  scene.plane = internal::supporting_plane(scene.cells, options);
  scene.object.assign(scene.cells.size(), -1);
  scene.part.assign(scene.cells.size(), -1);
  result.pieces = internal::separated_pieces(scene, options);
  if (result.pieces.empty())
    throw std::runtime_error("nothing stands on the plane that was found; is the sensor at the "
                             "viewpoint? set --viewpoint");
  return result;
}

// Finds the parts of the pieces.
inline Scene segment_pieces(Pieces_on_plane found, const Options& options)
{
  for (const auto& piece : found.pieces) internal::segment_piece(piece, options, found.scene);
  return std::move(found.scene);
}

// Finds the objects and their parts; throws as find_pieces() does.
inline Scene segment_scene(const std::vector<Point>& points, const Options& options)
{
  return segment_pieces(find_pieces(points, options), options);
}

} // namespace Scene_objects

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_SCENE_OBJECTS_H
