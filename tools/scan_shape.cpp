// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Scans a mesh, or a shape made in code, with a virtual depth camera and writes the cloud as PLY.

#include "io/atomic_file.h"
#include "io/read_shape.h"
#include "program/command_line.h"
#include "program/interruption.h"
#include "program/program_errors.h"
#include "scanner/virtual_scanner.h"
#include "shapes/shape_generator.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace po = boost::program_options;

struct Options
{
  std::string input, output, shape;
  long views = 4;
  unsigned seed = 0;
  bool with_noise = false;
  Virtual_scanner::Camera camera;
};

// returns whether there is something to do.
bool read_options(const int argc, char** argv, Options& options)
{
  po::options_description visible("scan_shape [MESH] -o CLOUD.ply [options]\n"
                                  "scans a mesh, or a made shape, from some sides\nOptions");
  Virtual_scanner::Camera& camera = options.camera;
  std::size_t resolution = camera.resolution;
  visible.add_options()("help,h", "print this")("output,o", po::value(&options.output),
                                                "cloud to write")(
      "shape", po::value(&options.shape)->default_value("figure"), "the made shape, without MESH")(
      "views", po::value(&options.views)->default_value(4), "number of viewpoints, 1 to 1000")(
      "resolution", po::value(&resolution)->default_value(resolution), "pixels along a side")(
      "noisy", po::bool_switch(&options.with_noise), "noise, steps and losses of a real camera")(
      "noise", po::value<double>(), "standard deviation of depths, in diameters of the shape")(
      "seed", po::value(&options.seed)->default_value(0), "seed of viewpoints and noise");
  const po::variables_map map = Command_line::parsed("scan_shape", argc, argv, visible);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  if (map.count("input") > 0) options.input = map["input"].as<std::string>();
  if (options.output.empty())
    throw std::invalid_argument(
        "there is no file to write; give -o CLOUD.ply, see scan_shape --help");
  if (options.views < 1 || options.views > 1000)
    throw std::invalid_argument("--views has to be from 1 to 1000");
  if (options.with_noise) camera = Virtual_scanner::realistic_camera();
  if (map.count("noise") > 0) camera.noise = map["noise"].as<double>();
  camera.resolution = resolution;
  return true;
}

Shape_generator::Labeled_mesh read_mesh(const std::string& path)
{
  const Shape_io::Shape shape = Shape_io::read_shape(path);
  if (!shape.is_mesh())
    throw std::runtime_error("'" + path + "' is a cloud; give a mesh, a cloud can't be scanned");
  Shape_generator::Labeled_mesh mesh;
  for (const auto& p : shape.points) mesh.points.push_back({p.x(), p.y(), p.z()});
  for (const auto& polygon : shape.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      mesh.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
  return mesh;
}

void write_scan(const Virtual_scanner::Scan& scan, const std::vector<int>& labels,
                const std::string& path)
{
  const Program_errors::Interruption interruption; // before there is a file to leave behind
  Shape_io::Atomic_file file(path);
  std::ostream& out = file.stream();
  out.precision(9);
  out << "ply\nformat ascii 1.0\ncomment points, normals, face and viewpoint of a virtual scan\n"
      << "element vertex " << scan.points.size() << '\n';
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    out << "property float " << name << '\n';
  out << "property int face\nproperty int view\n";
  if (!labels.empty()) out << "property int label\n";
  out << "end_header\n";
  for (std::size_t i = 0; i < scan.points.size(); ++i)
  {
    for (const double x : scan.points[i]) out << x << ' ';
    for (const double x : scan.normals[i]) out << x << ' ';
    out << scan.faces[i] << ' ' << scan.views[i];
    if (!labels.empty()) out << ' ' << labels[scan.faces[i]];
    out << '\n';
  }
  interruption.check();
  file.commit();
}

} // namespace

int main(int argc, char** argv)
{
  return Program_errors::run(
      "scan_shape",
      [&]
      {
        Options options;
        if (!read_options(argc, argv, options)) return;
        Shape_io::check_output_places({options.output}, {options.input});
        Shape_io::Atomic_file::check(options.output);
        const Shape_generator::Labeled_mesh mesh = options.input.empty()
                                                       ? Shape_generator::make_mesh(options.shape)
                                                       : read_mesh(options.input);
        const Virtual_scanner::Scan scan = Virtual_scanner::scan_mesh(
            mesh, static_cast<std::size_t>(options.views), options.camera, options.seed);
        write_scan(scan, mesh.labels, options.output);
        std::cout << scan.points.size() << " points from " << options.views << " viewpoints\n";
      });
}
