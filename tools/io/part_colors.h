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

// Found by a search for the largest least color_difference(), 0.073, with enough contrast to a dark and to a white
// ground; then ordered, so that each is the furthest from those before it.
constexpr std::size_t palette_size = 20;

constexpr Color palette[palette_size] = {
    {0, 105, 225},  {255, 135, 60},  {120, 255, 255}, {165, 15, 0},  {150, 120, 150},
    {195, 255, 90}, {45, 195, 135},  {195, 120, 255}, {90, 45, 180}, {255, 225, 180},
    {0, 210, 240},  {255, 150, 195}, {90, 120, 75},   {195, 120, 0}, {195, 210, 90},
    {150, 0, 120},  {150, 75, 180},  {30, 150, 210},  {120, 75, 75}, {225, 60, 105}};

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
