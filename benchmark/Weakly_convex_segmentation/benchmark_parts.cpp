// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures whether parts look right, without a person's labels to compare with: whether they are the same on
// both sides of a symmetric shape, how straight their borders run, and how many are bands, rings, strips or
// slivers.

#include "io/read_shape.h"
#include "metrics/princeton_benchmark.h"
#include "parts/Part_labels.h"
#include "parts/Sampled_surface.h"
#include "parts/asymmetry.h"
#include "parts/border_lines.h"
#include "parts/overcutting.h"
#include "parts/part_pieces.h"
#include "parts/part_report.h"
#include "parts/surface_diameters.h"

#include <boost/program_options.hpp>

#include <atomic>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace SM = Segmentation_metrics;
namespace PM = Part_measures;
namespace po = boost::program_options;

namespace {

/// NAME=PATH of the command line.
using Named_path = std::pair<std::string, std::filesystem::path>;

struct Options
{
  std::filesystem::path data, csv;
  std::vector<Named_path> sets, meshes;
  std::vector<int> models;
  bool people = false, quiet = false;
  std::size_t jobs = 1;
};

/// The name of the set of labels that come with a mesh, and of those in the benchmark.
constexpr const char* of_mesh = "mesh";
constexpr const char* of_people = "people";

struct Named_labels
{
  std::string set, name;
  SM::Segmentation labels;
};

/// A mesh and all labels of it that are to be measured.
struct Labeled_mesh
{
  std::string name;
  SM::Mesh mesh;
  std::vector<Named_labels> labels;
};

Named_path named_path(const std::string& text, const char* const form)
{
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    throw std::invalid_argument("can't read '" + text + "': give " + form);
  return {text.substr(0, sign), text.substr(sign + 1)};
}

std::vector<int> read_ids(const std::string& text)
{
  std::vector<int> ids;
  std::istringstream in(text);
  for (std::string id; std::getline(in, id, ',');)
    if (id.empty() || id.size() > 3 || id.find_first_not_of("0123456789") != std::string::npos)
      throw std::invalid_argument("'" + id + "' is no model: give numbers, as 1,3,21");
    else
      ids.push_back(std::stoi(id));
  return ids;
}

/// all models of the folder, if none were named
std::vector<int> models_in(const std::filesystem::path& data)
{
  std::vector<int> models;
  for (int model = 1; model <= 400; ++model)
    if (SM::is_in_benchmark(model) &&
        std::filesystem::exists(data / "off" / (std::to_string(model) + ".off")))
      models.push_back(model);
  if (models.empty())
    throw std::runtime_error("there are no models in " + (data / "off").string() +
                             "; give the folder that holds off/ and seg/");
  return models;
}

/// returns whether there is something to run.
bool read_options(const int argc, char** argv, Options& options)
{
  std::string ids;
  std::vector<std::string> sets, meshes;
  po::options_description visible("benchmark_parts [DATA_DIR NAME=SEG_DIR...] [options]\n"
                                  "measures labels SEG_DIR/N.seg of the benchmark's meshes without "
                                  "comparing them with people's");
  visible.add_options()("help", "print this")("ids", po::value(&ids),
                                              "only these models, as 1,3,21")(
      "people", po::bool_switch(&options.people), "measure people's labels too")(
      "mesh", po::value(&meshes)->composing(),
      "FILE=LABELS.seg: a mesh of your own; may be repeated")("csv", po::value(&options.csv),
                                                              "write a row a labeling")(
      "jobs", po::value(&options.jobs)->default_value(1),
      "meshes at once")("quiet", po::bool_switch(&options.quiet), "print the means only");
  po::options_description all;
  all.add(visible).add_options()("data", po::value(&options.data),
                                 "")("sets", po::value(&sets)->composing(), "");
  po::positional_options_description positional;
  positional.add("data", 1).add("sets", -1);
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), map);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  po::notify(map);
  for (const std::string& s : sets)
    options.sets.push_back(named_path(s, "a name and the folder of its labels, as mine=DIR"));
  for (const std::string& m : meshes)
    options.meshes.push_back(named_path(m, "a mesh and its labels, as FILE.off=LABELS.seg"));
  if (!options.data.empty() && options.sets.empty() && !options.people)
    throw std::invalid_argument("there are no labels to measure: give NAME=SEG_DIR or --people");
  if (options.data.empty() && options.meshes.empty())
    throw std::invalid_argument("there is nothing to measure: give DATA_DIR or --mesh");
  if (!options.data.empty()) options.models = ids.empty() ? models_in(options.data) : read_ids(ids);
  return true;
}

Labeled_mesh read_model(const int number, const Options& options)
{
  SM::category_of_model(number); // throws for a number outside the benchmark
  Labeled_mesh model;
  model.name = std::to_string(number);
  model.mesh = SM::read_off(options.data / "off" / (model.name + ".off"));
  const std::size_t faces = model.mesh.faces.size();
  if (options.people)
  {
    const auto annotations = SM::read_annotations(options.data, number, faces);
    for (std::size_t i = 0; i < annotations.size(); ++i)
      model.labels.push_back({of_people, std::to_string(i), annotations[i]});
  }
  for (const auto& [set, directory] : options.sets)
    model.labels.push_back(
        {set, model.name, SM::read_seg(directory / (model.name + ".seg"), faces)});
  return model;
}

/// reads a mesh of any format; polygons are cut into triangles, each with the label of its polygon.
Labeled_mesh read_mesh(const Named_path& files)
{
  const Shape_io::Shape shape = Shape_io::read_shape(files.first);
  if (!shape.is_mesh())
    throw std::runtime_error(files.first + " has no faces: give a mesh, not a cloud");
  const SM::Segmentation of_polygons = SM::read_seg(files.second, shape.polygons.size());
  Labeled_mesh result;
  result.name = std::filesystem::path(files.first).stem().string();
  for (const auto& p : shape.points) result.mesh.points.push_back({p.x(), p.y(), p.z()});
  SM::Segmentation labels;
  for (std::size_t f = 0; f < shape.polygons.size(); ++f)
    for (std::size_t i = 2; i < shape.polygons[f].size(); ++i)
    {
      const auto& polygon = shape.polygons[f];
      result.mesh.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
      labels.push_back(of_polygons[f]);
    }
  result.labels.push_back({of_mesh, files.second.stem().string(), std::move(labels)});
  return result;
}

/// measures all labels of a mesh, whose own geometry is computed once.
std::vector<PM::Labeling_row> measure(const Labeled_mesh& model)
{
  const SM::Mesh_geometry geometry = SM::compute_mesh_geometry(model.mesh);
  const PM::Sampled_surface surface(model.mesh);
  const std::optional<PM::Mirror_image> image = PM::find_mirror_image(surface);
  const std::vector<PM::Diameter_sample> diameters = PM::sample_diameters(surface);
  std::vector<PM::Labeling_row> rows;
  for (const Named_labels& named : model.labels)
  {
    const PM::Part_labels labels(named.labels, model.mesh.faces.size());
    PM::Labeling_row row;
    row.mesh = model.name;
    row.set = named.set;
    row.labels = named.name;
    row.parts = labels.number_of_parts;
    if (image) row.asymmetry = PM::asymmetry(*image, labels);
    const PM::Borders borders = PM::find_borders(model.mesh, geometry, labels);
    row.borders = PM::measure_borders(surface, borders);
    row.overcuts = PM::find_overcuts(PM::find_pieces(geometry, surface, borders, diameters, labels),
                                     diameters);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// the rows of all meshes, in the order of the meshes however many are measured at once
std::vector<PM::Labeling_row> measure_all(const Options& options)
{
  const std::size_t models = options.models.size(), count = models + options.meshes.size();
  std::vector<std::vector<PM::Labeling_row>> of_meshes(count);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::string failure;
  const auto work = [&]
  {
    for (std::size_t i = next++; i < count; i = next++) try
      {
        of_meshes[i] = measure(i < models ? read_model(options.models[i], options)
                                          : read_mesh(options.meshes[i - models]));
      }
      catch (const std::exception& error)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = (i < models ? "model " + std::to_string(options.models[i])
                              : options.meshes[i - models].first) +
                  ": " + error.what();
        next = count;
      }
  };
  std::vector<std::thread> threads;
  for (std::size_t j = 1; j < options.jobs; ++j) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (!failure.empty()) throw std::runtime_error(failure);
  std::vector<PM::Labeling_row> rows;
  for (auto& of_mesh_i : of_meshes)
    for (PM::Labeling_row& row : of_mesh_i) rows.push_back(std::move(row));
  return rows;
}

std::vector<PM::Set_summary> summaries(const std::vector<PM::Labeling_row>& rows,
                                       const Options& options)
{
  std::vector<PM::Set_summary> result;
  if (options.people && !options.models.empty()) result.push_back(PM::summarize(rows, of_people));
  if (!options.models.empty())
    for (const Named_path& set : options.sets) result.push_back(PM::summarize(rows, set.first));
  if (!options.meshes.empty()) result.push_back(PM::summarize(rows, of_mesh));
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Options options;
    if (!read_options(argc, argv, options)) return 0;
    const std::vector<PM::Labeling_row> rows = measure_all(options);
    if (!options.csv.empty()) PM::write_csv(rows, options.csv);
    const std::vector<PM::Set_summary> of_sets = summaries(rows, options);
    PM::print_summaries(std::cout, of_sets);
    if (!options.quiet) PM::print_worst(std::cout, of_sets);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_parts: " << error.what() << '\n';
    return 1;
  }
}
