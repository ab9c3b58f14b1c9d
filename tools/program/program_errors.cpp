// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/program_errors.h"

#include <iostream>
#include <stdexcept>
#include <string>

namespace Program_errors {

std::string one_line(std::string message)
{
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return message;
}

void flush_standard_output()
{
  if (!std::cout.flush())
    throw std::runtime_error("standard output can't be written; check where it goes");
}

} // namespace Program_errors
