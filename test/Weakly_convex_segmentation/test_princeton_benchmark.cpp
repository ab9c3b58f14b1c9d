// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers and averages of the Princeton Segmentation Benchmark and, if the environment variable
// WCS_PSB_DIR names its directory (with off/ and seg/), the measures against the values which the
// benchmark's own evaluator prints, and people against people.

#include <boost/test/unit_test.hpp>

#include "metrics/princeton_benchmark.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_princeton_benchmark)

namespace {

using namespace Segmentation_metrics;

constexpr double tolerance = 1e-12;

bool is_near(double a, double b, double epsilon = tolerance) { return std::abs(a - b) <= epsilon; }

// A file that exists as long as this object.
class Temporary_file
{
public:
  explicit Temporary_file(const std::string& content)
  {
    const std::string name = "wcs_metrics_" + std::to_string(std::random_device()()) + ".txt";
    m_path = std::filesystem::temp_directory_path() / name;
    std::ofstream(m_path, std::ios::binary) << content;
  }

  ~Temporary_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }

  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

// A benchmark directory with one model of two triangles, which exists as long as this object.
class Temporary_benchmark
{
public:
  Temporary_benchmark()
    : m_root(std::filesystem::temp_directory_path() /
             ("wcs_benchmark_" + std::to_string(std::random_device()())))
  {
    write("off/7.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  }

  ~Temporary_benchmark()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_root, ignored);
  }

  Temporary_benchmark(const Temporary_benchmark&) = delete;
  Temporary_benchmark& operator=(const Temporary_benchmark&) = delete;

  void write(const std::string& name, const std::string& content) const
  {
    std::filesystem::create_directories((m_root / name).parent_path());
    std::ofstream(m_root / name, std::ios::binary) << content;
  }

  const std::filesystem::path& root() const { return m_root; }

private:
  std::filesystem::path m_root;
};

Mesh parse_off(const std::string& content) { return read_off(Temporary_file(content).path()); }

Segmentation parse_seg(const std::string& content, std::size_t number_of_faces)
{
  return read_seg(Temporary_file(content).path(), number_of_faces);
}

std::optional<std::filesystem::path> benchmark_directory()
{
  const char* directory = std::getenv("WCS_PSB_DIR");
  if (directory == nullptr || *directory == '\0')
  {
    BOOST_TEST_MESSAGE("Skipped: set WCS_PSB_DIR to the directory of the benchmark.");
    return std::nullopt;
  }
  return directory;
}

} // namespace

BOOST_AUTO_TEST_SUITE(readers)

BOOST_AUTO_TEST_CASE(off_files)
{
  const std::string points = "0 0 0\n1 0 0\n\n# a comment\n0 1 0 255 0 0\r\n";
  BOOST_TEST(parse_off("OFF\n3 1 0\n" + points + "3 0 1 2\n").faces.size() == 1u);
  BOOST_TEST(parse_off("OFF 3 1 0\n" + points + "3 2 1 0 # red\n").points.size() == 3u);
  for (const std::string& bad :
       {std::string(), std::string("PLY\n3 1 0\n") + points + "3 0 1 2\n",
        "OFF\n-3 1 0\n" + points + "3 0 1 2\n", "OFF\n3 1 0\n" + points + "4 0 1 2 0\n",
        "OFF\n3 1 0\n" + points + "3 0 1 3\n", "OFF\n3 1 0\n" + points + "3 0 -1 2\n",
        "OFF\n3 1 0\n" + points, "OFF\n3 1 0\n" + points + "3 0 1 2\n3 0 1 2\n",
        std::string("OFF\n1 0 0\n0 zero 0\n")})
    BOOST_CHECK_THROW(parse_off(bad), std::runtime_error);
  BOOST_CHECK_THROW(read_off("there_is_no_such.off"), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(seg_files)
{
  const Segmentation expected{4, -1, 4};
  BOOST_TEST(parse_seg("4\n-1\r\n4", 3) == expected, boost::test_tools::per_element());
  for (const std::string bad :
       {"", "1\n2\n", "1\n2\n3\n4\n", "1\n2.5\n3\n", "1\nx\n3\n", "1 2 3\n", "1\n99999999999\n3\n"})
    BOOST_CHECK_THROW(parse_seg(bad, 3), std::runtime_error);
  BOOST_CHECK_THROW(read_seg("there_is_no_such.seg", 3), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(models)
{
  const Temporary_benchmark files;
  BOOST_CHECK_THROW(read_benchmark_model(files.root(), 7), std::runtime_error); // no folder
  files.write("seg/Benchmark/7/readme.txt", "not a segmentation");
  BOOST_CHECK_THROW(read_benchmark_model(files.root(), 7), std::runtime_error); // no annotators
  files.write("seg/Benchmark/7/7_10.seg", "0\n1\n");
  BOOST_CHECK_THROW(score_annotators(read_benchmark_model(files.root(), 7)), std::invalid_argument);
  files.write("seg/Benchmark/7/7_2.seg", "0\n0\n");
  files.write("seg/Benchmark/7/8_3.seg", "not of this model");
  files.write("seg/Benchmark/7/7_x.seg", "not a number");

  const Benchmark_model model = read_benchmark_model(files.root(), 7);
  BOOST_REQUIRE(model.annotators.size() == 2u);
  BOOST_TEST(model.annotators[0].number_of_segments == 1u); // in the order of numbers, 2 before 10
  BOOST_TEST(model.annotators[1].number_of_segments == 2u);

  const Scores scores = score_against_annotators(model, {5, 5});
  BOOST_TEST(is_near(scores.rand_error, 0.5));        // 0 and 1
  BOOST_TEST(is_near(scores.false_alarm_rate, 0.25)); // 0 and 1/2
  BOOST_TEST(!scores.cut_discrepancy.has_value());
  const Scores annotators = score_annotators(model);
  BOOST_TEST(is_near(annotators.rand_error, 1.));
  BOOST_TEST(is_near(annotators.missing_rate, 0.25));
  BOOST_TEST(is_near(annotators.number_of_segments, 1.5));
  BOOST_CHECK_THROW(read_benchmark_model(files.root(), 270), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(scores_of_the_benchmark)

BOOST_AUTO_TEST_CASE(categories)
{
  BOOST_TEST(category_names()[category_of_model(1)] == "Human");
  BOOST_TEST(category_names()[category_of_model(20)] == "Human");
  BOOST_TEST(category_names()[category_of_model(21)] == "Cup");
  BOOST_TEST(category_names()[category_of_model(260)] == "Bird");
  BOOST_TEST(category_names()[category_of_model(281)] == "Armadillo");
  BOOST_TEST(category_names()[category_of_model(400)] == "Fourleg");
  for (const int number : {-1, 0, 261, 280, 401})
    BOOST_CHECK_THROW(category_of_model(number), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(averages_over_models_then_categories)
{
  const auto with = [](double rand_error, std::optional<double> cut)
  {
    Scores scores;
    scores.rand_error = rand_error;
    scores.cut_discrepancy = cut;
    return scores;
  };
  Benchmark_average average;
  BOOST_CHECK_THROW(average.overall(), std::logic_error);
  average.add(1, with(0.1, 0.5));
  average.add(2, with(0.3, std::nullopt)); // left out of the mean cut discrepancy only
  average.add(400, with(0.6, 0.7));
  BOOST_TEST(is_near(average.category(0)->rand_error, 0.2));
  BOOST_TEST(is_near(average.category(0)->cut_discrepancy.value(), 0.5));
  BOOST_TEST(!average.category(1).has_value());
  BOOST_TEST(is_near(average.overall().rand_error, 0.4));
  BOOST_TEST(is_near(average.overall().cut_discrepancy.value(), 0.6));
}

// A line printed by the benchmark's own evaluator, for annotator 0 against 1.
struct Printed_scores
{
  int model;
  std::array<double, 9> values;
};

const std::vector<Printed_scores>& printed_scores()
{
  static const std::vector<Printed_scores> list{
      {1,
       {0.0613007, 0.12403, 0.0805103, 0.167551, 0.169579, 0.106244, 0.150408, 0.0911961,
        0.124176}},
      {21,
       {0.0205774, 0.00976396, 0.00976396, 0.00976396, 0.0188102, 0.0094051, 0.019566, 0.0089896,
        0.108744}},
      {61,
       {0.0531508, 0.0744568, 0.0690114, 0.0799023, 0.108442, 0.0790921, 0.110834, 0.0804844,
        0.0825124}},
      {141,
       {0.10364, 0.0366592, 0.064517, 0.00880128, 0.0164705, 0.0161553, 0.0166644, 0.0162917,
        0.41998}},
      {241,
       {0.0328466, 0.0379073, 0.0379073, 0.0379073, 0.0640096, 0.0403769, 0.0648176, 0.0396128,
        0.0558981}},
      {301,
       {0.0550645, 0.0841783, 0.0586447, 0.109712, 0.104087, 0.0939912, 0.103125, 0.0935878,
        0.0566284}},
      {341, {0.0316314, 0.0198036, 0.0396072, 3.18955e-15, 0., 0., 0., 0., 0.142705}},
      {381,
       {0.194379, 0.122598, 0.108502, 0.136693, 0.160068, 0.0593599, 0.158931, 0.0578894,
        0.302402}}};
  return list;
}

BOOST_AUTO_TEST_CASE(values_printed_by_the_evaluator)
{
  const auto directory = benchmark_directory();
  if (!directory) return;
  for (const Printed_scores& printed : printed_scores())
  {
    const Benchmark_model model = read_benchmark_model(*directory, printed.model);
    const Scores s = score(model.geometry, model.annotators.at(0), model.annotators.at(1),
                           Pair_count::as_evaluator);
    const std::array<double, 9> values{s.rand_error,       s.hamming,  s.missing_rate,
                                       s.false_alarm_rate, s.gce,      s.lce,
                                       s.gce_area,         s.lce_area, s.cut_discrepancy.value()};
    for (std::size_t i = 0; i < values.size(); ++i)
      BOOST_TEST(is_near(values[i], printed.values[i], 1e-5 * printed.values[i] + 1e-12),
                 "model " << printed.model << ", value " << i << ": " << values[i] << " instead of "
                          << printed.values[i]);
  }
}

// People against people on the models with odd numbers: 1 - RI, Hamming, GCEa, LCEa, cut
// discrepancy and number of segments.
const std::array<std::array<double, 6>, 19>& annotators_of_odd_models()
{
  static const std::array<std::array<double, 6>, 19> table{
      {{.1356, .2059, .1243, .0816, .2969, 13.9},
       {.1502, .0800, .0280, .0189, .5288, 2.8},
       {.1089, .1093, .0342, .0240, .2531, 4.8},
       {.1019, .1141, .0901, .0582, .1029, 7.0},
       {.0378, .0685, .0372, .0255, .0882, 13.6},
       {.0823, .0713, .0497, .0287, .1459, 8.3},
       {.0252, .0434, .0309, .0213, .0685, 10.4},
       {.1060, .0613, .0213, .0142, .1378, 5.6},
       {.0436, .0422, .0454, .0314, .0507, 8.2},
       {.1006, .1162, .0954, .0591, .1853, 8.0},
       {.0638, .0768, .0728, .0516, .0951, 5.1},
       {.1491, .0974, .0773, .0522, .1248, 7.8},
       {.0707, .0788, .0728, .0497, .1121, 5.7},
       {.0920, .1761, .1188, .0767, .1521, 16.2},
       {.2198, .1469, .0944, .0644, .2857, 7.9},
       {.1398, .0827, .0255, .0145, .1967, 3.5},
       {.1308, .0880, .0348, .0241, .2267, 5.1},
       {.1481, .0816, .0585, .0393, .2386, 5.1},
       {.1561, .2007, .1825, .1171, .2017, 12.7}}};
  return table;
}

BOOST_AUTO_TEST_CASE(annotators_against_annotators)
{
  const auto directory = benchmark_directory();
  if (!directory) return;
  Benchmark_average average;
  for (int number = 1; number <= 400; number += 2)
    if (is_in_benchmark(number))
      average.add(number, score_annotators(read_benchmark_model(*directory, number)));
  for (std::size_t i = 0; i < category_names().size(); ++i)
  {
    const Scores s = average.category(i).value();
    const std::array<double, 6> values{
        s.rand_error,        s.hamming, s.gce_area, s.lce_area, s.cut_discrepancy.value(),
        s.number_of_segments};
    for (std::size_t k = 0; k < values.size(); ++k)
      BOOST_TEST(is_near(values[k], annotators_of_odd_models()[i][k], k == 5 ? 0.051 : 0.000051),
                 category_names()[i] << ", value " << k << ": " << values[k]);
  }
  BOOST_TEST(is_near(average.overall().rand_error, 0.1085, 0.000051));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
