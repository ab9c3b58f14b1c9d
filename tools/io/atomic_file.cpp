// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/atomic_file.h"

#include "io/shape.h"
#include "program/interruption.h"

#include <filesystem>
#include <ios>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace Shape_io {

namespace {

// Follows links, also to what is not there yet. If links form a circle, one of them is returned.
std::filesystem::path without_links(std::filesystem::path path)
{
  constexpr int most_links = 40;
  std::error_code error;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, error); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path, error); // may be absolute
  return path;
}

} // namespace

namespace internal {

std::filesystem::path place_of_file(const std::string& path)
{
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(without_links(path), error);
  const std::filesystem::path place = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute : place;
}

} // namespace internal

void check_output_places(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs)
{
  std::map<std::filesystem::path, std::string> taken;
  std::error_code error;
  for (const std::string& input : inputs)
    if (!input.empty() && input != "-") taken.emplace(internal::place_of_file(input), input);
  for (const std::string& output : outputs)
  {
    if (output == "-" || (std::filesystem::exists(output, error) &&
                          !std::filesystem::is_regular_file(output, error)))
      continue;
    const auto [entry, is_new] = taken.emplace(internal::place_of_file(output), output);
    if (!is_new)
      throw File_error("cannot write '" + output + "': it is the same file as '" + entry->second +
                       "'; name another one");
  }
}

Atomic_file::Atomic_file(const std::string& path) : m_name(path), m_target(path)
{
  std::error_code error;
  m_is_standard = path == "-";
  m_is_direct = m_is_standard;
  if (m_is_standard) return;
  if (std::filesystem::is_directory(m_target, error)) fail("it is a folder; name a file");
  // A device or pipe can't be replaced, nor what standard output goes to: they are written to
  // directly.
  m_is_direct = path == "/dev/stdout" || path == "/dev/stderr" ||
                path.compare(0, 8, "/dev/fd/") == 0 ||
                (std::filesystem::exists(m_target, error) &&
                 !std::filesystem::is_regular_file(m_target, error));
  // The file that a link names is replaced, not the link.
  if (!m_is_direct) m_target = without_links(m_target);
  if (!m_is_direct && std::filesystem::is_symlink(m_target, error))
    fail("its links lead in a circle; name a file");
  m_written = m_target;
  if (!m_is_direct) m_written += "." + std::to_string(std::random_device()()) + ".tmp";
  m_stream.open(m_written, std::ios::binary | std::ios::trunc);
  if (!m_stream) fail("it can't be created; check that its folder exists and is writable");
}

Atomic_file::~Atomic_file()
{
  if (m_is_committed || m_is_direct) return;
  m_stream.close();
  std::error_code error;
  std::filesystem::remove(m_written, error);
}

void Atomic_file::check(const std::string& path)
{
  std::error_code error;
  if (path != "-" &&
      (!std::filesystem::exists(path, error) || std::filesystem::is_regular_file(path, error)))
  {
    const Program_errors::Interruption interruption; // the file is there for a moment
    const Atomic_file file(path);
  }
  Program_errors::Interruption::check();
}

void Atomic_file::commit()
{
  finish();
  std::error_code error;
  if (!m_is_direct) std::filesystem::rename(m_written, m_target, error);
  if (error) fail("its place can't be taken (" + error.message() + "); check its folder");
  m_is_committed = true;
}

void Atomic_file::finish()
{
  if (m_is_standard) std::cout.flush();
  if (m_stream.is_open()) m_stream.close(); // sets failbit if the buffer can't be written
  if (!stream()) fail("not all could be written; check for free space");
}

void Atomic_file::fail(const std::string& what) const
{
  throw File_error("cannot write '" + m_name + "': " + what);
}

New_folder::New_folder(const std::string& path) : m_path(path)
{
  std::error_code error;
  std::vector<std::filesystem::path> missing;
  for (std::filesystem::path p = m_path; !p.empty() && !std::filesystem::exists(p, error);
       p = p.parent_path())
    missing.insert(missing.begin(), p);
  for (const auto& p : missing)
    if (std::filesystem::create_directory(p, error)) m_made.insert(m_made.begin(), p);
  if (std::filesystem::is_directory(m_path, error)) return;
  remove_made();
  throw File_error("cannot make the folder '" + path +
                   "': name one that is no file, in a place that is writable");
}

void New_folder::remove_made()
{
  std::error_code error;
  for (const auto& p : m_made) std::filesystem::remove(p, error); // nothing if it is not empty
}

} // namespace Shape_io
