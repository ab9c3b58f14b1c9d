// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_INTERRUPTION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_INTERRUPTION_H

#include <csignal>
#include <stdexcept>

// How a program that is interrupted leaves no unfinished file behind.

namespace Program_errors {

// While it lives, the first interruption from the keyboard or by another program only sets a
// mark, so that the program can end in order and remove what it has begun to write.
class Interruption
{
public:
  Interruption()
  {
    for (const int signal : signals)
      if (std::signal(signal, take) == SIG_IGN) std::signal(signal, SIG_IGN); // as nohup wants it
  }
  ~Interruption()
  {
    for (const int signal : signals)
      if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool happened() { return mark() != 0; }
  // Throws if it happened.
  static void check()
  {
    if (happened()) throw std::runtime_error(message());
  }

  static const char* message() { return "interrupted, no unfinished file is left; start it again"; }

private:
  static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

  static volatile std::sig_atomic_t& mark()
  {
    static volatile std::sig_atomic_t value = 0;
    return value;
  }

  static void take(const int signal)
  {
    mark() = 1;
    std::signal(signal, SIG_DFL); // the second one ends the program at once
  }
};

} // namespace Program_errors

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_INTERRUPTION_H
