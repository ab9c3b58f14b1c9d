// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_REPORT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_REPORT_H

#include "parts/border_lines.h"
#include "parts/overcutting.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Tables of the measures of parts: a row a labeling in a file, and what they come to for each set of labels.

namespace Part_measures {

/// The measures of one labeling of a mesh; a set may have several, as people's.
struct Labeling_row
{
  std::string mesh, set, labels;
  std::size_t parts = 0;
  std::optional<double> asymmetry; ///< of meshes that have a plane of reflection
  Border_sums borders;
  std::vector<Overcut_part> overcuts;
};

/// The means of a set: each mesh counts once, however many labelings of it there are.
struct Set_summary
{
  std::string name;
  std::size_t meshes = 0;
  double parts = 0.;
  double asymmetry = 0.;
  double roughness = 0., turn = 0., concave = 0.;
  std::array<double, number_of_overcuts> overcuts{}; ///< of each kind, a mesh
  /// of all kinds, by the median of each mesh's labelings: a few people cut everything
  double typical_overcuts = 0.;
  std::vector<std::pair<double, std::string>> asymmetric; ///< the symmetric meshes, worst first
};

namespace internal {

/// The rows of one mesh and set, added up.
struct Mesh_sums
{
  std::string mesh;
  double labelings = 0., parts = 0.;
  std::optional<double> asymmetry;
  Border_sums borders;
  std::array<double, number_of_overcuts> overcuts{};
  std::vector<double> counts; ///< of all kinds, a labeling

  void add(const Labeling_row& row)
  {
    labelings += 1.;
    parts += static_cast<double>(row.parts);
    if (row.asymmetry) asymmetry = asymmetry.value_or(0.) + *row.asymmetry;
    borders.add(row.borders);
    counts.push_back(static_cast<double>(row.overcuts.size()));
    for (const Overcut_part& part : row.overcuts)
      overcuts[static_cast<std::size_t>(part.kind)] += 1.;
  }
};

/// in the order of the rows
inline std::vector<Mesh_sums> sums_of_meshes(const std::vector<Labeling_row>& rows,
                                             const std::string& set)
{
  std::vector<Mesh_sums> sums;
  for (const Labeling_row& row : rows)
  {
    if (row.set != set) continue;
    if (sums.empty() || sums.back().mesh != row.mesh)
    {
      sums.emplace_back();
      sums.back().mesh = row.mesh;
    }
    sums.back().add(row);
  }
  return sums;
}

} // namespace internal

/// returns the means of a set: of asymmetry over the symmetric meshes, of borders over those that have some.
inline Set_summary summarize(const std::vector<Labeling_row>& rows, const std::string& set)
{
  Set_summary summary;
  summary.name = set;
  const std::vector<internal::Mesh_sums> meshes = internal::sums_of_meshes(rows, set);
  summary.meshes = meshes.size();
  const double all = static_cast<double>((std::max)(meshes.size(), std::size_t(1)));
  const auto has_borders = [](const auto& mesh) { return mesh.borders.length > 0.; };
  const double with_borders =
      (std::max)(static_cast<double>(std::count_if(meshes.begin(), meshes.end(), has_borders)), 1.);
  for (const internal::Mesh_sums& mesh : meshes)
  {
    summary.parts += mesh.parts / mesh.labelings / all;
    summary.typical_overcuts += median(mesh.counts) / all;
    for (std::size_t k = 0; k < number_of_overcuts; ++k)
      summary.overcuts[k] += mesh.overcuts[k] / mesh.labelings / all;
    if (mesh.asymmetry)
      summary.asymmetric.emplace_back(*mesh.asymmetry / mesh.labelings, mesh.mesh);
    if (!has_borders(mesh)) continue;
    summary.roughness += mesh.borders.roughness() / with_borders;
    summary.turn += mesh.borders.mean_turn() / with_borders;
    summary.concave += mesh.borders.concave_share() / with_borders;
  }
  for (const auto& mesh : summary.asymmetric)
    summary.asymmetry += mesh.first / static_cast<double>(summary.asymmetric.size());
  const auto worse = [](const auto& a, const auto& b) { return a.first > b.first; };
  std::stable_sort(summary.asymmetric.begin(), summary.asymmetric.end(), worse);
  return summary;
}

/// Numbers as a table has them.
template <typename... Numbers>
std::string formatted(const char* const format, const Numbers... numbers)
{
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), format, numbers...);
  return text.data();
}

inline void print_summaries(std::ostream& out, const std::vector<Set_summary>& summaries)
{
  out << "                meshes   parts  asymmetry   of  border rough    turn  concave\n";
  for (const Set_summary& s : summaries)
    out << formatted("%-14s %7zu %7.2f %10.4f %4zu %13.3f %7.1f %8.3f\n", s.name.c_str(), s.meshes,
                     s.parts, s.asymmetry, s.asymmetric.size(), s.roughness, s.turn, s.concave);
  out << "over-cut parts";
  for (std::size_t k = 0; k < number_of_overcuts; ++k)
    out << formatted(" %10s", overcut_name(static_cast<Overcut>(k)));
  out << "        all    typical\n";
  for (const Set_summary& s : summaries)
  {
    out << formatted("%-14s", s.name.c_str());
    for (const double count : s.overcuts) out << formatted(" %10.3f", count);
    out << formatted(" %10.3f %10.3f\n", std::accumulate(s.overcuts.begin(), s.overcuts.end(), 0.),
                     s.typical_overcuts);
  }
}

/// prints the least symmetric labels of each set.
inline void print_worst(std::ostream& out, const std::vector<Set_summary>& summaries)
{
  constexpr std::size_t most = 10;
  for (const Set_summary& s : summaries)
  {
    out << "least symmetric, " << s.name << ':';
    for (std::size_t i = 0; i < s.asymmetric.size() && i < most; ++i)
      out << ' ' << s.asymmetric[i].second << formatted(" %.3f", s.asymmetric[i].first) << ',';
    out << '\n';
  }
}

inline void write_csv(const std::vector<Labeling_row>& rows, const std::filesystem::path& path)
{
  std::ofstream out(path);
  out << "mesh,set,labels,parts,asymmetry,border_length,border_roughness,border_turn,"
         "border_concave,overcut_parts\n";
  for (const Labeling_row& row : rows)
  {
    out << row.mesh << ',' << row.set << ',' << row.labels << ',' << row.parts << ',';
    if (row.asymmetry) out << *row.asymmetry;
    out << ',' << row.borders.length << ',' << row.borders.roughness() << ','
        << row.borders.mean_turn() << ',' << row.borders.concave_share() << ',';
    for (std::size_t i = 0; i < row.overcuts.size(); ++i)
      out << (i > 0 ? " " : "") << row.overcuts[i].label << ':'
          << overcut_name(row.overcuts[i].kind);
    out << '\n';
  }
  if (!out.flush())
    throw std::runtime_error("can't write " + path.string() +
                             ": check that the folder exists and has space");
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_REPORT_H
