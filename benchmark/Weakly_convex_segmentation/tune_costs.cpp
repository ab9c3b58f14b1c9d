// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random search for the constants of the merge cost of `training_free` on labeled shapes that
// `fit_merge_cost prepare` has analyzed: a trial takes two milliseconds a model. Borders are not refined
// here, unless for the last line. What is sought is a low mean 1 - Rand Index with people's number of
// parts, and in no category a higher one than the best of other tools.
//
//   tune_costs FOLDER,FOLDER... TRIALS SEED HALF [NAME=VALUE...]
//
// Several folders are several variants of the models, or seeds of their patches: what is tuned on one
// seed alone is overfit to it. The named parameters are searched from there on. HALF is 0 or 1 to search on every second model only,
// to see on the other half what a gain is worth; 2 for all.

#include "fit/saved_models.h"
#include "program/set_parameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
using Patch_scores::Model;

namespace {

constexpr std::size_t categories = 19;

/// the lowest of CPC, CGAL's SDF segmentation and LCCP, tuned, on the whole benchmark
constexpr std::array<double, categories> best_of_others = {.138, .293, .163, .105, .041, .112, .034,
                                                           .121, .070, .128, .131, .264, .110, .097,
                                                           .258, .138, .181, .171, .155};

struct Knob
{
  std::string name;
  double value;
};

/// A model and its regions before any merge.
struct Prepared
{
  Model model;
  std::unique_ptr<WCS::internal::Region_graph> graph;
  double annotator_parts = 0.;

  bool in_half(const int half) const
  {
    const auto n = static_cast<std::size_t>((model.number - 1) / 2);
    return half > 1 || (n + model.category()) % 2 == static_cast<std::size_t>(half);
  }
};

Prepared prepare(const std::filesystem::path& folder, const int number,
                 const WCS::Parameters& parameters)
{
  Prepared p;
  p.model = Patch_scores::load_saved(folder, number, parameters);
  const auto& shape = *p.model.shape;
  p.graph = std::make_unique<WCS::internal::Region_graph>(
      shape.points(), shape.graph, shape.patches(), shape.visibility(), parameters);
  WCS::internal::set_signatures(*p.graph, shape.patches(), shape.diameters, {});
  p.graph->add_shapes(shape.points(), shape.graph, shape.patches(), shape.diameters);
  for (const auto& annotator : p.model.annotators)
    p.annotator_parts +=
        static_cast<double>(std::set<int>(annotator.labels.begin(), annotator.labels.end()).size());
  p.annotator_parts /= static_cast<double>(p.model.annotators.size());
  return p;
}

std::vector<int> merged_regions(const Prepared& p, const WCS::Parameters& parameters)
{
  const WCS::internal::Histogram_scale scale;
  WCS::internal::Region_graph graph(*p.graph);
  const auto& shape = *p.model.shape;
  const WCS::internal::Region_cost cost(graph, shape.patches(), shape.diameters, scale);
  WCS::Merge_tree tree(shape.patches().size());
  const WCS::internal::Contraction_log log{tree, nullptr};
  const double threshold = parameters.merging_threshold;
  WCS::internal::contract_up_to(
      graph,
      [&](const int a, const int b) { return cost(a, b, parameters.merging_cost, threshold); },
      threshold, log);
  WCS::internal::absorb_small_regions(graph, cost, parameters, log);
  return graph.labels();
}

/// Means a category.
struct Outcome
{
  std::array<double, categories> error{}, parts{}, annotators{}, models{};
  double mean_error = 0., mean_parts = 0.;

  double objective() const
  {
    constexpr double gain_of_cut = 0.004;
    double sum = mean_error;
    for (std::size_t c = 0; c < categories; ++c)
      if (models[c] > 0.)
        sum += 2. / categories * (std::max)(0., error[c] - best_of_others[c] - gain_of_cut) +
               0.0004 * std::abs(std::log(parts[c] / annotators[c]));
    return sum;
  }
};

Outcome evaluate(const std::vector<Prepared>& models, const WCS::Parameters& parameters,
                 const int half, const bool with_cut = false)
{
  Outcome outcome;
  for (const Prepared& p : models)
  {
    if (!p.in_half(half)) continue;
    const auto regions = merged_regions(p, parameters);
    const std::size_t c = p.model.category();
    outcome.error[c] +=
        with_cut ? Patch_scores::rand_error_of_labels(
                       p.model, Patch_scores::refined_labels(p.model, regions, parameters))
                 : Patch_scores::rand_error(p.model, regions);
    outcome.parts[c] += 1. + *std::max_element(regions.begin(), regions.end());
    outcome.annotators[c] += p.annotator_parts;
    outcome.models[c] += 1.;
  }
  double count = 0.;
  for (std::size_t c = 0; c < categories; ++c)
    if (outcome.models[c] > 0.)
    {
      for (auto* values : {&outcome.error, &outcome.parts, &outcome.annotators})
        (*values)[c] /= outcome.models[c];
      outcome.mean_error += outcome.error[c];
      outcome.mean_parts += outcome.parts[c];
      count += 1.;
    }
  outcome.mean_error /= count;
  outcome.mean_parts /= count;
  return outcome;
}

void print(const Outcome& outcome)
{
  std::cout << outcome.mean_error << ", " << outcome.mean_parts << " parts, objective "
            << outcome.objective() << ';';
  for (std::size_t c = 0; c < categories; ++c)
    std::cout << ' ' << SM::category_names()[c].substr(0, 3) << ' '
              << std::lround(1000. * outcome.error[c]) << '/'
              << std::round(10. * outcome.parts[c]) / 10.;
  std::cout << '\n' << std::flush;
}

WCS::Parameters with(WCS::Parameters parameters, const std::vector<Knob>& knobs)
{
  for (const Knob& knob : knobs) Named_parameters::set(parameters, knob.name, knob.value);
  return parameters;
}

/// changes each knob with some probability, by a factor near 1 and a little more.
std::vector<Knob> changed(std::vector<Knob> knobs, const double step, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::normal_distribution<double> normal;
  for (Knob& knob : knobs)
    if (uniform(random) < 0.35)
    {
      knob.value *= std::exp(0.15 * step * normal(random));
      if (knob.name.find("weight") != std::string::npos) knob.value += 0.05 * step * normal(random);
      knob.value = (std::max)(0., knob.value);
      if (knob.name.find("saturation") != std::string::npos)
        knob.value = (std::min)(1., knob.value);
    }
  return knobs;
}

std::vector<Knob> search(const std::vector<Prepared>& models, const WCS::Parameters& start,
                         std::vector<Knob> best, const int trials, const unsigned int seed,
                         const int half)
{
  double least = evaluate(models, with(start, best), half).objective(), step = 1.;
  std::mt19937 random(seed);
  int failures = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    const std::vector<Knob> knobs = changed(best, step, random);
    const Outcome outcome = evaluate(models, with(start, knobs), half);
    if (outcome.objective() >= least)
    {
      if (++failures % 25 == 0) step *= 0.75;
      continue;
    }
    least = outcome.objective();
    best = knobs;
    failures = 0;
    std::cout << trial << ": ";
    print(outcome);
    for (const Knob& knob : best) std::cout << "  " << knob.name << '=' << knob.value;
    std::cout << '\n' << std::flush;
  }
  return best;
}

int run(const std::vector<std::string>& arguments)
{
  if (arguments.size() < 4)
    throw std::invalid_argument("usage: tune_costs FOLDER,... TRIALS SEED HALF [NAME=VALUE ...]");
  WCS::Parameters start = WCS::Parameters::training_free();
  std::vector<Knob> knobs;
  for (std::size_t i = 4; i < arguments.size(); ++i)
  {
    Named_parameters::set_parameter(start, arguments[i]);
    const std::size_t equals = arguments[i].find('=');
    knobs.push_back({arguments[i].substr(0, equals), std::stod(arguments[i].substr(equals + 1))});
  }
  std::vector<Prepared> models;
  std::istringstream folders(arguments[0]);
  for (std::string folder; std::getline(folders, folder, ',');)
    Patch_scores::for_each_number(
        folder, ".bin", [&](const int n) { models.push_back(prepare(folder, n, start)); });
  if (models.empty()) throw std::runtime_error("there are no models in " + arguments[0]);
  std::cout << "start: ";
  const int half = std::stoi(arguments[3]);
  print(evaluate(models, start, half));
  knobs = search(models, start, knobs, std::stoi(arguments[1]),
                 static_cast<unsigned int>(std::stoul(arguments[2])), half);
  for (const int part : {0, 1, 2})
  {
    std::cout << (part < 2 ? "half " + std::to_string(part) : std::string("all")) << ": ";
    print(evaluate(models, with(start, knobs), part));
  }
  std::cout << "all, borders refined: ";
  print(evaluate(models, with(start, knobs), 2, true));
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  }
  catch (const std::exception& error)
  {
    std::cerr << "tune_costs: " << error.what() << '\n';
    return 1;
  }
}
