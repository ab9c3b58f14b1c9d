// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GAPS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GAPS_H

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
  explicit Measured_shape(const Shape& whole);

  const Shape& shape() const { return m_rest ? *m_rest : m_whole; }
  std::size_t number_of_gaps() const;

  // The parts of the whole from those of what was measured.
  Parts spread(const Parts& parts) const;

private:
  const Shape& m_whole;
  std::vector<std::size_t> m_elements; // of a cloud: those that are no gaps
  std::optional<Shape> m_rest;
};

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GAPS_H
