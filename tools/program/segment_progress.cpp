// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/segment_progress.h"

#include "program/program_errors.h"

#include <chrono>
#include <cstddef>
#include <iostream>
#include <string>

namespace Segment_shape {

double Stopwatch::seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

void Stage_times::stage_begins(const WCS::Stage stage)
{
  m_name = WCS::stage_name(stage);
  m_stopwatch = Stopwatch();
}

void Stage_times::stage_ends(const WCS::Stage stage, std::size_t)
{
  m_seconds[static_cast<std::size_t>(stage)] += m_stopwatch.seconds();
}

void Progress_line::reading(const std::string& name) { show(0., "reading " + name); }

void Progress_line::segmenting(const double share, const std::string& stage)
{
  show(share_of_reading + (1. - share_of_reading - share_of_writing) * share, stage);
}

void Progress_line::writing(const std::string& path)
{
  show(1. - share_of_writing, "writing " + path);
}

void Progress_line::wipe()
{
  if (!m_shown.empty()) std::cerr << "\r\033[K" << std::flush;
  m_shown.clear();
}

// A name may hold line ends, and be too long for the line, which then could not be wiped.
void Progress_line::show(const double share, const std::string& what)
{
  constexpr std::size_t longest = 60;
  std::string line = std::to_string(static_cast<int>(100. * share)) + " % ";
  line += Program_errors::one_line(what).substr(0, longest);
  if (!m_is_shown || line == m_shown) return;
  m_shown = line;
  std::cerr << "\r\033[K" << line << std::flush;
}

} // namespace Segment_shape
