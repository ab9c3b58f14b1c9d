// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_REPORT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_REPORT_H

#include "io/shape.h"
#include "program/segment_options.h"
#include "program/segment_progress.h"

#include <CGAL/Weakly_convex_segmentation/Result.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <string>

// The numbers of a run of segment_shape: for programs as JSON, for people as a few lines.

namespace Segment_shape {

struct Run
{
  std::string name; // of the input
  double seconds_of_reading = 0.;
  double seconds_of_segmentation = 0.;
  std::size_t number_of_gaps = 0; // points without coordinates
  Stage_times stages;
  WCS::Result result;
};

namespace internal {

nlohmann::ordered_json json_of_segments(const Run& run, const Shape_io::Shape& shape);

} // namespace internal

void write_stats(std::ostream& out, const Options& options, const Shape_io::Shape& shape,
                 const Run& run);

void print_summary(std::ostream& out, const Shape_io::Shape& shape, const Run& run);

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_REPORT_H
