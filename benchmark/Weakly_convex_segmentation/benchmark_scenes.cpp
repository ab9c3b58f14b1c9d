// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Scores the objects and parts that segment_scene and methods of others find in depth-camera scenes
// against their labels.

#include "io/read_shape.h"
#include "program/set_parameter.h"
#include "scenes/scene_methods.h"
#include "scenes/scene_scores.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;

struct Options
{
  std::filesystem::path scenes, csv, program_folder;
  std::vector<std::string> methods, settings;
  Scene_objects::Options scene;
};

/// One method on one scene.
struct Row
{
  std::string scene, method;
  Scene_scores::Scores scores; ///< of no segment at all where the method failed
  double seconds = 0.;
  std::string failure;
};

/// returns whether there is something to run.
bool read_options(const int argc, char** argv, Options& options)
{
  std::string methods, scenes, csv; // a path is read from a text only up to its first space
  Scene_objects::Options& scene = options.scene;
  po::options_description visible("benchmark_scenes SCENE_DIR [options]\n"
                                  "scores objects and parts of the scenes *.ply, which have an int "
                                  "property 'label': 1 to 9 the "
                                  "table, 20 to 29 the first object, 30 to 39 the second, ...");
  visible.add_options()("help", "print this")(
      "methods", po::value(&methods)->default_value("default"),
      "of default, training_free, pieces, lccp, cpc, lccp_whole, cpc_whole; the last four may have "
      "settings: lccp@VOXEL/SEED/TOLERANCE/SMOOTHNESS/K, lengths in meters")(
      "csv", po::value(&csv), "write a row a scene and method")(
      "cell", po::value(&scene.cell)->default_value(scene.cell), "thinning in meters")(
      "normal-neighbors", po::value(&scene.normal_neighbors)->default_value(scene.normal_neighbors),
      "points that a normal comes from")(
      "plane-distance", po::value(&scene.plane_distance)->default_value(scene.plane_distance),
      "half thickness of the plane in meters")("set", po::value(&options.settings)->composing(),
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
  options.csv = csv;
  options.program_folder = std::filesystem::path(argv[0]).parent_path();
  std::istringstream list(methods);
  for (std::string word; std::getline(list, word, ',');)
    if (Scene_methods::is_of_pcl(word) && !Pcl_program::is_built(options.program_folder))
      std::cerr << word << " is skipped: segment_by_pcl was not built, for want of PCL\n";
    else
      options.methods.push_back(word);
  Scene_objects::WCS::Parameters checked;
  for (const std::string& s : options.settings) Named_parameters::set_parameter(checked, s);
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

Row run(const Shape_io::Shape& shape, const std::vector<int>& truth, const std::string& scene,
        const std::string& method, const Options& options)
{
  Row row{scene, method, {}, 0., ""};
  Scene_objects::Options scene_options = options.scene;
  if (method == "training_free")
    scene_options.parameters =
        Scene_objects::with_depth_noise(Scene_objects::WCS::Parameters::training_free());
  for (const std::string& s : options.settings)
    Named_parameters::set_parameter(scene_options.parameters, s);
  std::vector<int> labels(shape.points.size(), -1);
  try
  {
    Scene_methods::Segments segments =
        Scene_methods::segment(shape.points, method, scene_options, options.program_folder);
    labels = std::move(segments.labels);
    row.seconds = segments.seconds;
  }
  catch (const std::runtime_error& error) // not a method that there isn't
  {
    row.failure = error.what();
  }
  row.scores = Scene_scores::score(truth, labels);
  return row;
}

void write_csv(const std::vector<Row>& rows, const std::filesystem::path& path)
{
  std::ofstream out(path);
  out << "scene,method,over_segmentation,under_segmentation,weighted_overlap,unweighted_overlap,"
         "seconds,failure\n";
  for (const Row& r : rows)
  {
    std::string failure = r.failure;
    std::replace(failure.begin(), failure.end(), '"', '\'');
    out << r.scene << ',' << r.method << ',' << r.scores.over_segmentation << ','
        << r.scores.under_segmentation << ',' << r.scores.weighted_overlap << ','
        << r.scores.unweighted_overlap << ',' << r.seconds << ",\"" << failure << "\"\n";
  }
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

void print(const std::string& name, const Scene_scores::Scores& s, const double seconds,
           const std::string& failure)
{
  std::printf("%-36s %6.3f %6.3f %6.3f %6.3f %7.2f %s\n", name.c_str(), s.over_segmentation,
              s.under_segmentation, s.weighted_overlap, s.unweighted_overlap, seconds,
              failure.c_str());
  std::fflush(stdout);
}

void print_means(const std::vector<Row>& rows, const Options& options)
{
  for (const std::string& method : options.methods)
  {
    Scene_scores::Scores mean;
    double longest = 0., count = 0.;
    for (const Row& r : rows) count += r.method == method ? 1. : 0.;
    for (const Row& r : rows)
    {
      if (r.method != method) continue;
      mean.add(r.scores, 1. / count);
      longest = (std::max)(longest, r.seconds);
    }
    print("mean, most seconds: " + method, mean, longest, "");
  }
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
    std::vector<Row> rows;
    std::printf("%-36s %6s %6s %6s %6s %7s\n", "scene", "F_os", "F_us", "WOv", "UOv", "s");
    for (const auto& file : files)
    {
      const Shape_io::Shape shape = Shape_io::read_shape(file.string());
      const std::vector<int> truth = true_objects(shape, file.string());
      for (const std::string& method : options.methods)
      {
        rows.push_back(run(shape, truth, file.stem().string(), method, options));
        const Row& r = rows.back();
        print(r.scene + ' ' + method, r.scores, r.seconds, r.failure);
      }
    }
    print_means(rows, options);
    if (!options.csv.empty()) write_csv(rows, options.csv);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_scenes: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
