// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_ATOMIC_FILE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_ATOMIC_FILE_H

#include <filesystem>
#include <fstream>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

namespace Shape_io {
namespace internal {

// One name for all the names of a file.
std::filesystem::path place_of_file(const std::string& path);

} // namespace internal

// Throws File_error if two outputs are one file, or if one is an input, by whatever names. "-" and devices
// can be named more than once.
void check_output_places(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs);

// A file that is there as a whole or not at all: it is written beside its place and renamed by
// commit(). Without commit(), the destructor removes what was written. The name "-" is standard
// output.
class Atomic_file
{
public:
  // Throws File_error if the file can't be written there. What is at that place stays until
  // commit().
  explicit Atomic_file(const std::string& path);

  ~Atomic_file();

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  // Throws File_error if no file of that name can be written. Nothing is left there.
  static void check(const std::string& path);

  std::ostream& stream() { return m_is_standard ? std::cout : m_stream; }

  // Throws File_error if not all could be written.
  void commit();

  // Writes what is still in memory, so that a full disk shows before any of several files is
  // committed.
  void finish();

private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string m_name;
  std::filesystem::path m_target;
  std::filesystem::path m_written;
  std::ofstream m_stream;
  bool m_is_direct = false;
  bool m_is_standard = false;
  bool m_is_committed = false;
};

// A folder that is made if need be, with those around it. Without keep(), what was made is removed
// again if nothing else is in it.
class New_folder
{
public:
  // Throws File_error if there can't be a folder of that name.
  explicit New_folder(const std::string& path);
  ~New_folder() { remove_made(); }
  New_folder(const New_folder&) = delete;
  New_folder& operator=(const New_folder&) = delete;

  void keep() { m_made.clear(); }
  std::string path_of(const std::string& name) const { return (m_path / name).string(); }

private:
  void remove_made();

  std::filesystem::path m_path;
  std::vector<std::filesystem::path> m_made; // the innermost first
};

} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_ATOMIC_FILE_H
