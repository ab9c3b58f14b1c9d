// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "counted_memory.h"
#include "shapes_for_tests.h"

#include <cstddef>
#include <functional>
#include <new>
#include <utility>
#include <vector>

// Whichever allocation fails, and wherever the run is stopped, the caller's labels stay as they were.

BOOST_AUTO_TEST_SUITE(test_allocation_failure)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Element = std::pair<Kernel::Point_3, std::size_t>;

/// writes the label of an element to its place
struct Label_map
{
  using key_type = Element;
  using value_type = int;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::vector<int>* labels;
  friend void put(const Label_map& map, const Element& element, const int label)
  {
    (*map.labels)[element.second] = label;
  }
};

std::vector<Element> points()
{
  std::vector<Element> result;
  const auto cloud = Shape_generator::make_cloud("dumbbell", 400);
  for (const auto& p : cloud.points)
    result.push_back({Kernel::Point_3(p[0], p[1], p[2]), result.size()});
  return result;
}

auto maps() { return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Element>()); }

} // namespace

BOOST_AUTO_TEST_CASE(labels_stay_when_an_allocation_fails)
{
  const std::vector<Element> shape = points(); // without normals: their estimation is a stage too
  for (const WCS::Parameters& preset : {WCS::Parameters(), WCS::Parameters::paper()})
  {
    std::vector<int> labels(shape.size(), -7);
    const std::vector<int> before = labels;
    const long before_run = Counted_memory::total();
    CGAL::weakly_convex_segmentation(shape, Label_map{&labels}, preset, maps());
    const long total = Counted_memory::total() - before_run;
    const std::vector<int> usual = labels;
    BOOST_REQUIRE_GT(total, 100);
    BOOST_REQUIRE(usual != before);
    long failures = 0;
    constexpr long trials = 150;
    for (long trial = 0; trial < trials; ++trial)
    {
      // the first ones each, then spread over the run
      const long n = trial < 30 ? trial : trial * (total - 1) / (trials - 1);
      labels = before;
      bool has_failed = false;
      try
      {
        const Counted_memory::Failure failure(n);
        CGAL::weakly_convex_segmentation(shape, Label_map{&labels}, preset, maps());
      }
      catch (const std::bad_alloc&)
      {
        has_failed = true;
      }
      failures += has_failed ? 1 : 0;
      // without an error, what failed was not needed
      BOOST_CHECK_MESSAGE(labels == (has_failed ? before : usual),
                          "allocation " << n << " of " << total);
    }
    BOOST_CHECK_GT(failures, trials / 2);
    CGAL::weakly_convex_segmentation(shape, Label_map{&labels}, preset, maps());
    BOOST_CHECK(labels == usual); // nothing is left behind
  }
}

BOOST_AUTO_TEST_CASE(labels_stay_when_the_run_is_stopped)
{
  const std::vector<Element> shape = points();
  std::vector<int> labels(shape.size(), -7);
  const std::vector<int> before = labels;
  for (int last = 0; last < 9; ++last)
  {
    int calls = 0;
    const std::function<bool(double)> stop = [&](double) { return calls++ < last; };
    try
    {
      CGAL::weakly_convex_segmentation(shape, Label_map{&labels}, {}, maps().callback(stop));
    }
    catch (const WCS::Canceled&)
    {
      BOOST_CHECK(labels == before);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
