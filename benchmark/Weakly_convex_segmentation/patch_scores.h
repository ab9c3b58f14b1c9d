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

inline double pairs(const double n)
{
  return 0.5 * n * (n - 1.);
}

inline WCS::internal::Raw_points read_raw(const SM::Mesh& mesh)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  return WCS::internal::read_soup(
      points, mesh.faces,
      CGAL::Identity_property_map<CGAL::Simple_cartesian<double>::Point_3>());
}

inline Model load(const std::filesystem::path& data, const int number,
                  const WCS::Parameters& parameters)
{
  const SM::Benchmark_model benchmark = SM::read_benchmark_model(data, number);
  Model model;
  model.number = number;
  model.shape = WCS::internal::analyze_shape(read_raw(benchmark.mesh), parameters, {});
  const std::vector<int> patches =
      WCS::internal::element_labels(*model.shape, model.shape->patches.of_point);
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
      counts.of_patch[static_cast<std::size_t>(patches[f])][human.labels[f]] += 1.;
      sizes[human.labels[f]] += 1.;
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
