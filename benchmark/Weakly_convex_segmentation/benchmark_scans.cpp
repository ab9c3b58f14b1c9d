// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments incomplete clouds of the meshes of the Princeton Segmentation Benchmark: what a depth camera
// sees from some sides, and samples with holes; scores them on the points that are there.

#include "program/set_parameter.h"
#include "scans/scan_conditions.h"
#include "scans/scan_methods.h"
#include "scans/scan_rows.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
namespace SC = Scan_conditions;
namespace po = boost::program_options;
using Scan_methods::Method;
using Scan_rows::Row;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

struct Options
{
  std::filesystem::path data, csv, clouds, program_folder;
  std::vector<int> models;
  std::vector<Method> methods;
  std::vector<std::string> settings; ///< NAME=VALUE
  std::string only, without;
  bool resume = false;
  std::size_t jobs = 1;
};

WCS::Parameters parameters_of(const Method& method, const Options& options)
{
  WCS::Parameters parameters = WCS::Parameters::preset(method.name);
  for (const std::string& s : options.settings) Named_parameters::set_parameter(parameters, s);
  return parameters;
}

std::vector<int> segment_mesh(const SM::Mesh& mesh, const WCS::Parameters& parameters)
{
  std::vector<Kernel::Point_3> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  return CGAL::weakly_convex_segmentation_of_soup(points, mesh.faces, parameters).labels;
}

std::vector<int> of_seen_points(const SC::Scan& scan, const std::vector<int>& of_faces)
{
  std::vector<int> labels;
  for (const std::size_t face : scan.faces) labels.push_back(of_faces[face]);
  return labels;
}

/// for pictures: position, normal and face of each point, and its label by each method
void write_cloud(const SC::Scan& scan, const std::vector<std::vector<int>>& labelings,
                 const int model, const std::string& name, const std::filesystem::path& folder)
{
  std::string file = std::to_string(model) + "_" + name + ".xyz";
  for (char& c : file) c = c == ' ' || c == ',' || c == '%' ? '_' : c;
  const std::filesystem::path path = folder / file;
  std::ofstream out(path);
  out.precision(9);
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    for (const double x : scan.points[i]) out << x << ' ';
    for (const double x : scan.normals[i]) out << x << ' ';
    out << scan.faces[i];
    for (const std::vector<int>& labels : labelings) out << ' ' << labels[i];
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

/// scores all methods on one cloud.
class Cloud_scores
{
public:
  Cloud_scores(const SM::Benchmark_model& model, const SC::Condition& condition)
    : m_model(model), m_name(condition.name), m_scan(SC::make_scan(model, condition))
  {
    add("one segment", one_segment(), 0.);
  }
  const SC::Scan& scan() const { return m_scan; }
  const std::vector<Row>& rows() const { return m_rows; }
  std::vector<int> one_segment() const { return std::vector<int>(m_scan.points.size(), 0); }

  void add(const std::string& method, const std::vector<int>& labels, const double seconds,
           const std::string& failure = "")
  {
    const std::set<int> distinct(labels.begin(), labels.end());
    m_rows.push_back({m_model.number, m_name, method, labels.size(), distinct.size(),
                      SC::rand_error(m_model, m_scan, labels), seconds, failure});
  }
  /// returns the labels; one segment where the method fails, which the row says.
  std::vector<int> run(const Method& method, const Options& options)
  {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<int> labels;
    std::string failure;
    try
    {
      labels = Scan_methods::is_ours(method)
                   ? Scan_methods::segment_by_us(m_scan, parameters_of(method, options))
                   : Scan_methods::segment_by_others(m_scan, method, options.program_folder);
    }
    catch (const std::exception& error)
    {
      failure = error.what();
      labels = one_segment();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    add(method.text, labels, seconds.count(), failure);
    return labels;
  }

private:
  const SM::Benchmark_model& m_model;
  std::string m_name;
  SC::Scan m_scan;
  std::vector<Row> m_rows;
};

bool is_wanted(const SC::Condition& condition, const Options& options)
{
  return condition.name.find(options.only) != std::string::npos &&
         (options.without.empty() || condition.name.find(options.without) == std::string::npos);
}

/// scores all methods on all clouds of a model.
std::vector<Row> run_model(const int number, const Options& options)
{
  const SM::Benchmark_model model = SM::read_benchmark_model(options.data, number);
  std::map<std::string, std::vector<int>> complete; // labels of the faces
  for (const Method& method : options.methods)
    if (Scan_methods::is_ours(method))
      complete[method.name] = segment_mesh(model.mesh, parameters_of(method, options));
  std::vector<Row> rows;
  for (const SC::Condition& condition : SC::all_conditions())
  {
    if (!is_wanted(condition, options)) continue;
    Cloud_scores scores(model, condition);
    std::vector<std::vector<int>> labelings;
    for (const Method& method : options.methods)
    {
      labelings.push_back(scores.run(method, options));
      if (Scan_methods::is_ours(method))
        scores.add(method.name + ", complete mesh",
                   of_seen_points(scores.scan(), complete[method.name]), 0.);
    }
    if (!options.clouds.empty())
      write_cloud(scores.scan(), labelings, number, condition.name, options.clouds);
    rows.insert(rows.end(), scores.rows().begin(), scores.rows().end());
  }
  return rows;
}

/// Runs models, several at once; keeps the table after each and tells how far it is.
class Runner
{
public:
  Runner(const Options& options) : m_options(options)
  {
    if (options.resume) m_rows = Scan_rows::read(options.csv);
    std::set<int> done;
    for (const Row& r : m_rows) done.insert(r.model);
    for (const int model : options.models)
      if (done.count(model) == 0) m_waiting.push_back(model);
    if (!done.empty())
      std::cerr << done.size() << " models are done already, " << m_waiting.size() << " wait\n";
  }

  std::vector<Row> run()
  {
    std::vector<std::thread> threads;
    for (std::size_t j = 1; j < m_options.jobs; ++j) threads.emplace_back([this] { work(); });
    work();
    for (std::thread& thread : threads) thread.join();
    if (!m_failure.empty()) throw std::runtime_error(m_failure);
    return m_rows;
  }

private:
  void work()
  {
    for (std::size_t i = m_next++; i < m_waiting.size(); i = m_next++) try
      {
        keep(m_waiting[i], run_model(m_waiting[i], m_options));
      }
      catch (const std::exception& error)
      {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_failure = "model " + std::to_string(m_waiting[i]) + ": " + error.what();
        m_next = m_waiting.size();
      }
  }
  void keep(const int model, const std::vector<Row>& rows)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_rows.insert(m_rows.end(), rows.begin(), rows.end());
    std::stable_sort(m_rows.begin(), m_rows.end(),
                     [](const Row& a, const Row& b) { return a.model < b.model; });
    if (!m_options.csv.empty()) Scan_rows::write(m_rows, m_options.csv);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - m_begin;
    std::cerr << ++m_done << '/' << m_waiting.size() << " model " << model << ", "
              << static_cast<long>(spent.count()) << " s\n";
  }

  const Options& m_options;
  const std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
  std::vector<int> m_waiting;
  std::vector<Row> m_rows;
  std::atomic<std::size_t> m_next{0};
  std::size_t m_done = 0;
  std::mutex m_mutex;
  std::string m_failure;
};

/// prints a row a condition and a column a method: means over categories of means over models.
void print_table(const std::vector<Row>& rows)
{
  std::map<std::string, std::map<std::string, SM::Benchmark_average>> averages;
  std::vector<std::string> methods;
  for (const Row& r : rows)
  {
    if (std::find(methods.begin(), methods.end(), r.method) == methods.end())
      methods.push_back(r.method);
    SM::Scores scores;
    scores.rand_error = r.rand_error;
    averages[r.condition][r.method].add(r.model, scores);
  }
  std::printf("%-18s", "1 - RI");
  for (const std::string& m : methods) std::printf(" %23s", m.c_str());
  std::printf("\n");
  for (const SC::Condition& c : SC::all_conditions())
  {
    if (averages.count(c.name) == 0) continue;
    std::printf("%-18s", c.name.c_str());
    for (const std::string& m : methods)
      std::printf(" %23.4f", averages[c.name][m].overall().rand_error);
    std::printf("\n");
  }
}

/// returns the models that are named, or the first ones of each category.
std::vector<int> choose_models(const std::filesystem::path& data, const std::string& ids,
                               const std::size_t per_category)
{
  std::vector<int> models;
  std::istringstream id_list(ids);
  for (std::string word; std::getline(id_list, word, ',');) models.push_back(std::stoi(word));
  std::map<std::size_t, std::size_t> taken;
  for (int model = 1; model <= 400 && ids.empty(); ++model)
    if (SM::is_in_benchmark(model) &&
        std::filesystem::exists(data / "off" / (std::to_string(model) + ".off")) &&
        (per_category == 0 || taken[SM::category_of_model(model)]++ < per_category))
      models.push_back(model);
  if (models.empty())
    throw std::runtime_error("there are no models in " + (data / "off").string() +
                             "; give the folder that holds off/ and seg/");
  return models;
}

po::options_description visible_options(Options& options, std::vector<std::string>& paths,
                                        std::string& ids, std::string& methods,
                                        std::size_t& per_category)
{
  // as strings: a path is read from a text only up to its first space
  po::options_description visible("benchmark_scans DATA_DIR [options]\n"
                                  "scores the parts of incomplete clouds against people's");
  visible.add_options()("help", "print this")("ids", po::value(&ids), "only these models, as 1,3")(
      "per-category", po::value(&per_category)->default_value(0),
      "only the first so many models of each category; 0: all")(
      "methods", po::value(&methods)->default_value("default,training_free"),
      "of default, training_free, paper, sdf, lccp, cpc; the last three may have settings: "
      "sdf@CLUSTERS/SMOOTHING/CELL, lccp@VOXEL/SEED/TOLERANCE/SMOOTHNESS/K, cpc@ likewise")(
      "only", po::value(&options.only), "only clouds whose name has this in it, as '2 views'")(
      "without", po::value(&options.without), "no clouds whose name has this in it, as 'noise'")(
      "csv", po::value(&paths[1]), "write a row a model, cloud and method")(
      "resume", po::bool_switch(&options.resume), "leave out the models that are in the csv")(
      "clouds", po::value(&paths[2]), "write the clouds with the labels of each method here")(
      "set", po::value(&options.settings)->composing(),
      "NAME=VALUE of a parameter of our presets; may be repeated")(
      "jobs", po::value(&options.jobs)->default_value(1), "models at once, each single-threaded");
  return visible;
}

void read_methods(const std::string& methods, Options& options)
{
  std::istringstream list(methods);
  for (std::string word; std::getline(list, word, ',');)
  {
    const Method method = Scan_methods::method_from(word);
    if (method.name == "sdf") Scan_methods::sdf_settings_from(method.settings); // throws early
    if ((method.name == "lccp" || method.name == "cpc") &&
        !Pcl_program::is_built(options.program_folder))
      std::cerr << word << " is skipped: segment_by_pcl was not built, for want of PCL\n";
    else
      options.methods.push_back(method);
  }
}

/// returns whether there is something to run.
bool read_options(const int argc, char** argv, Options& options)
{
  std::string ids, methods;
  std::vector<std::string> paths(3);
  std::size_t per_category = 0;
  const po::options_description visible =
      visible_options(options, paths, ids, methods, per_category);
  po::options_description all;
  all.add(visible).add_options()("data", po::value(&paths[0])->required(), "");
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
  options.data = paths[0];
  options.csv = paths[1];
  options.clouds = paths[2];
  if (options.resume && options.csv.empty())
    throw std::invalid_argument("--resume goes on with a table; give it by --csv");
  options.program_folder = std::filesystem::path(argv[0]).parent_path();
  WCS::Parameters checked;
  for (const std::string& s : options.settings) Named_parameters::set_parameter(checked, s);
  read_methods(methods, options);
  options.models = choose_models(options.data, ids, per_category);
  if (!options.clouds.empty()) std::filesystem::create_directories(options.clouds);
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Options options;
    if (!read_options(argc, argv, options)) return 0;
    const std::vector<Row> rows = Runner(options).run();
    if (!options.csv.empty()) Scan_rows::write(rows, options.csv);
    print_table(rows);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_scans: " << error.what() << '\n';
    return 1;
  }
}
