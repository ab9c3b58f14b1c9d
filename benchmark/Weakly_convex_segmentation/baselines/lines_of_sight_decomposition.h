// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_DECOMPOSITION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_DECOMPOSITION_H

#include "baselines/lines_of_sight_clustering.h"

#include <CGAL/Weakly_convex_segmentation/internal/output/label_transfer.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

// Asafi, Goren, Cohen-Or: Weak Convex Decomposition by Lines-of-sight (2013), with which Kaick et al.
// compare themselves.

namespace Lines_of_sight {

/// The settings of `decompose()`.
struct Settings
{
  /// wanted number of parts, at most `number_of_samples`; 0: as many as there are eigenvalues before
  /// the largest gap
  std::size_t number_of_segments = 0;
  /// points between which all lines of sight are cast, at least 2: their number squared is the size of
  /// the matrix, its third power the time of the eigenvectors
  std::size_t number_of_samples = 500;
  /// the largest number of parts that the gap of the eigenvalues may give; at least 1
  std::size_t maximum_number_of_segments = 40;
  /// a line of sight may leave the surface to the outside by so many degrees: flat faces see
  /// themselves
  double outside_tolerance = 5.;
};

/// decomposes a shape into weakly convex parts by clustering its lines of sight.
///
/// Points that see each other inside of the shape belong together: the matrix of all lines of sight is
/// clustered by its spectrum. There are no patches, no surface and no volume; parts need not be
/// connected. What we chose where the public text on the method leaves it open:
///   - lines of sight are cast between `number_of_samples` points, each the farthest from those before,
///     where opposite normals count as 6 % of the extent of the shape;
///   - points occlude as disks as large as the mean distance to their neighbors, but not near the ends
///     of a line (`make_disk_tree()`); lines must not
///     leave the surface outwards (`outside_tolerance`);
///   - the affinity of two points is 1 in line of sight and 0 else, of a point with itself 1; the
///     Laplacian is the symmetric normalized one;
///   - the number of parts is given, or that of the eigenvalues before the largest gap from the second
///     on; shapes whose second eigenvalue is at least one half are one part;
///   - the rows of the first eigenvectors, scaled to unit length, are clustered by the best of ten runs
///     of k-means;
///   - every other point joins the nearest of the 8 nearest samples that it sees, else the nearest.
///
/// \returns the label of each input element, from 0 without gaps in the order of the first element.
///   There are as many parts as given unless the shape has fewer distinct points, or, on meshes, a part
///   holds no whole face.
///
/// Complexity: with s samples O(s n) in thinned points, s^2 lines of sight and O(s^3), in memory of
/// O(s^2).
inline std::vector<int> decompose(const WCS::internal::Shape_analysis& shape,
                                  const Settings& settings = {}, const unsigned int seed = 0,
                                  const bool parallel = false)
{
  if (settings.number_of_samples < 2)
    throw std::invalid_argument("the lines of sight need at least 2 samples");
  if (settings.number_of_segments > settings.number_of_samples)
    throw std::invalid_argument("there can't be more parts than samples");
  if (settings.maximum_number_of_segments == 0)
    throw std::invalid_argument("the largest number of parts is 0, give a value from 1 on");
  WCS::internal::check_range("outside_tolerance", settings.outside_tolerance, 0., 90.);
  const std::vector<Index> sample = farthest_points(shape.points(), settings.number_of_samples);
  const Spectrum spectrum = laplacian_spectrum(
      line_of_sight_matrix(*shape.sight, sample, settings.outside_tolerance, parallel));
  const std::size_t wanted =
      settings.number_of_segments > 0
          ? (std::min)(settings.number_of_segments, sample.size())
          : clusters_by_eigengap(spectrum.values, settings.maximum_number_of_segments);
  const std::vector<int> of_representatives =
      spread_clusters(*shape.sight, sample, cluster_spectrum(spectrum, wanted, seed),
                      settings.outside_tolerance, parallel);
  std::vector<int> of_points(shape.input.size());
  for (std::size_t i = 0; i < of_points.size(); ++i)
    of_points[i] = of_representatives[shape.representative(i)];
  std::vector<int> labels = WCS::internal::element_labels(shape.input, of_points);
  WCS::internal::number_labels(labels);
  return labels;
}

} // namespace Lines_of_sight

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_LINES_OF_SIGHT_DECOMPOSITION_H
