// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random search for the constants of the default's merge costs on labeled shapes. Patches, lines of
// sight and diameters of all models are kept, so that a trial takes milliseconds a model. Borders are
// not refined here.

#include "named_parameters.h"
#include "patch_scores.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;

namespace {

struct Knob
{
  std::string name;
  double value;
};

double mean_error(std::vector<Patch_scores::Model>& models, const WCS::Parameters& parameters,
                  double* segments = nullptr)
{
  std::map<std::size_t, std::pair<double, double>> categories;
  double count = 0.;
  for (auto& model : models)
  {
    const WCS::Merge_tree tree = WCS::internal::merge_patches(*model.shape, parameters, {});
    const std::vector<int> regions = WCS::internal::regions_at(tree, WCS::Level::SEGMENTS);
    auto& sum = categories[Segmentation_metrics::category_of_model(model.number)];
    sum.first += Patch_scores::rand_error(model, regions);
    sum.second += 1.;
    count += 1. + *std::max_element(regions.begin(), regions.end());
  }
  if (segments != nullptr) *segments = count / static_cast<double>(models.size());
  double sum = 0.;
  for (const auto& entry : categories) sum += entry.second.first / entry.second.second;
  return sum / static_cast<double>(categories.size());
}

/// one random change of each knob with some probability, by a factor near 1
std::vector<Knob> changed(std::vector<Knob> knobs, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::normal_distribution<double> normal(0., 0.15);
  for (Knob& knob : knobs)
    if (uniform(random) < 0.35) knob.value *= std::exp(normal(random));
  return knobs;
}

WCS::Parameters with(WCS::Parameters parameters, const std::vector<Knob>& knobs)
{
  static const auto setters = Named_parameters::setters();
  for (const Knob& knob : knobs) setters.at(knob.name)(parameters, knob.value);
  return parameters;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc < 3)
      throw std::invalid_argument("usage: tune_costs DATA_DIR TRIALS [NAME=VALUE ...]: the named "
                                  "parameters are searched from there on");
    WCS::Parameters start;
    std::vector<Knob> best;
    for (int i = 3; i < argc; ++i)
    {
      const std::string setting = argv[i];
      Named_parameters::set_parameter(start, setting);
      const std::size_t equals = setting.find('=');
      best.push_back({setting.substr(0, equals), std::stod(setting.substr(equals + 1))});
    }
    std::vector<Patch_scores::Model> models;
    for (int n = 1; n <= 400; ++n)
      if (Segmentation_metrics::is_in_benchmark(n) &&
          std::filesystem::exists(std::string(argv[1]) + "/off/" + std::to_string(n) + ".off"))
        models.push_back(Patch_scores::load(argv[1], n, start));
    double segments = 0., least = mean_error(models, start, &segments);
    std::cout << "start " << least << ", " << segments << " segments\n" << std::flush;
    std::mt19937 random(1);
    for (int trial = 0; trial < std::atoi(argv[2]); ++trial)
    {
      const std::vector<Knob> knobs = changed(best, random);
      const double error = mean_error(models, with(start, knobs), &segments);
      if (error >= least) continue;
      least = error;
      best = knobs;
      std::cout << trial << ' ' << least << ", " << segments << " segments";
      for (const Knob& knob : best) std::cout << ' ' << knob.name << '=' << knob.value;
      std::cout << '\n' << std::flush;
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "tune_costs: " << error.what() << '\n';
    return 1;
  }
}
