// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How much the score of one model of the Princeton Segmentation Benchmark changes with each parameter,
// by 3 and by 10 percent of its value down and up, as one JSON file. What only touches merging and
// borders is run on one analysis of the shape.

#include "metrics/princeton_benchmark.h"

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
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
using Json = nlohmann::json;
using WCS::Merging_cost;
using WCS::Parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;

namespace {

struct Knob
{
  std::string name;
  bool of_analysis; ///< used before merging: the shape has to be analyzed anew
  bool is_count;
  std::function<double(const Parameters&)> get;
  std::function<void(Parameters&, double)> set;
};

template <typename Number>
Knob knob(const std::string& name, Number Parameters::*member, const bool of_analysis)
{
  return {name, of_analysis, std::is_integral<Number>::value,
          [member](const Parameters& p) { return static_cast<double>(p.*member); },
          [member](Parameters& p, const double v) { p.*member = static_cast<Number>(v); }};
}

void add_cost(std::vector<Knob>& knobs, const std::string& name, Merging_cost Parameters::*cost)
{
  const auto add = [&](const std::string& part, double Merging_cost::*member)
  {
    knobs.push_back({name + "." + part, false, false,
                     [=](const Parameters& p) { return p.*cost.*member; },
                     [=](Parameters& p, const double v) { p.*cost.*member = v; }});
  };
  add("visibility_weight", &Merging_cost::visibility_weight);
  add("concavity_weight", &Merging_cost::concavity_weight);
  add("concavity_saturation", &Merging_cost::concavity_saturation);
  add("diameter_weight", &Merging_cost::diameter_weight);
  add("smaller_closure_weight", &Merging_cost::smaller_closure_weight);
  add("larger_closure_weight", &Merging_cost::larger_closure_weight);
  add("seam_extent_weight", &Merging_cost::seam_extent_weight);
  add("diameter_spread_weight", &Merging_cost::diameter_spread_weight);
  add("continuation_weight", &Merging_cost::continuation_weight);
}

/// the parameters that both presets use
std::vector<Knob> common_knobs()
{
  using P = Parameters;
  return {knob("number_of_neighbors", &P::number_of_neighbors, true),
          knob("number_of_patches", &P::number_of_patches, true),
          knob("number_of_supervoxels", &P::number_of_supervoxels, true),
          knob("samples_per_patch", &P::samples_per_patch, true),
          knob("disk_radius_factor", &P::disk_radius_factor, true),
          knob("clearance_factor", &P::clearance_factor, true),
          knob("seam_concavity_tolerance", &P::seam_concavity_tolerance, false),
          knob("band_width", &P::band_width, false),
          knob("data_weight", &P::data_weight, false),
          knob("data_exponent", &P::data_exponent, false)};
}

std::vector<Knob> knobs_of_default()
{
  using P = Parameters;
  std::vector<Knob> knobs = common_knobs();
  add_cost(knobs, "merging_cost", &P::merging_cost);
  for (const Knob& more : {knob("grazing_tolerance", &P::grazing_tolerance, true),
                           knob("patch_concavity_tolerance", &P::patch_concavity_tolerance, true),
                           knob("diameter_cone_angle", &P::diameter_cone_angle, true),
                           knob("diameter_samples", &P::diameter_samples, true),
                           knob("diameter_rays", &P::diameter_rays, true),
                           knob("missing_diameter_distance", &P::missing_diameter_distance, false),
                           knob("merging_threshold", &P::merging_threshold, false),
                           knob("minimum_segment_share", &P::minimum_segment_share, false),
                           knob("smoothness_angle", &P::smoothness_angle, false)})
    knobs.push_back(more);
  return knobs;
}

std::vector<Knob> knobs_of_paper()
{
  using P = Parameters;
  std::vector<Knob> knobs;
  for (std::size_t i = 0; i < 3; ++i)
    knobs.push_back({"fusion_thresholds[" + std::to_string(i) + "]", false, false,
                     [i](const Parameters& p) { return p.fusion_thresholds.at(i); },
                     [i](Parameters& p, const double v)
                     { p.fusion_thresholds.at(i) = (std::min)(v, 1.); }});
  for (const Knob& more : {knob("signature_threshold", &P::signature_threshold, false),
                           knob("concave_seam_ratio", &P::concave_seam_ratio, false),
                           knob("flat_share", &P::flat_share, false),
                           knob("flat_visibility", &P::flat_visibility, false),
                           knob("diameter_cone_angle", &P::diameter_cone_angle, false),
                           knob("histogram_bins", &P::histogram_bins, false)})
    knobs.push_back(more);
  for (const Knob& more : common_knobs()) knobs.push_back(more);
  return knobs;
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
  for (const Knob& k : knobs)
  {
    if (k.of_analysis && !analyze_anew) continue;
    for (const int percent : {-10, -3, 3, 10})
    {
      const double value = k.get(preset);
      double changed = value * (1. + percent / 100.);
      if (k.is_count) // at least by one, or nothing would change
        changed = percent < 0 ? (std::min)(std::round(changed), value - 1.)
                              : (std::max)(std::round(changed), value + 1.);
      Parameters parameters = preset;
      k.set(parameters, changed);
      if (!is_in_range(parameters)) continue;
      json["changes"].push_back({{"name", k.name},
                                 {"step", percent},
                                 {"value", k.get(parameters)},
                                 {"rand_error", experiment.score(parameters, k.of_analysis)}});
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
    const Json json = {{"model", number},
                       {"default", vary(model, {}, knobs_of_default(), all)},
                       {"paper", vary(model, Parameters::paper(), knobs_of_paper(), all)}};
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
