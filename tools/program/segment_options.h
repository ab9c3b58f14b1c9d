// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OPTIONS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OPTIONS_H

#include "io/part_hulls.h"

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
  std::string hulls;                   // a file, or a folder with a file a hull; empty: not written
  std::string split_folder, view_file; // empty: not written
  Shape_io::Hull_options hull_options;
  std::string dense_file; // empty: the labels are those of the input
  std::string preset = "default";
  std::string stage = "segments";
  std::string diameters = "own";
  std::string pieces; // joined, separate or whole; empty: that of the preset
  WCS::Level level = WCS::Level::SEGMENTS;
  WCS::Parameters parameters;
  std::size_t number_of_threads = 0; // 0: all
  bool is_cut = false;               // faces are split along borders
  bool is_closed = false;            // the parts of split_folder are closed solids
  bool is_named_by_us = false;       // parts_file, as nothing was asked for
  bool ascii = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

// Whether hulls are written as a file each, in a folder.
bool has_hull_folder(const Options& options);

// The files that are written, without those of folders.
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
