// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_CHECK_RESULT_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_CHECK_RESULT_H

#include <CGAL/Weakly_convex_segmentation/Result.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// What holds for every result. Include Boost.Test before. Patches of meshes with several points a face
// may be without a face: `every_patch` is false for these.

inline void check_result(const CGAL::Weakly_convex_segmentation::Result& result,
                         const std::size_t number_of_elements, const bool every_patch = true)
{
  BOOST_REQUIRE_EQUAL(result.labels.size(), number_of_elements);
  BOOST_REQUIRE_EQUAL(result.patches.size(), number_of_elements);
  BOOST_REQUIRE_EQUAL(result.number_of_segments(), result.segments.size());
  const std::size_t patches = result.merge_tree.number_of_patches();

  // numbered in the order of the first element, without gaps
  std::vector<std::size_t> sizes;
  for (const int label : result.labels)
  {
    BOOST_REQUIRE_GE(label, 0);
    BOOST_REQUIRE_LE(static_cast<std::size_t>(label), sizes.size());
    if (static_cast<std::size_t>(label) == sizes.size()) sizes.push_back(0);
    ++sizes[static_cast<std::size_t>(label)];
  }
  BOOST_REQUIRE_EQUAL(sizes.size(), result.number_of_segments());
  std::vector<char> is_patch(patches, 0);
  for (const int p : result.patches)
  {
    BOOST_REQUIRE(p >= 0 && static_cast<std::size_t>(p) < patches);
    is_patch[static_cast<std::size_t>(p)] = 1;
  }
  if (every_patch) BOOST_CHECK_EQUAL(std::count(is_patch.begin(), is_patch.end(), 1), patches);

  for (std::size_t l = 0; l < sizes.size(); ++l)
  {
    const auto& segment = result.segments[l];
    BOOST_CHECK_EQUAL(segment.size, sizes[l]);
    BOOST_CHECK(segment.convexity_rank > 0. && segment.convexity_rank <= 1.);
    BOOST_CHECK_GE(segment.diameter, 0.);
    BOOST_CHECK(std::is_sorted(segment.neighbors.begin(), segment.neighbors.end()));
    for (const std::size_t other : segment.neighbors)
    {
      BOOST_REQUIRE_LT(other, sizes.size());
      BOOST_CHECK_NE(other, l);
      const auto& back = result.segments[other].neighbors;
      BOOST_CHECK_EQUAL(std::count(back.begin(), back.end(), l), 1);
    }
  }

  // from patches over components and segments down to one
  const auto& tree = result.merge_tree;
  BOOST_CHECK_EQUAL(tree.merges().size(), patches - 1);
  BOOST_CHECK_LE(tree.number_of_fusions(), tree.number_of_accepted_merges());
  BOOST_CHECK_LE(tree.number_of_accepted_merges(), tree.merges().size());
  BOOST_CHECK_EQUAL(result.number_of_components, patches - tree.number_of_fusions());
  const std::vector<int> one = tree.labels_for(1);
  BOOST_CHECK_EQUAL(std::count(one.begin(), one.end(), 0), patches);
}

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_CHECK_RESULT_H
