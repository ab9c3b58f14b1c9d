// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The C++ side of fitting the merge cost of the `fitted` preset to labeled shapes; fit_merge_cost.py
// trains and calls it.
//
//   fit_merge_cost samples DATA_DIR OUT.bin [TABLES]  features, targets and weights of pairs of regions
//   fit_merge_cost score DATA_DIR TABLES THRESHOLD    1 - Rand Index of the trees' segmentations
//
// TABLES is a folder with a table of trees for each category, NAME.txt; with `samples` the pairs are
// then those on the trees' own path instead of the default cost's.

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
#include <optional>
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
                                                               {Variant::TWO_VIEWS, "2 views"},
                                                               {Variant::FOUR_VIEWS, "4 views"}};

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

  void samples(const std::filesystem::path& path) const
  {
    std::ofstream out(path, std::ios::binary);
    for (const auto& [variant, name] : variants)
    {
      std::cout << "samples of " << name << '\n' << std::flush;
      for_each_model(variant, [&](Trial& trial) { write_samples(trial, path_cost(trial), out); });
    }
    if (!out.flush()) throw std::runtime_error("can't write " + path.string());
  }

  void score(const double threshold) const
  {
    for (const auto& [variant, name] : variants)
    {
      std::map<std::size_t, std::vector<double>> errors, default_errors;
      double segments = 0., models = 0.;
      for_each_model(variant,
                     [&](Trial& trial)
                     {
                       const std::size_t category = SM::category_of_model(trial.model.number);
                       const auto fitted = fitted_regions(trial, threshold);
                       errors[category].push_back(Patch_scores::rand_error(trial.model, fitted));
                       const auto plain = WCS::internal::regions_at(
                           WCS::internal::merge_patches(*trial.model.shape, m_parameters, {}),
                           WCS::Level::SEGMENTS);
                       default_errors[category].push_back(
                           Patch_scores::rand_error(trial.model, plain));
                       segments += 1. + *std::max_element(fitted.begin(), fitted.end());
                       models += 1.;
                     });
      std::cout << name << ": fitted " << mean_of_means(errors) << ", default "
                << mean_of_means(default_errors) << ", " << segments / models << " segments\n"
                << std::flush;
      if (variant == Variant::MESH)
        for (const auto& [category, values] : errors)
          std::cout << "  " << SM::category_names()[category] << ' ' << mean_of_means({{0, values}})
                    << ' ' << mean_of_means({{0, default_errors[category]}}) << '\n';
    }
  }

private:
  static double mean_of_means(const std::map<std::size_t, std::vector<double>>& errors)
  {
    double sum = 0.;
    for (const auto& entry : errors)
    {
      double within = 0.;
      for (const double e : entry.second) within += e;
      sum += within / static_cast<double>(entry.second.size());
    }
    return sum / static_cast<double>(errors.size());
  }

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
    if (task == "samples" && argc >= 4)
      Fitting(argv[2], argc > 4 ? argv[4] : "").samples(argv[3]);
    else if (task == "score" && argc == 5)
      Fitting(argv[2], argv[3]).score(std::atof(argv[4]));
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
