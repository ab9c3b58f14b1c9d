// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/segment_report.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <set>

namespace Segment_shape {
namespace internal {

namespace {

double share_of(const WCS::Segment& segment, const Shape_io::Shape& shape, const Run& run)
{
  return static_cast<double>(segment.size) /
         static_cast<double>(shape.number_of_elements() - run.number_of_gaps);
}

nlohmann::ordered_json json_of_seconds(const Run& run)
{
  nlohmann::ordered_json stages;
  for (std::size_t i = 0; i < WCS::number_of_stages; ++i)
  {
    const auto stage = static_cast<WCS::Stage>(i);
    stages[WCS::stage_name(stage)] = run.stages.seconds(stage);
  }
  return {{"reading", run.seconds_of_reading},
          {"segmentation", run.seconds_of_segmentation},
          {"stages", stages}};
}

} // namespace

nlohmann::ordered_json json_of_segments(const Run& run, const Shape_io::Shape& shape)
{
  nlohmann::ordered_json segments = nlohmann::ordered_json::array();
  for (std::size_t label = 0; label < run.result.segments.size(); ++label)
  {
    const WCS::Segment& segment = run.result.segments[label];
    segments.push_back({{"label", label},
                        {"size", segment.size},
                        {"share", share_of(segment, shape, run)},
                        {"convexity_rank", segment.convexity_rank},
                        {"diameter", segment.diameter},
                        {"neighbors", segment.neighbors}});
  }
  return segments;
}

} // namespace internal

void write_stats(std::ostream& out, const Options& options, const Shape_io::Shape& shape,
                 const Run& run)
{
  const nlohmann::ordered_json stats = {
      {"input", run.name},
      {"kind", shape.is_mesh() ? "mesh" : "cloud"},
      {"number_of_points", shape.points.size()},
      {"number_of_faces", shape.polygons.size()},
      {"number_of_gaps", run.number_of_gaps},
      {"notes", shape.notes},
      {"preset", options.preset},
      {"stage", options.stage},
      {"seed", options.parameters.seed},
      {"seconds", internal::json_of_seconds(run)},
      {"number_of_patches", run.result.merge_tree.number_of_patches()},
      {"number_of_components", run.result.number_of_components},
      {"number_of_segments", run.result.number_of_segments()},
      {"has_flipped_normals", run.result.has_flipped_normals},
      {"has_doubtful_normals", run.result.has_doubtful_normals},
      {"segments", internal::json_of_segments(run, shape)}};
  // The name of a file need not be UTF-8, but JSON must be.
  out << stats.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void print_summary(std::ostream& out, const Shape_io::Shape& shape, const Run& run)
{
  constexpr std::size_t most_lines = 20;
  out << std::fixed << std::setprecision(2) << run.name << ": " << shape.points.size()
      << " points, ";
  if (shape.is_mesh()) out << shape.polygons.size() << " faces, ";
  if (run.number_of_gaps > 0) out << run.number_of_gaps << " of them without coordinates, ";
  out << run.result.merge_tree.number_of_patches() << " patches, "
      << run.result.number_of_components << " components, " << run.result.number_of_segments()
      << " segments in " << run.seconds_of_segmentation << " s\n";
  const std::size_t number_of_lines = (std::min)(run.result.segments.size(), most_lines);
  for (std::size_t label = 0; label < number_of_lines; ++label)
  {
    const WCS::Segment& segment = run.result.segments[label];
    out << "  segment " << label << ": " << segment.size << ' ' << shape.element_name() << " ("
        << 100. * internal::share_of(segment, shape, run) << " %), convexity rank "
        << segment.convexity_rank << '\n';
  }
  if (number_of_lines < run.result.segments.size())
    out << "  and " << run.result.segments.size() - number_of_lines << " more\n";
  for (const std::string& note : shape.notes) out << "  note: " << note << '\n';
  if (run.result.has_flipped_normals)
    out << "  note: normals that point inwards were turned for the run\n";
  if (run.result.has_doubtful_normals)
    out << "  warning: the normals contradict each other; try the points without them\n";
}

} // namespace Segment_shape
