// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "common/speed_shapes.h"
#include "shapes/shape_generator.h"

#include <CGAL/Weakly_convex_segmentation/Normal_orientation.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Kd_tree.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/estimate_normals.h>
#include <CGAL/Weakly_convex_segmentation/internal/points/oriented_points.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// How many estimated normals point outwards, by our propagation and by CGAL::mst_orient_normals(), and how
// long estimating and orienting takes, in units of CGAL's search for ten neighbors of the same points.

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using WCS::Normal_orientation;
using WCS::internal::Raw_shape;

const std::vector<std::pair<std::string, Normal_orientation>> rows = {
    {"propagation", Normal_orientation::PROPAGATION},
    {"mst_orient_normals", Normal_orientation::MST}};
const std::vector<std::string> ordinary_shapes = {
    "figure", "four_leg", "airplane", "octopus", "hand", "ant", "pliers", "box", "torus"};
const std::vector<std::string> thin_shapes = {"thin_plate", "cup", "table", "chair", "glasses"};

Raw_shape cloud(const std::string& name, const std::size_t size)
{
  auto made = Shape_generator::make_cloud(name, size, 1);
  Raw_shape raw;
  raw.positions = std::move(made.points);
  raw.normals = std::move(made.normals);
  return raw;
}

/// moves points by a standard deviation of so many mean distances to the nearest other point
void add_noise(Raw_shape& raw, const double spacings)
{
  const WCS::internal::Oriented_points points = WCS::internal::orient_points(raw);
  const WCS::internal::Kd_tree tree(points.positions);
  double sum = 0.;
  for (const auto& p : points.positions)
    tree.nearest(p, 2, [&](const WCS::internal::Index, const float d2) { sum += std::sqrt(d2); });
  const double size =
      std::sqrt(3.) * spacings * sum * points.extent / static_cast<double>(points.size());
  std::mt19937 random(2);
  for (auto& p : raw.positions)
    for (double& c : p) c += size * (2. * Speed_shapes::unit_random(random) - 1.);
}

double share_of_right(const Raw_shape& truth, const Normal_orientation orientation)
{
  Raw_shape bare = truth;
  WCS::internal::estimate_normals(bare, {}, orientation);
  double right = 0.;
  for (std::size_t i = 0; i < truth.normals.size(); ++i)
    right += std::inner_product(truth.normals[i].begin(), truth.normals[i].end(),
                                bare.normals[i].begin(), 0.) > 0.;
  return right / static_cast<double>(truth.normals.size());
}

void print_shares(const std::string& title, const std::vector<std::string>& shapes)
{
  std::cout << "share of normals that point outwards, mean of " << title << " (least of a shape)\n"
            << "points, noise in spacings:            0             0.2             0.5\n";
  for (const std::size_t size : {4000u, 20000u})
    for (const auto& [name, orientation] : rows)
    {
      std::cout << std::setw(6) << size << std::setw(19) << name << std::fixed;
      for (const double noise : {0., 0.2, 0.5})
      {
        std::vector<double> shares;
        for (const std::string& shape : shapes)
        {
          Raw_shape raw = cloud(shape, size);
          add_noise(raw, noise);
          shares.push_back(share_of_right(raw, orientation));
        }
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.);
        std::cout << std::setprecision(4) << std::setw(8)
                  << sum / static_cast<double>(shares.size()) << " ("
                  << *std::min_element(shares.begin(), shares.end()) << ')';
      }
      std::cout << std::endl;
    }
}

void print_times(const std::size_t size, const std::size_t runs)
{
  using namespace Speed_shapes;
  Raw_shape raw;
  const Cloud cloud = ordinary(size);
  for (const auto& p : cloud) raw.positions.push_back({p.first.x(), p.first.y(), p.first.z()});
  std::vector<double> floor, seconds[2];
  for (std::size_t run = 0; run < runs; ++run)
  {
    floor.push_back(seconds_of(cpu_seconds, [&] { search_neighbors(cloud); }));
    for (std::size_t r = 0; r < rows.size(); ++r)
      seconds[r].push_back(seconds_of(
          cpu_seconds, [&] { WCS::internal::estimate_normals(raw, {}, rows[r].second); }));
  }
  std::cout << size << " points, CPU time: T " << std::setprecision(3) << median(floor) << " s";
  for (std::size_t r = 0; r < rows.size(); ++r)
    std::cout << ", " << rows[r].first << ' ' << std::setprecision(2)
              << median(seconds[r]) / median(floor) << " T";
  std::cout << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  namespace po = boost::program_options;
  std::size_t runs = 3;
  po::options_description options("benchmark_normals [options]");
  options.add_options()("help,h", "show this text")("runs", po::value(&runs),
                                                    "runs whose median time counts (3)");
  try
  {
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    po::notify(given);
    if (given.count("help")) return std::cout << options, 0;
    if (runs < 1) throw std::invalid_argument("--runs is at least 1");
    print_shares("nine ordinary shapes", ordinary_shapes);
    print_shares("five with thin walls and bars", thin_shapes);
    for (const std::size_t size : {100000u, 1000000u}) print_times(size, runs);
  }
  catch (const std::exception& e)
  {
    std::cerr << "benchmark_normals: " << e.what() << '\n';
    return 1;
  }
}
