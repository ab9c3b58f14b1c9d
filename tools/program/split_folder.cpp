// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/split_folder.h"

#include "io/shape.h"
#include "io/write_parts.h"

#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <system_error>
#include <vector>

namespace Segment_shape {

Split_folder::Split_folder(const std::string& path, const std::string& kind)
  : m_folder(path), m_kind(kind)
{
  for (const auto& entry : std::filesystem::directory_iterator(path))
  {
    if (!is_name_of_part(entry.path().filename().string(), kind)) continue;
    if (!is_written_by_us(entry))
      throw Shape_io::File_error("cannot write to '" + path + "': '" +
                                 entry.path().filename().string() + "' there is no " + kind +
                                 " of an earlier run; move it or name another "
                                 "folder");
    m_earlier.insert(entry.path().string());
  }
}

std::string Split_folder::path_of(const std::string& name, const std::string& extension)
{
  const std::string path = m_folder.path_of(m_kind + "_" + name + extension);
  m_earlier.erase(path);
  return path;
}

void Split_folder::commit()
{
  m_folder.keep();
  for (const std::string& path : m_earlier)
  {
    std::error_code error;
    if (!std::filesystem::remove(path, error) && error)
      throw Shape_io::File_error("cannot remove '" + path + "', a " + m_kind +
                                 " of an earlier run (" + error.message() + "); remove it by hand");
  }
}

void Split_folder::check_no_part(const std::string& folder, const std::string& kind,
                                 const std::vector<std::string>& files)
{
  const auto place = Shape_io::internal::place_of_file(folder + "/.");
  for (const std::string& file : files)
  {
    if (file.empty() || file == "-") continue;
    const auto other = Shape_io::internal::place_of_file(file);
    if (is_name_of_part(other.filename().string(), kind) &&
        Shape_io::internal::place_of_file(other.parent_path().string() + "/.") == place)
      throw Shape_io::File_error("cannot write to '" + folder + "': '" + file +
                                 "' has the name of a " + kind + " there; name another folder");
  }
}

bool Split_folder::is_name_of_part(const std::string& name, const std::string& kind)
{
  const std::filesystem::path path = name;
  if (path.extension() != ".ply" && path.extension() != ".obj") return false;
  const std::string stem = path.stem().string();
  if (stem.compare(0, kind.size() + 1, kind + "_") != 0) return false;
  const std::string number = stem.substr(kind.size() + 1);
  return !number.empty() &&
         (number == "none" || number.find_first_not_of("0123456789") == std::string::npos);
}

bool Split_folder::is_written_by_us(const std::filesystem::directory_entry& entry)
{
  std::error_code error;
  if (entry.is_symlink(error) || !entry.is_regular_file(error)) return false;
  return Shape_io::is_written_by_us(entry.path().string());
}

} // namespace Segment_shape
