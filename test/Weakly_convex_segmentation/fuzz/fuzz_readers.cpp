// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz_readers.h"

#include <fstream>

// The target of libFuzzer; see scripts/fuzz. The environment variable WCS_FUZZ_SEEDS names a folder to
// which the first files are written.

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  if (const char* const folder = std::getenv("WCS_FUZZ_SEEDS"))
  {
    std::size_t number = 0;
    for (const std::string& seed : Fuzz_readers::seeds())
      std::ofstream(std::string(folder) + "/seed_" + std::to_string(number++), std::ios::binary)
          << seed;
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Fuzz_readers::run(data, size);
  return 0;
}
