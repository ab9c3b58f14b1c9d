// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_METHODS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_METHODS_H

#include "baselines/pcl_program.h"
#include "baselines/scan_baselines.h"
#include "common/run_in_child_process.h"
#include "scanner/virtual_scanner.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What is compared on scans: ways from points with normals to a label a point.

namespace Scan_methods {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Virtual_scanner::Scan;

/// The settings of PCL's methods with the best mean over ten kinds of scan (1 to 16 views, without and with
/// noise) of 19 odd-numbered models of the Princeton Segmentation Benchmark, as segment_by_pcl takes them: of
/// 24 for LCCP and 18 for CPC. For few views alone others are better, see the project's README.
constexpr const char* lccp_settings = "0.01/0.02/0/1/1";
constexpr const char* cpc_settings = "0.01/0.03/20/0/0";

/// A method as it is written on the command line: NAME or, with settings of its own, NAME@SETTINGS.
struct Method
{
  std::string text, name, settings;
};

inline bool is_ours(const Method& m)
{
  return m.name == "default" || m.name == "training_free" || m.name == "paper";
}

inline Method method_from(const std::string& text)
{
  const std::size_t at = text.find('@');
  Method method{text, text.substr(0, at), at == std::string::npos ? "" : text.substr(at + 1)};
  const bool has_settings = method.name == "sdf" || method.name == "lccp" || method.name == "cpc";
  if (!has_settings && !(is_ours(method) && method.settings.empty()))
    throw std::invalid_argument("there is no method '" + text +
                                "'; take default, training_free, paper, sdf, lccp, cpc");
  return method;
}

inline std::vector<int> segment_by_us(const Scan& scan, const WCS::Parameters& parameters)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const auto &p = scan.points[i], &n = scan.normals[i];
    points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  return WCS::Segmenter<CGAL::Sequential_tag>(
             points, parameters,
             CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                 .normal_map(CGAL::Second_of_pair_property_map<Oriented>()))
      .segment(parameters)
      .labels;
}

inline Scan_baselines::Sdf_settings sdf_settings_from(const std::string& text)
{
  Scan_baselines::Sdf_settings settings;
  if (text.empty()) return settings;
  std::istringstream in(text);
  std::array<char, 2> slashes{};
  in >> settings.clusters >> slashes[0] >> settings.smoothing >> slashes[1] >> settings.cell;
  if (!in || slashes != std::array<char, 2>{'/', '/'})
    throw std::invalid_argument("'" + text + "' are no settings of sdf; give them as 3/0.03/0.01");
  return settings;
}

/// in a process of its own: reconstructions of scans bring meshes that nobody has tested
inline std::vector<int> segment_by_sdf(const Scan& scan, const std::string& settings)
{
  constexpr unsigned most_seconds = 300;
  const auto outcome = Run_in_child_process::run(
      [&]() -> std::vector<Run_in_child_process::Labeling> {
        return {{"sdf", Scan_baselines::segment_by_sdf(scan, sdf_settings_from(settings)), 0.}};
      },
      most_seconds);
  if (!outcome.failure.empty()) throw std::runtime_error(outcome.failure);
  return outcome.labelings.at(0).labels;
}

/// returns a label a point by a method of others.
/// \throws std::exception if it fails
inline std::vector<int> segment_by_others(const Scan& scan, const Method& method,
                                          const std::filesystem::path& program_folder)
{
  if (method.name == "sdf") return segment_by_sdf(scan, method.settings);
  const char* const usual = method.name == "lccp" ? lccp_settings : cpc_settings;
  return Pcl_program::run(program_folder, method.name, scan.points, scan.normals, 0.,
                          method.settings.empty() ? usual : method.settings)
      .labels;
}

} // namespace Scan_methods

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_METHODS_H
