// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "fuzz/fuzz_library.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

// A bounded run of what the fuzzer runs, without libFuzzer: random bytes of every kind of shape.

BOOST_AUTO_TEST_SUITE(test_fuzz_replay)

BOOST_AUTO_TEST_CASE(random_bytes_are_segmented_or_refused)
{
  std::size_t answers = 0;
  constexpr unsigned int seeds = 1500;
  for (unsigned int seed = 0; seed < seeds; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(1 + random() % (seed % 3 == 0 ? 1500 : 200));
    const unsigned int spread = seed % 2 == 0 ? 256 : 3; // few different bytes: points coincide
    for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random() % spread);
    bytes[0] = static_cast<std::uint8_t>(seed % 32);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      BOOST_CHECK_NO_THROW(answers += Fuzz_library::run(bytes.data(), bytes.size()) ? 1 : 0);
    }
  }
  BOOST_CHECK_GT(answers, seeds / 4); // not everything is refused
  BOOST_CHECK_LT(answers, seeds);
}

BOOST_AUTO_TEST_SUITE_END()
