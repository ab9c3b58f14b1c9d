// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// One view of a depth camera: finds what stands on the supporting plane, and its parts.

#include "io/atomic_file.h"
#include "io/gaps.h"
#include "io/part_colors.h"
#include "io/read_shape.h"
#include "io/write_parts.h"
#include "program/command_line.h"
#include "program/interruption.h"
#include "program/program_errors.h"
#include "scanner/scene_objects.h"

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;

struct Files
{
  std::string input, parts, stats;
};

// returns whether there is something to do.
bool read_options(const int argc, char** argv, Files& files, Scene_objects::Options& options)
{
  std::vector<double> viewpoint, plane;
  std::string preset;
  po::options_description visible("segment_scene SCENE.ply [options]\n"
                                  "finds the objects on a table, and their parts\nOptions");
  visible.add_options()("help,h", "print this")(
      "output,o", po::value(&files.parts), "colored scene (PLY)")("stats", po::value(&files.stats),
                                                                  "numbers of the objects (JSON)")(
      "viewpoint", po::value(&viewpoint)->multitoken(), "x y z of the sensor, 0 0 0 by default")(
      "plane", po::value(&plane)->multitoken(),
      "a b c d: the plane a x + b y + c z + d = 0 that the objects stand on, by default that "
      "with the most on it")("cell", po::value(&options.cell)->default_value(options.cell),
                             "thinning, in scene units")(
      "plane-distance", po::value(&options.plane_distance)->default_value(options.plane_distance),
      "half thickness of the plane")("gap", po::value(&options.gap)->default_value(options.gap),
                                     "distance that separates objects")(
      "preset", po::value(&preset)->default_value("default"), "default, training_free or paper");
  const po::variables_map map = Command_line::parsed("segment_scene", argc, argv, visible);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  if (map.count("input") > 0) files.input = map["input"].as<std::string>();
  options.parameters =
      Scene_objects::with_depth_noise(Scene_objects::WCS::Parameters::preset(preset));
  if (!(options.cell > 0. && options.plane_distance > 0. && options.gap > 0.))
    throw std::invalid_argument("--cell, --plane-distance and --gap have to be above 0");
  if (!plane.empty())
  {
    if (plane.size() != 4 || (plane[0] == 0. && plane[1] == 0. && plane[2] == 0.))
      throw std::invalid_argument(
          "--plane takes four numbers, of which the first three are a normal");
    options.plane = Scene_objects::Kernel::Plane_3(plane[0], plane[1], plane[2], plane[3]);
  }
  if (!viewpoint.empty() && viewpoint.size() != 3)
    throw std::invalid_argument("--viewpoint takes three numbers");
  if (viewpoint.size() == 3)
    options.viewpoint = Scene_objects::Point(viewpoint[0], viewpoint[1], viewpoint[2]);
  return true;
}

// A point where the sensor itself is can't have been measured.
Shape_io::Shape read_scene(const std::string& path, const Scene_objects::Point& viewpoint)
{
  Shape_io::Shape shape = Shape_io::read_shape(path, Shape_io::Gaps::ALLOWED);
  if (shape.is_mesh()) throw std::runtime_error("the input is a mesh; give a cloud of points");
  shape.has_gaps_at_origin =
      viewpoint == CGAL::ORIGIN || Shape_io::has_repeated_origin(shape.points);
  return shape;
}

// The parts are 1, 2, ...; 0 is the plane and the background, -1 a pixel without a measurement.
void write_scene(const Shape_io::Shape& whole, const Shape_io::Measured_shape& measured,
                 const Scene_objects::Scene& scene, std::ostream& out)
{
  Shape_io::Parts parts;
  for (const std::size_t cell : scene.cell_of)
  {
    parts.labels.push_back(scene.part[cell] + 1);
    parts.quality.push_back(static_cast<double>(scene.object[cell] + 1));
  }
  parts.colors = Shape_io::part_colors(Shape_io::part_neighbors(
      measured.shape(), parts.labels, static_cast<std::size_t>(scene.number_of_parts) + 1));
  parts.colors[0] = {190, 190, 190};
  Shape_io::write_parts(out, whole, measured.spread(parts));
}

void write_stats(const Scene_objects::Scene& scene, const std::size_t number_of_gaps,
                 const double seconds, std::ostream& out)
{
  nlohmann::ordered_json objects = nlohmann::ordered_json::array();
  std::vector<std::size_t> sizes(scene.parts_of.size(), 0);
  for (const std::size_t cell : scene.cell_of)
    if (scene.object[cell] >= 0) ++sizes[static_cast<std::size_t>(scene.object[cell])];
  for (std::size_t i = 0; i < sizes.size(); ++i)
    objects.push_back({{"points", sizes[i]}, {"parts", scene.parts_of[i]}});
  const auto& plane = scene.plane;
  const nlohmann::ordered_json stats = {{"points", scene.cell_of.size()},
                                        {"number_of_gaps", number_of_gaps},
                                        {"cells", scene.cells.size()},
                                        {"plane", {plane.a(), plane.b(), plane.c(), plane.d()}},
                                        {"objects", objects},
                                        {"parts", scene.number_of_parts},
                                        {"seconds", seconds}};
  out << stats.dump(2) << '\n';
}

void segment_scene(const Files& files, const Scene_objects::Options& options)
{
  if (files.input.empty())
    throw std::invalid_argument("there is no scene; give SCENE.ply, see segment_scene --help");
  std::vector<std::string> outputs;
  for (const std::string& path : {files.parts, files.stats})
    if (!path.empty()) outputs.push_back(path);
  Shape_io::check_output_places(outputs, {files.input});
  for (const std::string& path : outputs) Shape_io::Atomic_file::check(path);
  const auto begin = std::chrono::steady_clock::now();
  const Shape_io::Shape shape = read_scene(files.input, options.viewpoint);
  const Shape_io::Measured_shape measured(shape);
  const Scene_objects::Scene scene = Scene_objects::segment_scene(measured.shape().points, options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Program_errors::Interruption interruption; // before there is a file to leave behind
  std::optional<Shape_io::Atomic_file> parts, stats;
  if (!files.parts.empty())
    write_scene(shape, measured, scene, parts.emplace(files.parts).stream());
  if (!files.stats.empty())
    write_stats(scene, measured.number_of_gaps(), seconds, stats.emplace(files.stats).stream());
  if (parts) parts->finish();
  if (stats) stats->finish();
  interruption.check();
  const auto& plane = scene.plane;
  std::cout << scene.parts_of.size() << " objects of " << scene.number_of_parts << " parts in "
            << seconds << " seconds, on the plane " << plane.a() << ' ' << plane.b() << ' '
            << plane.c() << ' ' << plane.d() << '\n';
  // all or none: nothing takes its place before all is written
  Program_errors::flush_standard_output();
  if (parts) parts->commit();
  if (stats) stats->commit();
}

} // namespace

int main(int argc, char** argv)
{
  return Program_errors::run("segment_scene",
                             [&]
                             {
                               Files files;
                               Scene_objects::Options options;
                               if (read_options(argc, argv, files, options))
                                 segment_scene(files, options);
                             });
}
