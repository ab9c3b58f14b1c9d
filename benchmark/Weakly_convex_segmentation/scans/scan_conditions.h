// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_CONDITIONS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_CONDITIONS_H

#include "metrics/princeton_benchmark.h"
#include "scanner/virtual_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

// The incomplete clouds that a model of the benchmark is turned into, and their scores.

namespace Scan_conditions {

namespace SM = Segmentation_metrics;
using Virtual_scanner::Scan;

/// How a cloud comes from a mesh: seen from `views` sides or, with 0 views, sampled all over and with
/// holes over a share of its surface.
struct Condition
{
  std::string name;
  std::size_t views = 0;
  bool with_noise = false;
  double removed_share = 0.;
};

inline std::vector<Condition> all_conditions()
{
  std::vector<Condition> result;
  for (const bool noise : {false, true})
    for (const std::size_t views : {1, 2, 4, 8, 16})
      result.push_back(
          {std::to_string(views) + (views == 1 ? " view" : " views") + (noise ? ", noise" : ""),
           views, noise, 0.});
  for (const double share : {0., 0.1, 0.3, 0.5})
    result.push_back({std::to_string(static_cast<int>(std::lround(100. * share))) + " % removed", 0,
                      false, share});
  return result;
}

/// returns points spread over the surface by area, with the normals of their faces.
inline Scan sample_surface(const SM::Mesh& mesh, const SM::Mesh_geometry& geometry,
                           const std::size_t count, std::mt19937& random)
{
  using namespace Virtual_scanner;
  std::discrete_distribution<std::size_t> face_of(geometry.face_areas.begin(),
                                                  geometry.face_areas.end());
  std::uniform_real_distribution<double> uniform;
  Scan scan;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t face = face_of(random);
    const auto& f = mesh.faces[face];
    double s = uniform(random), t = uniform(random);
    if (s + t > 1.)
    {
      s = 1. - s;
      t = 1. - t;
    }
    scan.points.push_back((1. - s - t) * mesh.points[f[0]] + s * mesh.points[f[1]] +
                          t * mesh.points[f[2]]);
    scan.normals.push_back(Virtual_scanner::internal::face_normal(mesh, face));
    scan.faces.push_back(face);
    scan.views.push_back(0);
  }
  return scan;
}

/// removes balls about random points until so many points are gone.
inline Scan with_holes(const Scan& scan, const double share, const double radius,
                       std::mt19937& random)
{
  using namespace Virtual_scanner;
  std::vector<char> keep(scan.points.size(), 1);
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(keep.size()));
  for (std::size_t gone = 0; gone < wanted;)
  {
    const Point center = scan.points[random() % scan.points.size()];
    for (std::size_t i = 0; i < keep.size() && gone < wanted; ++i)
    {
      const Point d = scan.points[i] - center;
      if (keep[i] == 0 || dot(d, d) > radius * radius) continue;
      keep[i] = 0;
      ++gone;
    }
  }
  Scan result;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i] != 0)
    {
      result.points.push_back(scan.points[i]);
      result.normals.push_back(scan.normals[i]);
      result.faces.push_back(scan.faces[i]);
      result.views.push_back(scan.views[i]);
    }
  return result;
}

/// returns the cloud of a model; the model's number is the seed.
inline Scan make_scan(const SM::Benchmark_model& model, const Condition& condition)
{
  constexpr std::size_t sampled_points = 20000;
  constexpr double hole_radius = 0.05; // in diameters of the bounding sphere
  const auto seed = static_cast<unsigned>(model.number);
  if (condition.views > 0)
    return Virtual_scanner::scan_mesh(model.mesh, condition.views,
                                      condition.with_noise ? Virtual_scanner::realistic_camera()
                                                           : Virtual_scanner::Camera(),
                                      seed);
  std::mt19937 random(seed);
  const Scan whole = sample_surface(model.mesh, model.geometry, sampled_points, random);
  const double diameter = Virtual_scanner::bounding_sphere(model.mesh).diameter;
  return with_holes(whole, condition.removed_share, hole_radius * diameter, random);
}

/// returns 1 - Rand Index of the points' labels against those that people gave to their faces, the mean
/// over the people.
inline double rand_error(const SM::Benchmark_model& model, const Scan& scan,
                         const std::vector<int>& labels)
{
  const auto pairs = [](const double n) { return 0.5 * n * (n - 1.); };
  double sum = 0.;
  for (const auto& annotator : model.annotators)
  {
    std::map<int, double> ours;
    std::map<std::size_t, double> theirs;
    std::map<std::pair<int, std::size_t>, double> both;
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      const std::size_t truth = annotator.labels[scan.faces[i]];
      ours[labels[i]] += 1.;
      theirs[truth] += 1.;
      both[{labels[i], truth}] += 1.;
    }
    double apart = 0.;
    for (const auto& entry : ours) apart += pairs(entry.second);
    for (const auto& entry : theirs) apart += pairs(entry.second);
    for (const auto& entry : both) apart -= 2. * pairs(entry.second);
    sum += apart / (std::max)(pairs(static_cast<double>(labels.size())), 1.);
  }
  return sum / static_cast<double>(model.annotators.size());
}

} // namespace Scan_conditions

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_CONDITIONS_H
