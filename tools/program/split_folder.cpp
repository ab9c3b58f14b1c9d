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

Split_folder::Split_folder(const std::string& path) : m_folder(path)
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

std::string Split_folder::path_of_part(const std::string& name, const std::string& extension)
{
  const std::string path = m_folder.path_of("part_" + name + extension);
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
      throw Shape_io::File_error("cannot remove '" + path + "', a part of an earlier run (" +
                                 error.message() + "); remove it by hand");
  }
}

void Split_folder::check_no_part(const std::string& folder, const std::vector<std::string>& files)
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

bool Split_folder::is_name_of_part(const std::string& name)
{
  if (name.size() < 10 || name.compare(0, 5, "part_") != 0) return false;
  const std::string extension = name.substr(name.size() - 4);
  if (extension != ".ply" && extension != ".obj") return false;
  const std::string number = name.substr(5, name.size() - 9);
  return number == "none" || number.find_first_not_of("0123456789") == std::string::npos;
}

bool Split_folder::is_written_by_us(const std::filesystem::directory_entry& entry)
{
  std::error_code error;
  if (entry.is_symlink(error) || !entry.is_regular_file(error)) return false;
  std::ifstream file(entry.path(), std::ios::binary);
  std::string ply, format, comment;
  if (entry.path().extension() == ".obj")
    return std::getline(file, comment) && comment == std::string("# ") + Shape_io::comment_of_parts;
  return std::getline(file, ply) && std::getline(file, format) && std::getline(file, comment) &&
         ply == "ply" && comment == std::string("comment ") + Shape_io::comment_of_parts;
}

} // namespace Segment_shape
