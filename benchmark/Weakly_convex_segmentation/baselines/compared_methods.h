// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_COMPARED_METHODS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_COMPARED_METHODS_H

#include "baselines/lines_of_sight_decomposition.h"
#include "baselines/pcl_program.h"
#include "common/run_in_child_process.h"
#include "metrics/mesh_geometry.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What is compared with each other: ways from a mesh to a label a face. Those that share most of their
// work run together.

namespace Compared_methods {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Run_in_child_process::Labeling;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Soup = Segmentation_metrics::Mesh;

struct Shape
{
  const Soup& soup;
  Surface_mesh mesh; ///< the faces in the same order; empty if they are no oriented manifold
  std::map<std::string, std::size_t> parts_found =
      {};                                    ///< by methods that ran, for those that are told
  std::filesystem::path program_folder = {}; ///< where segment_by_pcl may be
};

inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

inline std::vector<Kernel::Point_3> kernel_points(const Soup& soup)
{
  std::vector<Kernel::Point_3> points;
  for (const auto& p : soup.points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

inline Surface_mesh surface_mesh(const Soup& soup)
{
  Surface_mesh mesh;
  for (const auto& p : soup.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  const auto vertex = [](const std::size_t v)
  { return Surface_mesh::Vertex_index(static_cast<Surface_mesh::size_type>(v)); };
  for (const auto& f : soup.faces)
    if (mesh.add_face(vertex(f[0]), vertex(f[1]), vertex(f[2])) == Surface_mesh::null_face())
      return {};
  return mesh;
}

/// CPU seconds up to the end of each stage.
struct Cpu_clock : WCS::Visitor
{
  std::array<double, WCS::number_of_stages> at_end{};
  void stage_ends(const WCS::Stage stage, std::size_t) override
  {
    at_end[static_cast<std::size_t>(stage)] = cpu_seconds();
  }
};

inline WCS::Result segment(const Shape& shape, const WCS::Parameters& parameters, Cpu_clock& clock)
{
  const auto np = CGAL::parameters::visitor(std::ref(clock));
  if (!shape.mesh.is_empty())
    return WCS::Segmenter<>(shape.mesh, parameters, np).segment(parameters);
  return CGAL::weakly_convex_segmentation_of_soup(kernel_points(shape.soup), shape.soup.faces,
                                                  parameters, np);
}

/// the default, and where its first two stages end
inline std::vector<Labeling> segment_by_default(const Shape& shape)
{
  Cpu_clock clock;
  const double begin = cpu_seconds();
  const WCS::Result result = segment(shape, {}, clock);
  const double end = cpu_seconds();
  const auto until = [&](const WCS::Stage stage)
  { return clock.at_end[static_cast<std::size_t>(stage)] - begin; };
  return {{"default", result.labels, end - begin},
          {"components", result.labels_at(WCS::Level::COMPONENTS), until(WCS::Stage::FUSION)},
          {"patches", result.labels_at(WCS::Level::PATCHES), until(WCS::Stage::PATCHES)}};
}

inline std::vector<Labeling> segment_by_preset(const Shape& shape, const std::string& name)
{
  Cpu_clock clock;
  const double begin = cpu_seconds();
  const WCS::Result result = segment(shape, WCS::Parameters::preset(name), clock);
  return {{name, result.labels, cpu_seconds() - begin}};
}

inline WCS::internal::Raw_shape raw_points(const Shape& shape)
{
  if (!shape.mesh.is_empty())
    return WCS::internal::read_mesh(shape.mesh, CGAL::parameters::default_values());
  return WCS::internal::read_soup(kernel_points(shape.soup), shape.soup.faces,
                                  CGAL::Identity_property_map<Kernel::Point_3>());
}

/// The seconds are without those of stages whose results the method does not use.
/// \param number_of_parts 0: by the gap of the eigenvalues
inline std::vector<Labeling> segment_by_lines_of_sight(const Shape& shape, const std::string& name,
                                                       const std::size_t number_of_parts)
{
  Cpu_clock clock;
  WCS::internal::Run_control control;
  control.visitor = &clock;
  Lines_of_sight::Settings settings;
  settings.number_of_segments = number_of_parts;
  const double begin = cpu_seconds();
  const auto analysis = WCS::internal::analyze_shape(raw_points(shape), {}, control);
  std::vector<int> labels = Lines_of_sight::decompose(*analysis, settings);
  const double end = cpu_seconds();
  const auto at_end = [&](const WCS::Stage stage)
  { return clock.at_end[static_cast<std::size_t>(stage)]; };
  const double unused = at_end(WCS::Stage::SIGNATURES) - at_end(WCS::Stage::NEIGHBORS);
  return {{name, std::move(labels), end - begin - unused}};
}

/// the same with the number of parts that a preset found
inline std::vector<Labeling> segment_by_told_lines_of_sight(const Shape& shape,
                                                            const std::string& name,
                                                            const std::string& preset)
{
  const auto found = shape.parts_found.find(preset);
  if (found == shape.parts_found.end())
    throw std::runtime_error("the preset " + preset + ", before it, failed");
  return segment_by_lines_of_sight(shape, name, found->second);
}

/// the faces turned so that they agree, for methods that need an oriented manifold
inline Surface_mesh oriented_mesh(const Soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Kernel::Point_3> points = kernel_points(soup);
  auto faces = soup.faces;
  PMP::orient_polygon_soup(points, faces);
  Surface_mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
  if (mesh.number_of_faces() != soup.faces.size())
    throw std::runtime_error("the faces can't be made an oriented manifold");
  return mesh;
}

/// the shape diameter function of CGAL with its default clusters and smoothing, and with those that
/// were best on the odd-numbered meshes of the benchmark
inline std::vector<Labeling> segment_by_sdf(const Shape& shape)
{
  const double begin = cpu_seconds();
  Surface_mesh mesh = shape.mesh.is_empty() ? oriented_mesh(shape.soup) : shape.mesh;
  using Face = Surface_mesh::Face_index;
  const auto diameters = mesh.add_property_map<Face, double>("f:sdf", 0.).first;
  CGAL::sdf_values(mesh, diameters);
  const double of_values = cpu_seconds() - begin;
  std::vector<Labeling> labelings;
  const auto cluster = [&](const char* name, const std::size_t clusters, const double smoothing)
  {
    const double start = cpu_seconds();
    const auto parts = mesh.add_property_map<Face, std::size_t>(name, 0).first;
    CGAL::segmentation_from_sdf_values(mesh, diameters, parts, clusters, smoothing);
    Labeling labeling{name, {}, of_values + cpu_seconds() - start};
    for (const Face f : mesh.faces()) labeling.labels.push_back(static_cast<int>(parts[f]));
    labelings.push_back(std::move(labeling));
  };
  cluster("sdf", 5, 0.26);
  cluster("sdf_tuned", 3, 0.03);
  return labelings;
}

/// a method of PCL, on centroids and normals of the faces
inline std::vector<Labeling> segment_by_pcl(const Shape& shape, const std::string& method)
{
  const std::vector<Kernel::Point_3> corners = kernel_points(shape.soup);
  std::vector<Pcl_program::Coordinates> points, normals;
  double mean_area = 0.;
  for (const auto& f : shape.soup.faces)
  {
    const Kernel::Point_3 &p = corners[f[0]], &q = corners[f[1]], &r = corners[f[2]];
    const Kernel::Point_3 c = CGAL::centroid(p, q, r);
    const Kernel::Vector_3 n = CGAL::cross_product(q - p, r - p);
    mean_area += 0.5 * std::sqrt(n.squared_length()) / static_cast<double>(shape.soup.faces.size());
    points.push_back({c.x(), c.y(), c.z()});
    normals.push_back({n.x(), n.y(), n.z()});
  }
  const Pcl_program::Outcome outcome =
      Pcl_program::run(shape.program_folder, method, points, normals, 1.5 * std::sqrt(mean_area));
  return {{method, outcome.labels, outcome.cpu_seconds}};
}

struct Method
{
  std::string group; ///< methods of a group run in one process
  std::function<std::vector<Labeling>(const Shape&)> run;
  std::vector<std::string> names;
};

inline std::vector<Method> methods()
{
  using Labelings = std::vector<Labeling>;
  return {{"default", segment_by_default, {"default", "components", "patches"}},
          {"paper", [](const Shape& s) { return segment_by_preset(s, "paper"); }, {"paper"}},
          {"training_free",
           [](const Shape& s) { return segment_by_preset(s, "training_free"); },
           {"training_free"}},
          {"lines_of_sight",
           [](const Shape& s) { return segment_by_lines_of_sight(s, "lines_of_sight", 0); },
           {"lines_of_sight"}},
          {"lines_of_sight_told",
           [](const Shape& s)
           { return segment_by_told_lines_of_sight(s, "lines_of_sight_told", "default"); },
           {"lines_of_sight_told"}},
          {"lines_of_sight_told_paper",
           [](const Shape& s)
           { return segment_by_told_lines_of_sight(s, "lines_of_sight_told_paper", "paper"); },
           {"lines_of_sight_told_paper"}},
          {"sdf", segment_by_sdf, {"sdf", "sdf_tuned"}},
          {"cpc", [](const Shape& s) { return segment_by_pcl(s, "cpc"); }, {"cpc"}},
          {"lccp", [](const Shape& s) { return segment_by_pcl(s, "lccp"); }, {"lccp"}},
          {"one_segment",
           [](const Shape& s) {
             return Labelings{{"one_segment", std::vector<int>(s.soup.faces.size(), 0), 0.}};
           },
           {"one_segment"}}};
}

} // namespace Compared_methods

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_COMPARED_METHODS_H
