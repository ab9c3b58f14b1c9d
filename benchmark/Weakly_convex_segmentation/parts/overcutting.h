// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_OVERCUTTING_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_OVERCUTTING_H

#include "parts/part_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// Parts that a person would not have cut out, told by their shape alone: bands and rings about a trunk or a
// limb, strips and slivers along borders, pieces of a tube that goes on at both ends as it is.

namespace Part_measures {

enum class Overcut
{
  TRUNK_BAND, ///< goes about the thickest of the shape, and is shorter than 0.6 of its diameter
  RING,       ///< the same about a limb: a knee, an ankle, a neck
  STRIP,      ///< long and narrow, between others
  SLIVER,    ///< narrower than a fifth of the thickness below it, or than that of what is beside it
  TUBE_PIECE ///< of any length, between two others of the same tube
};
constexpr std::size_t number_of_overcuts = 5;

inline const char* overcut_name(const Overcut kind)
{
  constexpr std::array<const char*, number_of_overcuts> names{"trunk_band", "ring", "strip",
                                                              "sliver", "tube_piece"};
  return names[static_cast<std::size_t>(kind)];
}

/// A part that looks wrong.
struct Overcut_part
{
  int label;
  Overcut kind;
};

namespace internal {

/// A piece of a tube between two cuts: the two sides of its border.
struct Tube
{
  Border_loop first, second;
  double length = 0.; ///< from side to side
  double girth = 0.;  ///< mean, of the piece

  double mean_border() const { return (first.length + second.length) / 2.; }
  double diameter() const { return mean_border() / pi; }
};

/// mean distance of the vertices of a line to the nearest of another
inline double mean_distance(const Border_loop& from, const Border_loop& to)
{
  double sum = 0.;
  for (const Vector& p : from.vertices)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector& q : to.vertices) least = (std::min)(least, (p - q).squaredNorm());
    sum += std::sqrt(least);
  }
  return sum / static_cast<double>(from.vertices.size());
}

/// how many neighbors a piece has that take a good part of its border
inline std::size_t number_of_neighbors(const Piece& piece)
{
  constexpr double least_share = 0.2;
  Border_loop all;
  for (const Border_loop& loop : piece.loops) all.add(loop);
  std::size_t count = 0;
  for (const auto& with : all.length_with)
    if (with.second > least_share * all.length) ++count;
  return count;
}

/// returns the tube that a piece is of, between its longest loop and one or two more, as of the legs below a hip;
/// where a few small things grow from it matters not. A flange or a lip is no tube, its girth is not that of its ends;
/// nor is a joint where more than three meet.
inline std::optional<Tube> as_tube(const Piece& piece)
{
  constexpr double least_loop = 0.35, most_small = 0.5, most_ratio = 1.7, most_girth = 1.4;
  constexpr std::size_t most_loops = 3, most_neighbors = 3;
  Tube tube;
  std::size_t loops = 0;
  double of_small = 0.;
  for (const Border_loop& loop : piece.loops)
    if (loop.length > least_loop * piece.loops.front().length)
      (loops++ == 0 ? tube.first : tube.second).add(loop);
    else
      of_small += loop.length;
  if (of_small > most_small * tube.first.length) return std::nullopt;
  if (loops < 2 || loops > most_loops || number_of_neighbors(piece) > most_neighbors)
    return std::nullopt;
  const auto within = [](const double a, const double b, const double ratio)
  { return a <= ratio * b && b <= ratio * a; };
  if (!within(tube.first.length, tube.second.length, most_ratio)) return std::nullopt;
  tube.length =
      (mean_distance(tube.first, tube.second) + mean_distance(tube.second, tube.first)) / 2.;
  if (tube.length <= 0.) return std::nullopt;
  tube.girth = piece.area / tube.length;
  if (!within(tube.girth, tube.mean_border(), most_girth)) return std::nullopt;
  return tube;
}

/// the median thickness of a piece near a line
inline double diameter_near(const Piece& piece, const Border_loop& loop, const double distance)
{
  std::vector<double> near;
  for (const Diameter_sample& d : piece.diameters)
    if (std::any_of(loop.vertices.begin(), loop.vertices.end(),
                    [&](const Vector& p) { return (p - d.position).norm() < distance; }))
      near.push_back(d.diameter);
  return median(std::move(near));
}

/// the piece that a line has most in common with
inline std::size_t main_neighbor(const Border_loop& loop)
{
  const auto shorter = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(loop.length_with.begin(), loop.length_with.end(), shorter)->first;
}

/// whether a tube goes on at both ends without a crease, as thick as it is
inline bool goes_on(const std::vector<Piece>& pieces, const Piece& piece, const Tube& tube)
{
  constexpr double most_ratio = 1.25, most_crease = 0.3;
  const double own = piece.diameter();
  for (const Border_loop* const end : {&tube.first, &tube.second})
  {
    if (end->crease_length > most_crease * end->length) return false;
    const double beyond = diameter_near(pieces[main_neighbor(*end)], *end, tube.diameter());
    if (beyond > most_ratio * own || own > most_ratio * beyond) return false;
  }
  return main_neighbor(tube.first) != main_neighbor(tube.second) &&
         tube.first.length < most_ratio * tube.second.length &&
         tube.girth < most_ratio * tube.mean_border() &&
         tube.mean_border() < most_ratio * tube.girth;
}

/// The thickness of the trunk: three quarters of the shape's surface have less below them.
inline double trunk_diameter(const std::vector<Diameter_sample>& diameters)
{
  std::vector<double> values;
  for (const Diameter_sample& d : diameters) values.push_back(d.diameter);
  if (values.empty()) return 0.;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 3 / 4);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// whether a piece ends where the surface is folded: the faces and collars of a made thing do, and are seen
inline bool is_between_creases(const Piece& piece)
{
  constexpr double least_share = 0.6;
  Border_loop all;
  for (const Border_loop& loop : piece.loops) all.add(loop);
  return all.crease_length > least_share * all.length;
}

/// What a piece is, if it is one that looks wrong.
inline std::optional<Overcut> overcut_of(const std::vector<Piece>& pieces, const Piece& piece,
                                         const double trunk)
{
  constexpr double short_tube = 0.6, share_of_trunk = 0.7, thin = 0.2;
  // how much longer than that of a flat disk of the same area a border is, squared: 1 for the disk, 0.5 for a
  // half of a ball, 2 for a flat strip of about 4 to 1
  constexpr double flat = 1.25;
  if (piece.loops.empty() || is_between_creases(piece)) return std::nullopt;
  const auto tube = as_tube(piece);
  if (tube && tube->length < short_tube * tube->diameter())
    return piece.diameter() > share_of_trunk * trunk ? Overcut::TRUNK_BAND : Overcut::RING;
  if (tube && piece.loops.size() == 2 && goes_on(pieces, piece, *tube)) return Overcut::TUBE_PIECE;
  const double perimeter = piece.perimeter();
  if (piece.loops.size() > 1 || perimeter * perimeter < flat * 4. * pi * piece.area)
    return std::nullopt; // what limbs grow from, or a limb
  if (2. * piece.area < thin * piece.diameter() * perimeter) return Overcut::SLIVER;
  if (number_of_neighbors(piece) > 1) return Overcut::STRIP;
  return std::nullopt;
}

} // namespace internal

/// finds the parts that look wrong.
inline std::vector<Overcut_part> find_overcuts(const std::vector<Piece>& pieces,
                                               const std::vector<Diameter_sample>& diameters)
{
  constexpr double least_area = 1e-4; // of the shape: less is not seen
  const double trunk = internal::trunk_diameter(diameters);
  double area = 0.;
  for (const Piece& piece : pieces) area += piece.area;
  std::vector<Overcut_part> found;
  for (const Piece& piece : pieces)
    if (piece.area < least_area * area)
      continue;
    else if (const auto kind = internal::overcut_of(pieces, piece, trunk))
      found.push_back({piece.label, *kind});
  return found;
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_OVERCUTTING_H
