// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "baselines/compared_methods.h"
#include "common/speed_shapes.h"
#include "metrics/princeton_benchmark.h"

#include <CGAL/property_map.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <boost/program_options.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

// How fast the default is, in ratios that mean the same on any machine: against CGAL's search for ten
// nearest neighbors of the same points, and against other methods on the same meshes.

namespace {

using namespace Speed_shapes;
namespace WCS = CGAL::Weakly_convex_segmentation;

double wall_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <typename Tag = CGAL::Sequential_tag>
std::vector<int> segment(const Cloud& cloud)
{
  std::vector<int> labels(cloud.size());
  std::vector<std::size_t> indices(cloud.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  const auto first = CGAL::First_of_pair_property_map<Oriented_point>();
  const auto second = CGAL::Second_of_pair_property_map<Oriented_point>();
  const auto point = boost::make_function_property_map<std::size_t>(
      [&](const std::size_t i) { return get(first, cloud[i]); });
  const auto normal = boost::make_function_property_map<std::size_t>(
      [&](const std::size_t i) { return get(second, cloud[i]); });
  CGAL::weakly_convex_segmentation<Tag>(indices, CGAL::make_property_map(labels), WCS::Parameters(),
                                        CGAL::parameters::point_map(point).normal_map(normal));
  return labels;
}

double peak_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * static_cast<double>(usage.ru_maxrss);
}

void compare_with_neighbors(const std::vector<std::size_t>& sizes, const std::size_t runs)
{
  std::cout << "points       T (s)    ours (s)  ours/T  bytes a point\n";
  for (const std::size_t size : sizes)
  {
    const Cloud cloud = ordinary(size);
    std::vector<double> floor, ours, ratio;
    double bytes = 0.;
    for (std::size_t run = 0; run < runs; ++run)
    {
      const double before = peak_bytes();
      ours.push_back(seconds_of(cpu_seconds, [&] { segment(cloud); }));
      if (run == 0) bytes = (peak_bytes() - before) / static_cast<double>(size);
      floor.push_back(seconds_of(cpu_seconds, [&] { search_neighbors(cloud); }));
      ratio.push_back(ours.back() / floor.back());
    }
    std::cout << std::setw(8) << size << std::fixed << std::setprecision(3) << std::setw(10)
              << median(floor) << std::setw(12) << median(ours) << std::setprecision(2)
              << std::setw(8) << median(ratio) << std::setprecision(0) << std::setw(10) << bytes
              << std::endl;
  }
}

void compare_threads(const std::size_t size, const std::size_t runs)
{
  const Cloud cloud = ordinary(size);
  std::vector<double> ratio;
  bool same = true;
  for (std::size_t run = 0; run < runs; ++run)
  {
    std::vector<int> one, all;
    const double alone = seconds_of(wall_seconds, [&] { one = segment(cloud); });
    ratio.push_back(alone / seconds_of(wall_seconds, [&]
                                       { all = segment<CGAL::Parallel_if_available_tag>(cloud); }));
    same = same && one == all;
  }
  std::cout << "all threads on " << size << " points: " << std::setprecision(2) << median(ratio)
            << " times as fast as one (wall clock), " << (same ? "the same" : "OTHER")
            << " labels\n";
}

void compare_shapes(const std::size_t size, const std::size_t runs)
{
  const auto time = [runs](const Cloud& cloud)
  {
    std::vector<double> seconds;
    for (std::size_t run = 0; run < runs; ++run)
      seconds.push_back(seconds_of(cpu_seconds, [&] { segment(cloud); }));
    return median(seconds) / static_cast<double>(cloud.size());
  };
  const double usual = time(ordinary(size));
  const std::pair<const char*, Cloud (*)(std::size_t)> shapes[] = {
      {"hollow sphere", hollow_sphere},
      {"5000 separate pieces", separate_pieces},
      {"flat sheet", flat_sheet},
      {"long thin wire", straight_wire}};
  for (const auto& [name, make] : shapes)
    std::cout << std::setw(22) << name << ": " << std::setprecision(2) << time(make(size)) / usual
              << " times the time a point of an ordinary shape" << std::endl;
}

// CPU seconds of each method for one mesh; none if it is no manifold.
std::map<std::string, double> seconds_of_methods(const Segmentation_metrics::Mesh& soup,
                                                 const std::filesystem::path& programs)
{
  using namespace Compared_methods;
  const Shape shape{soup, surface_mesh(soup), {}, programs};
  std::map<std::string, double> seconds;
  if (shape.mesh.is_empty()) return seconds;
  std::vector<std::vector<Labeling>> results = {segment_by_default(shape), segment_by_sdf(shape),
                                                segment_by_preset(shape, "training_free")};
  if (Pcl_program::is_built(programs)) results.push_back(segment_by_pcl(shape, "cpc"));
  for (const auto& labelings : results)
    for (const Labeling& labeling : labelings) seconds[labeling.method] = labeling.cpu_seconds;
  return seconds;
}

// Other methods' times on the same meshes, as ratios to the default's.
void compare_with_others(const std::filesystem::path& folder, const int step,
                         const std::filesystem::path& programs)
{
  std::map<std::string, std::vector<double>> ratios;
  for (int model = 1, seen = 0; model <= 400; ++model)
  {
    const auto path = folder / "off" / (std::to_string(model) + ".off");
    if (!Segmentation_metrics::is_in_benchmark(model) || !std::filesystem::exists(path)) continue;
    if (seen++ % step != 0) continue;
    const auto seconds = seconds_of_methods(Segmentation_metrics::read_off(path), programs);
    for (const auto& [method, own] : seconds) ratios[method].push_back(own / seconds.at("default"));
  }
  if (ratios.empty()) throw std::runtime_error("'" + folder.string() + "' has no off/N.off");
  const std::pair<const char*, const char*> methods[] = {
      {"sdf", "CGAL's segmentation by its shape diameter function"},
      {"cpc", "PCL's CPC"},
      {"training_free", "the preset training_free"}};
  for (const auto& [method, name] : methods)
    if (const auto& own = ratios[method]; own.empty())
      std::cout << name << " is not measured: PCL was not there when this was built\n";
    else
      std::cout << own.size() << " meshes: " << name << " takes " << std::setprecision(2)
                << median(own) << " times as long (least "
                << *std::min_element(own.begin(), own.end()) << ")\n";
}

} // namespace

int main(int argc, char* argv[])
{
  namespace po = boost::program_options;
  std::string data;
  std::size_t runs = 5, largest = 1000000;
  int step = 1;
  po::options_description options("benchmark_speed [DATA_DIR] [options]");
  auto add = options.add_options();
  add("help,h", "show this text");
  add("data", po::value(&data), "folder with off/N.off of the Princeton benchmark");
  add("runs", po::value(&runs), "runs whose median counts (5)");
  add("largest", po::value(&largest), "most points (1000000)");
  add("step", po::value(&step), "every so many-th mesh only (1)");
  try
  {
    po::positional_options_description positional;
    positional.add("data", 1);
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(),
              given);
    po::notify(given);
    if (given.count("help")) return std::cout << options, 0;
    if (runs < 1 || step < 1) throw std::invalid_argument("--runs and --step are at least 1");
    std::vector<std::size_t> sizes;
    for (const std::size_t size : {10000u, 20000u, 100000u, 1000000u, 10000000u})
      if (size <= largest) sizes.push_back(size);
    compare_with_neighbors(sizes, runs);
    compare_shapes((std::min)(largest, std::size_t(50000)), runs);
    for (const std::size_t size : {20000u, 1000000u})
      if (size <= largest) compare_threads(size, runs);
    if (!data.empty())
      compare_with_others(data, step, std::filesystem::path(argv[0]).parent_path());
  }
  catch (const std::exception& e)
  {
    std::cerr << "benchmark_speed: " << e.what() << '\n';
    return 1;
  }
}
