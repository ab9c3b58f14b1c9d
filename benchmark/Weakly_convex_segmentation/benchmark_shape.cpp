// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// One model of the Princeton Segmentation Benchmark, all methods: their scores against people, the
// number and convexity of the parts, time and memory, as one JSON file. A method that fails or takes too
// long is reported in it and does not stop the others. Models are independent of each other: any tool
// that starts programs can run many at once, on one machine or on many.

#include "baselines/compared_methods.h"
#include "metrics/princeton_benchmark.h"

#include "draw/draw_parts.h"
#include "io/atomic_file.h"
#include "io/part_colors.h"

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SM = Segmentation_metrics;
namespace CM = Compared_methods;
namespace po = boost::program_options;
using Json = nlohmann::json;

namespace {

struct Options
{
  std::filesystem::path data, json, pictures, labels, program_folder;
  int model = 0;
  unsigned int seconds = 300;
  std::set<std::string> groups;
};

bool read_options(const int argc, char** argv, Options& options)
{
  std::string groups, known;
  for (const CM::Method& method : CM::methods()) known += method.group + ",";
  po::options_description visible("benchmark_shape DATA_DIR MODEL [options]\n"
                                  "scores all methods on one model of the benchmark");
  visible.add_options()("help", "print this")("json", po::value(&options.json),
                                              "file for the outcome (default: standard output)")(
      "methods", po::value(&groups)->default_value(known + "people"), "which, separated by commas")(
      "seconds", po::value(&options.seconds)->default_value(300), "most wall time for a method")(
      "pictures", po::value(&options.pictures), "folder for N_ours.png and N_person.png")(
      "labels", po::value(&options.labels), "folder for N_METHOD.seg");
  po::options_description all;
  all.add(visible).add_options()("data", po::value(&options.data)->required(),
                                 "")("model", po::value(&options.model)->required(), "");
  po::positional_options_description positional;
  positional.add("data", 1).add("model", 1);
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), map);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  po::notify(map);
  std::istringstream list(groups);
  for (std::string name; std::getline(list, name, ',');)
  {
    if (("," + known + "people,").find("," + name + ",") == std::string::npos)
      throw std::invalid_argument("there is no method '" + name + "'; choose from " + known +
                                  "people");
    options.groups.insert(name);
  }
  options.program_folder = std::filesystem::path(argv[0]).parent_path();
  return true;
}

/// Size-weighted mean convexity ranks, all by the lines of sight of one shape.
class Ranks
{
public:
  explicit Ranks(const CM::Shape& shape)
    : m_segmenter(shape.mesh.is_empty() ? CGAL::Weakly_convex_segmentation::Segmenter<>(
                                              CM::kernel_points(shape.soup), shape.soup.faces, {},
                                              CGAL::parameters::default_values())
                                        : CGAL::Weakly_convex_segmentation::Segmenter<>(shape.mesh))
  {}
  double mean(const std::vector<std::size_t>& labels) const
  {
    std::vector<std::vector<std::size_t>> members(1 +
                                                  *std::max_element(labels.begin(), labels.end()));
    for (std::size_t f = 0; f < labels.size(); ++f) members[labels[f]].push_back(f);
    double sum = 0.;
    for (const auto& segment : members)
      sum += static_cast<double>(segment.size()) * m_segmenter.convexity_rank(segment, 40);
    return sum / static_cast<double>(labels.size());
  }

private:
  CGAL::Weakly_convex_segmentation::Segmenter<> m_segmenter;
};

Json scores_as_json(const SM::Scores& scores)
{
  Json json = {{"rand_error", scores.rand_error},
               {"hamming", scores.hamming},
               {"missing_rate", scores.missing_rate},
               {"false_alarm_rate", scores.false_alarm_rate},
               {"gce", scores.gce},
               {"lce", scores.lce},
               {"gce_area", scores.gce_area},
               {"lce_area", scores.lce_area},
               {"cut_discrepancy", nullptr},
               {"segments", scores.number_of_segments}};
  if (scores.cut_discrepancy) json["cut_discrepancy"] = *scores.cut_discrepancy;
  return json;
}

/// runs the methods, each group in a child; the labelings of those that succeeded
std::vector<CM::Labeling> run_methods(const Options& options, CM::Shape& shape, Json& outcomes)
{
  std::vector<CM::Labeling> all;
  for (const CM::Method& method : CM::methods())
  {
    if (options.groups.count(method.group) == 0) continue;
    Run_in_child_process::Outcome outcome =
        Run_in_child_process::run([&] { return method.run(shape); }, options.seconds);
    for (const std::string& name : method.names) outcomes[name] = {{"failure", outcome.failure}};
    for (CM::Labeling& labeling : outcome.labelings)
    {
      Json& json = outcomes[labeling.method];
      if (labeling.labels.size() != shape.soup.faces.size())
      {
        json["failure"] = "it gave " + std::to_string(labeling.labels.size()) + " labels";
        continue;
      }
      json = {{"failure", nullptr},
              {"cpu_seconds", labeling.cpu_seconds},
              {"peak_megabytes", outcome.peak_megabytes},
              {"parent_megabytes", outcome.parent_megabytes}};
      shape.parts_found[labeling.method] =
          std::set<int>(labeling.labels.begin(), labeling.labels.end()).size();
      all.push_back(std::move(labeling));
    }
  }
  return all;
}

/// the person whose segmentation is nearest to those of the others
const SM::Prepared_segmentation& typical_person(const SM::Benchmark_model& model)
{
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.annotators.size(); ++i)
  {
    double sum = 0.;
    for (const auto& other : model.annotators)
      sum += SM::rand_error(SM::make_contingency_table(model.geometry, model.annotators[i], other));
    if (sum < least) least = sum, best = i;
  }
  return model.annotators[best];
}

/// gives each of our parts the number of the person's part that it covers most of, if that is still
/// free, so that parts that correspond have one color.
std::vector<int> matched_labels(const SM::Benchmark_model& model,
                                const SM::Prepared_segmentation& ours,
                                const SM::Prepared_segmentation& person)
{
  auto overlaps = SM::make_contingency_table(model.geometry, ours, person).overlaps;
  std::stable_sort(overlaps.begin(), overlaps.end(),
                   [](const SM::Overlap& a, const SM::Overlap& b) { return a.area > b.area; });
  std::vector<int> number(ours.number_of_segments, -1);
  std::vector<char> taken(person.number_of_segments, 0);
  for (const SM::Overlap& o : overlaps)
    if (number[o.first] < 0 && taken[o.second] == 0)
    {
      number[o.first] = static_cast<int>(o.second);
      taken[o.second] = 1;
    }
  int next = static_cast<int>(person.number_of_segments);
  for (int& n : number)
    if (n < 0) n = next++;
  std::vector<int> labels;
  for (const std::size_t l : ours.labels) labels.push_back(number[l]);
  return labels;
}

void draw(const SM::Benchmark_model& model, const SM::Prepared_segmentation& ours,
          const std::filesystem::path& folder)
{
  const SM::Prepared_segmentation& person = typical_person(model);
  const Draw_parts::Scene scene{model.mesh.points, {}, model.mesh.faces, {}};
  const std::vector<int> theirs(person.labels.begin(), person.labels.end());
  const std::vector<int> matched = matched_labels(model, ours, person);
  const Draw_parts::View view =
      Draw_parts::look(scene, Draw_parts::best_camera(scene, theirs), 220);
  std::vector<Draw_parts::Color> colors;
  for (std::size_t i = 0; i < ours.number_of_segments + person.number_of_segments; ++i)
    colors.push_back(Shape_io::internal::palette[i % Shape_io::internal::palette_size]);
  std::filesystem::create_directories(folder);
  const std::string number = std::to_string(model.number);
  for (const auto& [labels, side] : {std::pair(&matched, "_ours.png"), {&theirs, "_person.png"}})
  {
    Shape_io::Atomic_file file((folder / (number + side)).string());
    Draw_parts::write_png(Draw_parts::make_picture(view, *labels, colors), file.stream());
    file.commit();
  }
}

void write_labels(const Options& options, const CM::Labeling& labeling)
{
  std::filesystem::create_directories(options.labels);
  const std::string name = std::to_string(options.model) + "_" + labeling.method + ".seg";
  Shape_io::Atomic_file file((options.labels / name).string());
  for (const int l : labeling.labels) file.stream() << l << '\n';
  file.commit();
}

void score_methods(const Options& options, const SM::Benchmark_model& model,
                   const std::vector<CM::Labeling>& labelings, Json& outcomes)
{
  const Ranks ranks({model.mesh, CM::surface_mesh(model.mesh)});
  for (const CM::Labeling& labeling : labelings)
  {
    Json& outcome = outcomes[labeling.method];
    const SM::Prepared_segmentation prepared = SM::prepare(model.geometry, labeling.labels);
    SM::Mean_scores mean;
    for (const auto& annotator : model.annotators)
      mean.add(SM::score(model.geometry, prepared, annotator));
    outcome.update(scores_as_json(mean.mean()));
    outcome["convexity_rank"] = ranks.mean(prepared.labels);
    if (!options.pictures.empty() && labeling.method == "default")
      draw(model, prepared, options.pictures);
    if (!options.labels.empty()) write_labels(options, labeling);
  }
  if (options.groups.count("people") == 0) return;
  Json annotators = scores_as_json(SM::score_annotators(model));
  double rank = 0.;
  for (const auto& annotator : model.annotators) rank += ranks.mean(annotator.labels);
  annotators["convexity_rank"] = rank / static_cast<double>(model.annotators.size());
  annotators["failure"] = nullptr;
  outcomes["people"] = annotators;
}

Json run_model(const Options& options)
{
  Json json = {{"model", options.model},
               {"category", SM::category_names()[SM::category_of_model(options.model)]},
               {"methods", Json::object()}};
  std::vector<CM::Labeling> labelings;
  {
    // before people's segmentations are read: they would count as memory of the methods
    const SM::Mesh mesh =
        SM::read_off(options.data / "off" / (std::to_string(options.model) + ".off"));
    CM::Shape shape{mesh, CM::surface_mesh(mesh), {}, options.program_folder};
    labelings = run_methods(options, shape, json["methods"]);
  }
  const SM::Benchmark_model model = SM::read_benchmark_model(options.data, options.model);
  json["faces"] = model.mesh.faces.size();
  score_methods(options, model, labelings, json["methods"]);
  return json;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Options options;
    if (!read_options(argc, argv, options)) return 0;
    const Json json = run_model(options);
    if (options.json.empty())
    {
      std::cout << json.dump(1) << '\n';
      return 0;
    }
    Shape_io::Atomic_file file(options.json.string());
    file.stream() << json.dump(1) << '\n';
    file.commit();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_shape: " << error.what() << '\n';
    return 1;
  }
}
