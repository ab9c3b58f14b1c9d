// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

// How a run is watched, stopped and repeated: visitor, callback, seed, threads.

BOOST_AUTO_TEST_SUITE(test_control)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Shapes_for_tests::rand_distance;
using WCS::Parameters;
using WCS::Result;
using WCS::Stage;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

const std::vector<Point_with_normal>& hand()
{
  static const std::vector<Point_with_normal> points = []
  {
    std::vector<Point_with_normal> result;
    const auto cloud = Shape_generator::make_cloud("hand", 4000);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
    {
      const auto &p = cloud.points[i], &n = cloud.normals[i];
      result.push_back({{p[0], p[1], p[2]}, {n[0], n[1], n[2]}});
    }
    return result;
  }();
  return points;
}

auto maps()
{
  return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
      .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>());
}

/// writes to a vector, in the order of the range, and counts
struct Label_writer
{
  using key_type = Point_with_normal;
  using value_type = int;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::vector<int>* labels;
  friend void put(const Label_writer& writer, const key_type&, const int label)
  {
    writer.labels->push_back(label);
  }
};

/// the same for points without normals
struct Bare_label_writer
{
  using key_type = Kernel::Point_3;
  using value_type = int;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::vector<int>* labels;
  friend void put(const Bare_label_writer& writer, const key_type&, const int label)
  {
    writer.labels->push_back(label);
  }
};

template <typename Tag = CGAL::Sequential_tag, typename NamedParameters>
Result segment(const Parameters& parameters, const NamedParameters& np)
{
  std::vector<int> written;
  Result result =
      CGAL::weakly_convex_segmentation<Tag>(hand(), Label_writer{&written}, parameters, np);
  BOOST_REQUIRE(written == result.labels);
  return result;
}

struct Recorder : WCS::Visitor
{
  std::vector<std::tuple<bool, Stage, std::size_t>> events; // begins, stage, size
  std::vector<WCS::Merge_tree::Merge> merges;
  bool merged_outside = false;
  int throw_at = -1;

  void stage_begins(const Stage stage) override
  {
    if (static_cast<int>(stage) == throw_at) throw std::out_of_range("enough");
    events.push_back({true, stage, 0});
  }
  void stage_ends(const Stage stage, const std::size_t size) override
  {
    events.push_back({false, stage, size});
  }
  void merged(const int first, const int second, const double cost) override
  {
    const auto& [begins, stage, size] = events.back();
    merged_outside = merged_outside || !begins || size != 0 ||
                     (stage != Stage::FUSION && stage != Stage::MERGING);
    merges.push_back({first, second, cost});
  }
};

bool equal(const Result& a, const Result& b)
{
  if (a.labels != b.labels || a.patches != b.patches || a.segments.size() != b.segments.size() ||
      a.merge_tree.merges().size() != b.merge_tree.merges().size())
    return false;
  for (std::size_t i = 0; i < a.segments.size(); ++i)
    if (a.segments[i].convexity_rank != b.segments[i].convexity_rank ||
        a.segments[i].diameter != b.segments[i].diameter)
      return false;
  for (std::size_t i = 0; i < a.merge_tree.merges().size(); ++i)
  {
    const auto &m = a.merge_tree.merges()[i], &n = b.merge_tree.merges()[i];
    if (m.first != n.first || m.second != n.second || m.cost != n.cost) return false;
  }
  return true;
}

const std::vector<Parameters> presets = {Parameters(), Parameters::paper(),
                                         Parameters::training_free()};

} // namespace

BOOST_AUTO_TEST_CASE(a_visitor_is_told_of_the_stages_in_order)
{
  for (const Parameters& preset : presets)
  {
    Recorder recorder;
    const Result result = segment(preset, maps().visitor(std::ref(recorder)));
    check_result(result, hand().size());
    BOOST_REQUIRE_EQUAL(recorder.events.size(), 2 * WCS::number_of_stages);
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < recorder.events.size(); ++i)
    {
      const auto& [begins, stage, size] = recorder.events[i];
      BOOST_CHECK_EQUAL(begins, i % 2 == 0);
      BOOST_CHECK_EQUAL(static_cast<std::size_t>(stage), i / 2);
      if (!begins) sizes.push_back(size);
    }
    const auto size_of = [&](const Stage stage) { return sizes[static_cast<std::size_t>(stage)]; };
    BOOST_CHECK_EQUAL(size_of(Stage::SAMPLING), hand().size());
    BOOST_CHECK_GE(size_of(Stage::NEIGHBORS), 5 * hand().size());
    // a consensus cuts the patches, and small pieces join others
    if (preset.number_of_patch_sets == 1)
      BOOST_CHECK_EQUAL(size_of(Stage::PATCHES), result.merge_tree.number_of_patches());
    else
      BOOST_CHECK_LE(size_of(Stage::PATCHES), result.merge_tree.number_of_patches() * 11 / 10);
    BOOST_CHECK_EQUAL(size_of(Stage::VISIBILITY), hand().size());
    BOOST_CHECK_EQUAL(size_of(Stage::FUSION), result.number_of_components);
    BOOST_CHECK_EQUAL(size_of(Stage::MERGING), result.merge_tree.number_of_patches() -
                                                   result.merge_tree.number_of_accepted_merges());
    BOOST_CHECK_EQUAL(size_of(Stage::STATISTICS), result.number_of_segments());
    BOOST_CHECK(!recorder.merged_outside);
    const auto& merges = result.merge_tree.merges();
    BOOST_REQUIRE_EQUAL(recorder.merges.size(), merges.size());
    for (std::size_t i = 0; i < merges.size(); ++i)
    {
      BOOST_REQUIRE_EQUAL(recorder.merges[i].first, merges[i].first);
      BOOST_REQUIRE_EQUAL(recorder.merges[i].second, merges[i].second);
      BOOST_REQUIRE_EQUAL(recorder.merges[i].cost, merges[i].cost);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_exception_of_a_visitor_passes_through)
{
  for (const int stage : {0, 2, 5, 8})
  {
    Recorder recorder;
    recorder.throw_at = stage;
    std::vector<int> written;
    BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation(hand(), Label_writer{&written}, Parameters(),
                                                       maps().visitor(std::ref(recorder))),
                      std::out_of_range);
    BOOST_CHECK(written.empty());
    BOOST_CHECK_EQUAL(recorder.events.size(), 2u * static_cast<std::size_t>(stage));
  }
}

BOOST_AUTO_TEST_CASE(stage_names_are_distinct)
{
  BOOST_CHECK_EQUAL(WCS::stage_name(Stage::SAMPLING), std::string("sampling"));
  BOOST_CHECK_EQUAL(WCS::stage_name(Stage::STATISTICS), std::string("statistics"));
}

BOOST_AUTO_TEST_CASE(the_shares_of_the_stages_add_up_to_the_whole)
{
  using WCS::internal::stage_shares;
  for (const std::size_t points : {0u, 4000u, 1000000u})
    for (const bool has_given_normals : {false, true})
    {
      const auto shares = stage_shares(points, has_given_normals);
      BOOST_CHECK_EQUAL(shares.back(), 1.);
      BOOST_CHECK_GT(shares.front(), 0.);
      for (std::size_t i = 1; i < shares.size(); ++i) BOOST_CHECK_GT(shares[i], shares[i - 1]);
    }
  // as measured: patches and their agreement take most of the time of a small cloud, little of that of a large mesh
  const auto until = [](const auto& shares, const Stage s)
  { return shares[static_cast<std::size_t>(s) + 1]; };
  const auto small = stage_shares(4000, true), large = stage_shares(1000000, false);
  BOOST_CHECK_GT(until(small, Stage::CONSENSUS) - until(small, Stage::NEIGHBORS), 0.7);
  BOOST_CHECK_LT(until(large, Stage::CONSENSUS) - until(large, Stage::NEIGHBORS), 0.1);
}

BOOST_AUTO_TEST_CASE(progress_grows_from_0_to_1_and_may_stop_anywhere)
{
  std::vector<double> progress;
  const std::function<bool(double)> watch = [&](const double share)
  {
    progress.push_back(share);
    return true;
  };
  const Result result = segment(Parameters(), maps().callback(watch));
  BOOST_REQUIRE_GE(progress.size(), WCS::number_of_stages);
  BOOST_CHECK_EQUAL(progress.front(), 0.);
  BOOST_CHECK_CLOSE(progress.back(), 1., 1e-9);
  for (std::size_t i = 1; i < progress.size(); ++i) BOOST_CHECK_GE(progress[i], progress[i - 1]);

  for (const double last : progress)
  {
    bool was_stopped = false, was_called_again = false;
    const std::function<bool(double)> stop = [&](const double share)
    {
      was_called_again = was_stopped;
      was_stopped = share >= last;
      return !was_stopped;
    };
    std::vector<int> written;
    BOOST_CHECK_THROW(CGAL::weakly_convex_segmentation(hand(), Label_writer{&written}, Parameters(),
                                                       maps().callback(stop)),
                      WCS::Canceled);
    BOOST_CHECK(written.empty());
    BOOST_CHECK(was_stopped && !was_called_again);
  }

  // a segmenter that was canceled goes on as if nothing had been
  bool is_first = true;
  const std::function<bool(double)> once = [&](const double share)
  { return share < 0.7 || !std::exchange(is_first, false); };
  WCS::Segmenter<> segmenter(hand(), Parameters(), maps().callback(once));
  BOOST_CHECK_THROW(segmenter.segment(Parameters()), WCS::Canceled);
  BOOST_CHECK(equal(segmenter.segment(Parameters()), result));
}

// Questions come a tenth of a second apart at least: what takes so long is followed by one.
BOOST_AUTO_TEST_CASE(the_callback_is_heeded_within_stages)
{
  static constexpr std::chrono::milliseconds long_time(101);
  struct Slow_recorder : Recorder
  {
    std::size_t slow_merge = 0;
    void merged(const int first, const int second, const double cost) override
    {
      Recorder::merged(first, second, cost);
      if (merges.size() == slow_merge) std::this_thread::sleep_for(long_time);
    }
  };
  for (const std::size_t last : {1u, 3u, 8u})
  {
    Slow_recorder recorder;
    recorder.slow_merge = last;
    const std::function<bool(double)> stop = [&](double) { return recorder.merges.size() < last; };
    WCS::Segmenter<> segmenter(hand(), Parameters(),
                               maps().callback(stop).visitor(std::ref(recorder)));
    BOOST_CHECK_THROW(segmenter.segment(Parameters()), WCS::Canceled);
    BOOST_CHECK_LE(recorder.merges.size(), last);
  }

  // nor is the estimation of normals, before the first stage, left to itself
  std::vector<Kernel::Point_3> bare;
  for (const Point_with_normal& p : hand()) bare.push_back(p.first);
  for (const int last : {2, 4, 9})
  {
    std::vector<int> written;
    std::vector<std::thread::id> threads;
    int left = last;
    const std::function<bool(double)> stop = [&](const double share)
    {
      BOOST_REQUIRE_EQUAL(share, 0.);
      threads.push_back(std::this_thread::get_id());
      std::this_thread::sleep_for(long_time);
      return --left > 0;
    };
    BOOST_CHECK_THROW(
        CGAL::weakly_convex_segmentation<CGAL::Parallel_if_available_tag>(
            bare, Bare_label_writer{&written}, Parameters(), CGAL::parameters::callback(stop)),
        WCS::Canceled);
    BOOST_CHECK(written.empty());
    BOOST_CHECK(std::count(threads.begin(), threads.end(), std::this_thread::get_id()) ==
                static_cast<std::ptrdiff_t>(threads.size()));
  }
}

BOOST_AUTO_TEST_CASE(the_seed_is_used_and_two_runs_are_the_same)
{
  for (const Parameters& preset : presets)
  {
    const Result first = segment(preset, maps());
    BOOST_CHECK(equal(first, segment(preset, maps())));
    BOOST_CHECK(equal(first, segment(preset, maps().random_seed(0u))));
    Parameters seeded = preset;
    seeded.seed = 5;
    const Result other = segment(seeded, maps());
    BOOST_CHECK(equal(other, segment(preset, maps().random_seed(5u)))); // takes the seed's place
    BOOST_CHECK(first.patches != other.patches);
    BOOST_CHECK_LT(rand_distance(first.labels, other.labels), 0.25);
  }
}

BOOST_AUTO_TEST_CASE(parallel_runs_give_the_same_labels)
{
  for (const Parameters& preset : presets)
    BOOST_CHECK(
        equal(segment(preset, maps()), segment<CGAL::Parallel_if_available_tag>(preset, maps())));
}

BOOST_AUTO_TEST_CASE(two_threads_do_not_disturb_each_other)
{
  std::vector<Result> results(presets.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < presets.size(); ++i)
    threads.emplace_back(
        [i, &results]
        {
          std::vector<int> written;
          results[i] =
              CGAL::weakly_convex_segmentation(hand(), Label_writer{&written}, presets[i], maps());
        });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < presets.size(); ++i)
    BOOST_CHECK(equal(results[i], segment(presets[i], maps())));
}

BOOST_AUTO_TEST_SUITE_END()
