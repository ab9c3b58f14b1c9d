// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments incomplete clouds of the meshes of the Princeton Segmentation Benchmark: what a depth camera
// sees from some sides, and samples with holes; scores them on the points that are there.

#include "named_parameters.h"
#include "scan_alternatives.h"
#include "scan_conditions.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <boost/program_options.hpp>

#include <atomic>
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

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

struct Options
{
  std::filesystem::path data, csv, clouds;
  std::vector<int> models;
  std::set<std::string> methods;
  std::string only;
  WCS::Parameters parameters;
  WCS::Parameters fitted = WCS::Parameters::fitted();
  std::size_t jobs = 1;
};

struct Row
{
  int model;
  std::string condition, method;
  std::size_t points, segments;
  double rand_error;
};

std::vector<int> segment_cloud(const SC::Scan& scan, const WCS::Parameters& parameters)
{
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const auto& p = scan.points[i];
    const auto& n = scan.normals[i];
    points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  return WCS::Segmenter<CGAL::Sequential_tag>(
             points, parameters,
             CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                 .normal_map(CGAL::Second_of_pair_property_map<Oriented>()))
      .segment(parameters)
      .labels;
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

void write_cloud(const SC::Scan& scan, const std::filesystem::path& path)
{
  std::ofstream out(path);
  out.precision(9);
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    for (const double x : scan.points[i]) out << x << ' ';
    for (const double x : scan.normals[i]) out << x << ' ';
    out << scan.faces[i] << '\n';
  }
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

/// scores all methods on all clouds of a model.
std::vector<Row> run_model(const int number, const Options& options)
{
  const SM::Benchmark_model model = SM::read_benchmark_model(options.data, number);
  const auto is_wanted = [&](const std::string& m) { return options.methods.count(m) > 0; };
  std::vector<int> complete, complete_fitted;
  if (is_wanted("default")) complete = segment_mesh(model.mesh, options.parameters);
  if (is_wanted("fitted")) complete_fitted = segment_mesh(model.mesh, options.fitted);
  std::vector<Row> rows;
  for (const SC::Condition& condition : SC::all_conditions())
  {
    if (condition.name.find(options.only) == std::string::npos) continue;
    const SC::Scan scan = SC::make_scan(model, condition);
    const auto add = [&](const std::string& method, const std::vector<int>& labels)
    {
      const std::set<int> distinct(labels.begin(), labels.end());
      rows.push_back({number, condition.name, method, labels.size(), distinct.size(),
                      SC::rand_error(model, scan, labels)});
    };
    add("one segment", std::vector<int>(scan.points.size(), 0));
    if (is_wanted("default"))
    {
      add("default", segment_cloud(scan, options.parameters));
      add("default, complete mesh", of_seen_points(scan, complete));
    }
    if (is_wanted("fitted"))
    {
      add("fitted", segment_cloud(scan, options.fitted));
      add("fitted, complete mesh", of_seen_points(scan, complete_fitted));
    }
    if (is_wanted("sdf")) add("CGAL SDF", Scan_alternatives::segment_by_sdf(scan));
    if (!options.clouds.empty())
    {
      std::string file = std::to_string(number) + "_" + condition.name + ".xyz";
      for (char& c : file) c = c == ' ' || c == ',' || c == '%' ? '_' : c;
      write_cloud(scan, options.clouds / file);
    }
  }
  return rows;
}

std::vector<Row> run_models(const Options& options)
{
  std::vector<std::vector<Row>> rows(options.models.size());
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
  std::vector<Row> all;
  for (const auto& some : rows) all.insert(all.end(), some.begin(), some.end());
  return all;
}

void write_csv(const std::vector<Row>& rows, const std::filesystem::path& path)
{
  std::ofstream out(path);
  out << "model,category,condition,method,points,segments,rand_error\n";
  for (const Row& r : rows)
    out << r.model << ',' << SM::category_names()[SM::category_of_model(r.model)] << ",\""
        << r.condition << "\",\"" << r.method << "\"," << r.points << ',' << r.segments << ','
        << r.rand_error << '\n';
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

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

/// returns whether there is something to run.
bool read_options(const int argc, char** argv, Options& options)
{
  // as strings: a path is read from a text only up to its first space
  std::string ids, methods, data, csv, clouds;
  std::vector<std::string> settings;
  std::size_t per_category = 0;
  po::options_description visible("benchmark_scans DATA_DIR [options]\n"
                                  "scores the parts of incomplete clouds against people's");
  visible.add_options()("help", "print this")("ids", po::value(&ids), "only these models, as 1,3")(
      "per-category", po::value(&per_category)->default_value(0),
      "only the first so many models of each category; 0: all")(
      "methods", po::value(&methods)->default_value("default,fitted"), "of default,fitted,sdf")(
      "only", po::value(&options.only), "only clouds whose name has this in it, as '2 views'")(
      "csv", po::value(&csv), "write a row a model, cloud and method")(
      "clouds", po::value(&clouds), "write the clouds to this folder")(
      "set", po::value(&settings)->composing(), "NAME=VALUE of a parameter; may be repeated")(
      "jobs", po::value(&options.jobs)->default_value(1), "models at once, each single-threaded");
  po::options_description all;
  all.add(visible).add_options()("data", po::value(&data)->required(), "");
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
  options.data = data;
  options.csv = csv;
  options.clouds = clouds;
  for (const std::string& s : settings)
    for (WCS::Parameters* p : {&options.parameters, &options.fitted})
      Named_parameters::set_parameter(*p, s);
  std::istringstream method_list(methods);
  for (std::string word; std::getline(method_list, word, ',');) options.methods.insert(word);
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
    const std::vector<Row> rows = run_models(options);
    if (!options.csv.empty()) write_csv(rows, options.csv);
    print_table(rows);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_scans: " << error.what() << '\n';
    return 1;
  }
}
