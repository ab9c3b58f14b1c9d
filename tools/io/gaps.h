// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GAPS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GAPS_H

#include "io/separate_parts.h"
#include "io/shape.h"
#include "io/write_parts.h"

#include <cstddef>
#include <optional>
#include <vector>

// The pixels of a depth camera that have no measurement: they keep their place in the output, and have
// the label -1.

namespace Shape_io {

// What can be segmented of a shape.
class Measured_shape
{
public:
  explicit Measured_shape(const Shape& whole) : m_whole(whole)
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

  const Shape& shape() const { return m_rest ? *m_rest : m_whole; }
  std::size_t number_of_gaps() const
  {
    return m_whole.is_mesh() ? 0 : m_whole.points.size() - m_elements.size();
  }

  // The parts of the whole from those of what was measured.
  Parts spread(const Parts& parts) const
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

private:
  const Shape& m_whole;
  std::vector<std::size_t> m_elements; // of a cloud: those that are no gaps
  std::optional<Shape> m_rest;
};

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GAPS_H
