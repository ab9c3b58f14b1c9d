// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Scores the objects and parts that segment_scene finds in depth-camera scenes against their labels.

#include "named_parameters.h"
#include "read_shape.h"
#include "scene_objects.h"
#include "scene_scores.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;

struct Options
{
  std::filesystem::path scenes;
  Scene_objects::Options scene;
};

/// returns whether there is something to run.
bool read_options(const int argc, char** argv, Options& options)
{
  std::vector<std::string> settings;
  std::string preset, scenes; // a path is read from a text only up to its first space
  Scene_objects::Options& scene = options.scene;
  po::options_description visible("benchmark_scenes SCENE_DIR [options]\n"
                                  "scores objects and parts of the scenes *.ply, which have an int "
                                  "property 'label': 1 to 9 the "
                                  "table, 20 to 29 the first object, 30 to 39 the second, ...");
  visible.add_options()("help", "print this")("preset", po::value(&preset)->default_value("fitted"),
                                              "default or fitted")(
      "cell", po::value(&scene.cell)->default_value(scene.cell), "thinning in meters")(
      "normal-neighbors", po::value(&scene.normal_neighbors)->default_value(scene.normal_neighbors),
      "points that a normal comes from")(
      "plane-distance", po::value(&scene.plane_distance)->default_value(scene.plane_distance),
      "half thickness of the plane in meters")("set", po::value(&settings)->composing(),
                                               "NAME=VALUE of a parameter; may be repeated");
  po::options_description all;
  all.add(visible).add_options()("scenes", po::value(&scenes)->required(), "");
  po::positional_options_description positional;
  positional.add("scenes", 1);
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), map);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  po::notify(map);
  options.scenes = scenes;
  if (preset != "default" && preset != "fitted")
    throw std::invalid_argument("there is no preset '" + preset + "'; use default or fitted");
  if (preset == "default") scene.parameters = Scene_objects::WCS::Parameters();
  for (const std::string& s : settings) Named_parameters::set_parameter(scene.parameters, s);
  return true;
}

std::vector<int> true_objects(const Shape_io::Shape& shape, const std::string& file)
{
  for (const Shape_io::Property& property : shape.point_properties)
  {
    if (property.name != "label") continue;
    std::vector<int> objects;
    // tens name the object; what is below 20 is the table
    for (const double label : property.values)
      objects.push_back(label < 20. ? -1 : static_cast<int>(label) / 10);
    return objects;
  }
  throw std::runtime_error(file + " has no property 'label'; take labelled scenes");
}

std::vector<int> of_points(const Scene_objects::Scene& scene, const std::vector<int>& of_cells)
{
  std::vector<int> result;
  for (const std::size_t cell : scene.cell_of) result.push_back(of_cells[cell]);
  return result;
}

void print(const std::string& name, const Scene_scores::Scores& s)
{
  std::printf("%-22s %6.3f %6.3f %6.3f %6.3f\n", name.c_str(), s.over_segmentation,
              s.under_segmentation, s.weighted_overlap, s.unweighted_overlap);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Options options;
    if (!read_options(argc, argv, options)) return EXIT_SUCCESS;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(options.scenes))
      if (entry.path().extension() == ".ply") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    if (files.empty())
      throw std::runtime_error("there are no *.ply in " + options.scenes.string() +
                               "; give the folder of the scenes");
    Scene_scores::Scores of_parts, of_pieces;
    double seconds = 0.;
    std::printf("%-22s %6s %6s %6s %6s\n", "scene", "F_os", "F_us", "WOv", "UOv");
    for (const auto& file : files)
    {
      const Shape_io::Shape shape = Shape_io::read_shape(file.string());
      const std::vector<int> truth = true_objects(shape, file.string());
      const auto begin = std::chrono::steady_clock::now();
      const Scene_objects::Scene scene = Scene_objects::segment_scene(shape.points, options.scene);
      seconds = (std::max)(
          seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      const auto parts = Scene_scores::score(truth, of_points(scene, scene.part));
      const auto pieces = Scene_scores::score(truth, of_points(scene, scene.object));
      const double weight = 1. / static_cast<double>(files.size());
      of_parts.add(parts, weight);
      of_pieces.add(pieces, weight);
      print(file.stem().string() + " parts", parts);
      print(file.stem().string() + " pieces", pieces);
    }
    print("mean, parts", of_parts);
    print("mean, separated pieces", of_pieces);
    std::printf("longest time of a scene without reading: %.2f s\n", seconds);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_scenes: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
