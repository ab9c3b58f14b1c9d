// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz_library.h"

// The target of libFuzzer; see scripts/fuzz.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Fuzz_library::run(data, size);
  return 0;
}
