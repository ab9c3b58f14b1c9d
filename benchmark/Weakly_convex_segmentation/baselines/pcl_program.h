// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_PCL_PROGRAM_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_PCL_PROGRAM_H

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

// Runs segment_by_pcl, which is there where the Point Cloud Library is.

namespace Pcl_program {

using Coordinates = std::array<double, 3>;

struct Outcome
{
  std::vector<int> labels;
  double cpu_seconds = 0.;
};

inline std::filesystem::path program(const std::filesystem::path& folder)
{
  return folder / "segment_by_pcl";
}
inline bool is_built(const std::filesystem::path& folder)
{
  return std::filesystem::exists(program(folder));
}

inline void write_points(const std::vector<Coordinates>& points,
                         const std::vector<Coordinates>& normals, const std::string& path)
{
  std::ofstream out(path);
  out.precision(9);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const double x : points[i]) out << x << ' ';
    for (const double x : normals[i]) out << x << ' ';
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error("can't write " + path);
}

/// returns a label a point by `method`, lccp or cpc. May be called by several threads.
/// \param folder of the program
/// \param smallest_voxel in units of the points
/// \param settings as segment_by_pcl takes them; empty: those for meshes
/// \throws std::runtime_error if the program is not there or fails
inline Outcome run(const std::filesystem::path& folder, const std::string& method,
                   const std::vector<Coordinates>& points, const std::vector<Coordinates>& normals,
                   const double smallest_voxel, const std::string& settings = "")
{
  if (!is_built(folder))
    throw std::runtime_error("skipped: segment_by_pcl was not built, for want of PCL");
  static std::atomic<unsigned> number{0}; // threads share the process id
  const std::string stem = (std::filesystem::temp_directory_path() /
                            ("wcs_" + std::to_string(::getpid()) + '_' + std::to_string(number++)))
                               .string();
  const std::string cloud = stem + ".xyz", labels = stem + ".seg", log = stem + ".log";
  write_points(points, normals, cloud);
  std::ostringstream command;
  command << '\'' << program(folder).string() << "' " << method << " '" << cloud << "' '" << labels
          << "' " << smallest_voxel << ' ' << settings << " > '" << log << "' 2>&1";
  const int status = std::system(command.str().c_str());
  std::ifstream log_file(log), label_file(labels);
  Outcome outcome;
  std::string message; // the last line: the library prints lines of its own
  for (std::string line; std::getline(log_file, line);) message = line;
  if (status == 0) outcome.cpu_seconds = std::stod(message);
  for (int l = 0; label_file >> l;) outcome.labels.push_back(l);
  for (const std::string& name : {cloud, labels, log}) std::filesystem::remove(name);
  if (status != 0)
    throw std::runtime_error(message.empty() ? "segment_by_pcl was ended by a signal" : message);
  if (outcome.labels.size() != points.size())
    throw std::runtime_error("segment_by_pcl gave " + std::to_string(outcome.labels.size()) +
                             " labels for " + std::to_string(points.size()) + " points");
  return outcome;
}

} // namespace Pcl_program

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_PCL_PROGRAM_H
