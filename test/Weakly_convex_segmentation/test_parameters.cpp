// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/borders/band.h>
#include <CGAL/Weakly_convex_segmentation/internal/input/read_input.h>

#include <CGAL/Simple_cartesian.h>

#include "compiled_core.h"
#include "program/set_parameter.h"
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
using CGAL::Weakly_convex_segmentation::Merging_rule;
using CGAL::Weakly_convex_segmentation::Parameters;
using CGAL::Weakly_convex_segmentation::Refinement_rule;
using CGAL::Weakly_convex_segmentation::Result;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

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
  Parameters parameters = Parameters::training_free(); // whose thresholds have the widest ranges
  Named_parameters::set(parameters, name, value);
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
          {"normal_orientation", "default", "bare plate", 1.},
          {"extra_neighbors", "default", "stretched dumbbell", 0.},
          {"seed", "default", "dumbbell", 9.},
          {"face_sampling_factor", "default", "long triangles", 0.},
          {"flip_inward_normals", "default", "inward dumbbell", 0.},
          {"pieces", "default", "two dumbbells", 0.},
          {"number_of_patches", "default", "dumbbell", 40.},
          {"number_of_patch_sets", "default", "hand", 1.},
          {"number_of_supervoxels", "default", "dumbbell", 400.},
          {"spectral_dimensions", "default", "dumbbell", 1.},
          {"patch_concavity_tolerance", "default", "dumbbell", 40.},
          {"denoise", "default", "rough mesh", 0.},
          {"denoise", "default", "rough dumbbell", 0.},
          {"grazing_tolerance", "default", "dumbbell", 30.},
          {"maximum_rays_per_pair", "training_free", "dumbbell", 12.},
          {"merging", "default", "dumbbell", 0., {"merging_threshold=1"}},
          {"diameter", "default", "dumbbell", 0.},
          {"refinement", "default", "hand", 0.},
          {"fusion", "paper", "hand", 0.},
          {"fusion_thresholds[0]", "paper", "hand", 0.2},
          {"fusion_thresholds[1]", "paper", "hand", 0.2},
          {"fusion_thresholds[2]", "paper", "hand", 0.2},
          {"diameter_cone_angle", "default", "dumbbell", 20.},
          {"seam_concavity_tolerance", "default", "dumbbell", 60.},
          {"merging_cost.concavity_weight", "training_free", "dumbbell", 0.},
          {"merging_cost.concavity_saturation", "training_free", "dumbbell", 0.},
          {"merging_cost.diameter_weight", "training_free", "dumbbell", 0.},
          {"merging_cost.smaller_closure_weight", "training_free", "dumbbell", 0.},
          {"merging_cost.larger_closure_weight", "training_free", "dumbbell", 0.},
          {"merging_cost.seam_extent_weight", "training_free", "dumbbell", 0.},
          {"merging_cost.diameter_spread_weight", "training_free", "dumbbell", 0.},
          {"merging_cost.continuation_weight", "training_free", "octopus", 0.},
          {"fusion_threshold", "training_free", "dumbbell", 0.1},
          {"merging_threshold", "training_free", "dumbbell", 100.},
          {"fusion_threshold", "default", "dumbbell", 0.9},
          {"merging_threshold", "default", "dumbbell", 1.},
          {"maximum_rays_per_pair", "default", "hand", 1.},
          {"minimum_segment_share", "default", "dumbbell", 0.4},
          {"symmetry_tolerance", "default", "figure", 0.},
          {"minimum_number_of_segments", "default", "dumbbell", 9.},
          {"maximum_number_of_segments", "default", "dumbbell", 1.},
          {"band_width", "default", "hand", 0.05}};
}

Parameters preset_of(const Setting& setting)
{
  Parameters parameters = Parameters::preset(setting.preset);
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
  if (name == "two dumbbells") // that penetrate each other
  {
    auto two = Shape_generator::make_mesh("dumbbell", 3000);
    const std::size_t points = two.points.size(), faces = two.faces.size();
    for (std::size_t i = 0; i < points; ++i)
      two.points.push_back({two.points[i][0], two.points[i][1] + 0.3, two.points[i][2]});
    for (std::size_t f = 0; f < faces; ++f)
    {
      auto face = two.faces[f];
      for (auto& v : face) v += points;
      two.faces.push_back(face);
      two.labels.push_back(two.labels[f]);
    }
    slot->second = faces_of_mesh(two);
    return slot->second;
  }
  const bool is_stretched = name == "stretched dumbbell"; // neighbors across long edges are far
  const bool is_large = name == "hand" || name == "figure";
  auto mesh = Shape_generator::make_mesh(is_large ? name : "dumbbell", is_large ? 6000 : 3000);
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
  return Compiled_core::segment_points(
      read_input<CGAL::Sequential_tag>(points, CGAL::parameters::default_values()), parameters,
      Run_control());
}

Result segment_shape(const std::string& name, const Parameters& parameters)
{
  return name == "bare plate"
             ? segment_bare_plate(parameters)
             : Compiled_core::segment_points(shape(name), parameters, Run_control());
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
  for (const Parameters& preset : {Parameters(), Parameters::paper(), Parameters::training_free()})
    BOOST_CHECK_EQUAL(refusal(preset), "");
  const Parameters paper = Parameters::paper();
  BOOST_CHECK((paper.fusion_thresholds == std::vector<double>{0.9, 0.8, 0.7}));
  BOOST_CHECK(paper.fusion == Fusion_rule::AVERAGE);
  BOOST_CHECK(paper.refinement == Refinement_rule::ALPHA_EXPANSION);
  BOOST_CHECK_EQUAL(paper.number_of_neighbors, 10u);
  BOOST_CHECK_CLOSE(paper.diameter_cone_angle, 360. / 18., 1e-9);
  BOOST_CHECK_CLOSE(paper.seam_concavity_tolerance, 0.05 * 180., 1e-9);
  BOOST_CHECK_EQUAL(paper.merging_threshold, 0.12);
  BOOST_CHECK_EQUAL(data_exponent, 1.5);
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused_by_name)
{
  for (const Named_parameters::Knob& knob : Named_parameters::knobs())
  {
    BOOST_TEST_CONTEXT(knob.name)
    {
      if (knob.name == "seed" || (knob.high == 1. && knob.is_whole)) continue; // any value
      if (knob.name != "merging") // which the usual threshold does not suit
      {
        BOOST_CHECK_EQUAL(refusal(knob.name, knob.low), "");
        BOOST_CHECK_EQUAL(refusal(knob.name, knob.high), "");
      }
      const std::string full_name =
          "Parameters::" + knob.name.substr(0, knob.name.find('[')) + " is ";
      const double step = knob.is_whole ? 1. : 1e-3 * knob.high;
      std::vector<double> bad = {knob.high + step};
      if (!knob.is_whole)
        bad.insert(bad.end(), {knob.low - step, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()});
      else if (knob.low > 0.)
        bad.push_back(knob.low - 1.);
      for (const double value : bad)
        BOOST_CHECK_NE(refusal(knob.name, value).find(full_name), std::string::npos);
    }
  }
  // probabilities and relative distances are at most 1
  Parameters learned;
  learned.fusion_threshold = 1.1;
  BOOST_CHECK_NE(refusal(learned).find("fusion_threshold"), std::string::npos);
  for (const Merging_rule rule : {Merging_rule::PAPER, Merging_rule::FITTED})
  {
    Parameters parameters;
    parameters.merging = rule;
    parameters.merging_threshold = 1.1;
    BOOST_CHECK_NE(refusal(parameters).find("merging_threshold"), std::string::npos);
  }
  // a run refuses them too
  Parameters parameters;
  parameters.number_of_neighbors = 2;
  BOOST_CHECK_THROW(Compiled_core::segment_points(shape("dumbbell"), parameters, Run_control()),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(no_parameter_is_forgotten_here)
{
  std::set<std::string> known, tested;
  for (const auto& knob : Named_parameters::knobs()) known.insert(knob.name);
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
    BOOST_REQUIRE(Named_parameters::set(parameters, setting.name, setting.value));
    const Result changed = segment_shape(setting.shape, parameters);
    BOOST_CHECK_MESSAGE(numbers(changed) != usual, setting.name << " has changed nothing");
  }
}

BOOST_AUTO_TEST_CASE(assignments_of_a_command_line)
{
  Parameters parameters;
  Named_parameters::set_parameter(parameters, "merging_cost.diameter_weight=0.25");
  Named_parameters::set_parameter(parameters, "merging=2");
  Named_parameters::set_parameter(parameters, "denoise=0");
  Named_parameters::set_parameter(parameters, "fusion_thresholds=0.5,0.25");
  Named_parameters::set_parameter(parameters, "fusion_thresholds[1]=0.125");
  BOOST_CHECK_EQUAL(parameters.merging_cost.diameter_weight, 0.25);
  BOOST_CHECK(parameters.merging == Merging_rule::FITTED);
  BOOST_CHECK(!parameters.denoise);
  BOOST_CHECK((parameters.fusion_thresholds == std::vector<double>{0.5, 0.125}));
  BOOST_CHECK_EQUAL(Named_parameters::get(parameters, "fusion_thresholds[1]"), 0.125);
  for (const char* bad :
       {"number_of_patches", "number_of_patches=", "number_of_patches=9x", "number_of_patches=1,2",
        "no_such=1", "fusion_thresholds[7]=1", "=1", "fusion_thresholds=1,,2"})
    BOOST_CHECK_THROW(Named_parameters::set_parameter(parameters, bad), std::invalid_argument);
  BOOST_CHECK_THROW(Named_parameters::get(parameters, "no_such"), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
