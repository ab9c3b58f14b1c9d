// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>
#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include <CGAL/Simple_cartesian.h>

#include "common/set_parameter.h"
#include "shapes_for_tests.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Every parameter is range-checked by name, and every parameter changes something.

BOOST_AUTO_TEST_SUITE(test_parameters)

namespace {

using CGAL::Weakly_convex_segmentation::Fusion_rule;
using CGAL::Weakly_convex_segmentation::Parameters;
using CGAL::Weakly_convex_segmentation::Refinement_rule;
using CGAL::Weakly_convex_segmentation::Result;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

const std::map<std::string, Named_parameters::Setter>& setters()
{
  static const auto result = Named_parameters::setters();
  return result;
}

/// the lowest and the highest value that are allowed
struct Range
{
  double low, high;
};

std::map<std::string, Range> ranges()
{
  std::map<std::string, Range> result = {{"number_of_neighbors", {3., 100.}},
                                         {"number_of_representatives", {100., 1e9}},
                                         {"number_of_patches", {1., 1000.}},
                                         {"number_of_patch_sets", {1., 100.}},
                                         {"number_of_supervoxels", {1., 20000.}},
                                         {"spectral_dimensions", {0.01, 1.}},
                                         {"patch_concavity_tolerance", {0., 180.}},
                                         {"face_sampling_factor", {0., 1000.}},
                                         {"concave_edge_weight", {0., 1.}},
                                         {"samples_per_patch", {1., 100.}},
                                         {"disk_radius_factor", {1e-6, 10.}},
                                         {"clearance_factor", {0., 100.}},
                                         {"noise_tolerance", {0., 180.}},
                                         {"mesh_noise_tolerance", {0., 180.}},
                                         {"grazing_tolerance", {0., 89.}},
                                         {"outside_tolerance", {0., 90.}},
                                         {"signature_threshold", {0., 1.}},
                                         {"concave_seam_ratio", {0., 1e9}},
                                         {"flat_share", {0., 1.}},
                                         {"flat_visibility", {0., 1.}},
                                         {"histogram_bins", {2., 64.}},
                                         {"diameter_cone_angle", {1e-3, 179.}},
                                         {"diameter_samples", {1., 1e6}},
                                         {"diameter_rays", {1., 256.}},
                                         {"seam_concavity_tolerance", {0., 179.}},
                                         {"missing_diameter_distance", {0., 1e6}},
                                         {"fusion_threshold", {0., 1e6}},
                                         {"merging_threshold", {0., 1e6}},
                                         {"merging_cost.concavity_saturation", {0., 1.}},
                                         {"minimum_segment_share", {0., 1.}},
                                         {"fitted_fusion_threshold", {0., 1.}},
                                         {"fitted_merging_threshold", {0., 1.}},
                                         {"band_width", {0., 1.}},
                                         {"data_exponent", {0., 100.}},
                                         {"data_weight", {0., 1e6}},
                                         {"smoothness_angle", {1e-3, 180.}}};
  for (const char* term : {"visibility", "concavity", "diameter", "smaller_closure",
                           "larger_closure", "seam_extent", "diameter_spread", "continuation"})
    result["merging_cost." + std::string(term) + "_weight"] = {0., 1e6};
  return result;
}

bool is_count(const std::string& name)
{
  static const std::set<std::string> counts = {
      "number_of_neighbors",   "number_of_representatives", "number_of_patches",
      "number_of_supervoxels", "number_of_patch_sets",      "samples_per_patch",
      "histogram_bins",        "diameter_samples",          "diameter_rays"};
  return counts.count(name) > 0;
}

std::string refusal(const Parameters& parameters)
{
  try
  {
    parameters.check();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& name, const double value)
{
  Parameters parameters;
  setters().at(name)(parameters, value);
  return refusal(parameters);
}

/// a setting that shows in the result
struct Setting
{
  std::string name, preset, shape;
  double value;
  std::vector<std::string> others = {}; ///< what else must be set for it to matter
};

std::vector<Setting> settings()
{
  return {{"number_of_neighbors", "default", "dumbbell", 14.},
          {"number_of_representatives", "default", "dumbbell", 1000.},
          {"align_principal_axes", "default", "dumbbell", 0.},
          {"normal_orientation", "default", "bare plate", 1.},
          {"use_mesh_adjacency", "default", "stretched dumbbell", 0.},
          {"seed", "default", "dumbbell", 9.},
          {"face_sampling_factor", "default", "long triangles", 0.},
          {"minimum_face_samples",
           "default",
           "long triangles",
           9000.,
           {"number_of_representatives=20000"}},
          {"flip_inward_normals", "default", "inward dumbbell", 0.},
          {"number_of_patches", "default", "dumbbell", 40.},
          {"number_of_patch_sets", "default", "hand", 1.},
          {"number_of_supervoxels", "default", "dumbbell", 400.},
          {"spectral_dimensions", "default", "dumbbell", 1.},
          {"patch_concavity_tolerance", "default", "dumbbell", 40.},
          {"concave_edge_weight", "default", "dumbbell", 1.},
          {"minimum_patch_size", "default", "dumbbell", 60.},
          {"samples_per_patch", "default", "dumbbell", 3.},
          {"disk_radius_factor", "default", "dumbbell", 3.},
          {"clearance_factor", "default", "dumbbell", 10.},
          {"noise_tolerance", "default", "rough dumbbell", 180.},
          {"mesh_noise_tolerance", "default", "rough mesh", 180.},
          {"link_across_lines", "default", "rings", 0.},
          {"grazing_tolerance", "default", "dumbbell", 30.},
          {"outside_tolerance", "default", "dumbbell", 2.},
          {"rays_for_early_decision", "default", "dumbbell", 4.},
          {"maximum_rays_per_pair", "default", "dumbbell", 12.},
          {"merging", "default", "dumbbell", 0.},
          {"diameter", "default", "dumbbell", 0.},
          {"refinement", "default", "hand", 0.},
          {"fusion", "paper", "hand", 1.},
          {"signature_threshold", "paper", "hand", 0.9},
          {"concave_seam_ratio", "paper", "hand", 1e6, {"signature_threshold=1"}},
          {"flat_share", "paper", "hand", 0.9},
          {"flat_visibility", "paper", "hand", 0.95, {"flat_share=1"}},
          {"histogram_bins", "default", "dumbbell", 5.},
          {"diameter_cone_angle", "default", "dumbbell", 20.},
          {"diameter_samples", "default", "dumbbell", 200.},
          {"diameter_rays", "default", "dumbbell", 3.},
          {"seam_concavity_tolerance", "default", "dumbbell", 60.},
          {"merging_cost.visibility_weight", "default", "dumbbell", 0.},
          {"merging_cost.concavity_weight", "default", "dumbbell", 0.},
          {"merging_cost.concavity_saturation", "default", "dumbbell", 0.},
          {"merging_cost.diameter_weight", "default", "dumbbell", 0.},
          {"merging_cost.smaller_closure_weight", "default", "dumbbell", 0.},
          {"merging_cost.larger_closure_weight", "default", "dumbbell", 0.},
          {"merging_cost.seam_extent_weight", "default", "dumbbell", 0.},
          {"merging_cost.diameter_spread_weight", "default", "dumbbell", 0.},
          {"merging_cost.continuation_weight", "default", "octopus", 0.},
          {"fusion_threshold", "default", "dumbbell", 0.1},
          {"merging_threshold", "default", "dumbbell", 100.},
          {"missing_diameter_distance", "default", "dumbbell", 0., {"diameter_samples=30"}},
          {"minimum_segment_share", "default", "dumbbell", 0.4},
          {"fitted_fusion_threshold", "fitted", "dumbbell", 0.01},
          {"fitted_merging_threshold", "fitted", "dumbbell", 1.},
          {"maximum_number_of_segments", "default", "dumbbell", 1.},
          {"band_width", "default", "hand", 0.05},
          {"data_exponent", "default", "hand", 0., {"band_width=0.05"}},
          {"data_weight", "default", "hand", 100., {"band_width=0.05"}},
          {"smoothness_angle", "default", "hand", 90., {"band_width=0.05"}}};
}

Parameters preset_of(const Setting& setting)
{
  Parameters parameters = setting.preset == "paper"    ? Parameters::paper()
                          : setting.preset == "fitted" ? Parameters::fitted()
                                                       : Parameters();
  for (const std::string& other : setting.others)
    Named_parameters::set_parameter(parameters, other);
  return parameters;
}

/// a round bar of long sides and fans at its ends, with the corners of its faces
Raw_shape long_prism()
{
  constexpr std::size_t n = 60;
  const auto corner = [](const std::size_t i, const double z)
  {
    const double turn = 6.283185307179586 * static_cast<double>(i % n) / n;
    return Coordinates{std::cos(turn), std::sin(turn), z};
  };
  Raw_shape raw;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Coordinates a = corner(i, 0.), b = corner(i + 1, 0.), c = corner(i + 1, 8.),
                      d = corner(i, 8.);
    for (const auto& face :
         {std::vector<Coordinates>{a, b, c, d}, {{0., 0., 0.}, b, a}, {{0., 0., 8.}, d, c}})
      CGAL::Weakly_convex_segmentation::internal::add_polygon(face, raw);
  }
  return raw;
}

const Raw_shape& shape(const std::string& name)
{
  static std::map<std::string, Raw_shape> shapes;
  const auto [slot, is_new] = shapes.emplace(name, Raw_shape());
  if (!is_new) return slot->second;
  if (name == "long triangles")
  {
    slot->second = long_prism();
    return slot->second;
  }
  if (name == "rough mesh" || name == "rings")
  {
    slot->second =
        name == "rings"
            ? rings(4., [](const double) { return 0.8; })
            : faces_of_mesh(shaken(Shape_generator::make_mesh("dumbbell", 3000), 0.03, 1));
    return slot->second;
  }
  const bool is_stretched = name == "stretched dumbbell"; // neighbors across long edges are far
  auto mesh = Shape_generator::make_mesh(name == "hand" ? "hand" : "dumbbell",
                                         name == "hand" ? 6000 : 3000);
  if (is_stretched)
    for (auto& p : mesh.points) p[0] *= 8.;
  std::mt19937 random(1);
  if (name == "rough dumbbell")
    for (auto& p : mesh.points)
      for (double& c : p) c += 0.03 * uniform(random);
  slot->second = points_of_mesh(mesh);
  if (name == "inward dumbbell")
    for (auto& n : slot->second.normals) n = {-n[0], -n[1], -n[2]};
  return slot->second;
}

/// of a sparse plate whose normals are not given, read as a user's points are
Result segment_bare_plate(const Parameters& parameters)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points;
  for (const auto& p : Shape_generator::make_cloud("thin_plate", 3000, 1).points)
    points.emplace_back(p[0], p[1], p[2]);
  return segment_points(
      read_input<CGAL::Sequential_tag>(points, CGAL::parameters::default_values()), parameters,
      Run_control());
}

Result segment_shape(const std::string& name, const Parameters& parameters)
{
  return name == "bare plate" ? segment_bare_plate(parameters)
                              : segment_points(shape(name), parameters, Run_control());
}

/// all of a result in one row of numbers
std::vector<double> numbers(const Result& result)
{
  std::vector<double> row(result.labels.begin(), result.labels.end());
  row.insert(row.end(), result.patches.begin(), result.patches.end());
  for (const auto& merge : result.merge_tree.merges())
    row.insert(row.end(), {1. * merge.first, 1. * merge.second, merge.cost});
  for (const auto& segment : result.segments)
    row.insert(row.end(), {segment.convexity_rank, segment.diameter});
  row.push_back(static_cast<double>(result.merge_tree.number_of_fusions()));
  row.push_back(static_cast<double>(result.merge_tree.number_of_accepted_merges()));
  return row;
}

} // namespace

BOOST_AUTO_TEST_CASE(presets_are_in_range)
{
  for (const Parameters& preset : {Parameters(), Parameters::paper(), Parameters::fitted()})
    BOOST_CHECK_EQUAL(refusal(preset), "");
  const Parameters paper = Parameters::paper();
  BOOST_CHECK((paper.fusion_thresholds == std::vector<double>{0.9, 0.8, 0.7}));
  BOOST_CHECK(paper.fusion == Fusion_rule::EVERY_PAIR);
  BOOST_CHECK(paper.refinement == Refinement_rule::ALPHA_EXPANSION);
  BOOST_CHECK_EQUAL(paper.number_of_neighbors, 10u);
  BOOST_CHECK_EQUAL(paper.samples_per_patch, 10u);
  BOOST_CHECK_CLOSE(paper.diameter_cone_angle, 360. / 18., 1e-9);
  BOOST_CHECK_CLOSE(paper.seam_concavity_tolerance, 0.05 * 180., 1e-9);
  BOOST_CHECK_EQUAL(paper.concave_seam_ratio, 0.85);
  BOOST_CHECK_EQUAL(paper.signature_threshold, 0.12);
  BOOST_CHECK_EQUAL(paper.flat_visibility, 0.4);
  BOOST_CHECK_EQUAL(paper.data_exponent, 1.5);
  BOOST_CHECK_EQUAL(paper.data_weight, 0.1);
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused_by_name)
{
  for (const auto& [name, range] : ranges())
  {
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_CHECK_EQUAL(refusal(name, range.low), "");
      BOOST_CHECK_EQUAL(refusal(name, range.high), "");
      const std::string full_name = "Parameters::" + name + " is ";
      const double step = is_count(name) ? 1. : 1e-3 * range.high;
      BOOST_CHECK_NE(refusal(name, range.high + step).find(full_name), std::string::npos);
      if (is_count(name))
        BOOST_CHECK_NE(refusal(name, range.low - 1.).find(full_name), std::string::npos);
      else
        for (const double bad : {range.low - step, std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()})
          BOOST_CHECK_NE(refusal(name, bad).find(full_name), std::string::npos);
    }
  }
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
  {
    Parameters parameters;
    parameters.fusion_thresholds = {0.5, bad};
    BOOST_CHECK_NE(refusal(parameters).find("fusion_thresholds"), std::string::npos);
  }
  // a run refuses them too
  Parameters parameters;
  parameters.number_of_neighbors = 2;
  BOOST_CHECK_THROW(segment_points(shape("dumbbell"), parameters, Run_control()),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(no_parameter_is_forgotten_here)
{
  std::set<std::string> known, tested;
  for (const auto& entry : setters()) known.insert(entry.first);
  for (const Setting& setting : settings()) tested.insert(setting.name);
  BOOST_CHECK_EQUAL_COLLECTIONS(known.begin(), known.end(), tested.begin(), tested.end());
}

BOOST_AUTO_TEST_CASE(every_parameter_changes_something)
{
  std::map<std::string, std::vector<double>> known; // results by what was set
  for (const Setting& setting : settings())
  {
    Parameters parameters = preset_of(setting);
    std::string key = setting.preset + " " + setting.shape;
    for (const std::string& other : setting.others) key += " " + other;
    auto& usual = known[key];
    if (usual.empty()) usual = numbers(segment_shape(setting.shape, parameters));
    setters().at(setting.name)(parameters, setting.value);
    const Result changed = segment_shape(setting.shape, parameters);
    BOOST_CHECK_MESSAGE(numbers(changed) != usual, setting.name << " has changed nothing");
  }
  Parameters parameters = Parameters::paper();
  parameters.fusion_thresholds = {0.2};
  BOOST_CHECK(numbers(segment_points(shape("hand"), parameters, Run_control())) !=
              known.at("paper hand"));
}

BOOST_AUTO_TEST_SUITE_END()
