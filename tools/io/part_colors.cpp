// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/part_colors.h"

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Shape_io {
namespace internal {

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v)
{
  Triple result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

// What eyes make of light, in linear red, green and blue: usual ones, and without long, middle, short cones.
constexpr Matrix eyes[] = {{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}},
                           {{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}},
                           {{{0.367322, 0.860646, -0.227968},
                             {0.280085, 0.672501, 0.047413},
                             {-0.011820, 0.042940, 0.968881}}},
                           {{{1.255528, -0.076749, -0.178779},
                             {-0.078411, 0.930809, 0.147602},
                             {0.004733, 0.691367, 0.303900}}}};

Triple linear(const Color& color)
{
  Triple result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double c = color[i] / 255.;
    result[i] = c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4);
  }
  return result;
}

Triple oklab(const Triple& light)
{
  constexpr Matrix to_cones = {{{0.4122214708, 0.5363325363, 0.0514459929},
                                {0.2119034982, 0.6806995451, 0.1073969566},
                                {0.0883024619, 0.2817188376, 0.6299787005}}};
  constexpr Matrix to_lab = {{{0.2104542553, 0.7936177850, -0.0040720468},
                              {1.9779984951, -2.4285922050, 0.4505937099},
                              {0.0259040371, 0.7827717662, -0.8086757660}}};
  Triple cones = times(to_cones, light);
  for (double& cone : cones) cone = std::cbrt((std::max)(cone, 0.));
  return times(to_lab, cones);
}

Triple seen_by(const Matrix& eye, const Color& color)
{
  Triple light = times(eye, linear(color));
  for (double& channel : light) channel = (std::min)((std::max)(channel, 0.), 1.);
  return oklab(light);
}

} // namespace

double color_difference(const Color& a, const Color& b)
{
  double least = 1.;
  for (const Matrix& eye : eyes)
  {
    const Triple at_a = seen_by(eye, a), at_b = seen_by(eye, b);
    least = (std::min)(least, std::hypot(at_a[0] - at_b[0], at_a[1] - at_b[1], at_a[2] - at_b[2]));
  }
  return least;
}

namespace {

// How much two colors side by side look alike: of two that do, less than for any number that do not.
using Likeness = std::array<std::array<double, palette_size>, palette_size>;

Likeness likeness()
{
  Likeness result;
  for (std::size_t i = 0; i < palette_size; ++i)
    for (std::size_t j = 0; j < palette_size; ++j)
      result[i][j] = std::pow((std::max)(color_difference(palette[i], palette[j]), .01), -4.);
  return result;
}

// How alike a part would look to its neighbors; `as` is what the part `other` would be.
double cost_of(const Neighbors& neighbors, const std::vector<std::size_t>& chosen,
               const Likeness& alike, const std::size_t part, const std::size_t color,
               const std::size_t other, const std::size_t as)
{
  double sum = 0.;
  for (const std::size_t beside : neighbors[part])
    sum += alike[color][beside == other ? as : chosen[beside]];
  return sum;
}

// Gives a part another color, if the sum of likenesses becomes less; while there are enough, the part that has that one
// gets its own.
bool improve(const Neighbors& neighbors, const Likeness& alike, const std::size_t part,
             std::vector<std::size_t>& chosen)
{
  const std::size_t n = chosen.size(), own = chosen[part];
  const auto cost = [&](const std::size_t p, const std::size_t color, const std::size_t other,
                        const std::size_t as)
  { return cost_of(neighbors, chosen, alike, p, color, other, as); };
  for (std::size_t color = 0; color < palette_size; ++color)
  {
    const auto holder =
        n > palette_size ? chosen.end() : std::find(chosen.begin(), chosen.end(), color);
    const auto other = static_cast<std::size_t>(holder - chosen.begin()); // n if there is none
    if (color == own) continue;
    double before = cost(part, own, n, 0), after = cost(part, color, other, own);
    if (other < n)
    {
      before += cost(other, color, n, 0);
      after += cost(other, own, part, color);
    }
    if (!(after < before * (1. - 1e-9))) continue;
    if (other < n) chosen[other] = own;
    chosen[part] = color;
    return true;
  }
  return false;
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
  constexpr std::size_t most_rounds = 20; // few are needed
  static const internal::Likeness alike = internal::likeness();
  std::vector<std::size_t> chosen(neighbors.size());
  for (std::size_t part = 0; part < chosen.size(); ++part)
    chosen[part] = part % internal::palette_size;
  bool is_better = true;
  for (std::size_t round = 0; is_better && round < most_rounds; ++round)
  {
    is_better = false;
    for (std::size_t part = 0; part < chosen.size(); ++part)
      if (internal::improve(neighbors, alike, part, chosen)) is_better = true;
  }
  std::vector<Color> colors;
  for (const std::size_t color : chosen) colors.push_back(internal::palette[color]);
  return colors;
}

} // namespace Shape_io
