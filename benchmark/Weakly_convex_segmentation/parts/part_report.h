// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_REPORT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_REPORT_H

#include "parts/border_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
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
};

/// The means of a set: each mesh counts once, however many labelings of it there are.
struct Set_summary
{
  std::string name;
  std::size_t meshes = 0;
  double parts = 0.;
  double asymmetry = 0.;
  double roughness = 0., turn = 0., concave = 0.;
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

  void add(const Labeling_row& row)
  {
    labelings += 1.;
    parts += static_cast<double>(row.parts);
    if (row.asymmetry) asymmetry = asymmetry.value_or(0.) + *row.asymmetry;
    borders.add(row.borders);
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
    if (sums.empty() || sums.back().mesh != row.mesh) sums.push_back({row.mesh, 0., 0., {}, {}});
    sums.back().add(row);
  }
  return sums;
}

} // namespace internal

/// returns the means of a set; the borders' are over the meshes that have some.
inline Set_summary summarize(const std::vector<Labeling_row>& rows, const std::string& set)
{
  Set_summary summary;
  summary.name = set;
  double with_borders = 0.;
  for (const internal::Mesh_sums& mesh : internal::sums_of_meshes(rows, set))
  {
    ++summary.meshes;
    summary.parts += mesh.parts / mesh.labelings;
    if (mesh.asymmetry)
      summary.asymmetric.emplace_back(*mesh.asymmetry / mesh.labelings, mesh.mesh);
    if (mesh.borders.length == 0.) continue;
    with_borders += 1.;
    summary.roughness += mesh.borders.roughness();
    summary.turn += mesh.borders.mean_turn();
    summary.concave += mesh.borders.concave_share();
  }
  if (summary.meshes == 0) return summary;
  summary.parts /= static_cast<double>(summary.meshes);
  for (double* const mean : {&summary.roughness, &summary.turn, &summary.concave})
    *mean /= (std::max)(with_borders, 1.);
  for (const auto& mesh : summary.asymmetric) summary.asymmetry += mesh.first;
  summary.asymmetry /= (std::max)(static_cast<double>(summary.asymmetric.size()), 1.);
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
         "border_concave\n";
  for (const Labeling_row& row : rows)
  {
    out << row.mesh << ',' << row.set << ',' << row.labels << ',' << row.parts << ',';
    if (row.asymmetry) out << *row.asymmetry;
    out << ',' << row.borders.length << ',' << row.borders.roughness() << ','
        << row.borders.mean_turn() << ',' << row.borders.concave_share() << '\n';
  }
  if (!out.flush())
    throw std::runtime_error("can't write " + path.string() +
                             ": check that the folder exists and has space");
}

} // namespace Part_measures

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_PARTS_PART_REPORT_H
