// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes scans of shapes made in code, and of a room, as PLY files with the true part or object of each point:
//
//   make_scans FOLDER [NAME...]      without a name: all
//   make_scans --help                the names

#include "scans/made_scans.h"

#include "io/atomic_file.h"

#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void write(const Made_scans::Labeled_scan& made, const std::filesystem::path& path)
{
  Shape_io::Atomic_file file(path.string());
  std::ostream& out = file.stream();
  out.precision(9);
  out << "ply\nformat ascii 1.0\nelement vertex " << made.labels.size() << '\n';
  for (const char* const name : {"x", "y", "z", "nx", "ny", "nz"})
    out << "property float " << name << '\n';
  out << "property int view\nproperty int label\nend_header\n";
  for (std::size_t i = 0; i < made.labels.size(); ++i)
  {
    for (const double x : made.scan.points[i]) out << x << ' ';
    for (const double x : made.scan.normals[i]) out << x << ' ';
    out << made.scan.views[i] << ' ' << made.labels[i] << '\n';
  }
  file.commit();
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    std::vector<std::string> names(argv + (argc > 1 ? 2 : 1), argv + argc);
    if (argc < 2) throw std::invalid_argument("give FOLDER [NAME...]");
    if (names.empty()) names = Made_scans::scan_names();
    if (std::string(argv[1]) == "--help")
    {
      std::cout << "make_scans FOLDER [NAME...]\nNames:";
      for (const std::string& name : names) std::cout << ' ' << name;
      std::cout << '\n';
      return 0;
    }
    std::filesystem::create_directories(argv[1]);
    for (const std::string& name : names)
    {
      const Made_scans::Labeled_scan made = Made_scans::make_scan(name);
      write(made, std::filesystem::path(argv[1]) / (name + ".ply"));
      std::cout << name << ": " << made.labels.size() << " points\n";
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "make_scans: " << error.what() << '\n';
    return 1;
  }
}
