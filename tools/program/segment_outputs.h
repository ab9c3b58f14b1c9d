// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OUTPUTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OUTPUTS_H

#include "io/atomic_file.h"
#include "io/part_hulls.h"
#include "io/shape.h"
#include "io/write_parts.h"
#include "program/segment_options.h"
#include "program/segment_progress.h"
#include "program/segment_report.h"
#include "program/split_folder.h"
#include "view/write_view.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The files that segment_shape writes.

namespace Segment_shape {

// The files to write. They are begun before the work, so that an output that can't be written
// shows at once, and take their places together when all is written.
class Outputs
{
public:
  Outputs(const Options& options, Progress_line& progress);

  void write(const Shape_io::Shape& shape, const Shape_io::Parts& parts);

  // What people are to know of what was written, a line each.
  const std::vector<std::string>& notes() const { return m_notes; }

  void write_stats(const Shape_io::Shape& shape, const Run& run);

  // `page` is there if a page is asked for.
  void write_view(const std::optional<View_page>& page, const Shape_io::Shape& shape,
                  const std::vector<View_stage>& stages, const Run& run);

  // Writes all that is still in memory.
  void finish();

  // Puts all files in their places, unless there was an interruption.
  void commit();

private:
  using File = Shape_io::Atomic_file*;

  File open(const std::string& path);

  // Of the file that is written next, if it is asked for.
  bool begins(File file, const std::string& path);

  void write_hulls(const Shape_io::Shape& shape, const Shape_io::Parts& parts);
  void write_hull_file(const Shape_io::Part_hulls& hulls, const Shape_io::Parts& parts);
  void note_hulls(const Shape_io::Part_hulls& result);

  void write_separate_part(const Shape_io::Shape& part, const Shape_io::Parts& own,
                           const std::string& name);

  // What has no label is in a file of its own: no point is lost.
  void write_separate_parts(const Shape_io::Shape& shape, const Shape_io::Parts& parts);

  void write_closed_parts(const Shape_io::Shape& shape, const Shape_io::Parts& parts);

  const Options& m_options;
  Progress_line& m_progress;
  std::optional<Split_folder> m_folder, m_hull_folder; // before the files, which lie in them
  std::vector<std::unique_ptr<Shape_io::Atomic_file>> m_files;
  File m_parts, m_labels, m_stats, m_hulls, m_view;
  std::vector<std::string> m_notes;
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_OUTPUTS_H
