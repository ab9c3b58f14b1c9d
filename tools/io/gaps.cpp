// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/gaps.h"

#include "io/separate_parts.h"

#include <cstddef>

namespace Shape_io {

Measured_shape::Measured_shape(const Shape& whole) : m_whole(whole)
{
  if (whole.is_mesh()) return;
  bool has_bad_normals = false;
  for (std::size_t i = 0; i < whole.points.size(); ++i)
    if (!is_gap(whole, whole.points[i])) m_elements.push_back(i);
  for (const Vector& n : whole.normals) has_bad_normals = has_bad_normals || is_gap(n);
  if (number_of_gaps() == 0 && !has_bad_normals) return;
  m_rest = shape_of_elements(whole, m_elements);
  for (Vector& n : m_rest->normals)
    if (is_gap(n)) n = CGAL::NULL_VECTOR; // not known
}

std::size_t Measured_shape::number_of_gaps() const
{
  return m_whole.is_mesh() ? 0 : m_whole.points.size() - m_elements.size();
}

Parts Measured_shape::spread(const Parts& parts) const
{
  if (number_of_gaps() == 0) return parts;
  Parts result;
  result.colors = parts.colors;
  result.labels.assign(m_whole.points.size(), -1);
  result.quality.assign(m_whole.points.size(), 0.);
  for (std::size_t i = 0; i < m_elements.size(); ++i)
  {
    result.labels[m_elements[i]] = parts.labels[i];
    result.quality[m_elements[i]] = parts.quality[i];
  }
  return result;
}

} // namespace Shape_io
