// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_SAVED_MODELS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_SAVED_MODELS_H

#include "fit/patch_scores.h"

#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Analyzed models on disk, with the visibility of every pair of patches: fits and searches then need
// no lines of sight. The files are of one machine and one build, and not for keeping.

namespace Patch_scores {

/// Writes or reads plain values and arrays: one function for both directions keeps them equal.
template <typename Stream>
class Archive
{
public:
  explicit Archive(Stream& stream) : m_stream(stream) {}

  template <typename T>
  void operator()(T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only bytes are kept");
    transfer(&value, sizeof(T));
  }
  template <typename T>
  void operator()(std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only bytes are kept");
    std::size_t size = values.size();
    transfer(&size, sizeof(size));
    values.resize(size);
    transfer(values.data(), size * sizeof(T));
  }
  void operator()(WCS::internal::Oriented_points& points)
  {
    (*this)(points.positions);
    (*this)(points.normals);
    (*this)(points.elements);
    (*this)(points.links);
    (*this)(points.extent);
    (*this)(points.number_of_elements);
  }
  void operator()(WCS::internal::Shape_analysis& shape)
  {
    (*this)(shape.input);
    (*this)(shape.representatives.points);
    (*this)(shape.representatives.of_point);
    (*this)(shape.graph.first);
    (*this)(shape.graph.entries);
    (*this)(shape.graph.spacing);
    (*this)(shape.patch_sets.front().patches.of_point);
    (*this)(shape.diameters);
    shape.has_diameters = true; // as it had when it was saved
  }

private:
  template <typename T>
  void transfer(T* data, const std::size_t bytes)
  {
    if constexpr (std::is_base_of<std::ostream, Stream>::value)
      m_stream.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    else
      m_stream.read(reinterpret_cast<char*>(data), static_cast<std::streamsize>(bytes));
    if (!m_stream) throw std::runtime_error("a saved model is broken: make them anew");
  }

  Stream& m_stream;
};

inline std::filesystem::path saved_path(const std::filesystem::path& folder, const int number)
{
  return folder / (std::to_string(number) + ".bin");
}

/// saves a model, after all that is not known yet of its visibility was measured.
inline void save(Model& model, const std::filesystem::path& folder)
{
  const int patches = static_cast<int>(model.shape->patches().size());
  std::vector<std::pair<int, int>> all;
  for (int a = 0; a < patches; ++a)
    for (int b = a + 1; b < patches; ++b) all.push_back({a, b});
  model.shape->visibility().prepare(all);
  std::vector<float> visibility;
  for (const auto& [a, b] : all)
    visibility.push_back(static_cast<float>(model.shape->visibility()(a, b)));

  std::ofstream out(saved_path(folder, model.number), std::ios::binary);
  Archive<std::ofstream> archive(out);
  archive(*model.shape);
  archive(visibility);
  std::size_t annotators = model.annotators.size();
  archive(annotators);
  for (Annotator& annotator : model.annotators) archive(annotator.labels);
  if (!out.flush()) throw std::runtime_error("can't write to " + folder.string());
}

inline Model load_saved(const std::filesystem::path& folder, const int number,
                        const WCS::Parameters& parameters)
{
  std::ifstream in(saved_path(folder, number), std::ios::binary);
  Archive<std::ifstream> archive(in);
  Model model;
  model.number = number;
  model.shape = std::make_unique<WCS::internal::Shape_analysis>();
  WCS::internal::Shape_analysis& shape = *model.shape;
  shape.patch_sets.resize(1);
  archive(shape);
  WCS::internal::Patches& patches = shape.patch_sets.front().patches;
  for (std::size_t i = 0; i < patches.of_point.size(); ++i)
  {
    const auto p = static_cast<std::size_t>(patches.of_point[i]);
    if (p >= patches.members.size()) patches.members.resize(p + 1);
    patches.members[p].push_back(static_cast<WCS::internal::Index>(i));
  }
  std::vector<float> visibility;
  archive(visibility);
  shape.sight =
      std::make_unique<WCS::internal::Line_of_sight_query>(shape.points(), shape.graph, parameters);
  shape.patch_sets.front().visibility =
      std::make_unique<WCS::internal::Patch_visibility>(*shape.sight, patches, parameters, false);
  const int count = static_cast<int>(patches.size());
  std::size_t next = 0;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) shape.visibility().remember(a, b, visibility[next++]);
  std::size_t annotators = 0;
  archive(annotators);
  model.annotators.resize(annotators);
  for (Annotator& annotator : model.annotators) archive(annotator.labels);
  count_patches(model);
  return model;
}

} // namespace Patch_scores

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_FIT_SAVED_MODELS_H
