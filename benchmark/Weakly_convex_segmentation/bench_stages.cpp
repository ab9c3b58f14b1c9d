// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "common/speed_shapes.h"

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

// Time a stage on an ordinary shape of any number of points, each stage on its own.

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using namespace WCS::internal;

const Raw_shape& raw_points(const std::size_t size)
{
  static std::map<std::size_t, Raw_shape> made;
  Raw_shape& raw = made[size];
  if (!raw.positions.empty()) return raw;
  for (const auto& [p, n] : Speed_shapes::ordinary(size))
  {
    raw.positions.push_back({p.x(), p.y(), p.z()});
    raw.normals.push_back({n.x(), n.y(), n.z()});
  }
  return raw;
}

const Shape_analysis& analyzed(const std::size_t size)
{
  static std::map<std::size_t, std::unique_ptr<Shape_analysis>> made;
  auto& shape = made[size];
  if (!shape) shape = analyze_shape(raw_points(size), WCS::Parameters(), Run_control());
  return *shape;
}

std::size_t size_of(const benchmark::State& state)
{
  return static_cast<std::size_t>(state.range(0));
}

void sampling(benchmark::State& state)
{
  const Raw_shape& raw = raw_points(size_of(state));
  const WCS::Parameters parameters;
  for (auto _ : state)
    benchmark::DoNotOptimize(downsample(orient_points(raw), parameters.number_of_representatives));
}

void neighbors(benchmark::State& state)
{
  Oriented_points points = analyzed(size_of(state)).points();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        build_neighbor_graph(points, WCS::Parameters().number_of_neighbors, false));
}

void patches(benchmark::State& state)
{
  const Shape_analysis& shape = analyzed(size_of(state));
  WCS::Parameters parameters;
  parameters.number_of_patch_sets = 1;
  for (auto _ : state)
    benchmark::DoNotOptimize(extract_patch_sets(shape.points(), shape.graph, parameters, false,
                                                WCS::Spectral_patch_clustering()));
}

void disks(benchmark::State& state)
{
  const Shape_analysis& shape = analyzed(size_of(state));
  for (auto _ : state)
    benchmark::DoNotOptimize(Line_of_sight_query(shape.points(), shape.graph, WCS::Parameters()));
}

void diameters(benchmark::State& state)
{
  const Shape_analysis& shape = analyzed(size_of(state));
  for (auto _ : state)
    benchmark::DoNotOptimize(shape_diameters(*shape.sight, WCS::Parameters(), false));
}

// lines of sight between all patches, as many as a contraction asks for at most
void visibility(benchmark::State& state)
{
  const Shape_analysis& shape = analyzed(size_of(state));
  std::vector<std::pair<int, int>> pairs;
  for (int b = 0; b < static_cast<int>(shape.patches().size()); ++b)
    for (int a = 0; a < b; ++a) pairs.push_back({a, b});
  for (auto _ : state)
  {
    Patch_visibility lines(*shape.sight, shape.patches(), WCS::Parameters(), false);
    lines.prepare(pairs);
    benchmark::DoNotOptimize(lines(0, 1));
  }
}

void borders(benchmark::State& state)
{
  const Shape_analysis& shape = analyzed(size_of(state));
  for (auto _ : state)
  {
    std::vector<int> labels = shape.patches().of_point;
    benchmark::DoNotOptimize(refine_borders(shape.graph, WCS::Parameters(), labels));
  }
}

void sizes(benchmark::internal::Benchmark* stage)
{
  stage->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK(sampling)->Apply(sizes);
BENCHMARK(neighbors)->Apply(sizes);
BENCHMARK(patches)->Apply(sizes);
BENCHMARK(disks)->Apply(sizes);
BENCHMARK(visibility)->Apply(sizes);
BENCHMARK(diameters)->Apply(sizes);
BENCHMARK(borders)->Apply(sizes);
BENCHMARK_MAIN();
