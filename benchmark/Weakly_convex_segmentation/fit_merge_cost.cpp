// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The C++ side of fitting the merge cost of the `fitted` preset to labeled shapes; fit_merge_cost.py
// trains and calls it.
//
//   fit_merge_cost samples DATA_DIR VARIANT OUT.bin [TABLES]      features, targets, weights of pairs
//   fit_merge_cost score DATA_DIR VARIANT TABLES THRESHOLD...     1 - Rand Index of the segmentations
//   fit_merge_cost names                                          features and their directions
//
// VARIANT is what the models are turned into: mesh, points, half, two_views, four_views. TABLES is a
// folder with a table of trees for each category, NAME.txt; with `samples` the pairs are then those on
// the trees' own path instead of the default cost's.

#include "patch_scores.h"

#include <CGAL/Weakly_convex_segmentation/internal/fitted_merging.h>

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
using Patch_scores::Variant;

namespace {

const std::vector<std::pair<Variant, std::string>> variants = {{Variant::MESH, "mesh"},
                                                               {Variant::POINTS, "points"},
                                                               {Variant::HALF, "half"},
                                                               {Variant::TWO_VIEWS, "two_views"},
                                                               {Variant::FOUR_VIEWS, "four_views"}};

Variant variant_of_name(const std::string& name)
{
  for (const auto& [variant, its_name] : variants)
    if (name == its_name) return variant;
  throw std::invalid_argument("there is no variant '" + name + "'");
}

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

/// Share of the pairs of faces across two regions that people put in one part, the mean over people.
double agreement(const Patch_scores::Model& model, const WCS::internal::Region_graph& graph,
                 const int a, const int b)
{
  double sum = 0., size_a = 0., size_b = 0.;
  for (const int p : graph.region(a).patches) size_a += model.patch_sizes[p];
  for (const int p : graph.region(b).patches) size_b += model.patch_sizes[p];
  for (const auto& human : model.humans)
  {
    std::map<std::size_t, double> labels;
    for (const int p : graph.region(a).patches)
      for (const auto& [label, count] : human.of_patch[p]) labels[label] += count;
    for (const int p : graph.region(b).patches)
      for (const auto& [label, count] : human.of_patch[p])
      {
        const auto it = labels.find(label);
        if (it != labels.end()) sum += it->second * count;
      }
  }
  return sum / (size_a * size_b * static_cast<double>(model.humans.size()));
}

/// A model with its regions, features and the tables of its category.
struct Trial
{
  Patch_scores::Model& model;
  WCS::internal::Region_graph graph;
  WCS::internal::Pair_features features;
  WCS::Merge_tree tree;

  Trial(Patch_scores::Model& m, const WCS::Parameters& parameters)
    : model(m),
      graph(m.shape->points(), m.shape->graph, m.shape->patches, *m.shape->visibility, parameters),
      features(graph, m.shape->patches, m.shape->diameters), tree(m.shape->patches.size())
  {
    WCS::internal::set_signatures(graph, m.shape->patches, m.shape->diameters,
                                  WCS::internal::Histogram_scale());
    graph.add_profiles(m.shape->points(), m.shape->graph, m.shape->patches, m.shape->diameters);
  }
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
  void add(const Patch_scores::Model& model, const std::vector<int>& regions)
  {
    m_errors[SM::category_of_model(model.number)].push_back(
        Patch_scores::rand_error(model, regions));
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

class Fitting
{
public:
  Fitting(const std::filesystem::path& data, const std::filesystem::path& tables) : m_data(data)
  {
    if (!tables.empty())
      for (const std::string& name : SM::category_names())
        m_tables.push_back(read_table(tables / (name + ".txt")));
  }

  template <typename Visit>
  void for_each_model(const Variant variant, const Visit& visit) const
  {
    for (int n = 1; n <= 400; ++n)
      if (SM::is_in_benchmark(n) &&
          std::filesystem::exists(m_data / "off" / (std::to_string(n) + ".off")))
      {
        Patch_scores::Model model = Patch_scores::load(m_data, n, m_parameters, variant);
        Trial trial(model, m_parameters);
        visit(trial);
      }
  }

  void samples(const Variant variant, const std::filesystem::path& path) const
  {
    std::ofstream out(path, std::ios::binary);
    for_each_model(variant, [&](Trial& trial) { write_samples(trial, path_cost(trial), out); });
    if (!out.flush()) throw std::runtime_error("can't write " + path.string());
  }

  /// prints the scores at several thresholds, without a cut, and the default's.
  void score(const Variant variant, const std::vector<double>& thresholds) const
  {
    std::vector<Scores> fitted(thresholds.size());
    Scores plain;
    for_each_model(variant,
                   [&](const Trial& trial)
                   {
                     for (std::size_t i = 0; i < thresholds.size(); ++i)
                     {
                       Trial own(trial.model, m_parameters);
                       fitted[i].add(trial.model, fitted_regions(own, thresholds[i]));
                     }
                     plain.add(trial.model,
                               WCS::internal::regions_at(WCS::internal::merge_patches(
                                                             *trial.model.shape, m_parameters, {}),
                                                         WCS::Level::SEGMENTS));
                   });
    plain.print("default");
    for (std::size_t i = 0; i < thresholds.size(); ++i)
      fitted[i].print("threshold " + std::to_string(thresholds[i]));
  }

private:
  /// the order in which regions are merged while samples are taken
  Path_cost path_cost(Trial& trial) const
  {
    if (!m_tables.empty())
    {
      const Tree_table& table = m_tables[SM::category_of_model(trial.model.number)];
      return [&trial, &table](const int a, const int b)
      {
        std::vector<float> features;
        trial.features.compute(a, b, features);
        return -table.trees()(features);
      };
    }
    return [this, &trial](const int a, const int b)
    {
      const WCS::internal::Histogram_scale scale;
      const WCS::internal::Region_cost cost(trial.graph, scale, m_parameters);
      return cost(a, b, {0.5, 1., 0.5, 0.}, (std::numeric_limits<double>::max)());
    };
  }

  std::vector<int> fitted_regions(Trial& trial, const double threshold) const
  {
    const auto trees = m_tables[SM::category_of_model(trial.model.number)].trees();
    const WCS::internal::Fitted_cost cost(trial.features, trees);
    const WCS::internal::Contraction_log log{trial.tree, nullptr};
    WCS::internal::contract_fitted(trial.graph, cost, threshold, log);
    WCS::Parameters parameters = m_parameters;
    parameters.minimum_segment_share = 0.006;
    const WCS::internal::Histogram_scale scale;
    WCS::internal::absorb_small_regions(
        trial.graph, WCS::internal::Region_cost(trial.graph, scale, parameters), parameters, log);
    return trial.graph.labels();
  }

  std::filesystem::path m_data;
  std::vector<Tree_table> m_tables;
  WCS::Parameters m_parameters;
};

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const std::string task = argc > 1 ? argv[1] : "";
    if (task == "names")
    {
      for (const auto& name : WCS::internal::Pair_features::names())
        std::cout << name.name << ' ' << name.monotone << '\n';
      return 0;
    }
    if (task == "samples" && argc >= 5)
      Fitting(argv[2], argc > 5 ? argv[5] : "").samples(variant_of_name(argv[3]), argv[4]);
    else if (task == "score" && argc >= 6)
    {
      std::vector<double> thresholds;
      for (int i = 5; i < argc; ++i) thresholds.push_back(std::atof(argv[i]));
      Fitting(argv[2], argv[4]).score(variant_of_name(argv[3]), thresholds);
    }
    else
      throw std::invalid_argument("see the head of fit_merge_cost.cpp for the calls");
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "fit_merge_cost: " << error.what() << '\n';
    return 1;
  }
}
