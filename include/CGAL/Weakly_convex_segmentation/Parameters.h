// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_PARAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_PARAMETERS_H

#include <CGAL/Weakly_convex_segmentation/Normal_orientation.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// The three granularities at which a shape can be asked for.
enum class Level
{
  PATCHES,    ///< small, nearly convex pieces of the surface (section 4 of the paper)
  COMPONENTS, ///< weakly convex components: fused patches that see each other (section 4)
  SEGMENTS    ///< the parts of the shape: components merged by their volume (section 5)
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Which criteria drive the contraction of the patches into segments.
enum class Merging_rule
{
  PAPER, ///< fusion thresholds, signature distance, seam sets and flat components (sections 4, 5)
  COST,  ///< one weighted cost of visibility, seam concavity, volume and closure
  FITTED ///< a cost fitted to how people cut shapes of 19 kinds, see `Parameters::fitted()`
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How the visibility of two components is judged from that of their patches.
enum class Fusion_rule
{
  EVERY_PAIR, ///< the threshold holds for every pair of patches (the text of section 4)
  AVERAGE     ///< the threshold holds for the average over the pairs of patches
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How the diameter of the shape at a point is measured for the volumetric signatures.
enum class Diameter_rule
{
  OWN_POINTS,  ///< lengths to the component's own points in a cone (section 5)
  WHOLE_SHAPE, ///< cast rays in a cone until they leave the shape, whichever component is hit
  GIVEN ///< what was passed to `Segmenter::set_diameters()`, for instance CGAL's shape diameter
        ///< function by `mesh_diameters()`
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How the borders between the segments are refined.
enum class Refinement_rule
{
  NONE,            ///< borders stay where the patches end
  ALPHA_EXPANSION, ///< alpha expansion over all labels in the band (section 5, equations 3-5)
  SEAM_CUTS        ///< one binary minimum cut for each pair of adjacent segments
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Weights of the terms of the `Merging_rule::COST` contraction, each at least 0.
///
/// The cost of merging two adjacent regions is the weighted sum of
/// - their blindness: 1 - the mutual visibility `v`;
/// - the concave share `c` of their seam, saturating: `c (1 - concavity_saturation c)`;
/// - the earth mover's distance of their diameter histograms (natural logarithms of the diameter);
/// - the closure of the smaller and of the larger one: the share of sampled points whose line inwards
///   ends at the same region, which is high for complete parts;
///
/// less that of
/// - the extent of the seam: its longest axis relative to that of the union, in about `[0, 1]`;
/// - the spread of the diameters of the smaller region: standard deviation of the logarithm;
/// - the continuation: how much the two are pieces of one tube that goes on straight, in `[0, 1]`.
struct Merging_cost
{
  double visibility_weight = 0.;
  double concavity_weight = 0.;
  double concavity_saturation = 0.; ///< in `[0, 1]`
  double diameter_weight = 0.;
  double smaller_closure_weight = 0.;
  double larger_closure_weight = 0.;
  double seam_extent_weight = 0.;
  double diameter_spread_weight = 0.;
  double continuation_weight = 0.;
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// All knobs of the algorithm.
///
/// A default constructed object is the default preset, the best that we know; `paper()` has every
/// value and rule as \cgalCite{cgal:kfkac-ssaca-14} has them. Angles are in degrees; lengths are
/// relative to the extent of the shape: the diameter of the smallest sphere about the centroid of
/// the points that holds them all. One set of values serves all shapes. Ranges are given in brackets; costs and
/// weights without one are from 0 to 1e6.
struct Parameters
{
  /// \name Sampling
  /// @{

  /// number of nearest neighbors of a point in the neighbor graph (`k`, section 4); `[3, 100]`
  std::size_t number_of_neighbors = 10;
  /// Shapes of more points are thinned to about so many representatives, on which everything that
  /// is not linear in time runs; `[100, 1e9]`
  std::size_t number_of_representatives = 5000;
  /// Faces with an edge longer than so many square roots of the mean area of a face get more than one
  /// point, as if they were cut there; the label of a face is that of most of its points. 0: one
  /// point a face; `[0, 1000]`
  double face_sampling_factor = 7.;
  /// Meshes with fewer faces count as so many, for `face_sampling_factor`; `[0, 1e6]`
  std::size_t minimum_face_samples = 1000;
  /// Whether all normals are turned, for the run, where the shape is closed and its normals point
  /// inwards. Scans of a closed room from within want false. `Result::has_flipped_normals` tells.
  bool flip_inward_normals = true;
  /// Whether the shape is turned by its principal axes for the run, always aslant to them in the same way,
  /// so that it is cut the same however it lies.
  bool align_principal_axes = true;
  Normal_orientation normal_orientation = Normal_orientation::PROPAGATION; ///< if none are given
  /// whether the faces of a mesh count as neighbors where they share an edge
  bool use_mesh_adjacency = true;
  /// Whether points without a mesh whose nearest neighbors all lie along one line, as those of a laser
  /// scanner do, are also neighbors of the nearest points beside it.
  bool link_across_lines = true;
  unsigned int seed = 0; ///< seed of all random choices; any value
  /// The points are smoothed where noise turns the normals of neighbors by more degrees (most points have
  /// convex and concave edges in equal measure) or normals contradict positions by twice that, and thinned
  /// by sides where they are crumpled; `[0, 180]`, with 180 never. Given positions stay as they are.
  double noise_tolerance = 2.5;
  /// The vertices of a mesh are smoothed, before all else, where noise turns the normals of faces that
  /// share an edge by more degrees: where the median face has convex and concave edges in equal measure;
  /// `[0, 180]`, with 180 never. The positions that are given stay as they are.
  double mesh_noise_tolerance = 4.6;

  /// @}
  /// \name Patches (section 4)
  /// @{

  /// wanted number of patches; `[1, 1000]`
  std::size_t number_of_patches = 88;
  /// The patches are made anew so many times, each set is merged to segments, and the segments are what
  /// most of them agree on; `[1, 100]`. More are steadier and a little better, and take longer.
  std::size_t number_of_patch_sets = 5;
  /// number of supervoxels that the spectral clustering works on, which bound its time;
  /// `[1, 20000]`
  std::size_t number_of_supervoxels = 1500;
  /// dimensions of the space of the spectral clustering, in shares of the wanted number of patches, but
  /// up to 10 patches have one each; the paper has 1; `[0.01, 1]`
  double spectral_dimensions = 0.4;
  /// neighbors are joined in the convexity graph unless their normals are concave by more degrees;
  /// `[0, 180]`
  double patch_concavity_tolerance = 5.;
  /// weight of the edges that are too concave, relative to 1 for the others; `[0, 1]`
  double concave_edge_weight = 0.001;
  /// connected pieces of patches with fewer representatives are given to a neighbor; `[0, 1e9]`
  std::size_t minimum_patch_size = 5;

  /// @}
  /// \name Visibility (sections 3 and 4)
  /// @{

  /// points sampled on a patch for its lines of sight (`s_vis`); `[1, 100]`
  std::size_t samples_per_patch = 10;
  /// radius of the disk of a point, in mean distances to its neighbors; `(0, 10]`
  double disk_radius_factor = 1.;
  /// disks whose center is nearer to an end of a line of sight than so many of their radii do not
  /// occlude it; `[0, 100]`
  double clearance_factor = 2.;
  /// A disk does not occlude a line of sight that meets it at fewer degrees: over a flat surface of
  /// which nothing is seen from behind, noise of a thousandth would else blind all points to each
  /// other; `[0, 89]`
  double grazing_tolerance = 2.;
  /// A line of sight may leave the surface to the outside by so many degrees; `[0, 90]`. With 90
  /// there is no such test and lines that pass outside of the shape count when unoccluded.
  double outside_tolerance = 90.;
  /// A pair of patches is decided when so many first rays agree; 0 casts all rays.
  std::size_t rays_for_early_decision = 2;
  /// A pair of patches that is not decided early gets at most so many rays; 0: all
  /// `samples_per_patch` squared.
  std::size_t maximum_rays_per_pair = 5;

  /// @}
  /// \name Rules
  /// @{

  Merging_rule merging = Merging_rule::COST;               ///< criteria of the contraction
  Diameter_rule diameter = Diameter_rule::WHOLE_SHAPE;     ///< measure of the diameters
  Refinement_rule refinement = Refinement_rule::SEAM_CUTS; ///< method of border refinement

  /// @}
  /// \name Component fusion and merging with `Merging_rule::PAPER` (sections 4 and 5)
  /// @{

  /// the thresholds theta of the rounds of fusion, each in `[0, 1]`
  std::vector<double> fusion_thresholds = {0.9, 0.8, 0.7};
  Fusion_rule fusion = Fusion_rule::EVERY_PAIR; ///< what must exceed the threshold
  /// largest distance of signatures that is merged, relative to the largest one (`sigma`); `[0, 1]`
  double signature_threshold = 0.12;
  /// adjacencies with at least this ratio of concave to convex seam edges are not merged; `[0, 1e9]`
  double concave_seam_ratio = 0.85;
  /// components of which at most this share of the samples has a diameter are flat; `[0, 1]`
  double flat_share = 0.1;
  /// visibility that a flat component needs to join a neighbor over a partly concave seam; `[0, 1]`
  double flat_visibility = 0.4;

  /// @}
  /// \name Signatures (section 5)
  /// @{

  /// bins of a diameter histogram; `[2, 64]`
  std::size_t histogram_bins = 64;
  /// full opening angle of the cone in which diameters are measured (`alpha`), degrees; `[0.001, 179]`
  double diameter_cone_angle = 60.;
  /// `Diameter_rule::WHOLE_SHAPE`: number of points, over the whole shape, with a diameter;
  /// `[1, 1e6]`
  std::size_t diameter_samples = 2000;
  /// `Diameter_rule::WHOLE_SHAPE`: rays a point; `[1, 256]`
  std::size_t diameter_rays = 10;
  /// a seam edge is concave from this angle on (`epsilon`), degrees; `[0, 179]`
  double seam_concavity_tolerance = 10.2;

  /// @}
  /// \name Contraction with `Merging_rule::COST`
  /// @{

  /// weights of the cost of a merge
  Merging_cost merging_cost = {1., 2.23, 0.38, 0.67, 0.505, 0.305, 0.565, 0.44, 1.5};
  double fusion_threshold = 1.0;    ///< the highest cost at which patches become components
  double merging_threshold = 1.482; ///< the highest cost at which components become segments
  /// Distance of signatures where one of the regions has no diameter; at least 0.
  double missing_diameter_distance = 0.35;
  /// regions under this share of the points are given to their best neighbor at the end; `[0, 1]`
  double minimum_segment_share = 0.0078;

  /// @}
  /// \name Contraction with `Merging_rule::FITTED`
  /// @{

  /// Adjacent regions are fused into components while the probability that people cut between them
  /// is at most this; `[0, 1]`.
  double fitted_fusion_threshold = 0.12;
  /// The same for merging components into segments; `[0, 1]`.
  double fitted_merging_threshold = 0.62;

  /// @}
  /// \name All contractions
  /// @{

  /// The contraction goes on until there are at most so many segments; 0: no limit. It does not make
  /// more segments than there would be without.
  std::size_t maximum_number_of_segments = 0;

  /// @}
  /// \name Border refinement (section 5)
  /// @{

  /// half width of the band in which a border may move, relative to the extent; `[0, 1]`, 0: nothing moves
  double band_width = 0.025;
  /// exponent of the distance in the data cost (equation 4); `[0, 100]`
  double data_exponent = 1.5;
  /// Weight of the data cost against the smoothness cost; `[0, 1e6]`. With `Refinement_rule::SEAM_CUTS` it is
  /// multiplied by the spacing of the points over the band's width, so that density matters little.
  double data_weight = 1.5;
  /// `Refinement_rule::SEAM_CUTS`: concavity in degrees that halves the cost of an edge; `[0.001, 180]`
  double smoothness_angle = 10.;

  /// @}

  /// returns the values and rules of the paper; where it is silent, see the stage's header.
  static Parameters paper();

  /// returns the preset whose merge cost is fitted to people's segmentations of the 190 odd-numbered
  /// meshes of the Princeton Segmentation Benchmark: as meshes (with three seeds), as bare points, half of
  /// them, evenly sampled, as seen from one, two and four sides, and as a noisy depth camera sees them. All
  /// else is as in the default preset.
  static Parameters fitted();

  /// checks all ranges; a segmentation does so before its first stage.
  /// \throws std::invalid_argument naming the first parameter that is out of its range.
  void check() const;
};

inline Parameters Parameters::paper()
{
  Parameters p;
  p.face_sampling_factor = 0.;         // section 6: one point a face
  p.number_of_representatives = 10000; // as many points as the paper's largest shapes have
  p.number_of_supervoxels = 10000;     // the clustering is that of the points themselves
  p.noise_tolerance = 180.;
  p.mesh_noise_tolerance = 180.;
  p.align_principal_axes = false;
  p.use_mesh_adjacency = false; // section 6: "we first transform the meshes into point clouds"
  p.link_across_lines = false;
  p.number_of_patches = 100; // silent; the trial of the method used 100
  p.number_of_patch_sets = 1;
  p.spectral_dimensions = 1.;
  p.patch_concavity_tolerance = 0.;
  p.grazing_tolerance = 0.; // section 3: every disk on the line occludes it
  p.rays_for_early_decision = 0;
  p.maximum_rays_per_pair = 0;
  p.merging = Merging_rule::PAPER;
  p.diameter = Diameter_rule::OWN_POINTS;
  p.refinement = Refinement_rule::ALPHA_EXPANSION;
  p.seam_concavity_tolerance = 9.; // epsilon = 0.05 pi
  p.diameter_cone_angle = 20.;     // alpha = 2 pi / 18, read as the full opening
  p.minimum_segment_share = 0.;
  p.band_width = 0.015;
  p.data_weight = 0.1;
  return p;
}

inline Parameters Parameters::fitted()
{
  Parameters p;
  p.merging = Merging_rule::FITTED;
  p.minimum_segment_share = 0.006;
  return p;
}

namespace internal {

inline void check_range(const char* name, const double value, const double low, const double high)
{
  if (!(value >= low && value <= high)) // also refuses NaN
    throw std::invalid_argument("Parameters::" + std::string(name) + " is " +
                                std::to_string(value) + ", give a value from " +
                                std::to_string(low) + " to " + std::to_string(high));
}

inline void check_cost(const std::string& name, const Merging_cost& cost)
{
  const auto check = [&name](const char* member, const double value, const double high)
  { check_range((name + "." + member).c_str(), value, 0., high); };
  check("visibility_weight", cost.visibility_weight, 1e6);
  check("concavity_weight", cost.concavity_weight, 1e6);
  check("concavity_saturation", cost.concavity_saturation, 1.);
  check("diameter_weight", cost.diameter_weight, 1e6);
  check("smaller_closure_weight", cost.smaller_closure_weight, 1e6);
  check("larger_closure_weight", cost.larger_closure_weight, 1e6);
  check("seam_extent_weight", cost.seam_extent_weight, 1e6);
  check("diameter_spread_weight", cost.diameter_spread_weight, 1e6);
  check("continuation_weight", cost.continuation_weight, 1e6);
}

} // namespace internal

inline void Parameters::check() const
{
  const auto check = [](const char* name, const auto value, const double low, const double high)
  { internal::check_range(name, static_cast<double>(value), low, high); };
  check("number_of_neighbors", number_of_neighbors, 3., 100.);
  check("number_of_representatives", number_of_representatives, 100., 1e9);
  check("face_sampling_factor", face_sampling_factor, 0., 1000.);
  check("minimum_face_samples", minimum_face_samples, 0., 1e6);
  check("noise_tolerance", noise_tolerance, 0., 180.);
  check("mesh_noise_tolerance", mesh_noise_tolerance, 0., 180.);
  check("number_of_patches", number_of_patches, 1., 1000.);
  check("number_of_patch_sets", number_of_patch_sets, 1., 100.);
  check("number_of_supervoxels", number_of_supervoxels, 1., 20000.);
  check("spectral_dimensions", spectral_dimensions, 0.01, 1.);
  check("patch_concavity_tolerance", patch_concavity_tolerance, 0., 180.);
  check("concave_edge_weight", concave_edge_weight, 0., 1.);
  check("minimum_patch_size", minimum_patch_size, 0., 1e9);
  check("samples_per_patch", samples_per_patch, 1., 100.);
  check("disk_radius_factor", disk_radius_factor, 1e-6, 10.);
  check("clearance_factor", clearance_factor, 0., 100.);
  check("grazing_tolerance", grazing_tolerance, 0., 89.);
  check("outside_tolerance", outside_tolerance, 0., 90.);
  for (const double theta : fusion_thresholds) check("fusion_thresholds", theta, 0., 1.);
  check("signature_threshold", signature_threshold, 0., 1.);
  check("concave_seam_ratio", concave_seam_ratio, 0., 1e9);
  check("flat_share", flat_share, 0., 1.);
  check("flat_visibility", flat_visibility, 0., 1.);
  check("histogram_bins", histogram_bins, 2., 64.);
  check("diameter_cone_angle", diameter_cone_angle, 1e-3, 179.);
  check("diameter_samples", diameter_samples, 1., 1e6);
  check("diameter_rays", diameter_rays, 1., 256.);
  check("seam_concavity_tolerance", seam_concavity_tolerance, 0., 179.);
  internal::check_cost("merging_cost", merging_cost);
  check("missing_diameter_distance", missing_diameter_distance, 0., 1e6);
  check("fusion_threshold", fusion_threshold, 0., 1e6);
  check("merging_threshold", merging_threshold, 0., 1e6);
  check("minimum_segment_share", minimum_segment_share, 0., 1.);
  check("fitted_fusion_threshold", fitted_fusion_threshold, 0., 1.);
  check("fitted_merging_threshold", fitted_merging_threshold, 0., 1.);
  check("band_width", band_width, 0., 1.);
  check("data_exponent", data_exponent, 0., 100.);
  check("data_weight", data_weight, 0., 1e6);
  check("smoothness_angle", smoothness_angle, 1e-3, 180.);
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_PARAMETERS_H
