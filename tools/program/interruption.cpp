// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/interruption.h"

#include <csignal>
#include <stdexcept>

namespace Program_errors {

Interruption::Interruption()
{
  for (const int signal : signals)
    if (std::signal(signal, take) == SIG_IGN) std::signal(signal, SIG_IGN); // as nohup wants it
}

Interruption::~Interruption()
{
  for (const int signal : signals)
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void Interruption::check()
{
  if (happened()) throw std::runtime_error(message());
}

volatile std::sig_atomic_t& Interruption::mark()
{
  static volatile std::sig_atomic_t value = 0;
  return value;
}

void Interruption::take(const int signal)
{
  mark() = 1;
  std::signal(signal, SIG_DFL); // the second one ends the program at once
}

} // namespace Program_errors
