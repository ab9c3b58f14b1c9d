// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_RULES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_RULES_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/component_fusion.h>
#include <CGAL/Weakly_convex_segmentation/internal/component_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/cost_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/fitted_cost_table.h>
#include <CGAL/Weakly_convex_segmentation/internal/fitted_merging.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <memory>

// What becomes components and segments (sections 4 and 5), in three ways: by the default's cost, by the
// fitted one, and by the paper's rules.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// How the regions of a graph are fused and merged.
class Merging_rules
{
public:
  virtual ~Merging_rules() = default;
  /// fuses patches into weakly convex components.
  virtual void fuse(const Contraction_log& log) = 0;
  /// merges components into segments.
  virtual void merge(const Contraction_log& log) = 0;
  /// returns the highest cost at which components become segments.
  virtual double merging_threshold() const = 0;
  /// returns the cost of merging what lies beyond the segments, for the order of the merge tree.
  virtual double cost_beyond(int a, int b) = 0;
};

/// The default's cost.
class Cost_rules : public Merging_rules
{
public:
  Cost_rules(const Shape_analysis& shape, const Patches& patches, Region_graph& graph,
             const Parameters& parameters)
    : m_graph(graph), m_parameters(parameters), m_scale(scale(parameters)),
      m_cost(graph, patches, shape.diameters, m_scale, parameters)
  {
    set_signatures(graph, patches, shape.diameters, m_scale);
    graph.add_shapes(shape.points(), shape.graph, patches, shape.diameters);
  }
  void fuse(const Contraction_log& log) override
  {
    contract_by_cost(m_graph, m_cost, m_parameters.merging_cost, m_parameters.fusion_threshold,
                     log);
  }
  void merge(const Contraction_log& log) override
  {
    contract_by_cost(m_graph, m_cost, m_parameters.merging_cost, m_parameters.merging_threshold,
                     log);
    absorb_small_regions(m_graph, m_cost, m_parameters, log);
  }
  double merging_threshold() const override { return m_parameters.merging_threshold; }
  double cost_beyond(const int a, const int b) override // no more lines of sight
  {
    return m_cost.blind(a, b, m_parameters.merging_cost);
  }

private:
  static Histogram_scale scale(const Parameters& parameters)
  {
    Histogram_scale scale;
    scale.bins = parameters.histogram_bins;
    return scale;
  }

  Region_graph& m_graph;
  const Parameters& m_parameters;
  Histogram_scale m_scale;
  Region_cost m_cost;
};

/// The cost that is fitted to people's segmentations.
class Fitted_rules : public Merging_rules
{
public:
  Fitted_rules(const Shape_analysis& shape, const Patches& patches, Region_graph& graph,
               const Parameters& parameters)
    : m_graph(graph), m_parameters(parameters), m_features(graph, patches, shape.diameters),
      m_cost(m_features, fitted_trees()),
      m_plain_cost(graph, patches, shape.diameters, m_scale, parameters)
  {
    set_signatures(graph, patches, shape.diameters, m_scale);
    graph.add_shapes(shape.points(), shape.graph, patches, shape.diameters);
    graph.add_profiles(shape.points(), shape.graph, patches);
  }
  void fuse(const Contraction_log& log) override
  {
    contract_fitted(m_graph, m_cost, m_parameters.fitted_fusion_threshold, log);
  }
  void merge(const Contraction_log& log) override
  {
    contract_fitted(m_graph, m_cost, m_parameters.fitted_merging_threshold, log);
    absorb_small_regions(m_graph, m_plain_cost, m_parameters, log);
  }
  double merging_threshold() const override { return m_parameters.fitted_merging_threshold; }
  double cost_beyond(const int a, const int b) override { return m_cost(a, b); }

private:
  Region_graph& m_graph;
  const Parameters& m_parameters;
  Histogram_scale m_scale;
  Pair_features m_features;
  Fitted_cost m_cost;
  Region_cost m_plain_cost;
};

/// The rules of the paper.
class Paper_rules : public Merging_rules
{
public:
  Paper_rules(const Shape_analysis& shape, const Patches& patches, Region_graph& graph,
              const Parameters& parameters, const bool parallel)
    : m_shape(shape), m_graph(graph), m_parameters(parameters),
      m_signatures(shape.points(), patches, parameters, parallel)
  {}
  void fuse(const Contraction_log& log) override { fuse_components(m_graph, m_parameters, log); }
  void merge(const Contraction_log& log) override
  {
    merge_components(m_graph, m_signatures, m_shape.diameters, m_parameters, log);
  }
  double merging_threshold() const override { return m_parameters.signature_threshold; }
  double cost_beyond(const int a, const int b) override { return 2. - m_graph.visibility(a, b); }

private:
  const Shape_analysis& m_shape;
  Region_graph& m_graph;
  const Parameters& m_parameters;
  Component_signatures m_signatures;
};

/// returns the rules that are asked for, for regions made of these patches.
inline std::unique_ptr<Merging_rules> make_rules(const Shape_analysis& shape,
                                                 const Patches& patches, Region_graph& graph,
                                                 const Parameters& parameters, const bool parallel)
{
  if (parameters.merging == Merging_rule::COST)
    return std::make_unique<Cost_rules>(shape, patches, graph, parameters);
  if (parameters.merging == Merging_rule::FITTED)
    return std::make_unique<Fitted_rules>(shape, patches, graph, parameters);
  return std::make_unique<Paper_rules>(shape, patches, graph, parameters, parallel);
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_RULES_H
