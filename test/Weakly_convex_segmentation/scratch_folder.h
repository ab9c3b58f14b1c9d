// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_SCRATCH_FOLDER_H
#define TEST_SCRATCH_FOLDER_H

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

// A folder of its own for a test, removed at the end.
class Scratch_folder
{
public:
  Scratch_folder()
    : m_path(std::filesystem::temp_directory_path() /
             ("wcs_test_" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directories(m_path);
  }

  ~Scratch_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  Scratch_folder(const Scratch_folder&) = delete;
  Scratch_folder& operator=(const Scratch_folder&) = delete;

  std::string file(const std::string& name) const { return (m_path / name).string(); }

  // Writes the file and returns its path.
  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

  std::string read(const std::string& name) const
  {
    std::ifstream stream(file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }

  bool has(const std::string& name) const { return std::filesystem::exists(file(name)); }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(m_path),
                                                  std::filesystem::directory_iterator()));
  }

  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

#endif // TEST_SCRATCH_FOLDER_H
