// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SET_PARAMETER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SET_PARAMETER_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>

// The knobs of the method by name, for sweeps from a command line.

namespace Named_parameters {

using Parameters = CGAL::Weakly_convex_segmentation::Parameters;
using Setter = std::function<void(Parameters&, double)>;

/// returns a function that sets a number, count, flag or rule.
template <typename Type>
Setter setter(Type Parameters::*member)
{
  return [member](Parameters& parameters, const double value)
  {
    if constexpr (std::is_enum<Type>::value)
      parameters.*member = static_cast<Type>(static_cast<int>(value));
    else if constexpr (std::is_same<Type, bool>::value)
      parameters.*member = value != 0.;
    else
      parameters.*member = static_cast<Type>(value);
  };
}

inline void add_cost(std::map<std::string, Setter>& setters, const std::string& name,
                     CGAL::Weakly_convex_segmentation::Merging_cost Parameters::*cost)
{
  using Cost = CGAL::Weakly_convex_segmentation::Merging_cost;
  const auto add = [&](const char* part, double Cost::*member)
  {
    setters[name + "." + part] = [cost, member](Parameters& parameters, const double value)
    { parameters.*cost.*member = value; };
  };
  add("visibility_weight", &Cost::visibility_weight);
  add("concavity_weight", &Cost::concavity_weight);
  add("concavity_saturation", &Cost::concavity_saturation);
  add("diameter_weight", &Cost::diameter_weight);
  add("smaller_closure_weight", &Cost::smaller_closure_weight);
  add("larger_closure_weight", &Cost::larger_closure_weight);
  add("seam_extent_weight", &Cost::seam_extent_weight);
  add("diameter_spread_weight", &Cost::diameter_spread_weight);
  add("continuation_weight", &Cost::continuation_weight);
}

/// all parameters that are one number; enumerations by their position
inline std::map<std::string, Setter> setters()
{
  using P = Parameters;
  std::map<std::string, Setter> result = {
      {"number_of_neighbors", setter(&P::number_of_neighbors)},
      {"number_of_representatives", setter(&P::number_of_representatives)},
      {"link_across_lines", setter(&P::link_across_lines)},
      {"align_principal_axes", setter(&P::align_principal_axes)},
      {"normal_orientation", setter(&P::normal_orientation)},
      {"use_mesh_adjacency", setter(&P::use_mesh_adjacency)},
      {"face_sampling_factor", setter(&P::face_sampling_factor)},
      {"flip_inward_normals", setter(&P::flip_inward_normals)},
      {"minimum_face_samples", setter(&P::minimum_face_samples)},
      {"seed", setter(&P::seed)},
      {"number_of_patches", setter(&P::number_of_patches)},
      {"number_of_patch_sets", setter(&P::number_of_patch_sets)},
      {"number_of_supervoxels", setter(&P::number_of_supervoxels)},
      {"spectral_dimensions", setter(&P::spectral_dimensions)},
      {"patch_concavity_tolerance", setter(&P::patch_concavity_tolerance)},
      {"concave_edge_weight", setter(&P::concave_edge_weight)},
      {"minimum_patch_size", setter(&P::minimum_patch_size)},
      {"samples_per_patch", setter(&P::samples_per_patch)},
      {"disk_radius_factor", setter(&P::disk_radius_factor)},
      {"clearance_factor", setter(&P::clearance_factor)},
      {"noise_tolerance", setter(&P::noise_tolerance)},
      {"mesh_noise_tolerance", setter(&P::mesh_noise_tolerance)},
      {"grazing_tolerance", setter(&P::grazing_tolerance)},
      {"outside_tolerance", setter(&P::outside_tolerance)},
      {"rays_for_early_decision", setter(&P::rays_for_early_decision)},
      {"maximum_rays_per_pair", setter(&P::maximum_rays_per_pair)},
      {"merging", setter(&P::merging)},
      {"diameter", setter(&P::diameter)},
      {"refinement", setter(&P::refinement)},
      {"fusion", setter(&P::fusion)},
      {"signature_threshold", setter(&P::signature_threshold)},
      {"concave_seam_ratio", setter(&P::concave_seam_ratio)},
      {"flat_share", setter(&P::flat_share)},
      {"flat_visibility", setter(&P::flat_visibility)},
      {"histogram_bins", setter(&P::histogram_bins)},
      {"diameter_cone_angle", setter(&P::diameter_cone_angle)},
      {"diameter_samples", setter(&P::diameter_samples)},
      {"diameter_rays", setter(&P::diameter_rays)},
      {"seam_concavity_tolerance", setter(&P::seam_concavity_tolerance)},
      {"missing_diameter_distance", setter(&P::missing_diameter_distance)},
      {"fusion_threshold", setter(&P::fusion_threshold)},
      {"merging_threshold", setter(&P::merging_threshold)},
      {"minimum_segment_share", setter(&P::minimum_segment_share)},
      {"fitted_fusion_threshold", setter(&P::fitted_fusion_threshold)},
      {"fitted_merging_threshold", setter(&P::fitted_merging_threshold)},
      {"maximum_number_of_segments", setter(&P::maximum_number_of_segments)},
      {"band_width", setter(&P::band_width)},
      {"data_exponent", setter(&P::data_exponent)},
      {"data_weight", setter(&P::data_weight)},
      {"smoothness_angle", setter(&P::smoothness_angle)}};
  add_cost(result, "merging_cost", &P::merging_cost);
  return result;
}

/// sets a parameter from "name=value".
/// \throws std::invalid_argument if there is no such parameter or the value is no number
inline void set_parameter(Parameters& parameters, const std::string& assignment)
{
  static const std::map<std::string, Setter> known = setters();
  const std::size_t equals = assignment.find('=');
  const auto it = known.find(assignment.substr(0, equals));
  if (equals == std::string::npos || it == known.end())
    throw std::invalid_argument("'" + assignment +
                                "' does not set a parameter; give NAME=VALUE "
                                "with a name from Parameters.h");
  std::size_t used = 0;
  const std::string value = assignment.substr(equals + 1);
  double number = 0.;
  try
  {
    number = std::stod(value, &used);
  }
  catch (const std::exception&)
  {
    used = 0;
  }
  if (used == 0 || used != value.size())
    throw std::invalid_argument("'" + assignment + "': '" + value + "' is no number");
  it->second(parameters, number);
}

} // namespace Named_parameters

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_SET_PARAMETER_H
