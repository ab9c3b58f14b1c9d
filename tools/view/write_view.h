// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_VIEW_WRITE_VIEW_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_VIEW_WRITE_VIEW_H

#include "io/shape.h"
#include "io/write_parts.h"
#include "program/segment_report.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// The page that shows a shape and its parts in a browser: one file that needs no network. The page
// itself, with all its scripts, is made when the project is built (see ../view); here the shape is put
// into it.

namespace Segment_shape {

// The parts of a shape after one of the stages.
struct View_stage
{
  std::string name, singular; // such as "patches", "patch"
  Shape_io::Parts parts;
};

// The page without a shape.
class View_page
{
public:
  // Throws File_error if the page was not made.
  explicit View_page(const std::string& path);

  // `stages` go from the smallest parts to the largest. The labels may be those of a shape with other
  // elements than the run's.
  void write(std::ostream& out, const Options& options, const Shape_io::Shape& shape,
             const std::vector<View_stage>& stages, const Run& run) const;

private:
  static constexpr const char* mark = "<!-- SHAPE -->";

  static void write_data(std::ostream& out, const Shape_io::Shape& shape,
                         const std::vector<View_stage>& stages);

  std::string m_text;
  std::size_t m_place = std::string::npos;
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_VIEW_WRITE_VIEW_H
