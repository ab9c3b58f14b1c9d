// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments points with normals by a method of the Point Cloud Library. It is a program of its own, so
// that nothing else depends on that library: the other benchmarks run it where it was built.
//
//   segment_by_pcl lccp|cpc POINTS LABELS SMALLEST_VOXEL
//
// POINTS has a line "x y z nx ny nz" a point, LABELS gets one label a line; prints the CPU seconds.

#include "pcl_alternatives.h"

#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
  try
  {
    const std::string method = argc == 5 ? argv[1] : "";
    if (method != "lccp" && method != "cpc")
      throw std::invalid_argument("give lccp or cpc, a file of points, a file for labels, and the "
                                  "smallest voxel");
    std::ifstream in(argv[2]);
    if (!in) throw std::runtime_error("can't open " + std::string(argv[2]));
    std::vector<Pcl_alternatives::Coordinates> points, normals;
    Pcl_alternatives::Coordinates p, v;
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
        method == "lccp" ? Pcl_alternatives::segment_by_lccp(points, normals, smallest_voxel)
                         : Pcl_alternatives::segment_by_cpc(points, normals, smallest_voxel);
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
