// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/shape_catalog.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace Shape_generator {
namespace internal {

const std::array<std::pair<double, const char*>, 2>& sides()
{
  static const std::array<std::pair<double, const char*>, 2> result = {
      {{-1., "left "}, {1., "right "}}};
  return result;
}

void add_block(Implicit_shape& shape, std::size_t part, const Point& lower, const Point& upper)
{
  const Point center = scale(add(lower, upper), 0.5), half = scale(subtract(upper, lower), 0.5);
  const Prism::Polygon rectangle = {
      {-half[0], -half[1]}, {half[0], -half[1]}, {half[0], half[1]}, {-half[0], half[1]}};
  shape.add<Prism>(part, center, Point{1, 0, 0}, Point{0, 1, 0}, rectangle, half[2], 0.);
}

Implicit_shape sphere()
{
  Implicit_shape shape;
  shape.add_ball(shape.add_part("ball"), {0, 0, 0}, 0.5);
  return shape;
}

Implicit_shape box()
{
  Implicit_shape shape(0, true);
  add_block(shape, shape.add_part("box"), {-0.5, -0.35, -0.25}, {0.5, 0.35, 0.25});
  return shape;
}

Implicit_shape torus()
{
  Implicit_shape shape;
  shape.add<Torus>(shape.add_part("ring"), Point{0, 0, 0}, Point{0, 0, 1}, 0.36, 0.14);
  return shape;
}

Implicit_shape thin_plate()
{
  Implicit_shape shape(0, true);
  add_block(shape, shape.add_part("plate"), {-0.5, -0.4, -0.025}, {0.5, 0.4, 0.025});
  return shape;
}

Implicit_shape two_spheres()
{
  Implicit_shape shape(0.06);
  shape.add_ball(shape.add_part("left ball"), {-0.24, 0, 0}, 0.26);
  shape.add_ball(shape.add_part("right ball"), {0.24, 0, 0}, 0.26);
  return shape;
}

Implicit_shape l_shape()
{
  Implicit_shape shape(0, true);
  add_block(shape, shape.add_part("foot"), {-0.4, -0.15, 0}, {0.5, 0.15, 0.3});
  add_block(shape, shape.add_part("upright"), {-0.4, -0.15, 0.2}, {-0.1, 0.15, 1});
  return shape;
}

Implicit_shape dumbbell()
{
  Implicit_shape shape(0.02);
  shape.add<Rounded_cone>(shape.add_part("bar"), Point{-0.34, 0, 0}, 0.055, Point{0.34, 0, 0},
                          0.055);
  shape.add_ball(shape.add_part("left ball"), {-0.34, 0, 0}, 0.18);
  shape.add_ball(shape.add_part("right ball"), {0.34, 0, 0}, 0.18);
  return shape;
}

Implicit_shape cup()
{
  Implicit_shape shape(0.02);
  const Turned_wall::Profile profile = {{0, 0.035}, {0.22, 0.035}, {0.26, 0.08}, {0.3, 0.68}};
  shape.add<Turned_wall>(shape.add_part("body"), profile, 0.03);
  shape.add_limb(shape.add_part("handle"), {{{0.3, 0, 0.56}, 0.03},
                                            {{0.42, 0, 0.58}, 0.034},
                                            {{0.51, 0, 0.46}, 0.036},
                                            {{0.46, 0, 0.28}, 0.034},
                                            {{0.285, 0, 0.2}, 0.03}});
  return shape;
}

Implicit_shape table()
{
  Implicit_shape shape(0, true);
  add_block(shape, shape.add_part("top"), {-0.5, -0.32, 0.6}, {0.5, 0.32, 0.66});
  for (const auto& side : sides())
    for (const auto& end : {std::make_pair(-1., "front leg"), std::make_pair(1., "back leg")})
    {
      const Point at = {side.first * 0.43, end.first * 0.25, 0.315};
      add_block(shape, shape.add_part(std::string(side.second) + end.second),
                subtract(at, {0.036, 0.036, 0.315}), add(at, {0.036, 0.036, 0.315}));
    }
  return shape;
}

Implicit_shape chair()
{
  Implicit_shape shape(0, true);
  add_block(shape, shape.add_part("seat"), {-0.23, -0.23, 0.42}, {0.23, 0.23, 0.48});
  // The back leans, and its lower end is hidden in the seat.
  const double lean = 0.14;
  const Point up = {0, std::sin(lean), std::cos(lean)};
  shape.add<Prism>(
      shape.add_part("back"), Point{0, 0.19, 0.45}, Point{1, 0, 0}, up,
      Prism::Polygon{{-0.2, 0}, {0.2, 0}, {0.2, 0.4}, {0.14, 0.52}, {-0.14, 0.52}, {-0.2, 0.4}},
      0.025, 0.);
  for (const auto& side : sides())
    for (const auto& end : {std::make_pair(-1., "front leg"), std::make_pair(1., "back leg")})
    {
      const Point at = {side.first * 0.18, end.first * 0.18, 0.225};
      add_block(shape, shape.add_part(std::string(side.second) + end.second),
                subtract(at, {0.031, 0.031, 0.225}), add(at, {0.031, 0.031, 0.225}));
    }
  return shape;
}

void add_person_torso_and_head(Implicit_shape& shape)
{
  const std::size_t head = shape.add_part("head");
  shape.add_limb(head, {{{0, 0.002, 0.845}, 0.033}, {{0, -0.004, 0.89}, 0.034}});
  shape.add_limb(
      head, {{{0, -0.02, 0.903}, 0.036}, {{0, -0.008, 0.925}, 0.054}, {{0, 0.006, 0.942}, 0.058}});
  const std::size_t torso = shape.add_part("torso");
  shape.add_limb(torso,
                 {{{0, 0.004, 0.505}, 0.056},
                  {{0, 0.004, 0.545}, 0.057},
                  {{0, -0.002, 0.625}, 0.048},
                  {{0, -0.004, 0.715}, 0.062},
                  {{0, 0.002, 0.775}, 0.05}},
                 {0.046, 0, 0});
  for (const auto& side : sides())
    shape.add<Rounded_cone>(torso, Point{side.first * 0.01, 0.004, 0.825}, 0.032,
                            Point{side.first * 0.105, 0.002, 0.782}, 0.039);
}

Implicit_shape figure()
{
  Implicit_shape shape(0.024);
  add_person_torso_and_head(shape);
  for (const auto& side : sides())
  {
    const double s = side.first;
    const std::size_t arm = shape.add_part(std::string(side.second) + "arm");
    shape.add_limb(arm, {{{s * 0.132, 0.002, 0.774}, 0.042},
                         {{s * 0.178, 0.006, 0.712}, 0.035},
                         {{s * 0.23, 0.012, 0.64}, 0.026},
                         {{s * 0.262, -0.008, 0.575}, 0.028},
                         {{s * 0.3, -0.046, 0.495}, 0.0175},
                         {{s * 0.316, -0.062, 0.457}, 0.024},
                         {{s * 0.328, -0.086, 0.408}, 0.017}});
    shape.add<Rounded_cone>(arm, Point{s * 0.303, -0.062, 0.478}, 0.016,
                            Point{s * 0.283, -0.105, 0.448}, 0.0125);
    const std::size_t leg = shape.add_part(std::string(side.second) + "leg");
    shape.add_limb(leg, {{{s * 0.062, 0.004, 0.49}, 0.064},
                         {{s * 0.076, -0.004, 0.4}, 0.055},
                         {{s * 0.092, -0.014, 0.275}, 0.037},
                         {{s * 0.102, 0.008, 0.2}, 0.041},
                         {{s * 0.112, 0.014, 0.075}, 0.023},
                         {{s * 0.113, 0.018, 0.03}, 0.028}});
    shape.add_limb(leg, {{{s * 0.113, 0.014, 0.03}, 0.028},
                         {{s * 0.12, -0.045, 0.027}, 0.027},
                         {{s * 0.128, -0.095, 0.018}, 0.018}});
  }
  return shape;
}

Implicit_shape four_leg()
{
  Implicit_shape shape(0.03);
  shape.add_limb(shape.add_part("body"),
                 {{{0.24, 0, 0.63}, 0.125}, {{0, 0, 0.62}, 0.125}, {{-0.25, 0, 0.65}, 0.13}});
  const std::size_t head = shape.add_part("head and neck");
  shape.add_limb(head, {{{0.3, 0, 0.7}, 0.095}, {{0.4, 0, 0.82}, 0.072}, {{0.48, 0, 0.93}, 0.056}});
  shape.add_limb(head,
                 {{{0.5, 0, 0.935}, 0.06}, {{0.58, 0, 0.87}, 0.05}, {{0.67, 0, 0.79}, 0.038}});
  for (const auto& side : sides())
  {
    const double s = side.first;
    shape.add<Rounded_cone>(head, Point{0.475, s * 0.03, 0.97}, 0.024,
                            Point{0.465, s * 0.042, 1.03}, 0.01);
    shape.add_limb(shape.add_part(std::string(side.second) + "front leg"),
                   {{{0.24, s * 0.06, 0.56}, 0.08},
                    {{0.245, s * 0.075, 0.42}, 0.048},
                    {{0.25, s * 0.08, 0.3}, 0.036},
                    {{0.245, s * 0.08, 0.14}, 0.026},
                    {{0.255, s * 0.08, 0.035}, 0.035}});
    shape.add_limb(shape.add_part(std::string(side.second) + "hind leg"),
                   {{{-0.27, s * 0.06, 0.58}, 0.095},
                    {{-0.25, s * 0.075, 0.44}, 0.06},
                    {{-0.315, s * 0.08, 0.3}, 0.036},
                    {{-0.305, s * 0.08, 0.14}, 0.026},
                    {{-0.29, s * 0.08, 0.035}, 0.035}});
  }
  shape.add_limb(shape.add_part("tail"), {{{-0.36, 0, 0.72}, 0.03},
                                          {{-0.44, 0, 0.7}, 0.03},
                                          {{-0.5, 0, 0.56}, 0.036},
                                          {{-0.52, 0, 0.36}, 0.02}});
  return shape;
}

} // namespace internal
} // namespace Shape_generator
