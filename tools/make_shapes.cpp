// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes shapes with known parts: meshes as OFF or point clouds as PLY, and the true part of each
// face or point, one per line, as .seg.

#include "io/atomic_file.h"
#include "program/command_line.h"
#include "program/interruption.h"
#include "program/program_errors.h"
#include "shapes/shape_generator.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

struct Options
{
  std::string directory;
  long long faces = 0;
  long long points = 0;
  unsigned seed = 0;
  bool cloud = false;
  bool help = false;
  std::vector<std::string> names;
};

Options parse(int argc, char* argv[])
{
  namespace po = boost::program_options;
  Options options;
  po::options_description visible("make_shapes [options] [NAME...]\n"
                                  "Writes the named shapes with their true parts; without a name, "
                                  "all shapes.\nOptions");
  visible.add_options()("help,h", "show this text and the names of the shapes")(
      "output,o", po::value(&options.directory)->default_value("."), "directory to write to")(
      "faces", po::value(&options.faces)->default_value(12000), "faces of a mesh, about")(
      "points", po::value(&options.points)->default_value(20000), "points of a cloud")(
      "cloud", po::bool_switch(&options.cloud), "write point clouds instead of meshes")(
      "seed", po::value(&options.seed)->default_value(0), "seed of all that is random");
  const po::variables_map given =
      Command_line::parsed("make_shapes", argc, argv, visible, "name", -1);
  options.help = given.count("help") > 0;
  if (given.count("name") > 0) options.names = given["name"].as<std::vector<std::string>>();
  if (options.help)
  {
    std::cout << visible << "Shapes:";
    for (const std::string& name : Shape_generator::shape_names()) std::cout << ' ' << name;
    std::cout << '\n';
    return options;
  }
  // Read as signed numbers, as a minus sign would else turn into a huge number of faces.
  if (options.faces < 1000 || options.faces > 2000000)
    throw std::invalid_argument("--faces has to be from 1000 to 2000000");
  if (options.points < 1 || options.points > 10000000)
    throw std::invalid_argument("--points has to be from 1 to 10000000");
  const std::vector<std::string> names = Shape_generator::shape_names();
  if (options.names.empty()) options.names = names;
  for (const std::string& name : options.names) // before anything is made
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::invalid_argument("there is no shape '" + name + "'" +
                                  Command_line::suggestion(name, names) +
                                  "; see make_shapes --help");
  return options;
}

// Calls write(stream) for a file that is there as a whole or not at all.
template <class Write>
void write_file(const std::string& path, const Write& write)
{
  const Program_errors::Interruption interruption; // before there is a file to leave behind
  Shape_io::Atomic_file file(path);
  file.stream().precision(9);
  write(file.stream());
  interruption.check();
  file.commit();
}

void write_labels(const std::string& path, const std::vector<int>& labels)
{
  write_file(path,
             [&](std::ostream& out)
             {
               for (int label : labels) out << label << '\n';
             });
}

void write_mesh(const std::filesystem::path& base, const Shape_generator::Labeled_mesh& mesh)
{
  write_file(base.string() + ".off",
             [&](std::ostream& out)
             {
               out << "OFF\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
               for (const auto& p : mesh.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
               for (const auto& f : mesh.faces)
                 out << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
             });
  write_labels(base.string() + ".seg", mesh.labels);
}

void write_cloud(const std::filesystem::path& base, const Shape_generator::Labeled_cloud& cloud)
{
  write_file(base.string() + ".ply",
             [&](std::ostream& out)
             {
               out << "ply\nformat ascii 1.0\nelement vertex " << cloud.points.size() << '\n';
               for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
                 out << "property double " << name << '\n';
               out << "property int label\nend_header\n";
               for (std::size_t i = 0; i < cloud.points.size(); ++i)
               {
                 for (double x : cloud.points[i]) out << x << ' ';
                 for (double x : cloud.normals[i]) out << x << ' ';
                 out << cloud.labels[i] << '\n';
               }
             });
  write_labels(base.string() + ".seg", cloud.labels);
}

void make_shapes(const Options& options)
{
  const std::filesystem::path directory = options.directory;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw std::runtime_error("cannot make the directory " + options.directory + " (" +
                             error.message() + "); choose another one with -o");
  for (const std::string& name : options.names)
  {
    if (options.cloud)
      write_cloud(directory / name,
                  Shape_generator::make_cloud(name, static_cast<std::size_t>(options.points),
                                              options.seed));
    else
      write_mesh(
          directory / name,
          Shape_generator::make_mesh(name, static_cast<std::size_t>(options.faces), options.seed));
  }
}

} // namespace

int main(int argc, char* argv[])
{
  return Program_errors::run("make_shapes",
                             [&]
                             {
                               const Options options = parse(argc, argv);
                               if (!options.help) make_shapes(options);
                             });
}
