// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_COLORS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_COLORS_H

#include "io/shape.h"

#include <array>
#include <cstddef>
#include <vector>

// Colors for the parts of a shape: the same from run to run, no two the same while there are no more than 20, and
// clearly different for neighbors, to color-blind people too.

namespace Shape_io {

using Color = std::array<unsigned char, 3>;

// For each part, the parts beside it.
using Neighbors = std::vector<std::vector<std::size_t>>;

namespace internal {

// Found by a search for the largest least color_difference(), 0.073, with enough contrast to dark and white grounds.
constexpr std::size_t palette_size = 20;

constexpr Color palette[palette_size] = {
    {0, 135, 255},   {225, 150, 0},   {60, 195, 105},  {195, 45, 75},   {150, 45, 165},
    {180, 255, 120}, {90, 75, 120},   {0, 240, 195},   {255, 210, 255}, {195, 105, 0},
    {75, 75, 210},   {0, 135, 135},   {210, 165, 180}, {135, 195, 240}, {180, 210, 15},
    {0, 105, 0},     {165, 150, 255}, {255, 195, 150}, {135, 105, 195}, {135, 150, 105}};

// The distance of two colors in the space Oklab (Ottosson 2020), 0 to about 1: the least for usual eyes and for those
// without one of the three kinds of cones, as simulated by Machado et al. 2009.
double color_difference(const Color& a, const Color& b);

} // namespace internal

// Which parts lie side by side on the shape.
Neighbors part_neighbors(const Shape& shape, const std::vector<int>& labels,
                         std::size_t number_of_parts);

// A color for each part. Complexity: with the parts and their pairs of neighbors.
std::vector<Color> part_colors(const Neighbors& neighbors);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_COLORS_H
