// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_PARAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_PARAMETERS_H

// All parameters of the method, by stage, with the presets and the one table of their names and ranges.

#include <CGAL/Weakly_convex_segmentation/Normal_orientation.h>
#include <CGAL/Weakly_convex_segmentation/Piece_rule.h>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
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
  FITTED ///< probabilities that people make the merges of that cost, fitted to shapes of 19 kinds
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How the visibility of two components is judged from that of their patches.
enum class Fusion_rule
{
  EVERY_PAIR, ///< the threshold holds for every pair of patches (the letter of section 4)
  AVERAGE ///< the threshold holds for the share of all pairs of points, as the convexity rank (equation 1)
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
/// Weights of the terms of the `Merging_rule::COST` contraction, each in `[0, 1e6]`.
///
/// The cost of merging two adjacent regions is their blindness, which is 1 - the mutual visibility `v`, and the
/// weighted sum of
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
  double concavity_weight = 0.;
  double concavity_saturation = 0.; ///< in `[0, 1]`
  double diameter_weight = 0.;
  double smaller_closure_weight = 0.;
  double larger_closure_weight = 0.;
  double seam_extent_weight = 0.;
  double diameter_spread_weight = 0.;
  double continuation_weight = 0.;
};

namespace internal {

// an initializer list in the struct is taken for uninitialized by g++ 12 where operator new is replaced
inline std::vector<double> three_thetas()
{
  const double thetas[] = {0.9, 0.8, 0.7};
  return std::vector<double>(std::begin(thetas), std::end(thetas));
}

} // namespace internal

/// \ingroup PkgWeaklyConvexSegmentationRef
/// Who is a neighbor of a point beside the nearest points.
enum class Extra_neighbors
{
  NONE,           ///< nobody
  FACES,          ///< of a face of a mesh, those that share an edge with it
  FACES_AND_LINES ///< and of a point in a line of points, as those of a laser scanner, the nearest ones
                  ///< beside its line
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// What the points and the neighbor graph are made with (section 3).
struct Sampling_parameters
{
  /// number of nearest neighbors of a point in the neighbor graph (`k`, section 4); `[3, 100]`
  std::size_t number_of_neighbors = 10;
  /// Shapes of more points are thinned to about so many representatives, on which everything that
  /// is not linear in time runs; `[100, 1e9]`
  std::size_t number_of_representatives = 5000;
  /// Faces with an edge longer than so many square roots of the mean area of a face get more than one
  /// point, as if they were cut there; the label of a face is that of most of its points. 0: one
  /// point a face; `[0, 1000]`
  double face_sampling_factor = 7.;
  /// Whether normals are turned, for the run: all of them where the shape is closed and they point inwards; those of
  /// a cloud that is nearly closed and whose normals contradict each other, so that all point outwards. Scans of
  /// a closed room from within want false. `Result::has_flipped_normals` tells.
  bool flip_inward_normals = true;
  Normal_orientation normal_orientation = Normal_orientation::PROPAGATION; ///< if none are given
  Extra_neighbors extra_neighbors = Extra_neighbors::FACES_AND_LINES;      ///< beside the nearest
  /// Whether vertices and points are smoothed where noise, and not the shape, turns the normals of neighbors.
  /// Shapes without noise, and the positions that are given, stay as they are.
  bool denoise = true;
  Piece_rule pieces = Piece_rule::SEPARATE; ///< of a mesh of several connected pieces
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// What the patches are made with (section 4).
struct Patch_parameters
{
  /// wanted number of patches; `[1, 1000]`
  std::size_t number_of_patches = 88;
  /// The patches are made anew so many times, each set is merged to segments, and the segments are what
  /// most of them lead to; `[1, 100]`. More are steadier and a little better, and take longer.
  std::size_t number_of_patch_sets = 7;
  /// number of supervoxels that the spectral clustering works on, which bound its time;
  /// `[1, 20000]`
  std::size_t number_of_supervoxels = 1500;
  /// dimensions of the space of the spectral clustering, in shares of the wanted number of patches, but
  /// up to 10 patches have one each; the paper has 1; `[0.01, 1]`
  double spectral_dimensions = 0.4;
  /// neighbors are joined in the convexity graph unless their normals are concave by more degrees;
  /// `[0, 180]`
  double patch_concavity_tolerance = 5.;
  unsigned int seed = 0; ///< seed of all random choices; `[0, 4294967295]`
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How lines of sight are cast (sections 3 and 4).
struct Visibility_parameters
{
  /// A disk does not occlude a line of sight that meets it at fewer degrees: over a flat surface of
  /// which nothing is seen from behind, noise of a thousandth would else blind all points to each
  /// other; `[0, 89]`
  double grazing_tolerance = 2.;
  /// A pair of patches is decided by its first two lines of sight if they agree, and gets at most so many;
  /// `[0, 10000]`. 0: one between each two of the points sampled on the patches.
  std::size_t maximum_rays_per_pair = 5;
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How shape diameters are measured (section 5).
struct Diameter_parameters
{
  Diameter_rule diameter = Diameter_rule::WHOLE_SHAPE; ///< where lengths end
  /// full opening angle of the cone in which diameters are measured (`alpha`), degrees; `[0.001, 179]`
  double diameter_cone_angle = 60.;
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How patches become components and components become segments (sections 4 and 5).
struct Merging_parameters
{
  Merging_rule merging = Merging_rule::FITTED; ///< criteria of the contraction
  /// a seam edge is concave from this angle on (`epsilon`), degrees; `[0, 179]`
  double seam_concavity_tolerance = 10.2;
  /// The highest probability that people cut between patches that become components, in `[0, 1]`; with
  /// `Merging_rule::COST` the highest cost, `[0, 1e6]`; with `PAPER` it is not used.
  double fusion_threshold = 0.12;
  /// The highest probability that people cut between components that become segments, in `[0, 1]`; with
  /// `Merging_rule::COST` the highest cost, `[0, 1e6]`, with `PAPER` the distance of their signatures relative to the
  /// largest one (`sigma`), `[0, 1]`.
  double merging_threshold = 0.45;
  /// weights of `Merging_rule::COST`; `FITTED` orders the merges that it judges by constants of its own
  Merging_cost merging_cost = {2.23, 0.38, 0.67, 0.505, 0.305, 0.565, 0.44, 1.5};
  /// `Merging_rule::PAPER`: the thresholds theta of the rounds of fusion, each in `[0, 1]`: 0.9, 0.8, 0.7
  std::vector<double> fusion_thresholds = internal::three_thetas();
  Fusion_rule fusion = Fusion_rule::EVERY_PAIR; ///< `Merging_rule::PAPER`: what must exceed theta
  /// regions under this share of the points are given to their best neighbor at the end; `[0, 1]`
  double minimum_segment_share = 0.0078;
  /// What one side of a shape has, the other one gets: if there is a plane of reflection, from which the mirrored
  /// points are at most so far from the surface on average, relative to the extent, both sides are decided together;
  /// and what comes several times about an axis, as the teeth of a gear, is cut off everywhere or nowhere, if turned
  /// points are within a quarter of that. `[0, 1]`, 0: never
  double symmetry_tolerance = 0.008;
  /// Segments are joined until there are at most so many; 0: no limit; `[0, 1e9]`
  std::size_t maximum_number_of_segments = 0;
  /// Segments are divided until there are at least so many, or as many as there are patches; `[0, 1e9]`. With the
  /// maximum, that is the number that is wanted, and may not be larger.
  std::size_t minimum_number_of_segments = 0;
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// How borders are refined (section 5).
struct Border_parameters
{
  Refinement_rule refinement = Refinement_rule::SEAM_CUTS; ///< method of border refinement
  /// half width of the band in which a border may move, relative to the extent; `[0, 1]`, 0: nothing moves
  double band_width = 0.025;
};

/// \ingroup PkgWeaklyConvexSegmentationRef
/// All parameters of the method, by stage: each stage takes its own.
///
/// A default constructed object is the default preset, the best that we know. It judges merges by how probable it
/// is that people put the two regions together, fitted to people's segmentations of the 190 odd-numbered meshes of
/// the Princeton Segmentation Benchmark: as meshes (with four seeds), as bare points, half of them, evenly sampled, as
/// seen from one, two and four sides, and as a noisy depth camera sees them. `paper()` follows
/// \cgalCite{cgal:kfkac-ssaca-14} sentence by sentence, see \ref wcsPaperPreset. Angles are in degrees; lengths are
/// relative to the extent of the shape: the diameter of the smallest sphere about the centroid of
/// the points that holds them all. One set of values serves all shapes. Ranges are given in brackets.
struct Parameters : Sampling_parameters,
                    Patch_parameters,
                    Visibility_parameters,
                    Diameter_parameters,
                    Merging_parameters,
                    Border_parameters
{
  /// returns the values and rules of the paper; where it is silent, see the stage's header. Its letter, which
  /// asks theta of every pair of patches, is `Fusion_rule::EVERY_PAIR`, `Extra_neighbors::NONE` and a
  /// `grazing_tolerance` of 0.
  static Parameters paper();

  /// returns the preset that merges up to a threshold of a weighted cost of visibility, seam concavity, volume and
  /// closure: no table of trees, a few constants that can be read and set. All else is as in the default preset.
  static Parameters training_free();

  /// returns the default preset by the name of its rule.
  static Parameters fitted() { return {}; }

  /// returns the preset of a name: `default` (or `fitted`), `training_free` or `paper`.
  /// \throws std::invalid_argument if there is none of that name.
  static Parameters preset(const std::string& name);

  /// checks all ranges; a segmentation does so before its first stage.
  /// \throws std::invalid_argument naming the first parameter that is out of its range.
  void check() const;
};

inline Parameters Parameters::paper()
{
  Parameters p;
  p.face_sampling_factor = 0.; // section 6: "a point corresponding to the center of each triangle"
  p.number_of_representatives = 10000; // as many points as the paper's largest shapes have
  p.number_of_supervoxels = 10000;     // the clustering is that of the points themselves
  p.denoise = false;
  p.pieces = Piece_rule::JOINED;              // section 6: a mesh is the points of its faces
  p.extra_neighbors = Extra_neighbors::FACES; // section 3: meshes are "augmented point clouds"
  p.number_of_patches = 100;                  // silent; the trial of the method used 100
  p.number_of_patch_sets = 1;
  p.spectral_dimensions = 1.;
  p.patch_concavity_tolerance = 0.;
  p.grazing_tolerance = 5.; // silent; else neighbors on a flat or noisy surface hide each other
  p.maximum_rays_per_pair = 0;
  p.merging = Merging_rule::PAPER;
  p.fusion = Fusion_rule::AVERAGE; // section 4: "intra-component mutual visibility"
  p.diameter = Diameter_rule::OWN_POINTS;
  p.refinement = Refinement_rule::ALPHA_EXPANSION;
  p.seam_concavity_tolerance = 9.; // epsilon = 0.05 pi
  p.merging_threshold = 0.12;      // sigma
  p.diameter_cone_angle = 20.;     // alpha = 2 pi / 18, read as the full opening
  p.minimum_segment_share = 0.;
  p.symmetry_tolerance = 0.;
  p.band_width = 0.015; // silent: "a narrow band"
  return p;
}

inline Parameters Parameters::training_free()
{
  Parameters p;
  p.merging = Merging_rule::COST;
  p.fusion_threshold = 1.0;
  p.merging_threshold = 1.482;
  return p;
}

inline Parameters Parameters::preset(const std::string& name)
{
  if (name == "default" || name == "fitted") return {};
  if (name == "training_free") return training_free();
  if (name == "paper") return paper();
  throw std::invalid_argument("there is no preset '" + name +
                              "'; give default, training_free or paper");
}

namespace internal {

/// calls `f(name, member, lowest, highest)` for each parameter: the one table of their names and ranges. Rules
/// and switches are numbered from 0.
template <typename Parameters_, typename Function>
void for_each_parameter(Parameters_& p, const Function& f)
{
  f("number_of_neighbors", p.number_of_neighbors, 3., 100.);
  f("number_of_representatives", p.number_of_representatives, 100., 1e9);
  f("face_sampling_factor", p.face_sampling_factor, 0., 1000.);
  f("flip_inward_normals", p.flip_inward_normals, 0., 1.);
  f("normal_orientation", p.normal_orientation, 0., 1.);
  f("extra_neighbors", p.extra_neighbors, 0., 2.);
  f("denoise", p.denoise, 0., 1.);
  f("pieces", p.pieces, 0., 2.);

  f("number_of_patches", p.number_of_patches, 1., 1000.);
  f("number_of_patch_sets", p.number_of_patch_sets, 1., 100.);
  f("number_of_supervoxels", p.number_of_supervoxels, 1., 20000.);
  f("spectral_dimensions", p.spectral_dimensions, 0.01, 1.);
  f("patch_concavity_tolerance", p.patch_concavity_tolerance, 0., 180.);
  f("seed", p.seed, 0., 4294967295.);

  f("grazing_tolerance", p.grazing_tolerance, 0., 89.);
  f("maximum_rays_per_pair", p.maximum_rays_per_pair, 0., 10000.);

  f("diameter", p.diameter, 0., 2.);
  f("diameter_cone_angle", p.diameter_cone_angle, 1e-3, 179.);

  f("merging", p.merging, 0., 2.);
  f("seam_concavity_tolerance", p.seam_concavity_tolerance, 0., 179.);
  f("fusion_threshold", p.fusion_threshold, 0., 1e6);
  f("merging_threshold", p.merging_threshold, 0., 1e6);
  f("merging_cost.concavity_weight", p.merging_cost.concavity_weight, 0., 1e6);
  f("merging_cost.concavity_saturation", p.merging_cost.concavity_saturation, 0., 1.);
  f("merging_cost.diameter_weight", p.merging_cost.diameter_weight, 0., 1e6);
  f("merging_cost.smaller_closure_weight", p.merging_cost.smaller_closure_weight, 0., 1e6);
  f("merging_cost.larger_closure_weight", p.merging_cost.larger_closure_weight, 0., 1e6);
  f("merging_cost.seam_extent_weight", p.merging_cost.seam_extent_weight, 0., 1e6);
  f("merging_cost.diameter_spread_weight", p.merging_cost.diameter_spread_weight, 0., 1e6);
  f("merging_cost.continuation_weight", p.merging_cost.continuation_weight, 0., 1e6);
  f("fusion_thresholds", p.fusion_thresholds, 0., 1.);
  f("fusion", p.fusion, 0., 1.);
  f("minimum_segment_share", p.minimum_segment_share, 0., 1.);
  f("symmetry_tolerance", p.symmetry_tolerance, 0., 1.);
  f("maximum_number_of_segments", p.maximum_number_of_segments, 0., 1e9);
  f("minimum_number_of_segments", p.minimum_number_of_segments, 0., 1e9);

  f("refinement", p.refinement, 0., 2.);
  f("band_width", p.band_width, 0., 1.);
}

inline void check_range(const char* name, const double value, const double low, const double high)
{
  if (!(value >= low && value <= high)) // also refuses NaN
    throw std::invalid_argument("Parameters::" + std::string(name) + " is " +
                                std::to_string(value) + ", give a value from " +
                                std::to_string(low) + " to " + std::to_string(high));
}

/// Refuses what is out of its range.
struct Range_check
{
  template <typename Member>
  void operator()(const char* name, const Member& value, const double low, const double high) const
  {
    check_range(name, static_cast<double>(value), low, high);
  }
  void operator()(const char* name, const std::vector<double>& values, const double low,
                  const double high) const
  {
    for (const double value : values) check_range(name, value, low, high);
  }
};

} // namespace internal

inline void Parameters::check() const
{
  internal::for_each_parameter(*this, internal::Range_check());
  if (maximum_number_of_segments > 0 && minimum_number_of_segments > maximum_number_of_segments)
    throw std::invalid_argument(
        "minimum_number_of_segments is " + std::to_string(minimum_number_of_segments) +
        ", but maximum_number_of_segments only " + std::to_string(maximum_number_of_segments));
  if (merging == Merging_rule::COST) return;
  internal::check_range("merging_threshold", merging_threshold, 0., 1.);
  if (merging == Merging_rule::FITTED)
    internal::check_range("fusion_threshold", fusion_threshold, 0., 1.);
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_PARAMETERS_H
