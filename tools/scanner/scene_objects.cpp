// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanner/scene_objects.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/linear_least_squares_fitting_3.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
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

Kernel::Plane_3 towards_sensor(const Kernel::Plane_3& plane, const Options& options)
{
  return plane.has_on_negative_side(options.viewpoint) ? plane.opposite() : plane;
}

// A plane, and the convex hull in it of what belongs to it.
struct Support
{
  Kernel::Plane_3 plane;
  std::vector<std::size_t> cells; // that belong to it
  std::vector<Kernel::Point_2> hull;

  void set_hull(const Scene& scene)
  {
    std::vector<Kernel::Point_2> flat;
    for (const std::size_t i : cells) flat.push_back(plane.to_2d(scene.cells[i].first));
    CGAL::convex_hull_2(flat.begin(), flat.end(), std::back_inserter(hull));
  }

  bool is_below(const Point& p) const
  {
    return hull.size() < 3 || CGAL::bounded_side_2(hull.begin(), hull.end(), plane.to_2d(p)) !=
                                  CGAL::ON_UNBOUNDED_SIDE;
  }
};

// The planes of at least a twentieth of the cells, the largest first.
std::vector<Support> large_planes(const Scene& scene, const Options& options)
{
  using Numbered = std::tuple<Point, Vector, std::size_t>; // the detection reorders its range
  using Traits =
      CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, std::vector<Numbered>,
                                                     CGAL::Nth_of_tuple_property_map<0, Numbered>,
                                                     CGAL::Nth_of_tuple_property_map<1, Numbered>>;
  std::vector<Numbered> cells;
  for (const auto& [point, normal] : scene.cells) cells.emplace_back(point, normal, cells.size());
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
  std::vector<Support> planes;
  for (const auto& shape : ransac.shapes())
  {
    std::vector<Point> inliers;
    Support support;
    for (const std::size_t i : shape->indices_of_assigned_points())
    {
      inliers.push_back(std::get<0>(cells[i]));
      support.cells.push_back(std::get<2>(cells[i]));
    }
    CGAL::linear_least_squares_fitting_3(inliers.begin(), inliers.end(), support.plane,
                                         CGAL::Dimension_tag<0>());
    support.plane = towards_sensor(support.plane, options);
    support.set_hull(scene);
    planes.push_back(std::move(support));
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const Support& a, const Support& b)
                   { return a.cells.size() > b.cells.size(); });
  return planes;
}

double height(const Kernel::Plane_3& plane, const Point& p)
{
  const Vector n = plane.orthogonal_vector();
  return (p - plane.point()) * n / std::sqrt(n.squared_length());
}

// Pieces of what is above the plane; a gap without points parts two of them.
std::vector<std::vector<std::size_t>>
separated_pieces(const Scene& scene, const Kernel::Plane_3& plane, const Options& options)
{
  std::unordered_map<Cell, std::vector<std::size_t>, Cell_hash> grid;
  std::vector<char> waits(scene.cells.size(), 0);
  for (std::size_t i = 0; i < scene.cells.size(); ++i)
  {
    const double h = height(plane, scene.cells[i].first);
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

using Pieces = std::vector<std::vector<std::size_t>>;

// The share of the cells of a piece that are over a plane as far as it is seen.
double share_over(const Scene& scene, const Support& support, const std::vector<std::size_t>& piece)
{
  const auto over =
      std::count_if(piece.begin(), piece.end(),
                    [&](const std::size_t i) { return support.is_below(scene.cells[i].first); });
  return static_cast<double>(over) / static_cast<double>(piece.size());
}

// How much a piece speaks for its standing on a plane: by its size, twice if it begins near the plane, as from above only
// the tops of objects are seen; not at all if it is wider than objects are high.
std::size_t support_of(const Scene& scene, const Support& support,
                       const std::vector<std::size_t>& piece, const Options& options)
{
  constexpr double near = 3.; // times the distance up to which points belong to the plane
  CGAL::Bbox_3 box;
  double lowest = options.highest;
  for (const std::size_t i : piece)
  {
    box += scene.cells[i].first.bbox();
    lowest = (std::min)(lowest, height(support.plane, scene.cells[i].first));
  }
  const double width = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  if (width > 1.5 * options.highest) return 0;
  return lowest < near * options.plane_distance ? 2 * piece.size() : piece.size();
}

// The plane that was given, as far as there are cells in it.
Support given_support(const Scene& scene, const Options& options)
{
  Support support;
  support.plane = towards_sensor(*options.plane, options);
  for (std::size_t i = 0; i < scene.cells.size(); ++i)
    if (std::abs(height(support.plane, scene.cells[i].first)) < options.plane_distance)
      support.cells.push_back(i);
  support.set_hull(scene);
  return support;
}

// A plane, the pieces over it, and how much each speaks for the plane.
struct Candidate
{
  Support support;
  Pieces pieces;
  std::vector<std::size_t> weights;

  bool is_empty() const
  {
    return std::all_of(weights.begin(), weights.end(), [](const std::size_t w) { return w == 0; });
  }
};

Candidate candidate_of(const Scene& scene, Support support, const Options& options)
{
  constexpr double least_over = 0.5; // else it is behind the plane's end, as a wall behind a table
  Candidate result;
  for (std::vector<std::size_t>& piece : separated_pieces(scene, support.plane, options))
  {
    if (share_over(scene, support, piece) < least_over) continue;
    result.weights.push_back(support_of(scene, support, piece, options));
    result.pieces.push_back(std::move(piece));
  }
  result.support = std::move(support);
  return result;
}

// Whether a piece on a plane is a table before a wall: it holds another plane, on which something stands, and which is
// larger than the sides of objects are.
bool is_table(const std::vector<std::size_t>& piece, const Candidate& on,
              const std::vector<Candidate>& candidates, const Options& options)
{
  const double cells_across = 0.5 * options.highest / options.cell;
  const std::unordered_set<std::size_t> cells(piece.begin(), piece.end());
  for (const Candidate& other : candidates)
  {
    const std::vector<std::size_t>& plane = other.support.cells;
    if (&other == &on || other.is_empty() ||
        static_cast<double>(plane.size()) < cells_across * cells_across)
      continue;
    const auto held = std::count_if(plane.begin(), plane.end(),
                                    [&](const std::size_t i) { return cells.count(i) != 0; });
    if (2 * static_cast<std::size_t>(held) > plane.size()) return true;
  }
  return false;
}

// Sets the plane with the most cells of what stands on it, or that was given; returns the pieces over it.
Pieces find_plane(Scene& scene, const Options& options)
{
  std::vector<Candidate> candidates;
  if (options.plane)
    candidates.push_back(candidate_of(scene, given_support(scene, options), options));
  else
    for (Support& support : large_planes(scene, options))
      candidates.push_back(candidate_of(scene, std::move(support), options));
  if (candidates.empty())
    throw std::runtime_error("there is no plane that objects could stand on; give it by --plane, "
                             "or segment the cloud as one shape with segment_shape");
  const Candidate* best = nullptr;
  std::size_t most = 0;
  for (const Candidate& candidate : candidates)
  {
    std::size_t weight = 0;
    for (std::size_t i = 0; i < candidate.pieces.size(); ++i)
      if (!is_table(candidate.pieces[i], candidate, candidates, options))
        weight += candidate.weights[i];
    const bool is_first =
        best == nullptr && !candidate.pieces.empty(); // if all that there is is wide
    if (weight <= most && !is_first) continue;
    most = weight;
    best = &candidate;
  }
  if (best == nullptr) return {};
  scene.plane = best->support.plane;
  return best->pieces;
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
  scene.object.assign(scene.cells.size(), -1);
  scene.part.assign(scene.cells.size(), -1);
  result.pieces = find_plane(scene, options);
  if (result.pieces.empty())
    throw std::runtime_error(
        options.plane ? "nothing stands on the plane that was given; is it in the scene's unit?"
                      : "nothing stands on a plane that was found; is the sensor at the viewpoint? "
                        "set --viewpoint, or --plane");
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
