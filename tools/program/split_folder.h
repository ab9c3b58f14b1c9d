// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H

#include "io/atomic_file.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

// The folders of segment_shape --split and --hulls. Parts of an earlier run that this run has no part for would look
// like parts of this shape.

namespace Segment_shape {

// The folder with its files, `part_0.ply`, `part_1.ply`, ..., or `hull_0.obj`, ...: commit() removes those of an
// earlier run that were not written anew.
class Split_folder
{
public:
  // Throws File_error if there can't be such a folder, or if it has a file of such a name that
  // was not written by us: that is somebody's own.
  Split_folder(const std::string& path, const std::string& kind); // "part" or "hull"

  // The file of a part, "0", "1", ..., or of what is in none, "none".
  std::string path_of(const std::string& name, const std::string& extension);

  void commit();

  // Throws File_error if one of the files is one of the folder by its name.
  static void check_no_part(const std::string& folder, const std::string& kind,
                            const std::vector<std::string>& files);

private:
  static bool is_name_of_part(const std::string& name, const std::string& kind);

  static bool is_written_by_us(const std::filesystem::directory_entry& entry);

  Shape_io::New_folder m_folder;
  std::string m_kind;
  std::set<std::string> m_earlier; // files that are there and were not asked for yet
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H
