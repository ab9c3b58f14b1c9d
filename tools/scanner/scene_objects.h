// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_SCENE_OBJECTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_SCENE_OBJECTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
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

// A preset for one view of a depth camera: its errors, of some millimeters, are large compared with the distance between
// points, so lines over a flat face cross its disks at steeper angles than the preset allows for.
WCS::Parameters with_depth_noise(WCS::Parameters preset);

// Lengths in the unit of the scene; the defaults are for meters and tabletops.
struct Options
{
  Point viewpoint{0., 0., 0.};
  double cell = 0.004;            // side of the cells that the points are thinned to
  unsigned normal_neighbors = 24; // nearest points that a normal comes from
  double plane_distance = 0.01;   // up to here points belong to the plane
  double highest = 0.6;           // what is farther above the plane, or wider, is no object on it
  double gap = 0.014;             // pieces farther apart than this are different objects
  std::size_t smallest = 80;      // pieces of fewer cells are no objects
  std::optional<Kernel::Plane_3> plane; // that all stands on, if it is known
  WCS::Parameters parameters = with_depth_noise({});
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

// What is there before parts are looked for.
struct Pieces_on_plane
{
  Scene scene;                                  // without objects
  std::vector<std::vector<std::size_t>> pieces; // of its cells
};

// Finds the plane and the separated pieces on it: of the larger planes, that with the most on it.
// Throws std::runtime_error if there is no plane or nothing stands on one.
Pieces_on_plane find_pieces(const std::vector<Point>& points, const Options& options);

// Finds the parts of the pieces.
Scene segment_pieces(Pieces_on_plane found, const Options& options);

// Finds the objects and their parts; throws as find_pieces() does.
Scene segment_scene(const std::vector<Point>& points, const Options& options);

} // namespace Scene_objects

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCANNER_SCENE_OBJECTS_H
