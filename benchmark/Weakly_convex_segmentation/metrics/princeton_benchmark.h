// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_PRINCETON_BENCHMARK_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_PRINCETON_BENCHMARK_H

#include "metrics/segmentation_metrics.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The Princeton Segmentation Benchmark of Chen et al. 2009: its files, its categories and its
// averages. A benchmark directory holds `off/N.off` and `seg/Benchmark/N/N_K.seg`, as the
// archive of the benchmark unpacks.

namespace Segmentation_metrics {

namespace internal {

// The benchmark numbers its models from 1 to 400 in runs of 20 a category. The run of the springs
// was left out of the study, it has no segmentations by people.
constexpr int models_per_category = 20;
constexpr int number_of_runs = 20;
constexpr int run_of_springs = 13;

inline std::ifstream open_input(const std::filesystem::path& path)
{
  std::ifstream input(path);
  if (!input)
    throw std::runtime_error("Can't open " + path.string() +
                             ": check that the file exists and may be read.");
  input.imbue(std::locale::classic());
  return input;
}

// Hands out the lines of a text file that hold data, and words the errors about them.
class Data_lines
{
public:
  explicit Data_lines(const std::filesystem::path& path) : m_path(path), m_input(open_input(path))
  {
    m_fields.imbue(std::locale::classic());
  }

  // The fields of the next line that is neither blank nor a comment.
  std::istringstream& next(const std::string& expected)
  {
    if (!advance())
      fail("the file ends, but expected is " + expected + ": the file may be cut off");
    return m_fields;
  }

  std::istringstream& current() { return m_fields; }

  bool advance()
  {
    std::string line;
    while (std::getline(m_input, line))
    {
      ++m_line_number;
      line.erase(std::min(line.find('#'), line.size()));
      if (line.find_first_not_of(" \t\r\v\f") == std::string::npos) continue;
      m_fields.clear();
      m_fields.str(line);
      return true;
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw std::runtime_error(m_path.string() + ", line " + std::to_string(m_line_number) + ": " +
                             message + ".");
  }

private:
  std::filesystem::path m_path;
  std::ifstream m_input;
  std::istringstream m_fields;
  std::size_t m_line_number = 0;
};

// The numbers of points and of faces, from behind the header 'OFF'.
inline std::pair<long long, long long> read_off_counts(Data_lines& lines)
{
  std::istringstream& header = lines.next("the header 'OFF'");
  std::string keyword;
  header >> keyword;
  if (keyword != "OFF")
    lines.fail("the header is '" + keyword + "' instead of 'OFF': convert the file to text OFF");
  // Some writers put the counts behind the header, on its line.
  std::istringstream& counts = (header >> std::ws).eof() ? lines.next("three counts") : header;
  long long number_of_points = -1, number_of_faces = -1;
  if (!(counts >> number_of_points >> number_of_faces) || number_of_points < 0 ||
      number_of_faces < 0)
    lines.fail("expected are the numbers of points and of faces");
  return {number_of_points, number_of_faces};
}

inline std::array<std::size_t, 3> read_off_face(Data_lines& lines, long long number_of_points)
{
  std::istringstream& fields = lines.next("a face");
  int degree = 0;
  if (!(fields >> degree) || degree != 3)
    lines.fail("expected is a face of 3 vertices: triangulate the mesh");
  std::array<std::size_t, 3> face{};
  for (std::size_t& vertex : face)
  {
    long long id = -1;
    if (!(fields >> id) || id < 0 || id >= number_of_points)
      lines.fail("expected are three vertices, numbered from 0 to the number of points less 1: "
                 "correct the face");
    vertex = static_cast<std::size_t>(id);
  }
  return face;
}

// A number K of a file named N_K.seg, none for any other name.
inline std::optional<int> segmentation_number(const std::filesystem::path& path, int model)
{
  const std::string prefix = std::to_string(model) + "_";
  const std::string stem = path.stem().string();
  if (path.extension() != ".seg" || stem.compare(0, prefix.size(), prefix) != 0)
    return std::nullopt;
  const std::string digits = stem.substr(prefix.size());
  if (digits.empty() || digits.size() > 6 ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  return std::stoi(digits);
}

} // namespace internal

// Reads triangles in the OFF format; whatever follows the coordinates of a point or the vertices
// of a face on their line (colors) is skipped.
inline Mesh read_off(const std::filesystem::path& path)
{
  internal::Data_lines lines(path);
  const auto [number_of_points, number_of_faces] = internal::read_off_counts(lines);
  Mesh mesh;
  for (long long i = 0; i < number_of_points; ++i)
  {
    Point point{};
    if (!(lines.next("a point") >> point[0] >> point[1] >> point[2]))
      lines.fail("expected are the three coordinates of a point");
    mesh.points.push_back(point);
  }
  for (long long i = 0; i < number_of_faces; ++i)
    mesh.faces.push_back(internal::read_off_face(lines, number_of_points));
  if (lines.advance()) lines.fail("more lines than the counts announce: correct the counts");
  return mesh;
}

// Reads one label a line, for each face.
inline Segmentation read_seg(const std::filesystem::path& path, std::size_t number_of_faces)
{
  internal::Data_lines lines(path);
  Segmentation segmentation;
  segmentation.reserve(number_of_faces);
  while (lines.advance())
  {
    if (segmentation.size() == number_of_faces)
      lines.fail("more labels than the " + std::to_string(number_of_faces) +
                 " faces of the mesh: check that it belongs to this mesh");
    std::istringstream& fields = lines.current();
    int label = 0;
    if (!(fields >> label) || !(fields >> std::ws).eof())
      lines.fail("expected is one integer, the label of a face");
    segmentation.push_back(label);
  }
  if (segmentation.size() != number_of_faces)
    lines.fail("the file ends after " + std::to_string(segmentation.size()) +
               " labels, but the mesh has " + std::to_string(number_of_faces) +
               " faces: check that it belongs to this mesh");
  return segmentation;
}

// The segmentations by people of a model in the order of their numbers, which may have gaps.
inline std::vector<Segmentation> read_annotations(const std::filesystem::path& directory, int model,
                                                  std::size_t number_of_faces)
{
  const std::filesystem::path folder = directory / "seg" / "Benchmark" / std::to_string(model);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error("There is no folder " + folder.string() +
                             ": name the directory "
                             "which holds off/ and seg/ of the benchmark.");
  std::map<int, std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (const auto number = internal::segmentation_number(entry.path(), model))
      paths.emplace(*number, entry.path());
  if (paths.empty())
    throw std::runtime_error("There are no segmentations by people in " + folder.string() +
                             ": unpack the archive of the benchmark again.");
  std::vector<Segmentation> segmentations;
  for (const auto& [number, path] : paths) segmentations.push_back(read_seg(path, number_of_faces));
  return segmentations;
}

// A model and what scoring needs of it, computed once for any number of candidates.
struct Benchmark_model
{
  int number = 0;
  Mesh mesh;
  Mesh_geometry geometry;
  std::vector<Prepared_segmentation> annotators;
};

inline bool is_in_benchmark(int model)
{
  return model >= 1 && model <= internal::models_per_category * internal::number_of_runs &&
         (model - 1) / internal::models_per_category != internal::run_of_springs;
}

inline const std::array<std::string, 19>& category_names()
{
  static const std::array<std::string, 19> names{"Human", "Cup",     "Glasses", "Airplane",  "Ant",
                                                 "Chair", "Octopus", "Table",   "Teddy",     "Hand",
                                                 "Plier", "Fish",    "Bird",    "Armadillo", "Bust",
                                                 "Mech",  "Bearing", "Vase",    "Fourleg"};
  return names;
}

// The index into `category_names()`.
inline std::size_t category_of_model(int model)
{
  if (!is_in_benchmark(model))
    throw std::invalid_argument("There is no model " + std::to_string(model) +
                                " in the "
                                "benchmark: use 1 to 260 or 281 to 400.");
  const int run = (model - 1) / internal::models_per_category;
  return static_cast<std::size_t>(run > internal::run_of_springs ? run - 1 : run);
}

inline Benchmark_model read_benchmark_model(const std::filesystem::path& directory, int number)
{
  category_of_model(number); // throws for a number outside the benchmark
  Benchmark_model model;
  model.number = number;
  model.mesh = read_off(directory / "off" / (std::to_string(number) + ".off"));
  model.geometry = compute_mesh_geometry(model.mesh);
  for (const Segmentation& annotator : read_annotations(directory, number, model.mesh.faces.size()))
    model.annotators.push_back(prepare(model.geometry, annotator));
  return model;
}

// The means of scores, each over those that have it: the cut discrepancy may be missing.
class Mean_scores
{
public:
  void add(const Scores& scores)
  {
    for (const auto member : members()) m_sum.*member += scores.*member;
    ++m_count;
    if (scores.cut_discrepancy)
    {
      m_sum.cut_discrepancy = m_sum.cut_discrepancy.value_or(0.) + *scores.cut_discrepancy;
      ++m_cut_count;
    }
  }

  std::size_t count() const { return m_count; }

  Scores mean() const
  {
    if (m_count == 0) throw std::logic_error("There is no mean of no scores: add some first.");
    Scores scores = m_sum;
    for (const auto member : members()) scores.*member /= static_cast<double>(m_count);
    if (scores.cut_discrepancy) *scores.cut_discrepancy /= static_cast<double>(m_cut_count);
    return scores;
  }

private:
  static const std::array<double Scores::*, 9>& members()
  {
    static const std::array<double Scores::*, 9> list{
        &Scores::rand_error,       &Scores::hamming,  &Scores::missing_rate,
        &Scores::false_alarm_rate, &Scores::gce,      &Scores::lce,
        &Scores::gce_area,         &Scores::lce_area, &Scores::number_of_segments};
    return list;
  }

  Scores m_sum;
  std::size_t m_count = 0;
  std::size_t m_cut_count = 0;
};

// The average over the segmentations by people of the model.
inline Scores score_against_annotators(const Benchmark_model& model, const Segmentation& candidate,
                                       Pair_count pair_count = Pair_count::exact)
{
  const Prepared_segmentation prepared = prepare(model.geometry, candidate);
  Mean_scores mean;
  for (const Prepared_segmentation& annotator : model.annotators)
    mean.add(score(model.geometry, prepared, annotator, pair_count));
  return mean.mean();
}

// People against people, the bound below which no method is expected: the average over all
// unordered pairs of segmentations by people. Every pair is scored in both directions, so that the
// missing and false alarm rates and the number of segments don't depend on the order of the files.
inline Scores score_annotators(const Benchmark_model& model,
                               Pair_count pair_count = Pair_count::exact)
{
  if (model.annotators.size() < 2)
    throw std::invalid_argument("Model " + std::to_string(model.number) +
                                " has fewer than two "
                                "segmentations by people, so there are no pairs: leave it out.");
  Mean_scores mean;
  for (const Prepared_segmentation& annotator : model.annotators)
    for (const Prepared_segmentation& other : model.annotators)
      if (&annotator != &other) mean.add(score(model.geometry, annotator, other, pair_count));
  return mean.mean();
}

// Averages as in Chen et al. 2009: over a category's models, then over the categories, so that
// categories weigh alike when models are left out.
class Benchmark_average
{
public:
  // `scores` are those of one model.
  void add(int model, const Scores& scores) { m_categories[category_of_model(model)].add(scores); }

  // None if no model of the category was added.
  std::optional<Scores> category(std::size_t index) const
  {
    const Mean_scores& mean = m_categories.at(index);
    return mean.count() == 0 ? std::nullopt : std::optional<Scores>(mean.mean());
  }

  Scores overall() const
  {
    Mean_scores mean;
    for (const Mean_scores& scores : m_categories)
      if (scores.count() > 0) mean.add(scores.mean());
    return mean.mean();
  }

private:
  std::array<Mean_scores, 19> m_categories;
};

} // namespace Segmentation_metrics

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_METRICS_PRINCETON_BENCHMARK_H
