// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SEGMENTER_IMPL_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SEGMENTER_IMPL_H

// What `Segmenter` does that does not depend on the types of its input. Segmenter.h includes it.

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

template <typename ConcurrencyTag>
void Segmenter<ConcurrencyTag>::analyze(internal::Raw_shape raw, internal::Oracles oracles,
                                        const std::vector<double>& diameters)
{
  Parameters parameters = m_parameters;
  // whose diameters are given, none are measured
  if (!diameters.empty() && parameters.diameter == Diameter_rule::WHOLE_SHAPE)
    parameters.diameter = Diameter_rule::GIVEN;
  m_shape = internal::analyze_shape(std::move(raw), parameters, m_control, std::move(oracles));
  if (!diameters.empty()) internal::use_diameters(*m_shape, diameters, m_control.parallel);
}

template <typename ConcurrencyTag>
Result Segmenter<ConcurrencyTag>::segment(const Parameters& parameters)
{
  CGAL_precondition(m_shape != nullptr);
  return internal::segment_shape(*m_shape, parameters, m_control, m_merge_cost);
}

template <typename ConcurrencyTag>
Result Segmenter<ConcurrencyTag>::refine(const Result& result, const std::vector<int>& patch_labels,
                                         const Parameters& parameters)
{
  CGAL_precondition(m_shape != nullptr);
  parameters.check();
  const std::size_t patches = result.merge_tree.number_of_patches();
  if (result.patches.size() != m_shape->input.number_of_elements)
    throw std::invalid_argument("the result has " + std::to_string(result.patches.size()) +
                                " elements, the shape has " +
                                std::to_string(m_shape->input.number_of_elements));
  if (patch_labels.size() != patches)
    throw std::invalid_argument("there are " + std::to_string(patch_labels.size()) +
                                " patch labels for " + std::to_string(patches) + " patches");
  for (const int label : patch_labels)
    if (label < 0 || static_cast<std::size_t>(label) >= patches)
      throw std::invalid_argument("the patch label " + std::to_string(label) +
                                  " is not from 0 to " + std::to_string(patches - 1));
  internal::Representative_labels labels;
  labels.patches = internal::representative_labels(*m_shape, result.patches);
  for (const int patch : labels.patches) labels.segments.push_back(patch_labels[patch]);
  Result refined = internal::finish_segmentation(*m_shape, std::move(labels), result.merge_tree,
                                                 parameters, m_control, true);
  refined.symmetry_plane = result.symmetry_plane;
  return refined;
}

template <typename ConcurrencyTag>
std::size_t Segmenter<ConcurrencyTag>::number_of_patches() const
{
  CGAL_precondition(m_shape != nullptr);
  return m_shape->patches().size();
}

template <typename ConcurrencyTag>
void Segmenter<ConcurrencyTag>::set_diameters(const std::vector<double>& diameters)
{
  CGAL_precondition(m_shape != nullptr);
  if (diameters.size() != m_shape->input.number_of_elements)
    throw std::invalid_argument("there are " + std::to_string(diameters.size()) +
                                " diameters for " +
                                std::to_string(m_shape->input.number_of_elements) + " elements");
  internal::use_diameters(*m_shape, diameters, m_control.parallel);
}

template <typename ConcurrencyTag>
double Segmenter<ConcurrencyTag>::convexity_rank(const std::vector<std::size_t>& subset,
                                                 const std::size_t sample_size,
                                                 const double tolerance) const
{
  CGAL_precondition(m_shape != nullptr);
  if (sample_size == 0)
    throw std::invalid_argument("the convexity rank needs a sample of at least 1 element");
  if (!(tolerance >= 0. && tolerance <= 90.))
    throw std::invalid_argument("the tolerance is " + std::to_string(tolerance) +
                                " degrees, give a value from 0 to 90");
  const std::size_t n = m_shape->input.number_of_elements;
  std::vector<std::size_t> rank(n, std::numeric_limits<std::size_t>::max());
  for (std::size_t i = 0; i < m_shape->input.size(); ++i) rank[m_shape->input.elements[i]] = i;
  std::vector<internal::Index> points;
  for (const std::size_t element : subset)
  {
    if (element >= n)
      throw std::invalid_argument("element " + std::to_string(element) + " is not one of the " +
                                  std::to_string(n) + " elements of the shape");
    if (rank[element] < m_shape->input.size()) // strays have no point
      points.push_back(static_cast<internal::Index>(m_shape->representative(rank[element])));
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return internal::convexity_rank(*m_shape->sight, points, sample_size, tolerance);
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_SEGMENTER_IMPL_H
