// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/segment_outputs.h"

#include "io/closed_parts.h"
#include "io/part_hulls.h"
#include "io/separate_parts.h"
#include "io/shape_io.h"
#include "io/write_obj.h"
#include "program/interruption.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Segment_shape {

namespace {

// Gives the solid what the input has of its own faces; caps have no corner values and no words, else 0, and are told
// by a property.
void add_properties(const Shape_io::Shape& own, const std::size_t number_of_own,
                    Shape_io::Shape& solid)
{
  const std::size_t n = solid.polygons.size();
  solid.face_properties = own.face_properties;
  solid.face_words = own.face_words;
  solid.material_files = own.material_files;
  solid.is_textured_obj = own.is_textured_obj;
  solid.is_of_parts = own.is_of_parts;
  for (Shape_io::Property& property : solid.face_properties)
  {
    const bool has_words =
        std::any_of(own.face_words.begin(), own.face_words.end(),
                    [&](const Shape_io::Face_words& words) { return words.name == property.name; });
    if (property.is_list())
      property.first.resize(n + 1, property.values.size());
    else
      property.values.resize(n, has_words ? -1. : 0.);
    if (property.name == "cap") property.name = "input_cap";
  }
  Shape_io::Property cap = {"cap", "uchar", std::vector<double>(number_of_own, 0.)};
  cap.values.resize(n, 1.);
  solid.face_properties.push_back(std::move(cap));
}

void write_shape(Shape_io::Atomic_file& file, const std::string& path, const Shape_io::Shape& shape,
                 const Shape_io::Parts& parts, const bool ascii)
{
  if (internal::is_obj_file(path))
    Shape_io::write_obj_groups(file.stream(), shape, parts.labels, parts.colors.size());
  else
    Shape_io::write_parts(file.stream(), shape, parts,
                          ascii ? Shape_io::Encoding::ASCII : Shape_io::Encoding::BINARY);
}

Shape_io::Parts parts_of_elements(const Shape_io::Parts& parts,
                                  const std::vector<std::size_t>& elements)
{
  Shape_io::Parts own;
  own.colors = parts.colors;
  for (const std::size_t i : elements)
  {
    own.labels.push_back(parts.labels[i]);
    own.quality.push_back(parts.quality[i]);
  }
  return own;
}

// What has no label is after the others.
std::string name_of_part(const std::size_t label, const Shape_io::Parts& parts)
{
  return label < parts.colors.size() ? std::to_string(label) : "none";
}

} // namespace

Outputs::Outputs(const Options& options, Progress_line& progress)
  : m_options(options), m_progress(progress), m_parts(open(options.parts_file)),
    m_labels(open(options.labels_file)), m_stats(open(options.stats_file)),
    m_hulls(open(has_hull_folder(options) ? "" : options.hulls)), m_view(open(options.view_file))
{
  if (!options.split_folder.empty()) m_folder.emplace(options.split_folder, "part");
  if (has_hull_folder(options)) m_hull_folder.emplace(options.hulls, "hull");
}

void Outputs::write(const Shape_io::Shape& shape, const Shape_io::Parts& parts)
{
  if (begins(m_parts, m_options.parts_file))
    write_shape(*m_parts, m_options.parts_file, shape, parts, m_options.ascii);
  Program_errors::Interruption::check(); // a large shape takes seconds a file
  if (begins(m_labels, m_options.labels_file))
    Shape_io::write_labels(m_labels->stream(), parts.labels);
  if (m_hull_folder || begins(m_hulls, m_options.hulls)) write_hulls(shape, parts);
  if (m_folder && m_options.is_closed)
    write_closed_parts(shape, parts);
  else if (m_folder)
    write_separate_parts(shape, parts);
}

void Outputs::write_stats(const Shape_io::Shape& shape, const Run& run)
{
  if (m_stats) Segment_shape::write_stats(m_stats->stream(), m_options, shape, run);
}

void Outputs::write_view(const std::optional<View_page>& page, const Shape_io::Shape& shape,
                         const std::vector<View_stage>& stages, const Run& run)
{
  if (begins(m_view, m_options.view_file))
    page->write(m_view->stream(), m_options, shape, stages, run);
}

void Outputs::finish()
{
  for (const auto& file : m_files) file->finish();
}

void Outputs::commit()
{
  finish();
  Program_errors::Interruption::check();
  for (const auto& file : m_files) file->commit();
  if (m_folder) m_folder->commit();
  if (m_hull_folder) m_hull_folder->commit();
}

Outputs::File Outputs::open(const std::string& path)
{
  if (path.empty()) return nullptr;
  m_files.push_back(std::make_unique<Shape_io::Atomic_file>(path));
  return m_files.back().get();
}

bool Outputs::begins(const File file, const std::string& path)
{
  if (file != nullptr) m_progress.writing(path);
  return file != nullptr;
}

void Outputs::write_hulls(const Shape_io::Shape& shape, const Shape_io::Parts& parts)
{
  const auto result =
      Shape_io::part_hulls(shape, parts.labels, parts.colors.size(), m_options.hull_options);
  note_hulls(result);
  Program_errors::Interruption::check();
  if (m_hull_folder)
    for (std::size_t i = 0; i < result.hulls.size(); ++i)
    {
      const File file = open(m_hull_folder->path_of(std::to_string(i), ".obj"));
      const Shape_io::Shape hull = Shape_io::mesh_of_hulls({result.hulls[i]});
      Shape_io::write_obj_groups(file->stream(), hull, std::vector<int>(hull.polygons.size(), 0), 1,
                                 "part_" + std::to_string(result.hulls[i].label) + "_hull");
      file->finish();
    }
  else
    write_hull_file(result, parts);
}

void Outputs::write_hull_file(const Shape_io::Part_hulls& hulls, const Shape_io::Parts& parts)
{
  const Shape_io::Shape mesh = Shape_io::mesh_of_hulls(hulls.hulls);
  std::vector<int> hull_of_face, label_of_face;
  for (const double hull : mesh.face_properties.front().values)
  {
    hull_of_face.push_back(static_cast<int>(hull));
    label_of_face.push_back(hulls.hulls[static_cast<std::size_t>(hull)].label);
  }
  if (internal::is_obj_file(m_options.hulls))
    Shape_io::write_obj_groups(m_hulls->stream(), mesh, hull_of_face, hulls.hulls.size(), "hull");
  else
    write_shape(*m_hulls, m_options.hulls, mesh,
                {label_of_face, std::vector<double>(label_of_face.size(), 1.), parts.colors},
                m_options.ascii);
}

void Outputs::note_hulls(const Shape_io::Part_hulls& result)
{
  std::ostringstream note;
  note << result.hulls.size() << " hulls";
  double error = 0.;
  for (const auto& hull : result.hulls) error = (std::max)(error, hull.error);
  if (std::isfinite(m_options.hull_options.largest_error))
    note << ", none further from its part than " << std::setprecision(3) << error
         << " of the diagonal";
  if (!result.flat_parts.empty())
    note << "; " << result.flat_parts.size() << " parts are flat and have none";
  m_notes.push_back(note.str());
}

void Outputs::write_separate_part(const Shape_io::Shape& part, const Shape_io::Parts& own,
                                  const std::string& name)
{
  Program_errors::Interruption::check();
  // OBJ keeps the most of what has materials: no other format of ours names their files
  const std::string path = m_folder->path_of(name, part.is_textured_obj ? ".obj" : ".ply");
  const File file = open(path);
  m_progress.writing(path);
  write_shape(*file, path, part, own, m_options.ascii);
  file->finish();
}

void Outputs::write_separate_parts(const Shape_io::Shape& shape, const Shape_io::Parts& parts)
{
  std::vector<int> labels = parts.labels;
  const auto none = static_cast<int>(parts.colors.size());
  std::replace(labels.begin(), labels.end(), -1, none);
  const auto elements = Shape_io::elements_of_parts(labels, parts.colors.size() + 1);
  for (std::size_t label = 0; label < elements.size(); ++label)
    if (!elements[label].empty())
      write_separate_part(Shape_io::shape_of_elements(shape, elements[label]),
                          parts_of_elements(parts, elements[label]), name_of_part(label, parts));
}

void Outputs::write_closed_parts(const Shape_io::Shape& shape, const Shape_io::Parts& parts)
{
  auto solids = Shape_io::closed_parts(shape, parts.labels, parts.colors.size());
  std::size_t number_of_parts = 0, number_of_faults = 0;
  for (std::size_t label = 0; label < solids.size(); ++label)
  {
    Shape_io::Closed_part& solid = solids[label];
    const std::size_t n = solid.shape.polygons.size();
    if (n > 0 || !solid.fault.empty()) ++number_of_parts;
    if (!solid.fault.empty())
    {
      ++number_of_faults;
      m_notes.push_back("part " + name_of_part(label, parts) +
                        " is no closed solid: " + solid.fault);
    }
    if (n == 0) continue;
    add_properties(Shape_io::shape_of_elements(shape, solid.source_faces),
                   solid.source_faces.size(), solid.shape);
    Shape_io::Parts own = parts_of_elements(parts, solid.source_faces);
    own.labels.resize(n, own.labels.front());
    own.quality.resize(n, own.quality.front());
    write_separate_part(solid.shape, own, name_of_part(label, parts));
  }
  m_notes.push_back(std::to_string(number_of_parts - number_of_faults) + " of " +
                    std::to_string(number_of_parts) + " parts are closed solids");
}

} // namespace Segment_shape
