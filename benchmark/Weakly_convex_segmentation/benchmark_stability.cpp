// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How much the parts change with what should not matter: 1 - Rand Index between the labels of one shape
// and those of the same shape after a change of seed, order, pose, scale, precision (`tiny`: a move by 1e-9 of the
// diagonal), noise or sampling; a mean a category, the mean of these, and the worst shape.
//
//   benchmark_stability DATA_DIR [--preset default|training_free|paper] [--set NAME=VALUE] [--per-category N]
//                       [--points]

#include "common/shape_variants.h"
#include "program/set_parameter.h"

#include <boost/program_options.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
namespace po = boost::program_options;
using Shape_variants::diagonal;
using Shape_variants::moved;
using Shape_variants::noisy;
using Shape_variants::Raw_shape;

namespace {

std::vector<int> labels_of(const Raw_shape& raw, const WCS::Parameters& parameters)
{
  return WCS::internal::segment_points(raw, parameters, {}).labels;
}

double distance_of_labels(const std::vector<int>& a, const std::vector<int>& b)
{
  std::map<int, double> of_a, of_b;
  std::map<std::pair<int, int>, double> both;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    of_a[a[i]] += 1.;
    of_b[b[i]] += 1.;
    both[{a[i], b[i]}] += 1.;
  }
  const auto pairs = [](const auto& counts)
  {
    double sum = 0.;
    for (const auto& entry : counts) sum += 0.5 * entry.second * (entry.second - 1.);
    return sum;
  };
  const double n = static_cast<double>(a.size());
  return (pairs(of_a) + pairs(of_b) - 2. * pairs(both)) / (0.5 * n * (n - 1.));
}

double mean_edge(const SM::Mesh& mesh)
{
  double sum = 0.;
  for (const auto& f : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const SM::Point &p = mesh.points[f[k]], &q = mesh.points[f[(k + 1) % 3]];
      sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  return sum / (3. * static_cast<double>(mesh.faces.size()));
}

/// two points a face, in the middle of its halves beside the midpoint of its longest edge
Raw_shape doubled(const SM::Mesh& mesh)
{
  SM::Mesh halves;
  halves.points = mesh.points;
  for (auto f : mesh.faces)
  {
    const auto length = [&](const std::size_t k)
    {
      const SM::Point &p = mesh.points[f[k]], &q = mesh.points[f[(k + 1) % 3]];
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    };
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (length(k) > length(longest)) longest = k;
    std::rotate(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(longest), f.end());
    SM::Point middle;
    for (std::size_t x = 0; x < 3; ++x)
      middle[x] = 0.5 * (mesh.points[f[0]][x] + mesh.points[f[1]][x]);
    halves.points.push_back(middle);
    const std::size_t m = halves.points.size() - 1;
    halves.faces.push_back({f[0], m, f[2]});
    halves.faces.push_back({m, f[1], f[2]});
  }
  const Raw_shape whole = Shape_variants::read_raw(halves);
  return Shape_variants::kept_centroids(whole, std::vector<char>(halves.faces.size(), 1)).raw;
}

/// the elements of a mesh as they are segmented: faces, or their centroids without the mesh
Raw_shape read_elements(const SM::Mesh& mesh, const bool points_only)
{
  using Shape_variants::Variant;
  return Shape_variants::make_variant(mesh, points_only ? Variant::POINTS : Variant::MESH, 0).raw;
}

const std::vector<std::string> changes = {"seed",  "order",      "motion",     "scale", "tiny",
                                          "float", "noise_edge", "noise_diag", "half",  "double"};

/// distances of the labels after each of the changes
std::vector<double> distances(const SM::Mesh& mesh, const WCS::Parameters& parameters,
                              const bool points_only, std::mt19937& random)
{
  const auto read_raw = [points_only](const SM::Mesh& m) { return read_elements(m, points_only); };
  const std::vector<int> base = labels_of(read_raw(mesh), parameters);
  const auto distance_of = [&](const SM::Mesh& other)
  { return distance_of_labels(base, labels_of(read_raw(other), parameters)); };
  std::vector<double> result;

  WCS::Parameters other_seed = parameters;
  ++other_seed.seed;
  result.push_back(distance_of_labels(base, labels_of(read_raw(mesh), other_seed)));

  std::vector<std::size_t> order(mesh.faces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  SM::Mesh shuffled = mesh;
  for (std::size_t i = 0; i < order.size(); ++i) shuffled.faces[i] = mesh.faces[order[i]];
  const std::vector<int> of_shuffled = labels_of(read_raw(shuffled), parameters);
  std::vector<int> restored(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) restored[order[i]] = of_shuffled[i];
  result.push_back(distance_of_labels(base, restored));

  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, 0.7, -0.5).normalized()).toRotationMatrix();
  result.push_back(distance_of(moved(mesh,
                                     [&](const SM::Point& p)
                                     {
                                       const Eigen::Vector3d q =
                                           turn * Eigen::Vector3d(p[0], p[1], p[2]);
                                       return SM::Point{q[0] + 3., q[1] - 2., q[2] + 5.};
                                     })));
  result.push_back(distance_of(moved(mesh,
                                     [](const SM::Point& p) {
                                       return SM::Point{7.3 * p[0], 7.3 * p[1], 7.3 * p[2]};
                                     })));
  result.push_back(distance_of(noisy(mesh, 1e-9 * diagonal(mesh), random)));
  result.push_back(distance_of(
      moved(mesh,
            [](const SM::Point& p) // as in a binary STL file
            {
              return SM::Point{double(float(p[0])), double(float(p[1])), double(float(p[2]))};
            })));
  result.push_back(distance_of(noisy(mesh, 0.1 * mean_edge(mesh), random)));
  result.push_back(distance_of(noisy(mesh, 0.01 * diagonal(mesh), random)));

  const auto half = Shape_variants::make_variant(mesh, Shape_variants::Variant::HALF, random());
  std::vector<int> base_of_half;
  for (const std::size_t f : half.faces) base_of_half.push_back(base[f]);
  result.push_back(distance_of_labels(base_of_half, labels_of(half.raw, parameters)));

  const std::vector<int> of_doubled = labels_of(doubled(mesh), parameters);
  std::vector<int> of_first(base.size());
  for (std::size_t f = 0; f < base.size(); ++f) of_first[f] = of_doubled[2 * f];
  result.push_back(distance_of_labels(base, of_first));
  return result;
}

void print_row(const std::string& name, const std::vector<double>& values, const double count)
{
  std::printf("%-10s", name.c_str());
  for (const double v : values) std::printf(" %10.4f", v / count);
  std::printf("\n");
  std::fflush(stdout);
}

void run(const std::filesystem::path& data, const WCS::Parameters& parameters, const int models,
         const bool points_only)
{
  std::printf("%-10s", "");
  for (const std::string& change : changes) std::printf(" %10s", change.c_str());
  std::printf("\n");
  std::vector<double> total(changes.size(), 0.), worst(changes.size(), 0.);
  double categories = 0.;
  std::mt19937 random(1);
  for (std::size_t c = 0; c < SM::category_names().size(); ++c)
  {
    std::vector<double> sum(changes.size(), 0.);
    int count = 0;
    for (int n = 1; n <= 400 && count < models; ++n)
    {
      const std::filesystem::path path = data / "off" / (std::to_string(n) + ".off");
      if (!SM::is_in_benchmark(n) || SM::category_of_model(n) != c ||
          !std::filesystem::exists(path))
        continue;
      const auto of_model = distances(SM::read_off(path), parameters, points_only, random);
      for (std::size_t i = 0; i < sum.size(); ++i)
      {
        sum[i] += of_model[i];
        worst[i] = (std::max)(worst[i], of_model[i]);
      }
      ++count;
    }
    if (count == 0) continue;
    print_row(SM::category_names()[c], sum, count);
    for (std::size_t i = 0; i < sum.size(); ++i) total[i] += sum[i] / count;
    categories += 1.;
  }
  if (categories == 0.)
    throw std::runtime_error("there are no models in " + (data / "off").string() +
                             "; give the folder that holds off/");
  print_row("mean", total, categories);
  print_row("worst", worst, 1.);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    std::filesystem::path data;
    std::string preset_name;
    std::vector<std::string> settings;
    int models = 1;
    po::options_description options("benchmark_stability DATA_DIR [options]");
    options.add_options()("help", "print this")("preset",
                                                po::value(&preset_name)->default_value("default"),
                                                "default, training_free or paper")(
        "per-category", po::value(&models), "models a category (1)")(
        "set", po::value(&settings)->composing(), "NAME=VALUE of a parameter; may be repeated")(
        "points", "segment the centroids of the faces, without the mesh")(
        "data", po::value(&data)->required(), "folder that holds off/");
    po::positional_options_description positional;
    positional.add("data", 1);
    po::variables_map map;
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(),
              map);
    if (map.count("help") > 0)
    {
      std::cout << options;
      return 0;
    }
    po::notify(map);
    WCS::Parameters parameters = WCS::Parameters::preset(preset_name);
    for (const std::string& s : settings) Named_parameters::set_parameter(parameters, s);
    run(data, parameters, models, map.count("points") > 0);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_stability: " << error.what() << '\n';
    return 1;
  }
}
