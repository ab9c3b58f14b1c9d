// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_POSED_FIGURES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_POSED_FIGURES_H

#include "shapes/polygonize_shape.h"
#include "shapes/shape_catalog.h"
#include "shapes/shape_generator.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The figure of the shape generator in poses of yoga, and sitting. It looks along -y.

namespace Posed_figures {

using Shape_generator::Implicit_shape;
using Shape_generator::Station;

/// Stations of the limbs of either side, from the torso outwards.
struct Pose
{
  std::vector<Station> left_arm, right_arm, left_leg, right_leg;
};

/// the other side's limb
inline std::vector<Station> mirrored(std::vector<Station> limb)
{
  for (Station& s : limb) s.position[0] = -s.position[0];
  return limb;
}

/// on one leg, the foot of the other at its knee, arms above the head
inline Pose tree()
{
  const std::vector<Station> arm = {{{0.132, 0.002, 0.782}, 0.042}, {{0.198, 0.006, 0.86}, 0.034},
                                    {{0.222, 0.01, 0.965}, 0.027},  {{0.165, 0.004, 1.06}, 0.026},
                                    {{0.095, 0., 1.14}, 0.018},     {{0.062, 0., 1.19}, 0.024},
                                    {{0.05, 0., 1.25}, 0.015}};
  const std::vector<Station> standing = {
      {{-0.062, 0.004, 0.49}, 0.064}, {{-0.06, -0.004, 0.4}, 0.055},
      {{-0.05, -0.01, 0.275}, 0.037}, {{-0.046, 0.006, 0.2}, 0.041},
      {{-0.04, 0.014, 0.075}, 0.025}, {{-0.04, 0., 0.03}, 0.03}};
  const std::vector<Station> bent = {{{0.068, 0.004, 0.49}, 0.062}, {{0.15, -0.02, 0.44}, 0.054},
                                     {{0.255, -0.04, 0.37}, 0.041}, {{0.28, -0.045, 0.335}, 0.038},
                                     {{0.2, -0.03, 0.275}, 0.038},  {{0.09, -0.02, 0.235}, 0.025},
                                     {{0.045, -0.025, 0.2}, 0.026}};
  return {mirrored(arm), arm, standing, bent};
}

/// a wide stand with one knee bent, arms to the sides
inline Pose warrior()
{
  const std::vector<Station> arm = {{{0.132, 0.002, 0.776}, 0.042}, {{0.21, 0.004, 0.774}, 0.036},
                                    {{0.31, 0.004, 0.77}, 0.027},   {{0.4, 0.002, 0.77}, 0.027},
                                    {{0.5, 0., 0.768}, 0.018},      {{0.545, 0., 0.768}, 0.024},
                                    {{0.61, 0., 0.766}, 0.014}};
  const std::vector<Station> straight = {
      {{-0.066, 0.004, 0.49}, 0.064}, {{-0.13, 0., 0.4}, 0.054},     {{-0.22, 0., 0.275}, 0.038},
      {{-0.27, 0.006, 0.2}, 0.04},    {{-0.36, 0.01, 0.075}, 0.024}, {{-0.4, 0., 0.03}, 0.028}};
  const std::vector<Station> bent = {{{0.066, 0.004, 0.49}, 0.064}, {{0.15, -0.004, 0.44}, 0.055},
                                     {{0.265, -0.01, 0.37}, 0.042}, {{0.3, -0.005, 0.31}, 0.04},
                                     {{0.3, 0.01, 0.2}, 0.04},      {{0.3, 0.014, 0.075}, 0.024},
                                     {{0.3, 0., 0.03}, 0.03}};
  return {mirrored(arm), arm, straight, bent};
}

/// on a seat at 0.43, hands above the knees
inline Pose sitting()
{
  const std::vector<Station> arm = {{{0.132, 0.002, 0.774}, 0.042}, {{0.178, 0.01, 0.712}, 0.035},
                                    {{0.205, 0.005, 0.645}, 0.028}, {{0.195, -0.06, 0.61}, 0.028},
                                    {{0.15, -0.16, 0.6}, 0.018},    {{0.135, -0.2, 0.598}, 0.023},
                                    {{0.125, -0.25, 0.59}, 0.014}};
  const std::vector<Station> leg = {{{0.066, 0.004, 0.49}, 0.062},  {{0.078, -0.09, 0.485}, 0.054},
                                    {{0.088, -0.22, 0.478}, 0.042}, {{0.09, -0.275, 0.45}, 0.04},
                                    {{0.092, -0.275, 0.35}, 0.039}, {{0.094, -0.265, 0.24}, 0.025},
                                    {{0.095, -0.28, 0.195}, 0.028}};
  return {mirrored(arm), arm, mirrored(leg), leg};
}

inline Pose pose(const std::string& name)
{
  if (name == "tree") return tree();
  if (name == "warrior") return warrior();
  if (name == "sitting") return sitting();
  throw std::invalid_argument("there is no pose '" + name + "'; take tree, warrior, sitting");
}

/// returns a closed mesh with the true part of each face: head, torso, arms and legs.
inline Shape_generator::Labeled_mesh make_mesh(const std::string& name, const std::size_t faces)
{
  Implicit_shape shape(0.024);
  Shape_generator::internal::add_person_torso_and_head(shape);
  const Pose limbs = pose(name);
  const std::vector<std::pair<std::string, const std::vector<Station>*>> parts = {
      {"left arm", &limbs.left_arm},
      {"right arm", &limbs.right_arm},
      {"left leg", &limbs.left_leg},
      {"right leg", &limbs.right_leg}};
  for (const auto& [part, stations] : parts) shape.add_limb(shape.add_part(part), *stations);
  auto mesh = Shape_generator::internal::polygonize(name, shape, faces, 0);
  return {std::move(mesh.points), std::move(mesh.faces), std::move(mesh.labels),
          shape.part_names()};
}

} // namespace Posed_figures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_POSED_FIGURES_H
