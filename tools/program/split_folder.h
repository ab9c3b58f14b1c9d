// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H

#include "io/atomic_file.h"
#include "io/shape.h"
#include "io/write_parts.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <vector>

// The folder of segment_shape --split. Parts of an earlier run that this run has no part for would
// look like parts of this shape.

namespace Segment_shape {

// The folder with its part files: commit() removes those of an earlier run that were not written anew.
class Split_folder
{
public:
  // Throws File_error if there can't be such a folder, or if it has a file of a part's name that
  // write_parts() has not written: that is somebody's own.
  explicit Split_folder(const std::string& path) : m_folder(path)
  {
    for (const auto& entry : std::filesystem::directory_iterator(path))
    {
      if (!is_name_of_part(entry.path().filename().string())) continue;
      if (!is_written_by_us(entry))
        throw Shape_io::File_error("cannot write to '" + path + "': '" +
                                   entry.path().filename().string() +
                                   "' there is no part of an earlier run; move it or name another "
                                   "folder");
      m_earlier.insert(entry.path().string());
    }
  }

  // The file of a part, "0", "1", ..., or of what is in none, "none".
  std::string path_of_part(const std::string& name)
  {
    const std::string path = m_folder.path_of("part_" + name + ".ply");
    m_earlier.erase(path);
    return path;
  }

  void commit()
  {
    m_folder.keep();
    for (const std::string& path : m_earlier)
    {
      std::error_code error;
      if (!std::filesystem::remove(path, error) && error)
        throw Shape_io::File_error("cannot remove '" + path + "', a part of an earlier run (" +
                                   error.message() + "); remove it by hand");
    }
  }

  // Throws File_error if one of the files is a part of the folder by its name.
  static void check_no_part(const std::string& folder, const std::vector<std::string>& files)
  {
    const auto place = Shape_io::internal::place_of_file(folder + "/.");
    for (const std::string& file : files)
    {
      if (file.empty() || file == "-") continue;
      const auto other = Shape_io::internal::place_of_file(file);
      if (is_name_of_part(other.filename().string()) &&
          Shape_io::internal::place_of_file(other.parent_path().string() + "/.") == place)
        throw Shape_io::File_error("cannot write to '" + folder + "': '" + file +
                                   "' has the name of a part there; name another folder");
    }
  }

private:
  static bool is_name_of_part(const std::string& name)
  {
    if (name.size() < 10 || name.compare(0, 5, "part_") != 0 ||
        name.compare(name.size() - 4, 4, ".ply") != 0)
      return false;
    const std::string number = name.substr(5, name.size() - 9);
    return number == "none" || number.find_first_not_of("0123456789") == std::string::npos;
  }

  static bool is_written_by_us(const std::filesystem::directory_entry& entry)
  {
    std::error_code error;
    if (entry.is_symlink(error) || !entry.is_regular_file(error)) return false;
    std::ifstream file(entry.path(), std::ios::binary);
    std::string ply, format, comment;
    return std::getline(file, ply) && std::getline(file, format) && std::getline(file, comment) &&
           ply == "ply" && comment == std::string("comment ") + Shape_io::comment_of_parts;
  }

  Shape_io::New_folder m_folder;
  std::set<std::string> m_earlier; // part files that are there and were not asked for yet
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SPLIT_FOLDER_H
