// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/shape_catalog.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace Shape_generator {
namespace internal {

Implicit_shape airplane()
{
  Implicit_shape shape(0.012);
  shape.add_limb(shape.add_part("fuselage"), {{{0.5, 0, -0.012}, 0.02},
                                              {{0.44, 0, -0.004}, 0.048},
                                              {{0.3, 0, 0}, 0.066},
                                              {{-0.15, 0, 0}, 0.066},
                                              {{-0.46, 0, 0.03}, 0.022}});
  for (const auto& side : sides())
    shape.add<Prism>(shape.add_part(std::string(side.second) + "wing"), Point{0, 0, -0.02},
                     Point{1, 0, 0}, Point{0, -side.first, 0},
                     Prism::Polygon{{0.16, 0.02}, {-0.08, 0.02}, {-0.2, 0.5}, {-0.12, 0.5}}, 0.003,
                     0.014);
  shape.add<Prism>(shape.add_part("fin"), Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 0, 1},
                   Prism::Polygon{{-0.28, 0.03}, {-0.44, 0.03}, {-0.5, 0.22}, {-0.42, 0.22}}, 0.003,
                   0.013);
  // On top of the fin, so that nothing cuts it into two pieces.
  shape.add<Prism>(
      shape.add_part("tail plane"), Point{0, 0, 0.235}, Point{1, 0, 0}, Point{0, 1, 0},
      Prism::Polygon{
          {-0.41, 0}, {-0.48, 0.19}, {-0.53, 0.19}, {-0.5, 0}, {-0.53, -0.19}, {-0.48, -0.19}},
      0.003, 0.013);
  return shape;
}

Implicit_shape octopus()
{
  Implicit_shape shape(0.03);
  shape.add_limb(shape.add_part("head"), {{{0, 0, 0.25}, 0.13},
                                          {{0, 0, 0.36}, 0.125},
                                          {{0.01, 0, 0.5}, 0.17},
                                          {{0.03, 0, 0.6}, 0.165}});
  for (int i = 0; i < 8; ++i)
  {
    // Radius, height and twist of the arm, and its thickness.
    const std::vector<std::array<double, 4>> curve = {
        {0.09, 0.24, 0, 0.05},    {0.17, 0.16, 0, 0.047},    {0.29, 0.06, 0.05, 0.04},
        {0.41, 0.04, 0.2, 0.033}, {0.49, 0.05, 0.42, 0.026}, {0.52, 0.1, 0.62, 0.019}};
    std::vector<Station> stations;
    for (const std::array<double, 4>& c : curve)
    {
      const double angle = (i + 0.5) * std::acos(-1.) / 4 + c[2];
      stations.push_back({{c[0] * std::cos(angle), c[0] * std::sin(angle), c[1]}, c[3]});
    }
    shape.add_limb(shape.add_part("arm " + std::to_string(i + 1)), stations);
  }
  return shape;
}

Implicit_shape hand()
{
  Implicit_shape shape(0.02);
  shape.add<Prism>(shape.add_part("palm"), Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 0, 1},
                   Prism::Polygon{{-0.09, 0.06},
                                  {0.09, 0.06},
                                  {0.14, 0.26},
                                  {0.13, 0.36},
                                  {0.0, 0.39},
                                  {-0.13, 0.37},
                                  {-0.13, 0.2}},
                   0.012, 0.05);
  const std::vector<std::string> names = {"index finger", "middle finger", "ring finger",
                                          "little finger"};
  const std::array<double, 4> lengths = {0.4, 0.45, 0.41, 0.32};
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double x = -0.135 + 0.09 * double(i), l = lengths[i];
    const double lean = 0.32 * (double(i) - 1.5) / 1.5;
    const double root = i == 3 ? 0.34 : 0.38;
    shape.add_limb(shape.add_part(names[i]), {{{x, 0, root}, 0.044},
                                              {{x + 0.5 * l * lean, -0.012, root + 0.5 * l}, 0.041},
                                              {{x + l * lean, -0.06, root + l}, 0.032}});
  }
  shape.add_limb(
      shape.add_part("thumb"),
      {{{-0.11, -0.01, 0.14}, 0.056}, {{-0.24, -0.04, 0.26}, 0.05}, {{-0.32, -0.06, 0.38}, 0.036}});
  return shape;
}

Implicit_shape ant()
{
  Implicit_shape shape(0.012);
  const std::size_t head = shape.add_part("head");
  shape.add_limb(head, {{{0.33, 0, 0.25}, 0.075}, {{0.42, 0, 0.22}, 0.055}});
  shape.add_limb(shape.add_part("thorax"), {{{0.25, 0, 0.25}, 0.035},
                                            {{0.12, 0, 0.27}, 0.068},
                                            {{0, 0, 0.26}, 0.055},
                                            {{-0.1, 0, 0.25}, 0.03}});
  shape.add_limb(shape.add_part("abdomen"), {{{-0.15, 0, 0.26}, 0.05},
                                             {{-0.28, 0, 0.28}, 0.115},
                                             {{-0.42, 0, 0.25}, 0.085},
                                             {{-0.52, 0, 0.21}, 0.03}});
  const std::array<std::string, 3> names = {"front leg", "middle leg", "hind leg"};
  const std::array<double, 3> roots = {0.16, 0.08, 0.0}, feet = {0.36, 0.06, -0.26};
  for (const auto& side : sides())
  {
    const double s = side.first;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double root = roots[i], foot = feet[i], knee = root + 0.5 * (foot - root);
      shape.add_limb(shape.add_part(side.second + names[i]),
                     {{{root, s * 0.03, 0.23}, 0.026},
                      {{knee, s * 0.19, 0.33}, 0.022},
                      {{0.5 * (knee + foot), s * 0.28, 0.16}, 0.018},
                      {{foot, s * 0.36, 0.016}, 0.016}});
    }
    shape.add_limb(shape.add_part(side.second + std::string("antenna")),
                   {{{0.39, s * 0.035, 0.27}, 0.018},
                    {{0.44, s * 0.1, 0.39}, 0.016},
                    {{0.56, s * 0.15, 0.36}, 0.016}});
  }
  return shape;
}

Implicit_shape pliers()
{
  Implicit_shape shape(0.012);
  const double pi = std::acos(-1.);
  Prism::Polygon disk;
  for (int i = 0; i < 32; ++i)
    disk.push_back({0.065 * std::cos(i * pi / 16), 0.065 * std::sin(i * pi / 16)});
  shape.add<Prism>(shape.add_part("joint"), Point{0, 0, 0.65}, Point{1, 0, 0}, Point{0, 0, 1}, disk,
                   0.035, 0.015);
  for (const auto& side : sides())
  {
    const double s = side.first;
    shape.add_limb(shape.add_part(side.second + std::string("handle")),
                   {{{s * 0.02, 0, 0.61}, 0.036},
                    {{s * 0.1, 0, 0.5}, 0.034},
                    {{s * 0.15, 0, 0.28}, 0.037},
                    {{s * 0.12, 0, 0.04}, 0.034}});
    shape.add_limb(shape.add_part(side.second + std::string("jaw")),
                   {{{s * 0.04, 0, 0.69}, 0.036},
                    {{s * 0.085, 0, 0.79}, 0.036},
                    {{s * 0.045, 0, 0.97}, 0.022}});
  }
  return shape;
}

Implicit_shape glasses()
{
  Implicit_shape shape(0.012);
  shape.add_limb(
      shape.add_part("bridge"),
      {{{-0.085, 0, 0.05}, 0.019}, {{0, -0.01, 0.085}, 0.02}, {{0.085, 0, 0.05}, 0.019}});
  for (const auto& side : sides())
  {
    const double s = side.first;
    shape.add<Torus>(shape.add_part(side.second + std::string("rim")), Point{s * 0.235, 0, 0},
                     Point{0, 1, 0}, 0.16, 0.022);
    shape.add_limb(shape.add_part(side.second + std::string("temple")),
                   {{{s * 0.388, 0.005, 0.05}, 0.022},
                    {{s * 0.43, 0.06, 0.06}, 0.021},
                    {{s * 0.44, 0.45, 0.06}, 0.02},
                    {{s * 0.42, 0.62, -0.05}, 0.023}});
  }
  return shape;
}

} // namespace internal
} // namespace Shape_generator
