// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/part_colors.h"

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

double color_difference(const Color& a, const Color& b)
{
  const double mean_red = (double(a[0]) + double(b[0])) / 2.;
  const double red = double(a[0]) - double(b[0]);
  const double green = double(a[1]) - double(b[1]);
  const double blue = double(a[2]) - double(b[2]);
  return std::sqrt((2. + mean_red / 256.) * red * red + 4. * green * green +
                   (2. + (255. - mean_red) / 256.) * blue * blue);
}

namespace {

double smallest_difference(const Color& color, const std::vector<Color>& others)
{
  double result = 1000.;
  for (const Color& other : others) result = (std::min)(result, color_difference(color, other));
  return result;
}

// A color for a part that differs clearly from those around it: the first in the palette, from a
// place that depends on the label, or the most different one if all are near to another.
Color choose_color(const std::size_t label, const std::vector<Color>& around)
{
  constexpr double clear_difference = 200.;
  const std::size_t start = (label * 7) % palette_size; // 7 is prime to the size: all are used
  Color best = palette[start];
  for (std::size_t i = 0; i < palette_size; ++i)
  {
    const Color& color = palette[(start + i) % palette_size];
    if (smallest_difference(color, around) >= clear_difference) return color;
    if (smallest_difference(color, around) > smallest_difference(best, around)) best = color;
  }
  return best;
}

using Label_pairs = std::set<std::pair<std::size_t, std::size_t>>;

void add_pair(const int a, const int b, Label_pairs& pairs)
{
  if (a >= 0 && b >= 0 && a != b)
    pairs.emplace(static_cast<std::size_t>((std::min)(a, b)),
                  static_cast<std::size_t>((std::max)(a, b)));
}

Label_pairs pairs_at_corners(const Shape& shape, const std::vector<int>& labels)
{
  Label_pairs pairs;
  std::vector<int> first_label(shape.points.size(), -1);
  for (std::size_t i = 0; i < shape.polygons.size(); ++i)
    for (const std::size_t corner : shape.polygons[i])
    {
      if (first_label[corner] < 0) first_label[corner] = labels[i];
      add_pair(first_label[corner], labels[i], pairs);
    }
  return pairs;
}

// Labels that meet in a cell of a coarse grid or in cells side by side.
Label_pairs pairs_in_grid(const Shape& shape, const std::vector<int>& labels)
{
  constexpr std::int64_t cells = 64; // along the longest side of the box
  const auto box = CGAL::bounding_box(shape.points.begin(), shape.points.end());
  double side = 0.;
  for (int i = 0; i < 3; ++i)
    side = (std::max)(side, (box.max_coord(i) - box.min_coord(i)) / double(cells));
  Label_pairs pairs;
  if (!std::isfinite(side)) return pairs;
  if (!(side > 0.)) side = 1.;
  std::unordered_map<std::int64_t, int> label_of_cell;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    std::int64_t cell = 0;
    for (int j = 0; j < 3; ++j)
      cell = cell * 4 * cells + std::int64_t((shape.points[i][j] - box.min_coord(j)) / side) + 1;
    add_pair(label_of_cell.emplace(cell, labels[i]).first->second, labels[i], pairs);
  }
  for (const auto& cell : label_of_cell)
    for (const std::int64_t step : {std::int64_t(1), 4 * cells, 16 * cells * cells})
    {
      const auto beside = label_of_cell.find(cell.first + step);
      if (beside != label_of_cell.end()) add_pair(cell.second, beside->second, pairs);
    }
  return pairs;
}

} // namespace
} // namespace internal

Neighbors part_neighbors(const Shape& shape, const std::vector<int>& labels,
                         const std::size_t number_of_parts)
{
  Neighbors result(number_of_parts);
  for (const auto& pair : shape.is_mesh() ? internal::pairs_at_corners(shape, labels)
                                          : internal::pairs_in_grid(shape, labels))
  {
    result[pair.first].push_back(pair.second);
    result[pair.second].push_back(pair.first);
  }
  return result;
}

std::vector<Color> part_colors(const Neighbors& neighbors)
{
  std::vector<Color> colors(neighbors.size());
  for (std::size_t label = 0; label < neighbors.size(); ++label)
  {
    std::vector<Color> around;
    for (const std::size_t neighbor : neighbors[label])
      if (neighbor < label) around.push_back(colors[neighbor]);
    colors[label] = internal::choose_color(label, around);
  }
  return colors;
}

} // namespace Shape_io
