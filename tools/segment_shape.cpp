// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments a shape in a file, or a generated one, and writes the parts. See --help.

#include "io/cut_shape.h"
#include "io/gaps.h"
#include "io/nearest_elements.h"
#include "io/shape_io.h"
#include "program/cgal_diameters.h"
#include "program/interruption.h"
#include "program/program_errors.h"
#include "program/segment_options.h"
#include "program/segment_outputs.h"
#include "program/segment_progress.h"
#include "program/segment_report.h"
#include "program/thread_limit.h"
#include "shapes/shape_generator.h"
#include "view/write_view.h"

#include <CGAL/assertions_behaviour.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Segment_shape::Options;
using Segment_shape::Run;
using Shape_io::Shape;

Shape generated_shape(const std::string& name)
{
  const Shape_generator::Labeled_mesh mesh = Shape_generator::make_mesh(name);
  Shape shape;
  for (const auto& p : mesh.points) shape.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : mesh.faces) shape.polygons.emplace_back(f.begin(), f.end());
  return shape;
}

// The elements of a cloud are its indices: the maps look points and normals up where they lie.
template <typename Concurrency_tag, typename Named_parameters>
WCS::Result segment_cloud(const Shape& shape, const WCS::Parameters& parameters,
                          const Named_parameters& np)
{
  std::vector<std::size_t> indices(shape.points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  std::vector<int> labels(shape.points.size());
  const auto label_map = CGAL::make_property_map(labels);
  const auto with_points = np.point_map(CGAL::make_property_map(shape.points));
  if (shape.normals.empty())
    return CGAL::weakly_convex_segmentation<Concurrency_tag>(indices, label_map, parameters,
                                                             with_points);
  return CGAL::weakly_convex_segmentation<Concurrency_tag>(
      indices, label_map, parameters,
      with_points.normal_map(CGAL::make_property_map(shape.normals)));
}

template <typename Concurrency_tag>
WCS::Result segment_with(const Shape& shape, const Options& options,
                         Segment_shape::Stage_times& stages, Segment_shape::Progress_line& progress)
{
  const std::function<bool(double)> go_on = [&](const double share)
  {
    progress.segmenting(share, stages.name());
    return !Program_errors::Interruption::happened();
  };
  const auto np = CGAL::parameters::callback(go_on).visitor(std::ref(stages));
  const bool has_given = options.parameters.diameter == WCS::Diameter_rule::GIVEN;
  if (has_given && !shape.is_mesh())
    throw std::invalid_argument("a cloud of points has no diameters by CGAL; use --diameters own");
  if (shape.is_mesh())
  {
    if (has_given) progress.segmenting(0., "diameters");
    const std::vector<double> diameters =
        has_given ? Segment_shape::cgal_diameters(shape, options.parameters)
                  : std::vector<double>();
    WCS::Segmenter<Concurrency_tag> segmenter(shape.points, shape.polygons, options.parameters, np);
    if (has_given) segmenter.set_diameters(diameters);
    return segmenter.segment(options.parameters);
  }
  return segment_cloud<Concurrency_tag>(shape, options.parameters, np);
}

WCS::Result segment(const Shape& shape, const Options& options, Segment_shape::Stage_times& stages,
                    Segment_shape::Progress_line& progress)
{
  using Segment_shape::Thread_limit;
  const Thread_limit limit(options.number_of_threads);
  if (options.number_of_threads == 1)
    return segment_with<CGAL::Sequential_tag>(shape, options, stages, progress);
  if (!Thread_limit::has_threads && options.number_of_threads > 1 && !options.quiet)
  {
    progress.wipe();
    std::cerr << "segment_shape: built without TBB, so one thread is used\n";
  }
  return segment_with<CGAL::Parallel_if_available_tag>(shape, options, stages, progress);
}

Shape_io::Parts parts_at(const WCS::Level level, const Shape& shape, const WCS::Result& result)
{
  Shape_io::Parts parts;
  parts.labels = result.labels_at(level);
  for (const int label : result.labels)
    parts.quality.push_back(result.segments[static_cast<std::size_t>(label)].convexity_rank);

  Shape_io::Neighbors neighbors;
  if (level == WCS::Level::SEGMENTS)
    for (const WCS::Segment& s : result.segments) neighbors.push_back(s.neighbors);
  else
  {
    const int last = *std::max_element(parts.labels.begin(), parts.labels.end());
    neighbors = Shape_io::part_neighbors(shape, parts.labels, static_cast<std::size_t>(last) + 1);
  }
  parts.colors = Shape_io::part_colors(neighbors);
  return parts;
}

// The parts of what the labels are carried to.
Shape_io::Parts parts_of_nearest(const Shape& from, const Shape_io::Parts& parts, const Shape& to)
{
  Shape_io::Parts result;
  result.colors = parts.colors;
  for (const std::size_t source : Shape_io::nearest_elements(from, to))
  {
    const bool is_known = source != Shape_io::no_element;
    result.labels.push_back(is_known ? parts.labels[source] : -1);
    result.quality.push_back(is_known ? parts.quality[source] : 0.);
  }
  return result;
}

// The parts of what is cut: of its own level with its cut borders, else of the faces that pieces come from.
Shape_io::Parts parts_of_pieces(const Shape_io::Cut_shape& cut, const Shape_io::Parts& of_faces)
{
  Shape_io::Parts result;
  result.colors = of_faces.colors;
  for (const std::size_t face : cut.source_faces)
  {
    result.labels.push_back(of_faces.labels[face]);
    result.quality.push_back(of_faces.quality[face]);
  }
  return result;
}

// Where the page without a shape is. It is made with the project, or lies where the user says.
std::string path_of_page()
{
  const char* const folder = std::getenv("WCS_VIEW_DIR");
  return std::string(folder ? folder : WEAKLY_CONVEX_SEGMENTATION_VIEW_DIR) + "/page.html";
}

template <typename Parts_of>
void write_view(Segment_shape::Outputs& outputs,
                const std::optional<Segment_shape::View_page>& page, const Shape& shape,
                const Parts_of& parts_of, const Run& run)
{
  outputs.write_view(page, shape,
                     {{"patches", "patch", parts_of(WCS::Level::PATCHES)},
                      {"components", "component", parts_of(WCS::Level::COMPONENTS)},
                      {"segments", "segment", parts_of(WCS::Level::SEGMENTS)}},
                     run);
}

template <typename Parts_of>
void write_cut(Segment_shape::Outputs& outputs, const std::optional<Segment_shape::View_page>& page,
               const Shape& shape, const Parts_of& parts_of, const Run& run, const WCS::Level level)
{
  const Shape_io::Cut_shape cut = Shape_io::cut_shape(shape, parts_of(level));
  outputs.write(cut.shape, cut.parts);
  const auto parts_of_cut = [&](const WCS::Level other)
  { return other == level ? cut.parts : parts_of_pieces(cut, parts_of(other)); };
  if (page) write_view(outputs, page, cut.shape, parts_of_cut, run);
}

// OBJ names the files of its materials relative to itself.
void print_material_files(std::ostream& out, const Options& options, const Shape& written)
{
  if (written.material_files.empty()) return;
  namespace fs = std::filesystem;
  const auto folder_of = [](const std::string& file)
  { return fs::absolute(fs::path(file)).lexically_normal().parent_path(); };
  const std::string& read = options.dense_file.empty() ? options.input : options.dense_file;
  std::vector<fs::path> folders;
  if (Segment_shape::internal::is_obj_file(options.parts_file))
    folders.push_back(folder_of(options.parts_file));
  if (!options.split_folder.empty()) folders.push_back(folder_of(options.split_folder + "/part"));
  for (const fs::path& folder : folders)
    if (read == "-" || folder != folder_of(read))
      for (const std::string& file : written.material_files)
        out << "note: for its materials '" << Program_errors::one_line(file) << "' must lie in "
            << folder.string() << '\n';
}

void print_files(std::ostream& out, const Options& options, const Shape& written)
{
  for (const std::string& file : Segment_shape::output_files(options))
    if (file != "-") out << "wrote " << file << '\n';
  if (!options.split_folder.empty()) out << "wrote parts to " << options.split_folder << '\n';
  if (Segment_shape::has_hull_folder(options)) out << "wrote hulls to " << options.hulls << '\n';
  const std::string renamed = Shape_io::renamed_properties(written);
  if (!renamed.empty() && !(options.parts_file.empty() && options.split_folder.empty()))
    out << "kept " << renamed << '\n';
  print_material_files(out, options, written);
}

std::string name_of_input(const Options& options)
{
  if (options.input.empty()) return options.shape + " (generated)";
  return options.input == "-" ? "standard input" : options.input;
}

Shape read(const std::string& path) { return Shape_io::read_shape(path, Shape_io::Gaps::ALLOWED); }

void check_outputs(const Options& options)
{
  std::vector<std::string> files = Segment_shape::output_files(options);
  Shape_io::check_output_places(files, {options.input, options.dense_file});
  for (const std::string& file : files) Shape_io::Atomic_file::check(file);
  files.insert(files.end(), {options.input, options.dense_file});
  if (!options.split_folder.empty())
    Segment_shape::Split_folder::check_no_part(options.split_folder, "part", files);
  if (Segment_shape::has_hull_folder(options))
    Segment_shape::Split_folder::check_no_part(options.hulls, "hull", files);
  std::error_code error;
  if (options.is_named_by_us && std::filesystem::exists(options.parts_file, error) &&
      !Shape_io::is_written_by_us(options.parts_file))
    throw Shape_io::File_error("there is a file '" + options.parts_file +
                               "' that is no earlier result; name another one with -o");
}

void segment_shape(const Options& options)
{
  check_outputs(options);
  std::optional<Segment_shape::View_page> page;
  if (!options.view_file.empty()) page.emplace(path_of_page());
  Run run;
  run.name = name_of_input(options);
  Segment_shape::Progress_line progress(options.quiet);
  const Segment_shape::Stopwatch reading;
  progress.reading(run.name);
  const Shape shape = options.input.empty() ? generated_shape(options.shape) : read(options.input);
  std::optional<Shape> dense;
  if (!options.dense_file.empty()) progress.reading(options.dense_file);
  if (!options.dense_file.empty()) dense = read(options.dense_file);
  run.seconds_of_reading = reading.seconds();
  const Shape& written = dense ? *dense : shape;
  if (options.is_cut) Shape_io::check_can_be_cut(written);
  if (options.is_closed && !written.is_mesh())
    throw std::invalid_argument(
        "a cloud of points has no surface that could be closed; give a mesh, or leave out --close");
  const Shape_io::Measured_shape measured(shape);
  run.number_of_gaps = measured.number_of_gaps();

  const Program_errors::Interruption interruption;
  Segment_shape::Outputs outputs(options, progress);
  const Segment_shape::Stopwatch segmentation;
  run.result = segment(measured.shape(), options, run.stages, progress);
  run.seconds_of_segmentation = segmentation.seconds();
  const auto parts_of = [&](const WCS::Level level)
  {
    const Shape_io::Parts parts = parts_at(level, measured.shape(), run.result);
    return dense ? parts_of_nearest(measured.shape(), parts, *dense) : measured.spread(parts);
  };
  if (options.is_cut)
    write_cut(outputs, page, written, parts_of, run, options.level);
  else
  {
    outputs.write(written, parts_of(options.level));
    if (page) write_view(outputs, page, written, parts_of, run);
  }
  outputs.write_stats(shape, run);
  outputs.finish();
  progress.wipe();
  const std::vector<std::string> files = Segment_shape::output_files(options);
  const bool is_standard_output_taken = std::count(files.begin(), files.end(), "-") > 0;
  std::ostream& out = is_standard_output_taken ? std::cerr : std::cout;
  if (!options.quiet) Segment_shape::print_summary(out, shape, run);
  // before the files take their places: if this fails there are to be none
  Program_errors::flush_standard_output();
  outputs.commit();
  if (options.quiet) return;
  for (const std::string& note : outputs.notes()) out << "  note: " << note << '\n';
  print_files(out, options, written);
}

void run_program(const int argc, const char* const argv[])
{
  const Options options = Segment_shape::read_options(argc, argv);
  if (options.help)
    Segment_shape::print_help(std::cout);
  else if (options.version)
    std::cout << "segment_shape " << WEAKLY_CONVEX_SEGMENTATION_VERSION << ", with CGAL "
              << CGAL_STRINGIZE(CGAL_VERSION) << '\n';
  else
    segment_shape(options);
}

} // namespace

int main(const int argc, char* argv[])
{
  // CGAL prints errors before it throws them; they are printed once, as one line.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  return Program_errors::run("segment_shape",
                             [&]
                             {
                               try
                               {
                                 run_program(argc, argv);
                               }
                               catch (const WCS::Canceled&)
                               {
                                 throw std::runtime_error(Program_errors::Interruption::message());
                               }
                             });
}
