// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_ROWS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_ROWS_H

#include "metrics/princeton_benchmark.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What benchmark_scans measures, and the table in which it is kept: an interrupted run goes on with it.

namespace Scan_rows {

/// One method on one cloud of a model.
struct Row
{
  int model = 0;
  std::string condition, method;
  std::size_t points = 0, segments = 0;
  double rand_error = 0.; ///< of one segment where the method failed
  double seconds = 0.;
  std::string failure; ///< empty if all went well
};

constexpr const char* header =
    "model,category,condition,method,points,segments,rand_error,seconds,failure";

/// returns a word in quotes, without what would end it.
inline std::string quoted(std::string word)
{
  std::replace(word.begin(), word.end(), '"', '\'');
  std::replace(word.begin(), word.end(), '\n', ' ');
  return '"' + word + '"';
}

/// writes the whole table, or leaves the file as it was.
inline void write(const std::vector<Row>& rows, const std::filesystem::path& path)
{
  std::filesystem::path part = path;
  part += ".tmp";
  {
    std::ofstream out(part);
    out << header << '\n';
    for (const Row& r : rows)
      out << r.model << ','
          << Segmentation_metrics::category_names()[Segmentation_metrics::category_of_model(
                 r.model)]
          << ',' << quoted(r.condition) << ',' << quoted(r.method) << ',' << r.points << ','
          << r.segments << ',' << r.rand_error << ',' << r.seconds << ',' << quoted(r.failure)
          << '\n';
    if (!out.flush()) throw std::runtime_error("can't write " + part.string());
  }
  std::filesystem::rename(part, path);
}

/// returns the words of a line of a table; quotes hold commas.
inline std::vector<std::string> words_of(const std::string& line)
{
  std::vector<std::string> words(1);
  bool is_quoted = false;
  for (const char c : line)
  {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

/// returns the rows of a table, none if there is no file.
/// \throws std::runtime_error if it is not a table of this version
inline std::vector<Row> read(const std::filesystem::path& path)
{
  std::vector<Row> rows;
  std::ifstream in(path);
  if (!in) return rows;
  std::string line;
  const auto fail = [&](const std::string& what)
  { throw std::runtime_error(path.string() + what + "; remove it to begin anew"); };
  if (!std::getline(in, line) || line != header) fail(" is no table of this version");
  while (std::getline(in, line))
  {
    const std::vector<std::string> w = words_of(line);
    if (w.size() != 9) fail(" has a line of " + std::to_string(w.size()) + " words");
    try
    {
      rows.push_back({std::stoi(w[0]), w[2], w[3], std::stoul(w[4]), std::stoul(w[5]),
                      std::stod(w[6]), std::stod(w[7]), w[8]});
    }
    catch (const std::logic_error&)
    {
      fail(" has a line without numbers: " + line);
    }
  }
  return rows;
}

} // namespace Scan_rows

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_SCANS_SCAN_ROWS_H
