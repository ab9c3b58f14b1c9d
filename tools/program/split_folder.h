// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H

#include "io/atomic_file.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

// The folder of segment_shape --split. Parts of an earlier run that this run has no part for would
// look like parts of this shape.

namespace Segment_shape {

// The folder with its part files: commit() removes those of an earlier run that were not written anew.
class Split_folder
{
public:
  // Throws File_error if there can't be such a folder, or if it has a file of a part's name that
  // we have not written: that is somebody's own.
  explicit Split_folder(const std::string& path);

  // The file of a part, "0", "1", ..., or of what is in none, "none"; the extension is ".ply" or ".obj".
  std::string path_of_part(const std::string& name, const std::string& extension);

  void commit();

  // Throws File_error if one of the files is a part of the folder by its name.
  static void check_no_part(const std::string& folder, const std::vector<std::string>& files);

private:
  static bool is_name_of_part(const std::string& name);

  static bool is_written_by_us(const std::filesystem::directory_entry& entry);

  Shape_io::New_folder m_folder;
  std::set<std::string> m_earlier; // part files that are there and were not asked for yet
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H
