// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes what each stage makes of a mesh as one JSON file, for the figures of the manual:
//
//   trace_stages SHAPE TRACE.json [PRESET] [NAME=VALUE...]
//
// SHAPE is a mesh file or a shape of make_shapes, PRESET default, training_free or paper. All elements are faces,
// numbered in input order; lengths are in units of the input.

#include "program/set_parameter.h"

#include "io/atomic_file.h"
#include "io/read_shape.h"
#include "shapes/shape_generator.h"

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>
#include <CGAL/property_map.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
using Json = nlohmann::json;
using WCS::internal::Shape_analysis;

namespace {

Shape_io::Shape read_mesh(const std::string& name)
{
  if (std::filesystem::exists(name))
  {
    Shape_io::Shape shape = Shape_io::read_shape(name);
    if (!shape.is_mesh()) throw std::invalid_argument(name + " has no faces; give a mesh");
    return shape;
  }
  const Shape_generator::Labeled_mesh mesh = Shape_generator::make_mesh(name);
  Shape_io::Shape shape;
  for (const auto& p : mesh.points) shape.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : mesh.faces) shape.polygons.emplace_back(f.begin(), f.end());
  return shape;
}

WCS::Parameters read_parameters(const std::vector<std::string>& words)
{
  WCS::Parameters parameters;
  for (const std::string& word : words)
    if (word.find('=') == std::string::npos)
      parameters = WCS::Parameters::preset(word);
    else
      Named_parameters::set_parameter(parameters, word);
  return parameters;
}

/// A face of each representative.
std::vector<WCS::internal::Index> faces_of_representatives(const Shape_analysis& shape)
{
  std::vector<WCS::internal::Index> faces(shape.points().size());
  for (std::size_t i = 0; i < shape.input.size(); ++i)
    faces[shape.representative(i)] = shape.input.elements[i];
  return faces;
}

/// One face a patch, and between which of them is a line of sight: rows of 0 and 1.
Json lines_of_sight(const Shape_analysis& shape, const std::size_t faces_per_patch)
{
  const auto face_of = faces_of_representatives(shape);
  std::vector<WCS::internal::Index> sample;
  Json faces = Json::array(), patches = Json::array(), rows = Json::array();
  for (std::size_t p = 0; p < shape.patches().size(); ++p)
    for (const auto i : WCS::internal::spread_sample(shape.patches().members[p], faces_per_patch))
    {
      sample.push_back(i);
      faces.push_back(face_of[i]);
      patches.push_back(p);
    }
  for (const auto i : sample)
  {
    std::string row;
    for (const auto j : sample) row += shape.sight->sees(i, j) ? '1' : '0';
    rows.push_back(row);
  }
  return {{"faces", faces}, {"patches", patches}, {"seen", rows}};
}

/// The visibility of each pair of patches, as it is used: a row a patch.
Json visibility(Shape_analysis& shape)
{
  Json rows = Json::array();
  const int count = static_cast<int>(shape.patches().size());
  for (int a = 0; a < count; ++a)
  {
    std::vector<double> row;
    for (int b = 0; b < count; ++b) row.push_back(a == b ? 1. : shape.visibility()(a, b));
    rows.push_back(row);
  }
  return rows;
}

Json diameters(const Shape_analysis& shape)
{
  const auto face_of = faces_of_representatives(shape);
  Json result = Json::array();
  for (const auto& sample : shape.diameters)
    result.push_back(
        {face_of[sample.point], sample.diameter * static_cast<float>(shape.input.extent)});
  return result;
}

Json labels_of(const WCS::Result& result, const Json& moved)
{
  return {{"patches", result.labels_at(WCS::Level::PATCHES)},
          {"components", result.labels_at(WCS::Level::COMPONENTS)},
          {"merged", moved},
          {"segments", result.labels}};
}

Json trace(const Shape_io::Shape& mesh, const WCS::Parameters& parameters)
{
  parameters.check();
  const WCS::internal::Run_control control;
  const auto shape = WCS::internal::analyze_shape(
      WCS::internal::read_soup(mesh.points, mesh.polygons,
                               CGAL::Identity_property_map<Shape_io::Point>()),
      parameters, control);
  const WCS::Result result = WCS::internal::segment_shape(*shape, parameters, control);
  const WCS::Merge_tree& tree = result.merge_tree;
  const std::vector<int> regions = tree.labels_after(tree.number_of_accepted_merges());
  std::vector<int> merged; // segments before refinement
  for (const int patch : result.patches) merged.push_back(regions[patch]);
  Json points = Json::array(), ranks = Json::array();
  for (const auto& p : mesh.points) points.push_back({p.x(), p.y(), p.z()});
  for (const WCS::Segment& s : result.segments) ranks.push_back(s.convexity_rank);
  return {{"points", points},
          {"faces", mesh.polygons},
          {"labels", labels_of(result, merged)},
          {"convexity_ranks", ranks},
          {"lines", lines_of_sight(*shape, 2)},
          {"visibility", visibility(*shape)},
          {"diameters", diameters(*shape)}};
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc < 3)
      throw std::invalid_argument(
          "give SHAPE TRACE.json [default|training_free|paper] [NAME=VALUE...]");
    const Json json = trace(read_mesh(argv[1]), read_parameters({argv + 3, argv + argc}));
    Shape_io::Atomic_file file(argv[2]);
    file.stream() << json.dump() << '\n';
    file.commit();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "trace_stages: " << error.what() << '\n';
    return 1;
  }
}
