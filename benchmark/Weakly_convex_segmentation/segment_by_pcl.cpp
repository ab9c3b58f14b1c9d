// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments points with normals by a method of the Point Cloud Library. It is a program of its own, so
// that nothing else depends on that library: the other benchmarks run it where it was built.
//
//   segment_by_pcl lccp|cpc POINTS LABELS SMALLEST_VOXEL [VOXEL/SEED/TOLERANCE/SMOOTHNESS/K]
//
// POINTS has a line "x y z nx ny nz" a point, LABELS gets one label a line; prints the CPU seconds.
// Without the last word the settings are those that were best on complete meshes. VOXEL and SEED are in
// diagonals of the bounding box, TOLERANCE in degrees, SMOOTHNESS 0 or 1 (check it or not), K the k-factor.

#include "baselines/pcl_baselines.h"

#include <array>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

Pcl_baselines::Options read_settings(const std::string& words)
{
  std::istringstream in(words);
  Pcl_baselines::Options options{};
  std::array<char, 4> slashes{};
  in >> options.voxel >> slashes[0] >> options.seed >> slashes[1] >> options.tolerance >>
      slashes[2] >> options.check_smoothness >> slashes[3] >> options.k_factor;
  if (!in || slashes != std::array<char, 4>{'/', '/', '/', '/'} || !(options.voxel > 0.))
    throw std::invalid_argument("'" + words + "' are no settings; give them as 0.01/0.03/20/0/0");
  return options;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const std::string method = argc == 5 || argc == 6 ? argv[1] : "";
    if (method != "lccp" && method != "cpc")
      throw std::invalid_argument("give lccp or cpc, a file of points, a file for labels, and the "
                                  "smallest voxel; then settings, if any");
    const bool is_lccp = method == "lccp";
    Pcl_baselines::Options options =
        is_lccp ? Pcl_baselines::lccp_options : Pcl_baselines::cpc_options;
    if (argc == 6) options = read_settings(argv[5]);
    std::ifstream in(argv[2]);
    if (!in) throw std::runtime_error("can't open " + std::string(argv[2]));
    std::vector<Pcl_baselines::Coordinates> points, normals;
    Pcl_baselines::Coordinates p, v;
    while (in >> p[0] >> p[1] >> p[2] >> v[0] >> v[1] >> v[2])
    {
      points.push_back(p);
      normals.push_back(v);
    }
    if (!in.eof())
      throw std::runtime_error(std::string(argv[2]) + ", point " + std::to_string(points.size()) +
                               ": expected are six numbers");
    const double smallest_voxel = std::stod(argv[4]);
    const std::clock_t begin = std::clock();
    const std::vector<int> labels =
        is_lccp ? Pcl_baselines::segment_by_lccp(points, normals, smallest_voxel, options)
                : Pcl_baselines::segment_by_cpc(points, normals, smallest_voxel, options);
    std::cout << static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC << '\n';
    std::ofstream out(argv[3]);
    for (const int l : labels) out << l << '\n';
    if (!out.flush()) throw std::runtime_error("can't write " + std::string(argv[3]));
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "segment_by_pcl: " << error.what() << '\n';
    return 1;
  }
}
