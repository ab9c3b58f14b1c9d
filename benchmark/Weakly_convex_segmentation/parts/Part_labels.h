// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_LABELS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_LABELS_H

#include "metrics/mesh_geometry.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace Part_measures {

/// The part of each face, numbered from 0, and the labels that the parts were read with.
struct Part_labels
{
  std::vector<std::size_t> of_face;
  std::vector<int> names;
  std::size_t number_of_parts = 0;

  /// \throws std::invalid_argument if there is not one label a face
  Part_labels(const Segmentation_metrics::Segmentation& labels, const std::size_t number_of_faces)
  {
    if (labels.size() != number_of_faces)
      throw std::invalid_argument("There are " + std::to_string(labels.size()) + " labels, but " +
                                  std::to_string(number_of_faces) +
                                  " faces: give the labels of this mesh, one a face.");
    std::unordered_map<int, std::size_t> numbers;
    for (const int label : labels)
    {
      const auto [it, is_new] = numbers.emplace(label, names.size());
      if (is_new) names.push_back(label);
      of_face.push_back(it->second);
    }
    number_of_parts = names.size();
  }
};

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_LABELS_H
