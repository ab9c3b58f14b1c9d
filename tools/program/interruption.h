// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_INTERRUPTION_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_INTERRUPTION_H

#include <csignal>

// How a program that is interrupted leaves no unfinished file behind.

namespace Program_errors {

// While it lives, the first interruption from the keyboard or by another program only sets a
// mark, so that the program can end in order and remove what it has begun to write.
class Interruption
{
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool happened() { return mark() != 0; }
  // Throws if it happened.
  static void check();

  static const char* message() { return "interrupted, no unfinished file is left; start it again"; }

private:
  static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

  static volatile std::sig_atomic_t& mark();

  static void take(int signal);
};

} // namespace Program_errors

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_INTERRUPTION_H
