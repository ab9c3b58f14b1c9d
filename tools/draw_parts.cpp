// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws what segment_shape and segment_scene have written as one picture, without a display. See --help.

#include "draw/draw_parts.h"

#include "io/atomic_file.h"
#include "io/read_shape.h"
#include "program/command_line.h"
#include "program/interruption.h"
#include "program/program_errors.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;

struct Options
{
  std::vector<std::string> inputs;
  std::string output, up;
  int size = 0;
};

// returns whether there is something to do.
bool read_options(const int argc, char** argv, Options& options)
{
  po::options_description visible("draw_parts PARTS.ply... -o PICTURE.png [options]\n"
                                  "draws the parts that segment_shape has written, each shape from "
                                  "the side that shows most of them\nOptions");
  visible.add_options()("help,h", "print this")("output,o", po::value(&options.output),
                                                "picture to write (PNG)")(
      "size", po::value(&options.size)->default_value(480), "pixels a shape, 16 to 4000")(
      "up", po::value(&options.up)->default_value("z"), "which axis is upwards: x, y or z");
  const po::variables_map map =
      Command_line::parsed("draw_parts", argc, argv, visible, "input", -1);
  if (map.count("help") > 0)
  {
    std::cout << visible;
    return false;
  }
  if (map.count("input") > 0) options.inputs = map["input"].as<std::vector<std::string>>();
  if (options.inputs.empty())
    throw std::invalid_argument("there is nothing to draw; give PARTS.ply of segment_shape");
  if (options.output.empty())
    throw std::invalid_argument("there is no file to write; give -o PICTURE.png");
  if (options.size < 16 || options.size > 4000)
    throw std::invalid_argument("--size has to be from 16 to 4000");
  if (options.up != "x" && options.up != "y" && options.up != "z")
    throw std::invalid_argument("--up takes x, y or z");
  return true;
}

const std::vector<double>& values_of(const Shape_io::Shape& shape, const std::string& name,
                                     const std::string& path)
{
  for (const Shape_io::Property& property :
       shape.is_mesh() ? shape.face_properties : shape.point_properties)
    if (property.name == name && !property.is_list()) return property.values;
  throw std::runtime_error("'" + path + "' has no parts; segment it first, by segment_shape '" +
                           path + "' -o PARTS.ply");
}

// The color of each label, as it is in the file.
std::vector<Draw_parts::Color> colors_of(const Shape_io::Shape& shape,
                                         const std::vector<int>& labels, const std::string& path)
{
  const auto &red = values_of(shape, "red", path), &green = values_of(shape, "green", path),
             &blue = values_of(shape, "blue", path);
  std::vector<Draw_parts::Color> colors;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (labels[i] < 0) continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    if (label >= colors.size()) colors.resize(label + 1);
    const auto channel = [&](const std::vector<double>& values)
    { return static_cast<unsigned char>(std::clamp(values[i], 0., 255.)); };
    colors[label] = {channel(red), channel(green), channel(blue)};
  }
  return colors;
}

Draw_parts::Picture draw(const std::string& path, const Options& options)
{
  const Shape_io::Shape shape = Shape_io::read_shape(path, Shape_io::Gaps::ALLOWED);
  const auto& values = values_of(shape, "label", path);
  std::vector<int> labels;
  for (const double value : values)
  {
    if (!(value >= -1. && value < static_cast<double>(values.size())))
      throw std::runtime_error("'" + path +
                               "' has labels that are no numbers of parts; segment it anew");
    labels.push_back(static_cast<int>(value));
  }
  const auto colors = colors_of(shape, labels, path);
  const Draw_parts::Scene scene = Draw_parts::make_scene(shape, labels);
  Draw_parts::Point up = {0., 0., 0.};
  up[static_cast<std::size_t>(options.up[0] - 'x')] = 1.;
  const auto camera = Draw_parts::best_upright_camera(scene, labels, up);
  return Draw_parts::make_picture(Draw_parts::look(scene, camera, options.size), labels, colors);
}

void draw_parts(const Options& options)
{
  Shape_io::check_output_places({options.output}, options.inputs);
  Shape_io::Atomic_file::check(options.output);
  std::vector<Draw_parts::Picture> pictures;
  for (const std::string& path : options.inputs) pictures.push_back(draw(path, options));
  const Program_errors::Interruption interruption; // before there is a file to leave behind
  Shape_io::Atomic_file file(options.output);
  Draw_parts::write_png(Draw_parts::sheet(pictures, options.size / 16), file.stream());
  interruption.check();
  file.commit();
}

} // namespace

int main(int argc, char** argv)
{
  return Program_errors::run("draw_parts",
                             [&]
                             {
                               Options options;
                               if (read_options(argc, argv, options)) draw_parts(options);
                             });
}
