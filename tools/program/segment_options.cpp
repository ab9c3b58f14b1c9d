// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/segment_options.h"

#include "program/command_line.h"
#include "program/set_parameter.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace Segment_shape {

namespace internal {

namespace {

namespace po = boost::program_options;

bool has_extension(const std::string& path, const std::string& lower, const std::string& upper)
{
  const std::string end = path.substr(path.size() - (std::min)(path.size(), lower.size()));
  return end == lower || end == upper;
}

} // namespace

bool is_obj_file(const std::string& path) { return has_extension(path, ".obj", ".OBJ"); }

} // namespace internal

bool has_hull_folder(const Options& options)
{
  const std::filesystem::path path = options.hulls;
  if (path.empty() || path == "-") return false;
  std::error_code error;
  return std::filesystem::is_directory(path, error) ||
         (!std::filesystem::exists(path, error) && !path.has_extension());
}

std::vector<std::string> output_files(const Options& options)
{
  std::vector<std::string> files;
  for (const std::string& file : {options.parts_file, options.labels_file, options.stats_file,
                                  has_hull_folder(options) ? "" : options.hulls, options.view_file})
    if (!file.empty()) files.push_back(file);
  return files;
}

namespace internal {

namespace {

// All numbers are read as signed ones: read as unsigned, -1 would be a large number.
struct Numbers
{
  long long segments = 0, max_segments = 0, seed = 0, threads = 0;
  long long max_hulls = 0, hull_vertices = 0;
  double min_segment_share = 0., hull_error = 0.;
  std::vector<std::string> settings; ///< NAME=VALUE
};

po::options_description described_outputs(Options& options, Numbers& numbers)
{
  po::options_description result("Files that are written (without any: INPUT_parts.ply)");
  auto add = result.add_options();
  add("output,o", po::value(&options.parts_file)->value_name("PARTS.ply"),
      "write the input with a color, an int label and a float quality for each part as PLY; or, if "
      "the name ends in .obj, as OBJ with a group a part");
  add("labels", po::value(&options.labels_file)->value_name("PARTS.seg"),
      "write one label a line, in the order of the input");
  add("stats", po::value(&options.stats_file)->value_name("STATS.json"),
      "write counts, seconds and the numbers of each part as JSON");
  add("view", po::value(&options.view_file)->value_name("PARTS.html"),
      "write a page for a browser: turn the shape, step through the stages, pull the parts apart");
  add("split", po::value(&options.split_folder)->value_name("FOLDER"),
      "write each part as a file of its own, FOLDER/part_0.ply and so on (.obj if INPUT is OBJ "
      "with materials or texture coordinates), in place of those of an earlier run");
  add("close", po::bool_switch(&options.is_closed),
      "write the parts of --split as closed solids, with caps over their cuts, as printers take "
      "them; says which could not be closed");
  add("cut", po::bool_switch(&options.is_cut),
      "split the faces of a mesh along the smoothed borders of the parts, for all outputs but the "
      "numbers of STATS; "
      "PLY files tell the face of the input that each face is of, source_face");
  add("hulls", po::value(&options.hulls)->value_name("HULLS"),
      "write the convex hulls of the parts: HULLS.ply or HULLS.obj as one mesh (OBJ: a group a "
      "hull), HULLS as a folder with a file a hull; flat parts have none");
  add("hull-error", po::value(&numbers.hull_error)->value_name("E"),
      "cut parts of a mesh by planes until each hull is nearer than E to its part, in diagonals of "
      "the box of the shape (such as 0.02)");
  add("max-hulls", po::value(&numbers.max_hulls)->value_name("N"),
      "join hulls until there are at most N");
  add("hull-vertices", po::value(&numbers.hull_vertices)->value_name("N"),
      "leave out corners until no hull has more than N");
  add("transfer", po::value(&options.dense_file)->value_name("DENSE.ply"),
      "give all outputs for this shape instead, each point or face with the part of INPUT that it "
      "is nearest to");
  add("ascii", po::bool_switch(&options.ascii), "write PLY files as text");
  return result;
}

po::options_description described_method(Options& options, Numbers& numbers)
{
  po::options_description result("How it is segmented");
  auto add = result.add_options();
  add("preset", po::value(&options.preset)->value_name("default|training_free|paper"),
      "parameters: the best known, which are fitted to people's parts (default), a weighted cost "
      "without that (training_free), or those of the paper");
  add("segments", po::value(&numbers.segments)->value_name("N"),
      "make N segments, if the shape can be cut into so many");
  add("max-segments", po::value(&numbers.max_segments)->value_name("N"),
      "join segments until there are at most N");
  add("min-segment-size", po::value(&numbers.min_segment_share)->value_name("SHARE"),
      "give segments under this share of the shape, 0 to 1, to a neighbor (default: that of "
      "the preset)");
  add("stage", po::value(&options.stage)->value_name("patches|components|segments"),
      "granularity of the labels (default: segments)");
  add("pieces", po::value(&options.pieces)->value_name("joined|separate|whole"),
      "whether the connected pieces of a mesh may share a part, are objects of their own, or are "
      "not even cut (default: that of the preset, separate but for paper)");
  add("diameters", po::value(&options.diameters)->value_name("own|cgal"),
      "how thick the shape is at a face: measured on points, or by CGAL's shape diameter function, "
      "which takes "
      "longer and needs a manifold mesh of triangles (default: own)");
  add("set", po::value(&numbers.settings)->value_name("NAME=VALUE"),
      "set a member of Parameters, such as merging_threshold=0.4; may be repeated");
  add("seed", po::value(&numbers.seed)->value_name("N"), "seed of all random choices (default: 0)");
  add("threads", po::value(&numbers.threads)->value_name("N"),
      "number of threads; the result does not depend on it (default: all)");
  return result;
}

po::options_description described_rest(Options& options)
{
  po::options_description result("Other");
  auto add = result.add_options();
  add("shape", po::value(&options.shape)->value_name("NAME"),
      "generated shape that is segmented without INPUT (default: figure)");
  add("quiet", po::bool_switch(&options.quiet), "print nothing but errors");
  add("help,h", "print this help");
  add("version", po::bool_switch(&options.version), "print the version");
  return result;
}

po::options_description described_options(Options& options, Numbers& numbers)
{
  po::options_description result;
  result.add(described_outputs(options, numbers));
  result.add(described_method(options, numbers));
  result.add(described_rest(options));
  return result;
}

[[noreturn]] void refuse(const std::string& what)
{
  throw std::invalid_argument(what + "; see segment_shape --help");
}

void check_range(const po::variables_map& given, const char* const name, const long long value,
                 const long long low, const long long high)
{
  if (given.count(name) && (value < low || value > high))
    refuse("--" + std::string(name) + " is " + std::to_string(value) + ", give a number from " +
           std::to_string(low) + " to " + std::to_string(high));
}

void check_mesh_file(const std::string& path)
{
  if (!path.empty() && path != "-" && path.compare(0, 5, "/dev/") != 0 &&
      !has_extension(path, ".ply", ".PLY") && !is_obj_file(path))
    refuse("'" + path + "' is written as PLY or OBJ; end its name with .ply or .obj");
}

void check_files(const po::variables_map& given, const Options& options)
{
  for (const char* const name :
       {"input", "output", "labels", "stats", "hulls", "split", "view", "transfer"})
    if (given.count(name) && given[name].as<std::string>().empty())
      refuse("the name of a file is empty (" + std::string(name) + ")");
  if (given.count("input") && given.count("shape"))
    refuse("there is both a file and --shape; give one of them");
  if (options.input == "-" && options.dense_file == "-")
    refuse("standard input can't be both INPUT and --transfer");
  check_mesh_file(options.parts_file);
  if (!has_hull_folder(options)) check_mesh_file(options.hulls);
  std::set<std::string> names;
  for (const std::string& file : output_files(options))
    if (!names.insert(file).second) refuse("two outputs have the same name");
}

// Carries the given words and numbers over to the parameters.
void apply(const Numbers& numbers, Options& options)
{
  options.parameters = WCS::Parameters::preset(options.preset);

  if (options.stage == "patches")
    options.level = WCS::Level::PATCHES;
  else if (options.stage == "components")
    options.level = WCS::Level::COMPONENTS;
  else if (options.stage != "segments")
    refuse("--stage is '" + options.stage + "', give patches, components or segments");

  if (options.diameters == "cgal")
    options.parameters.diameter = WCS::Diameter_rule::GIVEN;
  else if (options.diameters != "own")
    refuse("--diameters is '" + options.diameters + "', give own or cgal");

  if (options.pieces == "joined")
    options.parameters.pieces = WCS::Piece_rule::JOINED;
  else if (options.pieces == "separate")
    options.parameters.pieces = WCS::Piece_rule::SEPARATE;
  else if (options.pieces == "whole")
    options.parameters.pieces = WCS::Piece_rule::WHOLE;
  else if (!options.pieces.empty())
    refuse("--pieces is '" + options.pieces + "', give joined, separate or whole");

  if (numbers.segments > 0)
    options.parameters.minimum_number_of_segments = static_cast<std::size_t>(numbers.segments);
  options.parameters.maximum_number_of_segments =
      static_cast<std::size_t>(numbers.segments > 0 ? numbers.segments : numbers.max_segments);
  options.parameters.seed = static_cast<unsigned int>(numbers.seed);
  options.number_of_threads = static_cast<std::size_t>(numbers.threads);
}

void apply_hulls(const po::variables_map& given, const Numbers& numbers, Options& options)
{
  for (const char* const name : {"hull-error", "max-hulls", "hull-vertices"})
    if (given.count(name) > 0 && options.hulls.empty())
      refuse("--" + std::string(name) +
             " is about hulls, which --hulls writes; name a file or a folder there");
  check_range(given, "max-hulls", numbers.max_hulls, 1, 1000000000);
  check_range(given, "hull-vertices", numbers.hull_vertices, 4, 1000000000);
  if (given.count("hull-error") > 0 && !(numbers.hull_error >= .001 && numbers.hull_error <= 1.))
    refuse("--hull-error is a share of the shape's size; give a number from 0.001 to 1");
  if (given.count("hull-error") > 0) options.hull_options.largest_error = numbers.hull_error;
  if (given.count("max-hulls") > 0)
    options.hull_options.most_hulls = static_cast<std::size_t>(numbers.max_hulls);
  if (given.count("hull-vertices") > 0)
    options.hull_options.most_corners = static_cast<std::size_t>(numbers.hull_vertices);
}

// The name of the parts where none was given: that of the input, in the folder where the program runs.
std::string default_parts_file(const Options& options)
{
  if (options.input.empty() || options.input == "-") return "parts.ply";
  std::filesystem::path name = std::filesystem::path(options.input).filename();
  if (has_extension(name.string(), ".gz", ".GZ")) name = name.stem();
  return name.stem().string() + "_parts.ply";
}

} // namespace
} // namespace internal

Options read_options(const int argc, const char* const argv[])
{
  Options options;
  internal::Numbers numbers;
  const auto described = internal::described_options(options, numbers);
  const auto given = Command_line::parsed("segment_shape", argc, argv, described);
  options.help = given.count("help") > 0;
  if (options.help || options.version) return options;
  if (given.count("input")) options.input = given["input"].as<std::string>();
  internal::check_files(given, options);
  internal::check_range(given, "segments", numbers.segments, 1, 1000000000);
  if (given.count("segments") && given.count("max-segments"))
    internal::refuse("there are both --segments and --max-segments; give one of them");
  internal::check_range(given, "max-segments", numbers.max_segments, 1, 1000000000);
  internal::check_range(given, "seed", numbers.seed, 0, 4294967295);
  internal::check_range(given, "threads", numbers.threads, 1, 1024);
  internal::apply(numbers, options);
  internal::apply_hulls(given, numbers, options);
  if (options.is_closed && options.split_folder.empty())
    internal::refuse("--close is about the parts that --split writes; name a folder there");
  if (given.count("min-segment-size"))
  {
    if (!(numbers.min_segment_share >= 0. && numbers.min_segment_share <= 1.))
      internal::refuse("--min-segment-size is not a share; give a number from 0 to 1");
    options.parameters.minimum_segment_share = numbers.min_segment_share;
  }
  for (const std::string& setting : numbers.settings)
    Named_parameters::set_parameter(options.parameters, setting);
  options.parameters.check();
  options.is_named_by_us =
      output_files(options).empty() && options.split_folder.empty() && options.hulls.empty();
  if (options.is_named_by_us) options.parts_file = internal::default_parts_file(options);
  return options;
}

void print_help(std::ostream& out)
{
  Options options;
  internal::Numbers numbers;
  out << "Usage: segment_shape [INPUT] [OPTIONS]\n\n"
         "Segments a mesh (OFF, PLY, OBJ, STL, glTF, GLB, 3MF, DAE, FBX) or a cloud of points "
         "(PLY, PCD,\n"
         "XYZ, PWN, TXT, ASC, CSV, PTS, OFF, OBJ, glTF), also compressed (.gz), into weakly "
         "convex parts.\n"
         "Without INPUT it segments a shape of its own. The name - is standard input or output. "
         "Pixels of\n"
         "a depth camera without a measurement (NaN; 0 0 0 repeated in an organized PCD or PLY) "
         "keep\n"
         "their place and get the label -1.\n\n"
         "  segment_shape scan.ply                           writes scan_parts.ply\n"
         "  segment_shape model.stl --split parts --close    a solid a part, for a printer\n"
      << internal::described_options(options, numbers);
}

} // namespace Segment_shape
