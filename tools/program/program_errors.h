// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_PROGRAM_ERRORS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_PROGRAM_ERRORS_H

#include "program/kept_memory.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>

// How all programs end: with exit code 0, or 1 and one line on standard error.

namespace Program_errors {

// Names of files and messages of libraries may hold line ends, but an error is one line.
std::string one_line(std::string message);

// Throws if standard output could not be written.
void flush_standard_output();

// Calls `work` and returns the exit code.
template <typename Work>
int run(const std::string& program, const Work& work)
{
  // A reader that goes away, or a file that may not become larger, shows as an error of writing: what
  // was begun is removed.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  Program_memory::keep_freed();
  try
  {
    work();
    flush_standard_output();
    return EXIT_SUCCESS;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << program << ": there is not enough memory; take a smaller shape\n";
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << one_line(error.what()) << '\n';
  }
  return EXIT_FAILURE;
}

} // namespace Program_errors

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_PROGRAM_ERRORS_H
