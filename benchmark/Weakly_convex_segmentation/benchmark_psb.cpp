// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments the meshes of the Princeton Segmentation Benchmark (Chen et al. 2009) and scores the parts
// against those of people.

#include "metrics/princeton_benchmark.h"
#include "program/set_parameter.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/mesh_diameters.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
namespace po = boost::program_options;

namespace {

struct Options
{
  std::filesystem::path data, seg_directory, csv;
  std::vector<int> models;
  WCS::Parameters parameters;
  WCS::Level level = WCS::Level::SEGMENTS;
  bool bare_points = false, people = false, quiet = false, parallel = false;
  std::size_t jobs = 1;
};

/// Seconds a stage.
struct Stage_clock : WCS::Visitor
{
  std::array<double, WCS::number_of_stages> seconds{};
  std::chrono::steady_clock::time_point begin;
  void stage_begins(WCS::Stage) override { begin = std::chrono::steady_clock::now(); }
  void stage_ends(const WCS::Stage stage, std::size_t) override
  {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    seconds[static_cast<std::size_t>(stage)] += time.count();
  }
};

struct Row
{
  int model = 0;
  std::size_t faces = 0, patches = 0, components = 0;
  SM::Scores scores;
  double seconds = 0.;
  std::array<double, WCS::number_of_stages> stage_seconds{};
};

std::vector<int> read_ids(const std::string& text)
{
  std::vector<int> ids;
  std::istringstream in(text);
  for (std::string id; std::getline(in, id, ',');) ids.push_back(std::stoi(id));
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

WCS::Level level(const std::string& name)
{
  if (name == "patches") return WCS::Level::PATCHES;
  if (name == "components") return WCS::Level::COMPONENTS;
  if (name == "segments") return WCS::Level::SEGMENTS;
  throw std::invalid_argument("there is no stage '" + name +
                              "', use patches, components or segments");
}

/// returns whether there is something to run.
bool read_options(const int argc, char** argv, Options& options)
{
  std::string preset_name, stage, ids, diameters;
  std::vector<std::string> settings;
  po::options_description visible("benchmark_psb DATA_DIR [options]\n"
                                  "scores the parts of the benchmark's meshes against people's");
  visible.add_options()("help", "print this")("ids", po::value(&ids),
                                              "only these models, as 1,3,21")(
      "seg-dir", po::value(&options.seg_directory),
      "write the labels to DIR/N.seg")("csv", po::value(&options.csv), "write a row a model")(
      "preset", po::value(&preset_name)->default_value("default"),
      "default, training_free or paper")("stage", po::value(&stage)->default_value("segments"),
                                         "patches, components or segments")(
      "set", po::value(&settings)->composing(), "NAME=VALUE of a parameter; may be repeated")(
      "diameters", po::value(&diameters)->default_value("own"),
      "own, or cgal: CGAL's shape diameter function, where the mesh is a manifold")(
      "points", po::bool_switch(&options.bare_points), "segment the bare face centroids")(
      "people", po::bool_switch(&options.people), "score people against people instead")(
      "jobs", po::value(&options.jobs)->default_value(1), "models at once, each single-threaded")(
      "parallel", po::bool_switch(&options.parallel), "let each model use all threads")(
      "quiet", po::bool_switch(&options.quiet), "print the overall line only");
  po::options_description all;
  all.add(visible).add_options()("data", po::value(&options.data)->required(), "");
  po::positional_options_description positional;
  positional.add("data", 1);
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), map);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  po::notify(map);
  options.parameters = WCS::Parameters::preset(preset_name);
  for (const std::string& s : settings) Named_parameters::set_parameter(options.parameters, s);
  if (diameters == "cgal")
    options.parameters.diameter = WCS::Diameter_rule::GIVEN;
  else if (diameters != "own")
    throw std::invalid_argument("there are no diameters '" + diameters + "', use own or cgal");
  if (diameters == "cgal" && options.bare_points)
    throw std::invalid_argument("points have no diameters by CGAL: leave out --points");
  options.parameters.check();
  options.level = level(stage);
  options.models = ids.empty() ? models_in(options.data) : read_ids(ids);
  return true;
}

/// segments as a mesh, or as bare oriented points at the centroids of the faces
template <typename ConcurrencyTag>
WCS::Result segment(const SM::Mesh& soup, const Options& options, Stage_clock& clock)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  for (const auto& p : soup.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& f : soup.faces)
    if (mesh.add_face(Mesh::Vertex_index(static_cast<Mesh::size_type>(f[0])),
                      Mesh::Vertex_index(static_cast<Mesh::size_type>(f[1])),
                      Mesh::Vertex_index(static_cast<Mesh::size_type>(f[2]))) == Mesh::null_face())
      return CGAL::weakly_convex_segmentation_of_soup<ConcurrencyTag>(
          mesh.points(), soup.faces, options.parameters,
          CGAL::parameters::visitor(std::ref(clock)));
  if (!options.bare_points)
  {
    WCS::Segmenter<ConcurrencyTag> segmenter(mesh, options.parameters,
                                             CGAL::parameters::visitor(std::ref(clock)));
    if (options.parameters.diameter == WCS::Diameter_rule::GIVEN)
      segmenter.set_diameters(WCS::mesh_diameters(mesh, options.parameters));
    return segmenter.segment(options.parameters);
  }
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  std::vector<Oriented> points;
  for (const auto& f : soup.faces)
  {
    const auto corner = [&](const int i)
    { return Kernel::Point_3(soup.points[f[i]][0], soup.points[f[i]][1], soup.points[f[i]][2]); };
    points.emplace_back(CGAL::centroid(corner(0), corner(1), corner(2)),
                        CGAL::normal(corner(0), corner(1), corner(2)));
  }
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
                      .visitor(std::ref(clock));
  return WCS::Segmenter<ConcurrencyTag>(points, options.parameters, np).segment(options.parameters);
}

Row run_model(const int number, const Options& options)
{
  const SM::Benchmark_model model = SM::read_benchmark_model(options.data, number);
  Row row;
  row.model = number;
  row.faces = model.mesh.faces.size();
  if (options.people)
  {
    row.scores = SM::score_annotators(model);
    return row;
  }
  Stage_clock clock;
  const auto begin = std::chrono::steady_clock::now();
  const WCS::Result result =
      options.parallel ? segment<CGAL::Parallel_if_available_tag>(model.mesh, options, clock)
                       : segment<CGAL::Sequential_tag>(model.mesh, options, clock);
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  row.stage_seconds = clock.seconds;
  row.patches = result.merge_tree.number_of_patches();
  row.components = result.number_of_components;
  const std::vector<int> labels = result.labels_at(options.level);
  row.scores = SM::score_against_annotators(model, labels);
  if (!options.seg_directory.empty())
  {
    std::ofstream out(options.seg_directory / (std::to_string(number) + ".seg"));
    for (const int l : labels) out << l << '\n';
    if (!out.flush()) throw std::runtime_error("can't write to " + options.seg_directory.string());
  }
  return row;
}

std::vector<Row> run_models(const Options& options)
{
  std::vector<Row> rows(options.models.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::string failure;
  const auto work = [&]
  {
    for (std::size_t i = next++; i < rows.size(); i = next++) try
      {
        rows[i] = run_model(options.models[i], options);
      }
      catch (const std::exception& error)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = "model " + std::to_string(options.models[i]) + ": " + error.what();
        next = rows.size();
      }
  };
  std::vector<std::thread> threads;
  for (std::size_t j = 1; j < options.jobs; ++j) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (!failure.empty()) throw std::runtime_error(failure);
  return rows;
}

void write_csv(const std::vector<Row>& rows, const std::filesystem::path& path)
{
  std::ofstream out(path);
  out << "model,category,faces,patches,components,segments,rand_error,hamming,gce_area,lce_area,"
         "cut_discrepancy,seconds";
  for (std::size_t s = 0; s < WCS::number_of_stages; ++s)
    out << ',' << WCS::stage_name(static_cast<WCS::Stage>(s));
  out << '\n';
  for (const Row& r : rows)
  {
    out << r.model << ',' << SM::category_names()[SM::category_of_model(r.model)] << ',' << r.faces
        << ',' << r.patches << ',' << r.components << ',' << r.scores.number_of_segments << ','
        << r.scores.rand_error << ',' << r.scores.hamming << ',' << r.scores.gce_area << ','
        << r.scores.lce_area << ',';
    if (r.scores.cut_discrepancy) out << *r.scores.cut_discrepancy;
    out << ',' << r.seconds;
    for (const double s : r.stage_seconds) out << ',' << s;
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename Number>
std::string column(const Number& number)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%10.4f", static_cast<double>(number));
  return text.data();
}

void print_scores(const std::string& name, const SM::Scores& scores)
{
  std::cout << name << std::string(12 - (std::min)(name.size(), std::size_t(12)), ' ')
            << column(scores.rand_error) << column(scores.hamming)
            << column(scores.number_of_segments) << '\n';
}

void print_summary(const std::vector<Row>& rows, const Options& options)
{
  SM::Benchmark_average average;
  for (const Row& r : rows) average.add(r.model, r.scores);
  std::cout << "              1 - RI   Hamming  segments\n";
  if (!options.quiet)
    for (std::size_t c = 0; c < SM::category_names().size(); ++c)
      if (const auto scores = average.category(c)) print_scores(SM::category_names()[c], *scores);
  print_scores("overall", average.overall());
  if (options.people) return;
  const auto median_of = [&](const auto& value)
  {
    std::vector<double> values;
    for (const Row& r : rows) values.push_back(value(r));
    return median(values);
  };
  std::cout << "median seconds a model" << column(median_of([](const Row& r) { return r.seconds; }))
            << '\n';
  if (options.quiet) return;
  for (std::size_t s = 0; s < WCS::number_of_stages; ++s)
    std::cout << "  " << WCS::stage_name(static_cast<WCS::Stage>(s))
              << column(median_of([s](const Row& r) { return r.stage_seconds[s]; })) << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Options options;
    if (!read_options(argc, argv, options)) return 0;
    if (!options.seg_directory.empty()) std::filesystem::create_directories(options.seg_directory);
    const std::vector<Row> rows = run_models(options);
    if (!options.csv.empty()) write_csv(rows, options.csv);
    print_summary(rows, options);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_psb: " << error.what() << '\n';
    return 1;
  }
}
