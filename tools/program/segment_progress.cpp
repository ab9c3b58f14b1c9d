// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/segment_progress.h"

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
  m_stage = stage;
  m_stopwatch = Stopwatch();
}

void Stage_times::stage_ends(const WCS::Stage stage, std::size_t)
{
  m_seconds[static_cast<std::size_t>(stage)] += m_stopwatch.seconds();
}

Progress_line::~Progress_line()
{
  if (m_percent >= 0) std::cerr << "\r\033[K" << std::flush;
}

void Progress_line::show(const double share, const std::string& what)
{
  const int percent = static_cast<int>(100. * share);
  if (!m_is_shown || percent == m_percent) return;
  m_percent = percent;
  std::cerr << "\r\033[K" << percent << " % " << what << std::flush;
}

} // namespace Segment_shape
