// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PATCH_SCORES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PATCH_SCORES_H

#include "common/shape_variants.h"

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A model of the benchmark kept with its patches and lines of sight, and its Rand Index from counts of
// faces a patch: a merge of patches is then scored in microseconds, for sweeps over parameters.

namespace Patch_scores {

namespace SM = Segmentation_metrics;
namespace WCS = CGAL::Weakly_convex_segmentation;
using Shape_variants::Variant;

/// One person's labels, and how many elements of each patch have each of them.
struct Annotator
{
  std::vector<int> labels; ///< of the elements, from 0
  std::vector<std::map<int, double>> of_patch;
  double pairs_within = 0.; ///< pairs of elements with equal label
};

struct Model
{
  int number = 0;
  std::unique_ptr<WCS::internal::Shape_analysis> shape;
  std::vector<double> patch_sizes; ///< elements
  std::vector<Annotator> annotators;
  double elements = 0.;

  std::size_t category() const { return SM::category_of_model(number); }
};

inline double pairs(const double n) { return 0.5 * n * (n - 1.); }

/// counts what the scores need in one of the sets of patches, once shape and people's labels are there.
inline void count_patches(Model& model, const std::size_t set = 0)
{
  const WCS::internal::Patches& of_set = model.shape->patch_sets[set].patches;
  const std::vector<int> patches = WCS::internal::element_patches(*model.shape, of_set.of_point);
  model.elements = static_cast<double>(patches.size());
  model.patch_sizes.assign(of_set.size(), 0.);
  for (const int p : patches) model.patch_sizes[static_cast<std::size_t>(p)] += 1.;
  for (Annotator& annotator : model.annotators)
  {
    annotator.of_patch.assign(model.patch_sizes.size(), {});
    std::map<int, double> sizes;
    for (std::size_t e = 0; e < patches.size(); ++e)
    {
      annotator.of_patch[static_cast<std::size_t>(patches[e])][annotator.labels[e]] += 1.;
      sizes[annotator.labels[e]] += 1.;
    }
    annotator.pairs_within = 0.;
    for (const auto& entry : sizes) annotator.pairs_within += pairs(entry.second);
  }
}

inline Model load(const std::filesystem::path& data, const int number,
                  const WCS::Parameters& parameters, const Variant variant = Variant::MESH)
{
  const SM::Mesh mesh = SM::read_off(data / "off" / (std::to_string(number) + ".off"));
  const auto segmentations = SM::read_annotations(data, number, mesh.faces.size());
  const auto shape = Shape_variants::make_variant(
      mesh, variant, static_cast<unsigned int>(number) + 1000 * parameters.seed, segmentations);
  Model model;
  model.number = number;
  model.shape = WCS::internal::analyze_shape(shape.raw, parameters, {});
  for (const auto& of_faces : segmentations)
  {
    Annotator annotator;
    for (const std::size_t f : shape.faces) annotator.labels.push_back(of_faces[f]);
    model.annotators.push_back(std::move(annotator));
  }
  count_patches(model);
  return model;
}

/// calls `visit(number)` for every model of the benchmark that the folder has.
template <typename Visit>
void for_each_number(const std::filesystem::path& folder, const std::string& extension,
                     const Visit& visit)
{
  for (int n = 1; n <= 400; ++n)
    if (SM::is_in_benchmark(n) && std::filesystem::exists(folder / (std::to_string(n) + extension)))
      visit(n);
}

/// 1 - Rand Index from the overlaps with people's parts, the mean over them.
template <typename Overlaps>
double rand_error(const Model& model, const std::vector<double>& sizes, const Overlaps& overlaps)
{
  double within = 0., sum = 0.;
  for (const double size : sizes) within += pairs(size);
  for (const Annotator& annotator : model.annotators)
  {
    double common = 0.;
    for (const auto& entry : overlaps(annotator)) common += pairs(entry.second);
    sum += (within + annotator.pairs_within - 2. * common) / pairs(model.elements);
  }
  return sum / static_cast<double>(model.annotators.size());
}

/// 1 - Rand Index of regions of patches, the mean over the model's people.
inline double rand_error(const Model& model, const std::vector<int>& region_of_patch)
{
  std::vector<double> sizes(region_of_patch.size(), 0.);
  for (std::size_t p = 0; p < region_of_patch.size(); ++p)
    sizes[static_cast<std::size_t>(region_of_patch[p])] += model.patch_sizes[p];
  return rand_error(model, sizes,
                    [&](const Annotator& annotator)
                    {
                      std::map<std::pair<int, int>, double> overlaps;
                      for (std::size_t p = 0; p < region_of_patch.size(); ++p)
                        for (const auto& [label, count] : annotator.of_patch[p])
                          overlaps[{region_of_patch[p], label}] += count;
                      return overlaps;
                    });
}

/// returns the labels of the elements after the borders of the representatives' were refined.
inline std::vector<int> refined_labels(const Model& model, std::vector<int> labels,
                                       const WCS::Parameters& parameters)
{
  WCS::internal::refine_borders(model.shape->graph, parameters, labels);
  std::vector<int> of_elements = WCS::internal::element_labels(
      model.shape->input, WCS::internal::carry_labels(*model.shape, labels, parameters, {}));
  WCS::internal::number_labels(of_elements);
  return of_elements;
}

/// 1 - Rand Index of labels of the elements, the mean over the model's people.
inline double rand_error_of_labels(const Model& model, const std::vector<int>& labels)
{
  std::vector<double> sizes;
  for (const int l : labels)
  {
    if (static_cast<std::size_t>(l) >= sizes.size()) sizes.resize(static_cast<std::size_t>(l) + 1);
    sizes[static_cast<std::size_t>(l)] += 1.;
  }
  return rand_error(model, sizes,
                    [&](const Annotator& annotator)
                    {
                      std::map<std::pair<int, int>, double> overlaps;
                      for (std::size_t e = 0; e < labels.size(); ++e)
                        overlaps[{labels[e], annotator.labels[e]}] += 1.;
                      return overlaps;
                    });
}

} // namespace Patch_scores

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_PATCH_SCORES_H
