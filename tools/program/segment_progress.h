// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_PROGRESS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_PROGRESS_H

#include <CGAL/Weakly_convex_segmentation/Visitor.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

#include <unistd.h>

// What segment_shape follows while the segmentation runs.

namespace Segment_shape {

namespace WCS = CGAL::Weakly_convex_segmentation;

class Stopwatch
{
public:
  double seconds() const;

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

// Measures the seconds of each stage.
class Stage_times : public WCS::Visitor
{
public:
  void stage_begins(WCS::Stage stage) override;

  void stage_ends(WCS::Stage stage, std::size_t) override;

  const char* name() const { return m_name; } // of the last that began
  double seconds(const WCS::Stage of) const { return m_seconds[static_cast<std::size_t>(of)]; }

private:
  const char* m_name = "preparation";
  Stopwatch m_stopwatch;
  std::array<double, WCS::number_of_stages> m_seconds{};
};

// Shows how far the work is, on a terminal only, and wipes the line at the end.
class Progress_line
{
public:
  explicit Progress_line(const bool quiet) : m_is_shown(!quiet && isatty(STDERR_FILENO) == 1) {}
  ~Progress_line() { wipe(); }
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  void reading(const std::string& name);
  void segmenting(double share, const std::string& stage);
  void writing(const std::string& path);

  // Makes room for other text.
  void wipe();

private:
  // Of the time: 3 to 30 % and 5 to 8 %, the more the larger the input is.
  static constexpr double share_of_reading = 0.12, share_of_writing = 0.07;

  void show(double share, const std::string& what);

  bool m_is_shown;
  std::string m_shown;
};

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SEGMENT_PROGRESS_H
