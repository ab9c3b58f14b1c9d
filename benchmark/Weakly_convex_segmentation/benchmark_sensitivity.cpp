// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How much the score of one model of the Princeton Segmentation Benchmark changes with each parameter,
// by 3 and by 10 percent of its value down and up, as one JSON file. What only touches merging and
// borders is run on one analysis of the shape.

#include "metrics/princeton_benchmark.h"
#include "program/set_parameter.h"

#include "io/atomic_file.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
using Json = nlohmann::json;
using WCS::Parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;

namespace {

using Named_parameters::Knob;

/// whether a name begins with another
bool begins_with(const std::string& name, const std::string& beginning)
{
  return name.compare(0, beginning.size(), beginning) == 0;
}

/// the parameters that a preset uses and that are not 0, but for the seed, rules and switches
std::vector<Knob> used_knobs(const Parameters& preset)
{
  const bool is_paper = preset.merging == WCS::Merging_rule::PAPER;
  std::vector<Knob> knobs;
  for (const Knob& knob : Named_parameters::knobs(preset))
  {
    const bool is_of_paper = begins_with(knob.name, "fusion_thresholds");
    if (is_paper ? knob.name == "fusion_threshold" : is_of_paper) continue;
    if (preset.merging != WCS::Merging_rule::COST && begins_with(knob.name, "merging_cost"))
      continue;
    if (knob.name == "seed" || (knob.is_whole && knob.high <= 2.)) continue;
    if (Named_parameters::get(preset, knob.name) != 0.) knobs.push_back(knob);
  }
  return knobs;
}

/// the names of what only touches merging and borders: the table is in the order of the stages
std::set<std::string> names_after_analysis()
{
  std::set<std::string> names;
  bool is_after = false;
  for (const Knob& knob : Named_parameters::knobs())
  {
    is_after = is_after || knob.name == "merging";
    if (is_after) names.insert(knob.name);
  }
  return names;
}

/// The shape, analyzed anew only where it has to be.
class Experiment
{
public:
  Experiment(const SM::Benchmark_model& model, const Parameters& preset)
    : m_model(model), m_preset(preset)
  {
    for (const auto& p : model.mesh.points) m_points.emplace_back(p[0], p[1], p[2]);
    m_kept = std::make_unique<WCS::Segmenter<>>(analyzed(preset));
  }

  double score(const Parameters& parameters, const bool analyze)
  {
    if (!analyze) return rand_error(m_kept->segment(parameters));
    WCS::Segmenter<> segmenter = analyzed(parameters);
    return rand_error(segmenter.segment(parameters));
  }

private:
  WCS::Segmenter<> analyzed(const Parameters& parameters) const
  {
    return WCS::Segmenter<>(m_points, m_model.mesh.faces, parameters,
                            CGAL::parameters::default_values());
  }

  double rand_error(const WCS::Result& result) const
  {
    // no distances to cuts: the Rand Index does not need them
    SM::Prepared_segmentation prepared;
    prepared.labels.assign(result.labels.begin(), result.labels.end());
    prepared.number_of_segments = result.number_of_segments();
    double sum = 0.;
    for (const auto& annotator : m_model.annotators)
      sum += SM::rand_error(SM::make_contingency_table(m_model.geometry, prepared, annotator));
    return sum / static_cast<double>(m_model.annotators.size());
  }

  const SM::Benchmark_model& m_model;
  Parameters m_preset;
  std::vector<Point> m_points;
  std::unique_ptr<WCS::Segmenter<>> m_kept;
};

bool is_in_range(const Parameters& parameters)
{
  try
  {
    parameters.check();
    return true;
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
}

Json vary(const SM::Benchmark_model& model, const Parameters& preset,
          const std::vector<Knob>& knobs, const bool analyze_anew)
{
  Experiment experiment(model, preset);
  Json json = {{"base", experiment.score(preset, false)}, {"changes", Json::array()}};
  for (unsigned int seed = 1; seed <= 4 && analyze_anew; ++seed)
  {
    Parameters parameters = preset;
    parameters.seed = seed;
    json["changes"].push_back({{"name", "seed"},
                               {"step", seed},
                               {"value", seed},
                               {"rand_error", experiment.score(parameters, true)}});
  }
  const std::set<std::string> after_analysis = names_after_analysis();
  for (const Knob& k : knobs)
  {
    const bool is_of_analysis = after_analysis.count(k.name) == 0;
    if (is_of_analysis && !analyze_anew) continue;
    for (const int percent : {-10, -3, 3, 10})
    {
      const double value = Named_parameters::get(preset, k.name);
      double changed = value * (1. + percent / 100.);
      if (k.is_whole) // at least by one, or nothing would change
        changed = percent < 0 ? (std::min)(std::round(changed), value - 1.)
                              : (std::max)(std::round(changed), value + 1.);
      Parameters parameters = preset;
      Named_parameters::set(parameters, k.name, changed);
      if (!is_in_range(parameters)) continue;
      json["changes"].push_back({{"name", k.name},
                                 {"step", percent},
                                 {"value", Named_parameters::get(parameters, k.name)},
                                 {"rand_error", experiment.score(parameters, is_of_analysis)}});
    }
  }
  return json;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc != 4 && !(argc == 5 && std::string(argv[4]) == "--merging-only"))
      throw std::invalid_argument("give DATA_DIR MODEL OUTCOME.json [--merging-only]: without it, "
                                  "parameters of patches and lines of sight are varied, too");
    const int number = std::stoi(argv[2]);
    const SM::Benchmark_model model = SM::read_benchmark_model(argv[1], number);
    const bool all = argc == 4;
    const Json json = {
        {"model", number},
        {"default", vary(model, {}, used_knobs({}), all)},
        {"paper", vary(model, Parameters::paper(), used_knobs(Parameters::paper()), all)}};
    Shape_io::Atomic_file file(argv[3]);
    file.stream() << json.dump(1) << '\n';
    file.commit();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_sensitivity: " << error.what() << '\n';
    return 1;
  }
}
