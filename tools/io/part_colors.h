// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_COLORS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_COLORS_H

#include "io/shape.h"

#include <array>
#include <cstddef>
#include <vector>

// Colors for the parts of a shape: the same from run to run, clearly different for neighbors.

namespace Shape_io {

using Color = std::array<unsigned char, 3>;

// For each part, the parts beside it.
using Neighbors = std::vector<std::vector<std::size_t>>;

namespace internal {

// Hues about evenly spread, in strong, dark and pale tones.
constexpr std::size_t palette_size = 20;

constexpr Color palette[palette_size] = {
    {230, 57, 53},   {30, 136, 229}, {67, 160, 71},   {253, 216, 53},  {142, 36, 170},
    {0, 188, 212},   {251, 140, 0},  {240, 98, 186},  {27, 94, 32},    {121, 85, 72},
    {26, 35, 126},   {174, 213, 60}, {136, 14, 79},   {128, 203, 196}, {179, 157, 219},
    {255, 183, 132}, {0, 121, 107},  {100, 100, 110}, {158, 157, 36},  {144, 202, 249}};

// How far apart two colors look, 0 to about 765: the green weighs most, and red the more the
// redder the colors are.
double color_difference(const Color& a, const Color& b);

} // namespace internal

// Which parts lie side by side on the shape.
Neighbors part_neighbors(const Shape& shape, const std::vector<int>& labels,
                         std::size_t number_of_parts);

// A color for each part.
std::vector<Color> part_colors(const Neighbors& neighbors);

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_PART_COLORS_H
