// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The C++ side of fitting the merge cost of the default preset to labeled shapes; fit_merge_cost.py
// trains and calls it.
//
//   fit_merge_cost prepare DATA_DIR VARIANT FOLDER [NAME=VALUE...]  analyzes all models once, for tune_costs
//   fit_merge_cost samples DATA_DIR VARIANT OUT.bin [NAME=VALUE...] features, targets, weights of merges
//   fit_merge_cost score DATA_DIR VARIANT TABLES [NAME=VALUE...]    1 - Rand Index of the segmentations
//   fit_merge_cost names                                            features, in order
//
// VARIANT is what the models are turned into: mesh, points, half, surface, one_view, two_views,
// four_views, noisy_scan, stretched, noisy_mesh, hull, and NAME=VALUE is a member of Parameters. TABLES is a folder
// with tables of trees, K.txt, and folds.txt, which names a model and its table a line.

#include "fit/patch_scores.h"
#include "fit/saved_models.h"
#include "program/set_parameter.h"

#include "fit/pair_feature_names.h"
#include <CGAL/Weakly_convex_segmentation/internal/merging/Learned_cost.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace SM = Segmentation_metrics;
using Patch_scores::Model;

namespace {

/// Trees read from a text file.
struct Tree_table
{
  std::vector<WCS::internal::Tree_node> nodes;
  std::vector<std::uint16_t> roots;
  double bias = 0.;

  WCS::internal::Boosted_trees trees() const
  {
    return {nodes.data(), roots.data(), roots.size(), bias};
  }
};

Tree_table read_table(const std::filesystem::path& path)
{
  std::ifstream in(path);
  std::size_t nodes = 0, roots = 0;
  Tree_table table;
  in >> table.bias >> roots >> nodes;
  table.roots.resize(roots);
  table.nodes.resize(nodes);
  for (auto& root : table.roots) in >> root;
  for (auto& node : table.nodes) in >> node.feature >> node.child >> node.value;
  if (!in) throw std::runtime_error("can't read the trees in " + path.string());
  return table;
}

/// The tables of a folder and which model is judged by which.
class Tree_tables
{
public:
  explicit Tree_tables(const std::filesystem::path& folder)
  {
    std::ifstream in(folder / "folds.txt");
    int model = 0;
    for (std::string name; in >> model >> name;)
    {
      m_name_of_model[model] = name;
      if (m_tables.count(name) == 0) m_tables[name] = read_table(folder / (name + ".txt"));
    }
    if (m_tables.empty()) throw std::runtime_error("there is no folds.txt in " + folder.string());
  }
  const Tree_table& of_model(const int number) const
  {
    return m_tables.at(m_name_of_model.at(number));
  }

private:
  std::map<int, std::string> m_name_of_model;
  std::map<std::string, Tree_table> m_tables;
};

/// Share of the pairs of elements across two regions that people put in one part, the mean over people; NaN if a region
/// has none.
double agreement(const Model& model, const WCS::internal::Region_graph& graph, const int a,
                 const int b)
{
  double sum = 0., size_a = 0., size_b = 0.; // a patch of points of large faces may have no face
  for (const int p : graph.region(a).patches) size_a += model.patch_sizes[p];
  for (const int p : graph.region(b).patches) size_b += model.patch_sizes[p];
  for (const auto& annotator : model.annotators)
  {
    std::map<int, double> labels;
    for (const int p : graph.region(a).patches)
      for (const auto& [label, count] : annotator.of_patch[p]) labels[label] += count;
    for (const int p : graph.region(b).patches)
      for (const auto& [label, count] : annotator.of_patch[p])
      {
        const auto it = labels.find(label);
        if (it != labels.end()) sum += it->second * count;
      }
  }
  const double count = size_a * size_b * static_cast<double>(model.annotators.size());
  return count > 0. ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// writes one row for each merge that is judged on the way of a set of patches down to one region, by the weighted
/// cost: model, weight, target (NaN if there is none), features.
void write_samples(const Model& model, const WCS::internal::Patch_set& set, std::ofstream& out)
{
  const WCS::internal::Shape_analysis& shape = *model.shape;
  WCS::internal::Region_graph graph(shape.points(), shape.graph, set.patches, *set.visibility,
                                    WCS::Parameters());
  WCS::internal::measure_pairs(graph, shape.points(), shape.graph, set.patches, shape.diameters);
  WCS::internal::Pair_features features(graph, set.patches, shape.diameters);
  std::vector<float> row, values;
  bool above = false;
  const auto write = [&](const int a, const int b, const double cost)
  {
    above = above || cost > WCS::internal::certain_merge_cost;
    if (!above) return; // no tree is asked
    const double shares =
        graph.region(a).size * graph.region(b).size / (graph.total_size() * graph.total_size());
    row = {static_cast<float>(model.number), static_cast<float>(std::pow(shares, 0.8)),
           static_cast<float>(agreement(model, graph, a, b))};
    features.compute(a, b, values);
    row.insert(row.end(), values.begin(), values.end());
    out.write(reinterpret_cast<const char*>(row.data()),
              static_cast<std::streamsize>(row.size() * sizeof(float)));
  };
  WCS::Merge_tree tree(set.patches.size());
  WCS::internal::Contraction_log log{tree};
  log.before_merge = write;
  WCS::internal::contract(
      graph, [&](const int a, const int b) { return features.weighted_cost(a, b); }, log);
}

/// 1 - Rand Index and number of segments, averaged a category and overall.
class Scores
{
public:
  void add(const Model& model, const double error, const std::vector<int>& regions)
  {
    m_errors[model.category()].push_back(error);
    m_segments += 1. + *std::max_element(regions.begin(), regions.end());
    m_models += 1.;
  }
  void print(const std::string& name) const
  {
    double sum = 0.;
    std::ostringstream each;
    for (const auto& [category, errors] : m_errors)
    {
      const double mean =
          std::accumulate(errors.begin(), errors.end(), 0.) / static_cast<double>(errors.size());
      sum += mean;
      each << ' ' << SM::category_names()[category].substr(0, 3) << ' '
           << std::lround(1000. * mean);
    }
    std::cout << name << ": " << sum / static_cast<double>(m_errors.size()) << ", "
              << m_segments / m_models << " segments;" << each.str() << '\n'
              << std::flush;
  }

private:
  std::map<std::size_t, std::vector<double>> m_errors;
  double m_segments = 0., m_models = 0.;
};

/// analyzes all models and calls `visit(model)` for each.
template <typename Visit>
void for_each_model(const std::filesystem::path& data, const std::string& variant,
                    const WCS::Parameters& parameters, const Visit& visit)
{
  const auto its = Shape_variants::variant_of_name(variant);
  Patch_scores::for_each_number(data / "off", ".off",
                                [&](const int n)
                                {
                                  Model model = Patch_scores::load(data, n, parameters, its);
                                  visit(model);
                                });
}

void prepare(const std::filesystem::path& data, const std::string& variant,
             const std::filesystem::path& folder, WCS::Parameters parameters)
{
  std::filesystem::create_directories(folder);
  parameters.number_of_patch_sets = 1; // a cost is searched for by what it makes of one
  for_each_model(data, variant, parameters,
                 [&](Model& model) { Patch_scores::save(model, folder); });
}

void samples(const std::filesystem::path& data, const std::string& variant,
             const std::filesystem::path& path, const WCS::Parameters& parameters)
{
  std::ofstream out(path, std::ios::binary);
  for_each_model(data, variant, parameters,
                 [&](Model& model)
                 {
                   for (std::size_t s = 0; s < model.shape->patch_sets.size(); ++s)
                   {
                     Patch_scores::count_patches(model, s);
                     write_samples(model, model.shape->patch_sets[s], out);
                   }
                 });
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

/// prints the scores of the whole pipeline, each model judged by the trees that are for it.
void score(const std::filesystem::path& data, const std::string& variant, const Tree_tables& tables,
           const WCS::Parameters& parameters)
{
  Scores scores;
  for_each_model(data, variant, parameters,
                 [&](Model& model)
                 {
                   const auto trees = tables.of_model(model.number).trees();
                   const auto labels = Patch_scores::refined_labels(
                       model,
                       WCS::internal::decide_segments(
                           *model.shape, parameters, {}, {},
                           WCS::internal::symmetries_of(*model.shape, parameters, {}), trees),
                       parameters);
                   scores.add(model, Patch_scores::rand_error_of_labels(model, labels), labels);
                 });
  scores.print(variant);
}

int run(const std::vector<std::string>& arguments)
{
  const auto is = [&](const char* task, const std::size_t least)
  { return !arguments.empty() && arguments[0] == task && arguments.size() > least; };
  const auto changed = [&](WCS::Parameters parameters)
  {
    for (std::size_t i = 4; i < arguments.size(); ++i)
      Named_parameters::set_parameter(parameters, arguments[i]);
    return parameters;
  };
  if (is("names", 0))
    for (const char* name : WCS::internal::pair_feature_names()) std::cout << name << '\n';
  else if (is("prepare", 3))
    prepare(arguments[1], arguments[2], arguments[3], changed({}));
  else if (is("samples", 3))
    samples(arguments[1], arguments[2], arguments[3], changed({}));
  else if (is("score", 3))
    score(arguments[1], arguments[2], Tree_tables(arguments[3]), changed({}));
  else
    throw std::invalid_argument("see the head of fit_merge_cost.cpp for the calls");
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  }
  catch (const std::exception& error)
  {
    std::cerr << "fit_merge_cost: " << error.what() << '\n';
    return 1;
  }
}
