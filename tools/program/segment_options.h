// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OPTIONS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OPTIONS_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

// The command line of segment_shape.

namespace Segment_shape {

namespace WCS = CGAL::Weakly_convex_segmentation;

struct Options
{
  std::string input; // empty: the generated shape is segmented
  std::string shape = "figure";
  std::string parts_file, labels_file, stats_file; // empty: not written
  std::string hulls_file, split_folder, view_file; // empty: not written
  std::string dense_file;                          // empty: the labels are those of the input
  std::string preset = "default";
  std::string stage = "segments";
  std::string diameters = "own";
  std::string pieces; // joined, separate or whole; empty: that of the preset
  WCS::Level level = WCS::Level::SEGMENTS;
  WCS::Parameters parameters;
  std::size_t number_of_threads = 0; // 0: all
  bool is_cut = false;               // faces are split along borders
  bool ascii = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

// The files that are written, without those of `split_folder`.
// "-" among them is standard output.
std::vector<std::string> output_files(const Options& options);

namespace internal {

bool is_obj_file(const std::string& path);

} // namespace internal

// Throws std::invalid_argument for anything wrong, with one line that says what.
Options read_options(int argc, const char* const argv[]);

void print_help(std::ostream& out);

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OPTIONS_H
