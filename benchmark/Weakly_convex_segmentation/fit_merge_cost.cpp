// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The C++ side of fitting the merge cost of the `fitted` preset to labeled shapes; fit_merge_cost.py
// trains and calls it.
//
//   fit_merge_cost prepare DATA_DIR VARIANT FOLDER [NAME=VALUE...]  analyzes all models once
//   fit_merge_cost samples FOLDER OUT.bin [TABLES]                  features, targets, weights of pairs
//   fit_merge_cost score FOLDER TABLES THRESHOLD...                 1 - Rand Index of the segmentations
//   fit_merge_cost score_cut FOLDER TABLES THRESHOLD...             the same after refining borders
//   fit_merge_cost names                                            features and their directions
//
// VARIANT is what the models are turned into: mesh, points, half, surface, one_view, two_views,
// four_views, noisy_scan, and NAME=VALUE is a member of Parameters. TABLES is a folder with tables of trees, K.txt, and folds.txt,
// which names a model and its table a line; with `samples` the pairs are then those on the trees' own
// path instead of the default cost's.

#include "common/set_parameter.h"
#include "fit/patch_scores.h"
#include "fit/saved_models.h"

#include "fit/pair_feature_names.h"
#include <CGAL/Weakly_convex_segmentation/internal/merging/Learned_cost.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
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

/// Share of the pairs of elements across two regions that people put in one part, the mean over people.
double agreement(const Model& model, const WCS::internal::Region_graph& graph, const int a,
                 const int b)
{
  double sum = 0., size_a = 0., size_b = 0.; // a patch may have no element that it has most of
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
  return count > 0. ? sum / count : 0.5;
}

/// A model with its regions and features.
struct Trial
{
  Model& model;
  WCS::internal::Region_graph graph;
  WCS::internal::Pair_features features;
  WCS::Merge_tree tree;

  Trial(Model& m, const WCS::Parameters& parameters)
    : model(m), graph(m.shape->points(), m.shape->graph, m.shape->patches(), m.shape->visibility(),
                      parameters),
      features(graph, m.shape->patches(), m.shape->diameters), tree(m.shape->patches().size())
  {
    WCS::internal::set_signatures(graph, m.shape->patches(), m.shape->diameters,
                                  WCS::internal::Histogram_scale());
    graph.add_shapes(m.shape->points(), m.shape->graph, m.shape->patches(), m.shape->diameters);
    graph.add_profiles(m.shape->points(), m.shape->graph, m.shape->patches());
  }
  Trial(const Trial& other)
    : model(other.model), graph(other.graph),
      features(graph, model.shape->patches(), model.shape->diameters), tree(other.tree)
  {}
};

using Path_cost = std::function<double(int, int)>;

/// writes one row a pair that is looked at on the way down to one region: model, weight, target,
/// features.
void write_samples(Trial& trial, const Path_cost& cost, std::ofstream& out)
{
  std::vector<std::vector<float>> rows;
  double total = 0.;
  const auto criterion = [&](const int a, const int b)
  {
    std::vector<float> row = {static_cast<float>(trial.model.number)}, features;
    const double shares = trial.graph.region(a).size * trial.graph.region(b).size /
                          (trial.graph.total_size() * trial.graph.total_size());
    row.push_back(static_cast<float>(std::pow(shares, 0.8)));
    total += row.back();
    row.push_back(static_cast<float>(agreement(trial.model, trial.graph, a, b)));
    trial.features.compute(a, b, features);
    row.insert(row.end(), features.begin(), features.end());
    rows.push_back(std::move(row));
    return cost(a, b);
  };
  WCS::internal::contract(trial.graph, criterion, {trial.tree, nullptr});
  for (auto& row : rows)
  {
    row[1] = static_cast<float>(row[1] / total);
    out.write(reinterpret_cast<const char*>(row.data()),
              static_cast<std::streamsize>(row.size() * sizeof(float)));
  }
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

void prepare(const std::filesystem::path& data, const std::string& variant,
             const std::filesystem::path& folder, const WCS::Parameters& parameters)
{
  std::filesystem::create_directories(folder);
  const auto its = Shape_variants::variant_of_name(variant);
  Patch_scores::for_each_number(data / "off", ".off",
                                [&](const int n)
                                {
                                  Model model = Patch_scores::load(data, n, parameters, its);
                                  Patch_scores::save(model, folder);
                                });
}

template <typename Visit>
void for_each_saved(const std::filesystem::path& folder, const Visit& visit)
{
  Patch_scores::for_each_number(folder, ".bin",
                                [&](const int n)
                                {
                                  Model model = Patch_scores::load_saved(folder, n, {});
                                  visit(model);
                                });
}

/// the order in which regions are merged while samples are taken
Path_cost path_cost(Trial& trial, const Tree_tables* tables)
{
  if (tables != nullptr)
    return [&trial, table = tables->of_model(trial.model.number)](const int a, const int b)
    {
      std::vector<float> features;
      trial.features.compute(a, b, features);
      return -table.trees()(features);
    };
  return [&trial](const int a, const int b)
  {
    const WCS::internal::Histogram_scale scale;
    const WCS::internal::Region_cost cost(trial.graph, trial.model.shape->patches(),
                                          trial.model.shape->diameters, scale);
    WCS::Merging_cost weights;
    weights.diameter_weight = 1.;
    weights.concavity_weight = 2.;
    return 0.5 * cost(a, b, weights, (std::numeric_limits<double>::max)());
  };
}

void samples(const std::filesystem::path& folder, const std::filesystem::path& path,
             const Tree_tables* tables)
{
  const WCS::Parameters parameters;
  std::ofstream out(path, std::ios::binary);
  for_each_saved(folder,
                 [&](Model& model)
                 {
                   Trial trial(model, parameters);
                   write_samples(trial, path_cost(trial, tables), out);
                 });
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

std::vector<int> fitted_regions(Trial& trial, const Tree_table& table, const double threshold)
{
  const auto trees = table.trees();
  const WCS::internal::Learned_cost cost(trial.features, trees);
  const WCS::internal::Contraction_log log{trial.tree, nullptr};
  WCS::internal::contract_up_to(
      trial.graph, [&](const int a, const int b) { return cost(a, b); }, threshold, log);
  const WCS::Parameters parameters = WCS::Parameters::fitted();
  const WCS::internal::Histogram_scale scale;
  WCS::internal::absorb_small_regions(
      trial.graph,
      WCS::internal::Region_cost(trial.graph, trial.model.shape->patches(),
                                 trial.model.shape->diameters, scale),
      parameters, log);
  return trial.graph.labels();
}

/// prints the scores at several thresholds and the default's.
void score(const std::filesystem::path& folder, const Tree_tables& tables,
           const std::vector<double>& thresholds, const bool with_cut)
{
  const WCS::Parameters parameters;
  std::vector<Scores> fitted(thresholds.size());
  Scores plain;
  const auto error = [&](const Model& model, const std::vector<int>& regions)
  {
    return with_cut ? Patch_scores::rand_error_of_labels(
                          model, Patch_scores::refined_labels(model, regions, parameters))
                    : Patch_scores::rand_error(model, regions);
  };
  for_each_saved(folder,
                 [&](Model& model)
                 {
                   const Trial fresh(model, parameters);
                   for (std::size_t i = 0; i < thresholds.size(); ++i)
                   {
                     Trial own(fresh);
                     const auto regions =
                         fitted_regions(own, tables.of_model(model.number), thresholds[i]);
                     fitted[i].add(model, error(model, regions), regions);
                   }
                   const auto labels = WCS::internal::segments_of_patches(
                       *model.shape, model.shape->patch_sets.front(), parameters, {}, {});
                   std::vector<int> regions; // of the patches
                   for (const auto& members : model.shape->patches().members)
                     regions.push_back(labels[members.front()]);
                   plain.add(model, error(model, regions), regions);
                 });
  plain.print("default");
  for (std::size_t i = 0; i < thresholds.size(); ++i)
    fitted[i].print("threshold " + std::to_string(thresholds[i]));
}

int run(const std::vector<std::string>& arguments)
{
  const auto is = [&](const char* task, const std::size_t least)
  { return !arguments.empty() && arguments[0] == task && arguments.size() > least; };
  if (is("names", 0))
    for (const auto& name : WCS::internal::pair_feature_names())
      std::cout << name.name << ' ' << name.monotone << '\n';
  else if (is("prepare", 3))
  {
    WCS::Parameters parameters;
    for (std::size_t i = 4; i < arguments.size(); ++i)
      Named_parameters::set_parameter(parameters, arguments[i]);
    prepare(arguments[1], arguments[2], arguments[3], parameters);
  }
  else if (is("samples", 2))
  {
    const auto tables =
        arguments.size() > 3 ? std::make_unique<Tree_tables>(arguments[3]) : nullptr;
    samples(arguments[1], arguments[2], tables.get());
  }
  else if (is("score", 3) || is("score_cut", 3))
  {
    std::vector<double> thresholds;
    for (std::size_t i = 3; i < arguments.size(); ++i)
      thresholds.push_back(std::stod(arguments[i]));
    score(arguments[1], Tree_tables(arguments[2]), thresholds, arguments[0] == "score_cut");
  }
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
