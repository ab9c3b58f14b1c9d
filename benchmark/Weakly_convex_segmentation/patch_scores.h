// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PATCH_SCORES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PATCH_SCORES_H

#include "princeton_benchmark.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>
#include <CGAL/Weakly_convex_segmentation/internal/read_input.h>

#include <cstddef>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// A model of the benchmark kept with its patches and lines of sight, and its Rand Index from counts of
// faces a patch: a merge of patches is then scored in microseconds, for sweeps over parameters.

namespace Patch_scores {

namespace SM = Segmentation_metrics;
namespace WCS = CGAL::Weakly_convex_segmentation;

/// How many faces of each patch have each label of one person.
struct Human_counts
{
  std::vector<std::map<std::size_t, double>> of_patch;
  double pairs_within = 0.; ///< pairs of faces with equal label
};

struct Model
{
  int number = 0;
  std::unique_ptr<WCS::internal::Shape_analysis> shape;
  std::vector<double> patch_sizes; ///< faces
  std::vector<Human_counts> humans;
  double faces = 0.;
};

inline double pairs(const double n) { return 0.5 * n * (n - 1.); }

inline WCS::internal::Raw_points read_raw(const SM::Mesh& mesh)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  return WCS::internal::read_soup(
      points, mesh.faces, CGAL::Identity_property_map<CGAL::Simple_cartesian<double>::Point_3>());
}

/// What a model is turned into before it is segmented.
enum class Variant
{
  MESH,      ///< as it is
  POINTS,    ///< face centroids without the mesh
  HALF,      ///< a random half of the face centroids
  TWO_VIEWS, ///< the face centroids that are seen from two random sides
  FOUR_VIEWS ///< the same from four sides
};

/// returns which faces are seen from `views` random directions.
inline std::vector<char> seen_faces(const WCS::internal::Raw_points& raw, const int views,
                                    std::mt19937& random)
{
  WCS::Parameters parameters;
  parameters.number_of_representatives = 1000000;
  WCS::internal::Oriented_points points = WCS::internal::orient_points(raw);
  const auto graph = WCS::internal::build_neighbor_graph(points, 10, false);
  const WCS::internal::Sight sight(points, graph, parameters);
  std::vector<char> seen(points.size(), 0);
  std::normal_distribution<float> normal;
  for (int view = 0; view < views; ++view)
  {
    const auto camera =
        2.f * WCS::internal::normalized({normal(random), normal(random), 0.5f * normal(random)});
    for (std::size_t i = 0; i < points.size(); ++i)
      if (dot(points.normals[i], camera - points.positions[i]) > 0.f &&
          sight.tree().unoccluded(points.positions[i], camera))
        seen[points.elements[i]] = 1;
  }
  return seen;
}

/// returns the faces that a variant keeps.
inline std::vector<std::size_t> kept_faces(const WCS::internal::Raw_points& raw,
                                           const Variant variant, const int seed)
{
  std::mt19937 random(static_cast<unsigned int>(seed));
  std::vector<char> keep(raw.positions.size(), 1);
  if (variant == Variant::HALF)
    for (char& k : keep) k = random() % 2 == 0 ? 1 : 0;
  if (variant == Variant::TWO_VIEWS) keep = seen_faces(raw, 2, random);
  if (variant == Variant::FOUR_VIEWS) keep = seen_faces(raw, 4, random);
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < keep.size(); ++f)
    if (keep[f] != 0) faces.push_back(f);
  return faces;
}

inline Model load(const std::filesystem::path& data, const int number,
                  const WCS::Parameters& parameters, const Variant variant = Variant::MESH)
{
  const SM::Benchmark_model benchmark = SM::read_benchmark_model(data, number);
  const WCS::internal::Raw_points whole = read_raw(benchmark.mesh);
  const std::vector<std::size_t> faces = kept_faces(whole, variant, number);
  WCS::internal::Raw_points raw;
  if (variant == Variant::MESH)
    raw = whole;
  else
    for (const std::size_t f : faces)
    {
      raw.positions.push_back(whole.positions[f]);
      raw.normals.push_back(whole.normals[f]);
    }
  Model model;
  model.number = number;
  model.shape = WCS::internal::analyze_shape(raw, parameters, {});
  const std::vector<int> patches = WCS::internal::element_patches(*model.shape);
  model.faces = static_cast<double>(patches.size());
  model.patch_sizes.assign(model.shape->patches.size(), 0.);
  for (const int p : patches) model.patch_sizes[static_cast<std::size_t>(p)] += 1.;
  for (const auto& human : benchmark.humans)
  {
    Human_counts counts;
    counts.of_patch.resize(model.patch_sizes.size());
    std::map<std::size_t, double> sizes;
    for (std::size_t f = 0; f < patches.size(); ++f)
    {
      const std::size_t label = human.labels[faces[f]];
      counts.of_patch[static_cast<std::size_t>(patches[f])][label] += 1.;
      sizes[label] += 1.;
    }
    for (const auto& entry : sizes) counts.pairs_within += pairs(entry.second);
    model.humans.push_back(std::move(counts));
  }
  return model;
}

/// 1 - Rand Index of regions of patches, the mean over the model's people.
inline double rand_error(const Model& model, const std::vector<int>& region_of_patch)
{
  std::map<int, double> sizes;
  for (std::size_t p = 0; p < region_of_patch.size(); ++p)
    sizes[region_of_patch[p]] += model.patch_sizes[p];
  double within = 0., sum = 0.;
  for (const auto& entry : sizes) within += pairs(entry.second);
  for (const Human_counts& human : model.humans)
  {
    std::map<std::pair<int, std::size_t>, double> overlaps;
    for (std::size_t p = 0; p < region_of_patch.size(); ++p)
      for (const auto& [label, count] : human.of_patch[p])
        overlaps[{region_of_patch[p], label}] += count;
    double common = 0.;
    for (const auto& entry : overlaps) common += pairs(entry.second);
    sum += (within + human.pairs_within - 2. * common) / pairs(model.faces);
  }
  return sum / static_cast<double>(model.humans.size());
}

} // namespace Patch_scores

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PATCH_SCORES_H
