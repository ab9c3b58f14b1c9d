// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_SEGMENTATION_METRICS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_SEGMENTATION_METRICS_H

#include "metrics/mesh_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

// How far apart two segmentations of one triangle mesh are, by the measures of
//   Chen, Golovinskiy, Funkhouser: A benchmark for 3D mesh segmentation. SIGGRAPH 2009,
// as the evaluator of that benchmark computes them. Lower is better everywhere.
//
// Use: `compute_mesh_geometry()` once a mesh, `prepare()` once a segmentation (it runs the only
// step that is not linear, a Dijkstra search), then `score()` for every pair.

namespace Segmentation_metrics {

// The faces which have label `first` in one segmentation and label `second` in the other.
struct Overlap
{
  std::size_t first;
  std::size_t second;
  std::uint64_t count;
  double area;
};

struct Segment_size
{
  std::uint64_t count = 0;
  double area = 0.;
};

// The non-empty overlaps of two segmentations, and the sizes of their segments.
struct Contingency_table
{
  std::vector<Overlap> overlaps;
  std::vector<Segment_size> first_sizes;
  std::vector<Segment_size> second_sizes;
  std::uint64_t number_of_faces = 0;
  double total_area = 0.;
};

// The benchmark's evaluator counts the pairs of n faces as n * ((n - 1) / 2) with an integer
// division, so that its 1 - RI is too large by (n - 1) / (n - 2) if n is even. `as_evaluator`
// repeats this, to compare with printed values.
enum class Pair_count
{
  exact,
  as_evaluator
};

struct Hamming_distance
{
  double missing_rate = 0.;     // Rm
  double false_alarm_rate = 0.; // Rf
  double mean = 0.;
};

struct Consistency_error
{
  double global = 0.;               // GCE
  double local = 0.;                // LCE
  double global_area_weighted = 0.; // GCEa
  double local_area_weighted = 0.;  // LCEa
};

// All measures of a candidate against a reference. They are doubles, the number of segments of
// the candidate too, so that the same struct holds averages.
struct Scores
{
  double rand_error = 0.; // 1 - RI
  double hamming = 0.;
  double missing_rate = 0.;
  double false_alarm_rate = 0.;
  double gce = 0.;
  double lce = 0.;
  double gce_area = 0.;
  double lce_area = 0.;
  double number_of_segments = 0.;
  std::optional<double> cut_discrepancy; // none if either side has no cut
};

namespace internal {

inline std::uint64_t pairs_of(std::uint64_t n) { return n == 0 ? 0 : n * (n - 1) / 2; }

// The part of a segment outside an overlap; 0 for a segment of degenerate faces, which has no
// area to be outside of.
inline double outside(double segment, double overlap)
{
  return segment > 0. ? std::max(0., (segment - overlap) / segment) : 0.;
}

// Sizes are summed from the overlaps, not the faces, so that a segment with a single overlap has
// exactly its area, and nested segmentations have errors of exactly 0.
inline void add_sizes(Contingency_table& table)
{
  for (const Overlap& overlap : table.overlaps)
  {
    for (Segment_size* size :
         {&table.first_sizes[overlap.first], &table.second_sizes[overlap.second]})
    {
      size->count += overlap.count;
      size->area += overlap.area;
    }
    table.total_area += overlap.area;
  }
}

} // namespace internal

// Linear for any number of segments: the faces are sorted by their first label by counting, and
// the overlap of a second label is looked up in an array that remembers whose overlap it was.
inline Contingency_table make_contingency_table(const Mesh_geometry& geometry,
                                                const Prepared_segmentation& first,
                                                const Prepared_segmentation& second)
{
  const std::size_t n = geometry.face_areas.size();
  if (first.labels.size() != n || second.labels.size() != n)
    throw std::invalid_argument("The segmentations and the mesh differ in their numbers of "
                                "faces: prepare both segmentations with this mesh.");
  std::vector<std::size_t> next(first.number_of_segments + 1, 0);
  for (const std::size_t label : first.labels) ++next[label + 1];
  for (std::size_t i = 0; i < first.number_of_segments; ++i) next[i + 1] += next[i];
  std::vector<std::size_t> faces(n);
  for (std::size_t f = 0; f < n; ++f) faces[next[first.labels[f]]++] = f;

  Contingency_table table;
  table.number_of_faces = n;
  table.first_sizes.resize(first.number_of_segments);
  table.second_sizes.resize(second.number_of_segments);
  std::vector<std::size_t> overlap_of(second.number_of_segments, n);
  for (const std::size_t f : faces)
  {
    const std::size_t i = first.labels[f];
    const std::size_t j = second.labels[f];
    if (overlap_of[j] == n || table.overlaps[overlap_of[j]].first != i)
    {
      overlap_of[j] = table.overlaps.size();
      table.overlaps.push_back({i, j, 0, 0.});
    }
    Overlap& overlap = table.overlaps[overlap_of[j]];
    ++overlap.count;
    overlap.area += geometry.face_areas[f];
  }
  internal::add_sizes(table);
  return table;
}

// 1 - Rand index: the share of the pairs of faces that are together in one segmentation and apart
// in the other. Faces count alike, whatever their areas.
inline double rand_error(const Contingency_table& table, Pair_count pair_count = Pair_count::exact)
{
  const std::uint64_t n = table.number_of_faces;
  if (pair_count == Pair_count::as_evaluator && n < 3)
    throw std::invalid_argument("The evaluator divides by zero for fewer than 3 faces: "
                                "use Pair_count::exact.");
  const std::uint64_t pairs =
      pair_count == Pair_count::exact ? internal::pairs_of(n) : n * ((n - 1) / 2);
  if (pairs == 0) return 0.; // a single face is in no pair to disagree about
  std::uint64_t together_in_one = 0;
  for (const auto* sizes : {&table.first_sizes, &table.second_sizes})
    for (const Segment_size& size : *sizes) together_in_one += internal::pairs_of(size.count);
  std::uint64_t together_in_both = 0;
  for (const Overlap& overlap : table.overlaps)
    together_in_both += internal::pairs_of(overlap.count);
  return static_cast<double>(together_in_one - 2 * together_in_both) / static_cast<double>(pairs);
}

// Missing rate: the share of the area that lies, in the segments of the reference (the second
// side of the table), outside the best matching segment of the candidate (the first); the false
// alarm rate is the same with the sides exchanged.
inline Hamming_distance hamming_distance(const Contingency_table& table)
{
  std::vector<double> best_of_first(table.first_sizes.size(), 0.);
  std::vector<double> best_of_second(table.second_sizes.size(), 0.);
  for (const Overlap& overlap : table.overlaps)
  {
    double& first = best_of_first[overlap.first];
    double& second = best_of_second[overlap.second];
    first = std::max(first, overlap.area);
    second = std::max(second, overlap.area);
  }
  const auto uncovered =
      [&](const std::vector<Segment_size>& sizes, const std::vector<double>& best)
  {
    double area = 0.;
    for (std::size_t i = 0; i < sizes.size(); ++i) area += sizes[i].area - best[i];
    return area / table.total_area;
  };
  Hamming_distance distance;
  distance.missing_rate = uncovered(table.second_sizes, best_of_second);
  distance.false_alarm_rate = uncovered(table.first_sizes, best_of_first);
  distance.mean = (distance.missing_rate + distance.false_alarm_rate) / 2.;
  return distance;
}

// A face's error is the part of its segment outside its segment of the other side; the global
// error adds the errors of one side, the better one, the local one the lesser error of each face.
// With area weights only the parts are measured by area: the sum is over faces all the same, as
// in the evaluator. Both are 0 if a segmentation refines the other, so also for a single segment
// and for a segment a face.
inline Consistency_error consistency_error(const Contingency_table& table)
{
  std::array<double, 2> first{0., 0.}, second{0., 0.}, lesser{0., 0.}; // by count, by area
  for (const Overlap& overlap : table.overlaps)
  {
    const double count = static_cast<double>(overlap.count);
    const Segment_size& a = table.first_sizes[overlap.first];
    const Segment_size& b = table.second_sizes[overlap.second];
    const std::array<std::array<double, 2>, 2> errors{
        {{internal::outside(static_cast<double>(a.count), count),
          internal::outside(static_cast<double>(b.count), count)},
         {internal::outside(a.area, overlap.area), internal::outside(b.area, overlap.area)}}};
    for (std::size_t i = 0; i < 2; ++i)
    {
      first[i] += count * errors[i][0];
      second[i] += count * errors[i][1];
      lesser[i] += count * std::min(errors[i][0], errors[i][1]);
    }
  }
  const double n = static_cast<double>(table.number_of_faces);
  return {std::min(first[0], second[0]) / n, lesser[0] / n, std::min(first[1], second[1]) / n,
          lesser[1] / n};
}

// None if either side has no cut, or the cuts can't reach each other along edges.
inline std::optional<double> cut_discrepancy(const Mesh_geometry& geometry, const Cut_field& first,
                                             const Cut_field& second)
{
  double sum = 0.;
  std::size_t number_of_vertices = 0;
  for (const auto& [from, to] : {std::pair(&first, &second), std::pair(&second, &first)})
    for (const std::size_t v : from->cut_vertices)
      if (std::isfinite(to->distances[v]))
      {
        sum += to->distances[v];
        ++number_of_vertices;
      }
  if (number_of_vertices == 0) return std::nullopt;
  return sum / static_cast<double>(number_of_vertices) / geometry.mean_radius;
}

inline Scores score(const Mesh_geometry& geometry, const Prepared_segmentation& candidate,
                    const Prepared_segmentation& reference,
                    Pair_count pair_count = Pair_count::exact)
{
  const Contingency_table table = make_contingency_table(geometry, candidate, reference);
  const Hamming_distance hamming = hamming_distance(table);
  const Consistency_error consistency = consistency_error(table);
  Scores scores;
  scores.rand_error = rand_error(table, pair_count);
  scores.hamming = hamming.mean;
  scores.missing_rate = hamming.missing_rate;
  scores.false_alarm_rate = hamming.false_alarm_rate;
  scores.gce = consistency.global;
  scores.lce = consistency.local;
  scores.gce_area = consistency.global_area_weighted;
  scores.lce_area = consistency.local_area_weighted;
  scores.number_of_segments = static_cast<double>(candidate.number_of_segments);
  scores.cut_discrepancy = cut_discrepancy(geometry, candidate.cuts, reference.cuts);
  return scores;
}

} // namespace Segmentation_metrics

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_SEGMENTATION_METRICS_H
