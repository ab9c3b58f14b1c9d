// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "fuzz/fuzz_readers.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// A bounded run of what the fuzzer of the readers runs, without libFuzzer: sound files, and those files
// damaged at random.

BOOST_AUTO_TEST_SUITE(test_fuzz_readers)

namespace {

bool run(const std::string& file)
{
  return Fuzz_readers::run(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
}

void damage(std::string& file, std::mt19937& random)
{
  const std::vector<std::string> pieces = {"nan", "-1",    "999999999", "0", "\n",
                                           " ",   "1e999", "\\",        "/"};
  const std::size_t at = 1 + random() % (file.size() - 1);
  switch (random() % 6)
  {
  case 0:
    file[at] = static_cast<char>(random() % 256);
    break;
  case 1:
    file[at] = static_cast<char>(file[at] ^ (1 << random() % 8));
    break;
  case 2:
    file.resize(at + 1);
    break;
  case 3:
    file.insert(at, pieces[random() % pieces.size()]);
    break;
  case 4:
    file.erase(at, 1 + random() % 4);
    if (file.size() < 2) file += "xx";
    break;
  default:
    file.insert(at, file.substr(1 + random() % (file.size() - 1), random() % 30));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(sound_files_are_read)
{
  const auto seeds = Fuzz_readers::seeds();
  for (std::size_t i = 0; i < seeds.size(); ++i) BOOST_TEST(run(seeds[i]), "seed " << i);
}

BOOST_AUTO_TEST_CASE(damaged_files_are_read_or_refused)
{
  const auto seeds = Fuzz_readers::seeds();
  std::size_t answers = 0;
  constexpr unsigned int runs = 40000;
  for (unsigned int seed = 0; seed < runs; ++seed)
  {
    std::mt19937 random(seed);
    std::string file = seeds[seed % seeds.size()];
    for (unsigned int i = 0; i <= seed % 4; ++i) damage(file, random);
    if (seed % 16 == 0) file[0] = static_cast<char>(random() % Fuzz_readers::number_of_kinds);
    BOOST_TEST_CONTEXT("seed " << seed)
    BOOST_CHECK_NO_THROW(answers += run(file) ? 1 : 0);
  }
  BOOST_CHECK_GT(answers, runs / 20);
  BOOST_CHECK_LT(answers, runs);
}

BOOST_AUTO_TEST_SUITE_END()
