// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/segment_outputs.h"

#include "io/part_hulls.h"
#include "io/separate_parts.h"
#include "io/shape_io.h"
#include "program/interruption.h"

#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace Segment_shape {

namespace {

// The parts of the hulls have the colors of the parts.
Shape_io::Parts parts_of_hulls(const Shape_io::Part_hulls& hulls, const Shape_io::Parts& parts)
{
  return {hulls.labels, std::vector<double>(hulls.labels.size(), 1.), parts.colors};
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

} // namespace

Outputs::Outputs(const Options& options, Progress_line& progress)
  : m_options(options), m_progress(progress), m_parts(open(options.parts_file)),
    m_labels(open(options.labels_file)), m_stats(open(options.stats_file)),
    m_hulls(open(options.hulls_file)), m_view(open(options.view_file))
{
  if (!options.split_folder.empty()) m_folder.emplace(options.split_folder);
}

void Outputs::write(const Shape_io::Shape& shape, const Shape_io::Parts& parts)
{
  if (begins(m_parts, m_options.parts_file))
    write_shape(*m_parts, m_options.parts_file, shape, parts, m_options.ascii);
  Program_errors::Interruption::check(); // a large shape takes seconds a file
  if (begins(m_labels, m_options.labels_file))
    Shape_io::write_labels(m_labels->stream(), parts.labels);
  if (begins(m_hulls, m_options.hulls_file)) write_hulls(shape, parts);
  if (m_folder) write_separate_parts(shape, parts);
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
  const auto hulls = Shape_io::part_hulls(shape, parts.labels, parts.colors.size());
  if (!hulls.flat_parts.empty() && !m_options.quiet)
  {
    m_progress.wipe();
    std::cerr << "segment_shape: " << hulls.flat_parts.size()
              << " parts are flat and have no hull\n";
  }
  write_shape(*m_hulls, m_options.hulls_file, hulls.shape, parts_of_hulls(hulls, parts),
              m_options.ascii);
}

void Outputs::write_separate_part(const Shape_io::Shape& shape, const Shape_io::Parts& parts,
                                  const std::vector<std::size_t>& elements, const std::string& name)
{
  Shape_io::Parts own;
  own.colors = parts.colors;
  for (const std::size_t i : elements)
  {
    own.labels.push_back(parts.labels[i]);
    own.quality.push_back(parts.quality[i]);
  }
  Program_errors::Interruption::check();
  const std::string path = m_folder->path_of_part(name);
  const File file = open(path);
  m_progress.writing(path);
  write_shape(*file, path, Shape_io::shape_of_elements(shape, elements), own, m_options.ascii);
  file->finish();
}

void Outputs::write_separate_parts(const Shape_io::Shape& shape, const Shape_io::Parts& parts)
{
  const auto elements = Shape_io::elements_of_parts(parts.labels, parts.colors.size());
  for (std::size_t label = 0; label < elements.size(); ++label)
    if (!elements[label].empty())
      write_separate_part(shape, parts, elements[label], std::to_string(label));
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < parts.labels.size(); ++i)
    if (parts.labels[i] < 0) others.push_back(i);
  if (!others.empty()) write_separate_part(shape, parts, others, "none");
}

} // namespace Segment_shape
