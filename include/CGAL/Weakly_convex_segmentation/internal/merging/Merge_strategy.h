// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_MERGE_STRATEGY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_MERGE_STRATEGY_H

// What becomes components and segments (sections 4 and 5): by a cost, such as the default's or the learned
// one, or by the paper's rules.

#include <CGAL/Weakly_convex_segmentation/Merge_cost.h>
#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/oracle_functions.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Learned_cost.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/Region_cost.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/learned_cost_table.h>
#include <CGAL/Weakly_convex_segmentation/internal/merging/paper_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <limits>
#include <memory>
#include <utility>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// How the regions of a graph are fused and merged.
class Merge_strategy
{
public:
  virtual ~Merge_strategy() = default;
  /// fuses patches into weakly convex components.
  virtual void fuse(const Contraction_log& log) = 0;
  /// merges components into segments.
  virtual void merge(const Contraction_log& log) = 0;
  /// returns the highest cost at which components become segments.
  virtual double merging_threshold() const = 0;
  /// returns the cost of merging what lies beyond the segments, for the order of the merge tree.
  virtual double cost_above_threshold(int a, int b) = 0;
};

/// Contraction by ascending cost, of any model of `WeaklyConvexSegmentationMergeCost`.
class Cost_strategy : public Merge_strategy
{
public:
  Cost_strategy(const Shape_analysis& shape, const Patches& patches, Region_graph& graph,
                const Parameters& parameters, Merge_cost cost)
    : m_graph(graph), m_parameters(parameters), m_cost(std::move(cost)),
      m_measures(graph, patches, shape.diameters, m_scale)
  {
    set_signatures(graph, patches, shape.diameters, m_scale);
    graph.add_shapes(shape.points(), shape.graph, patches, shape.diameters);
    if (!m_cost.uses_cut_probability) return;
    graph.add_profiles(shape.points(), shape.graph, patches);
    m_features = std::make_unique<Pair_features>(graph, patches, shape.diameters);
    m_learned = std::make_unique<Learned_cost>(*m_features, learned_trees());
  }
  void fuse(const Contraction_log& log) override { contract_up_to(m_cost.fusion_threshold, log); }
  void merge(const Contraction_log& log) override
  {
    contract_up_to(m_cost.merging_threshold, log);
    absorb_small_regions(m_graph, m_measures, m_parameters, log);
  }
  double merging_threshold() const override { return m_cost.merging_threshold; }
  double cost_above_threshold(const int a, const int b) override
  {
    return m_cost.cost({m_measures, m_learned.get(), a, b, true},
                       std::numeric_limits<double>::infinity());
  }

private:
  void contract_up_to(const double threshold, const Contraction_log& log)
  {
    internal::contract_up_to(
        m_graph,
        [&](const int a, const int b) {
          return m_cost.cost({m_measures, m_learned.get(), a, b, false}, threshold);
        },
        threshold, log);
  }

  Region_graph& m_graph;
  const Parameters& m_parameters;
  Merge_cost m_cost;
  Histogram_scale m_scale;
  Region_cost m_measures;
  std::unique_ptr<Pair_features> m_features; ///< where the cost uses the learned probability
  std::unique_ptr<Learned_cost> m_learned;
};

/// The rules of the paper.
class Paper_strategy : public Merge_strategy
{
public:
  Paper_strategy(const Shape_analysis& shape, const Patches& patches, Region_graph& graph,
                 const Parameters& parameters, const bool parallel)
    : m_shape(shape), m_graph(graph), m_parameters(parameters),
      m_signatures(shape.points(), patches, parameters, parallel)
  {}
  void fuse(const Contraction_log& log) override { fuse_components(m_graph, m_parameters, log); }
  void merge(const Contraction_log& log) override
  {
    merge_components(m_graph, m_signatures, m_shape.diameters, m_parameters, log);
  }
  double merging_threshold() const override { return m_parameters.merging_threshold; }
  double cost_above_threshold(const int a, const int b) override
  {
    return 2. - m_graph.visibility(a, b);
  }

private:
  const Shape_analysis& m_shape;
  Region_graph& m_graph;
  const Parameters& m_parameters;
  Component_signatures m_signatures;
};

/// returns the strategy that is asked for, for regions made of these patches; that of the own cost if there is
/// one.
inline std::unique_ptr<Merge_strategy>
make_strategy(const Shape_analysis& shape, const Patches& patches, Region_graph& graph,
              const Parameters& parameters, const bool parallel, const Merge_cost& own_cost = {})
{
  const auto by_cost = [&](const Merge_cost& cost)
  { return std::make_unique<Cost_strategy>(shape, patches, graph, parameters, cost); };
  if (own_cost.cost) return by_cost(own_cost);
  if (parameters.merging == Merging_rule::COST)
    return by_cost(Merge_cost(Weighted_merge_cost(parameters)));
  if (parameters.merging == Merging_rule::FITTED)
    return by_cost(Merge_cost(Learned_merge_cost(parameters)));
  return std::make_unique<Paper_strategy>(shape, patches, graph, parameters, parallel);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_MERGE_STRATEGY_H
