// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What several segmentations agree on, and how the pipeline makes use of it.

BOOST_AUTO_TEST_SUITE(test_consensus)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;
using Labels = std::vector<int>;

/// labels of runs: a label and how often it comes
Labels runs(const std::vector<std::pair<int, std::size_t>>& of_label)
{
  Labels labels;
  for (const auto& [label, count] : of_label) labels.insert(labels.end(), count, label);
  return labels;
}

bool are_one_partition(const Labels& a, const Labels& b)
{
  std::map<int, int> to_b, to_a;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (to_b.emplace(a[i], b[i]).first->second != b[i] ||
        to_a.emplace(b[i], a[i]).first->second != a[i])
      return false;
  return true;
}

/// the consensus of cuts, at the share that the default asks for
Labels agreed_labels(const std::vector<Labels>& cuts, const double minimum_size)
{
  std::vector<Votes> votes;
  for (const Labels& cut : cuts) votes.push_back({cut});
  return consensus_labels(votes, least_share_of_cuts, minimum_size);
}

/// votes of regions of ten points each that are together with the probabilities of a full matrix
Votes votes_of_matrix(const std::vector<std::vector<double>>& matrix)
{
  Votes votes;
  votes.together.resize(matrix.size());
  for (std::size_t a = 0; a < matrix.size(); ++a)
  {
    votes.labels.insert(votes.labels.end(), 10, static_cast<int>(a));
    for (std::size_t b = 0; b < matrix.size(); ++b)
      if (a != b && matrix[a][b] > 0.)
        votes.together[a].push_back({static_cast<int>(b), matrix[a][b]});
  }
  return votes;
}

Result segmented(const Shape_generator::Labeled_mesh& mesh, const Parameters& parameters)
{
  return Compiled_core::segment_points(points_of_mesh(mesh), parameters, {});
}

} // namespace

BOOST_AUTO_TEST_CASE(segmentations_that_are_the_same_agree_on_themselves)
{
  std::mt19937 random(3);
  for (const int count : {1, 2, 7, 40})
    for (const std::size_t number : {1u, 2u, 3u, 5u})
    {
      Labels labels;
      for (int i = 0; i < 500; ++i) labels.push_back(static_cast<int>(random() % count));
      std::vector<Labels> renamed(number, labels);
      for (std::size_t s = 0; s < number; ++s)
        for (int& l : renamed[s]) l = (l * 7 + static_cast<int>(s)) % (count * 7 + 10);
      BOOST_CHECK(are_one_partition(agreed_labels(renamed, 0.), labels));
    }
}

BOOST_AUTO_TEST_CASE(two_of_three_decide)
{
  const Labels apart = runs({{0, 50}, {1, 50}}), together = runs({{4, 100}});
  BOOST_CHECK(are_one_partition(agreed_labels({apart, together, apart}, 0.), apart));
  BOOST_CHECK(are_one_partition(agreed_labels({together, apart, together}, 0.), together));
  // the middle of three borders
  BOOST_CHECK(are_one_partition(
      agreed_labels({runs({{0, 45}, {1, 55}}), runs({{2, 52}, {9, 48}}), runs({{0, 60}, {1, 40}})},
                    0.),
      runs({{0, 52}, {1, 48}})));
}

BOOST_AUTO_TEST_CASE(the_order_of_the_segmentations_does_not_matter)
{
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial)
  {
    std::vector<Labels> segmentations(3);
    for (Labels& labels : segmentations)
      while (labels.size() < 400)
        labels.insert(labels.end(), 1 + random() % 60, static_cast<int>(random() % 6));
    for (Labels& labels : segmentations) labels.resize(400);
    const Labels agreed = agreed_labels(segmentations, 0.);
    std::swap(segmentations[0], segmentations[2]);
    BOOST_CHECK(are_one_partition(agreed, agreed_labels(segmentations, 0.)));
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_part_to_most_votes_is_none)
{
  // between two places of a border, ten points are with one side to a half of the votes, and with the other one to the
  // rest: on average they are with neither
  const Votes with_first = votes_of_matrix({{1., .9, 0.}, {.9, 1., .2}, {0., .2, 1.}});
  const Votes with_second = votes_of_matrix({{1., .2, 0.}, {.2, 1., .9}, {0., .9, 1.}});
  const Votes with_neither = votes_of_matrix({{1., .4, 0.}, {.4, 1., .4}, {0., .4, 1.}});
  const auto parts = [](const std::vector<Votes>& votes)
  {
    const Labels agreed = consensus_labels(votes, 0.6, 0.);
    return std::set<int>(agreed.begin(), agreed.end()).size();
  };
  BOOST_CHECK_EQUAL(parts({with_first, with_second}), 2u);
  BOOST_CHECK_EQUAL(parts({with_neither, with_first, with_second}), 2u); // 0.73 on average
  BOOST_CHECK_EQUAL(parts({with_neither, with_first, with_second, with_neither, with_neither}), 3u);
  BOOST_CHECK_EQUAL(parts({with_neither, with_neither}), 3u);
}

BOOST_AUTO_TEST_CASE(small_segments_join_what_they_agree_with_most)
{
  // three points that are once with the first, once with the second and once on their own
  const std::vector<Labels> segmentations = {runs({{0, 53}, {1, 50}}), runs({{0, 50}, {1, 53}}),
                                             runs({{0, 50}, {2, 3}, {1, 50}})};
  const Labels all = agreed_labels(segmentations, 0.);
  BOOST_CHECK_EQUAL(std::set<int>(all.begin(), all.end()).size(), 3u);
  const Labels large = agreed_labels(segmentations, 4.);
  BOOST_CHECK_EQUAL(std::set<int>(large.begin(), large.end()).size(), 2u);
  BOOST_CHECK(large[0] != large[102]);
}

BOOST_AUTO_TEST_CASE(what_nothing_agrees_with_stays)
{
  const Labels labels = runs({{0, 100}, {1, 1}});
  BOOST_CHECK(are_one_partition(agreed_labels({labels, labels}, 50.), labels));
}

BOOST_AUTO_TEST_CASE(probabilities_decide_by_their_mean)
{
  const Labels apart = runs({{0, 10}, {1, 10}}), together = runs({{0, 20}});
  const auto votes = [](const double p) { return votes_of_matrix({{1., p}, {p, 1.}}); };
  BOOST_CHECK(are_one_partition(consensus_labels({votes(0.6)}, 0.5, 0.), together));
  BOOST_CHECK(are_one_partition(consensus_labels({votes(0.4)}, 0.5, 0.), apart));
  // two doubt it a little, one is sure: a majority of cuts would part them
  BOOST_CHECK(
      are_one_partition(consensus_labels({votes(0.4), votes(0.4), votes(0.9)}, 0.5, 0.), together));
  BOOST_CHECK(
      are_one_partition(consensus_labels({votes(0.6), votes(0.6), votes(0.1)}, 0.5, 0.), apart));
  // a cut votes with a probability of 0 or 1
  BOOST_CHECK(are_one_partition(consensus_labels({{apart}, votes(0.9)}, 0.5, 0.), apart));
  BOOST_CHECK(are_one_partition(consensus_labels({{together}, votes(0.1)}, 0.5, 0.), together));
}

BOOST_AUTO_TEST_CASE(clusters_are_linked_by_the_mean_over_their_points)
{
  // the middle one goes with the first; the pair is then together with the last by (0.6 + 0.1) / 2
  const Votes chain = votes_of_matrix({{1., 0.8, 0.1}, {0.8, 1., 0.6}, {0.1, 0.6, 1.}});
  BOOST_CHECK(
      are_one_partition(consensus_labels({chain}, 0.5, 0.), runs({{0, 10}, {0, 10}, {1, 10}})));
  BOOST_CHECK(are_one_partition(consensus_labels({chain}, 0.3, 0.), runs({{0, 30}})));
  BOOST_CHECK(
      are_one_partition(consensus_labels({chain}, 0.9, 0.), runs({{0, 10}, {1, 10}, {2, 10}})));
  // too small for a segment: each joins what it is together with most, until all are one
  BOOST_CHECK(
      are_one_partition(consensus_labels({chain}, 0.9, 10.), runs({{0, 10}, {1, 10}, {2, 10}})));
  BOOST_CHECK(are_one_partition(consensus_labels({chain}, 0.9, 11.), runs({{0, 30}})));
}

BOOST_AUTO_TEST_CASE(what_was_linked_early_moves_to_where_it_is_more_at_home)
{
  // linkage joins the first two and the last two, whose means are then 0.35; the second one gains 0.2 + 0.2
  // with the last two, and 0.3 with the first
  const Votes votes = votes_of_matrix(
      {{1., 0.8, 0., 0.}, {0.8, 1., 0.7, 0.7}, {0., 0.7, 1., 0.7}, {0., 0.7, 0.7, 1.}});
  const Labels labels = runs({{0, 10}, {1, 30}});
  BOOST_CHECK(are_one_partition(consensus_labels({votes}, 0.5, 0.), labels));
  BOOST_CHECK(are_one_partition(consensus_labels({votes, votes, votes}, 0.5, 0.), labels));
  std::vector<int> clusters = {0, 0, 0, 3}; // a class that fits nowhere is a cluster of its own
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(4, 4);
  together(0, 1) = together(1, 0) = 0.9;
  const std::vector<double> sizes(4, 1.);
  Class_moves(sizes, together, 0.5, clusters).run();
  BOOST_CHECK(clusters[0] == clusters[1]);
  BOOST_CHECK(clusters[2] != clusters[0] && clusters[2] != clusters[3]);
}

BOOST_AUTO_TEST_CASE(a_tree_votes_by_the_merge_that_joins_two_regions)
{
  Judged_merges tree;
  tree.region_of_patch = {0, 1, 1, 2, 3}; // the last one touches nothing
  tree.number_of_regions = 4;
  tree.merges = {{1, 2, 0.7}, {0, 1, 0.2}};
  const Votes votes = votes_of_merges(tree, {0, 1, 2, 3, 4, 0});
  BOOST_CHECK(votes.labels == (Labels{0, 1, 1, 2, 3, 0}));
  using Row = std::vector<std::pair<int, double>>;
  BOOST_CHECK(votes.together[0] == (Row{{1, 0.2}, {2, 0.2}}));
  BOOST_CHECK(votes.together[1] == (Row{{0, 0.2}, {2, 0.7}}));
  BOOST_CHECK(votes.together[2] == (Row{{0, 0.2}, {1, 0.7}}));
  BOOST_CHECK(votes.together[3].empty());
}

BOOST_AUTO_TEST_CASE(merges_of_a_shape_are_judged_once_each)
{
  const auto shape =
      analyze_shape(points_of_mesh(Shape_generator::make_mesh("dumbbell", 3000)), Parameters(), {});
  const Patch_set& set = shape->patch_sets.front();
  const Judged_merges tree = judge_patches(*shape, set, Parameters(), {}, learned_trees());
  BOOST_CHECK_GE(tree.number_of_regions, 3u);
  BOOST_CHECK_LT(tree.number_of_regions, set.patches.size());
  BOOST_CHECK_EQUAL(tree.merges.size() + 1, tree.number_of_regions);
  std::set<int> gone;
  for (const Judged_merge& merge : tree.merges)
  {
    BOOST_CHECK(gone.count(merge.first) == 0 && gone.insert(merge.second).second);
    BOOST_CHECK(merge.probability > 0. && merge.probability < 1.);
  }
}

/// a row of points, each a neighbor of the next
Neighbor_graph row(const std::size_t size)
{
  Neighbor_graph graph;
  for (Index i = 0; i < size; ++i)
  {
    if (i > 0) graph.entries.push_back({i - 1, 1.f, 0.f});
    if (i + 1 < size) graph.entries.push_back({i + 1, 1.f, 0.f});
    graph.first.push_back(graph.entries.size());
    graph.spacing.push_back(1.f);
  }
  return graph;
}

BOOST_AUTO_TEST_CASE(patches_are_cut_where_segments_end)
{
  const Patches patches = patches_of_labels({0, 0, 0, 1, 1, 1, 1, 2, 2, 2});
  const Labels segments = {5, 5, 7, 7, 7, 7, 5, 5, 5, 5};
  const Cut_patches cut = cut_patches(row(10), patches, segments, 1);
  BOOST_CHECK(cut.patches.of_point == (Labels{0, 0, 1, 2, 2, 2, 3, 4, 4, 4}));
  BOOST_CHECK(cut.segments == (Labels{5, 7, 7, 5, 5}));
  BOOST_CHECK(cut.piece_of == (Labels{0, 0, 1, 1, 2}));
  // single points join the patch beside them, but not across the end of a segment
  const Cut_patches large = cut_patches(row(10), patches, segments, 2);
  BOOST_CHECK(large.patches.of_point == (Labels{0, 0, 1, 1, 1, 1, 2, 2, 2, 2}));
  BOOST_CHECK(large.segments == (Labels{5, 7, 5}));
  BOOST_CHECK(large.piece_of == (Labels{0, 1, 2}));
  // whole patches stay as they are
  const Cut_patches whole = cut_patches(row(10), patches, patches.of_point, 5);
  BOOST_CHECK(whole.patches.of_point == patches.of_point);
}

BOOST_AUTO_TEST_CASE(the_merge_tree_has_the_segments_that_are_agreed_on)
{
  for (const std::string& name : Shape_generator::shape_names())
  {
    const auto mesh = Shape_generator::make_mesh(name, 8000);
    for (const bool fitted : {false, true})
    {
      Parameters parameters = fitted ? Parameters() : Parameters::training_free();
      parameters.refinement = Refinement_rule::NONE;
      parameters.number_of_patch_sets = 4;
      const Result result = segmented(mesh, parameters);
      const Merge_tree& tree = result.merge_tree;
      BOOST_CHECK_EQUAL(tree.merges().size() + 1, tree.number_of_patches());
      BOOST_CHECK_LE(tree.number_of_fusions(), tree.number_of_accepted_merges());
      BOOST_CHECK(tree.labels_at_cost(parameters.merging_threshold) ==
                  tree.labels_after(tree.number_of_accepted_merges()));
      BOOST_CHECK_EQUAL(result.number_of_segments(),
                        tree.number_of_patches() - tree.number_of_accepted_merges());
      std::map<int, int> label_of_patch; // each lies in one segment
      for (std::size_t i = 0; i < result.labels.size(); ++i)
        BOOST_REQUIRE_EQUAL(
            label_of_patch.emplace(result.patches[i], result.labels[i]).first->second,
            result.labels[i]);
    }
  }
}

BOOST_AUTO_TEST_CASE(fewer_segments_can_be_asked_for)
{
  const auto mesh = Shape_generator::make_mesh("hand", 3000);
  Parameters parameters;
  for (const std::size_t most : {1u, 2u, 3u})
  {
    parameters.maximum_number_of_segments = most;
    BOOST_CHECK_EQUAL(segmented(mesh, parameters).number_of_segments(), most);
  }
}

BOOST_AUTO_TEST_CASE(as_many_segments_as_are_wanted)
{
  for (const Parameters& preset : {Parameters(), Parameters::training_free(), Parameters::paper()})
    for (const char* name : {"hand", "table"})
    {
      const auto mesh = Shape_generator::make_mesh(name, 4000);
      for (const std::size_t wanted : {2u, 5u, 9u, 15u})
      {
        Parameters parameters = preset;
        parameters.minimum_number_of_segments = parameters.maximum_number_of_segments = wanted;
        BOOST_CHECK_EQUAL(segmented(mesh, parameters).number_of_segments(), wanted);
      }
    }
  // the number of true parts gives the true parts, where they were found before or not
  for (const char* name : {"table", "chair", "dumbbell", "airplane"})
  {
    const auto mesh = Shape_generator::make_mesh(name, 4000);
    Parameters parameters;
    const double before = rand_distance(segmented(mesh, parameters).labels, mesh.labels);
    parameters.minimum_number_of_segments = parameters.maximum_number_of_segments =
        mesh.part_names.size();
    const double told = rand_distance(segmented(mesh, parameters).labels, mesh.labels);
    BOOST_CHECK_LE(told, before + 0.01);
  }
  Parameters wrong;
  wrong.minimum_number_of_segments = 4;
  wrong.maximum_number_of_segments = 3;
  BOOST_CHECK_THROW(wrong.check(), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_segments_are_steadier_than_those_of_one_set)
{
  double of_one = 0., of_three = 0.;
  const auto shapes = {"two_spheres", "cup", "hand", "four_leg", "figure", "airplane", "octopus"};
  for (const char* name : shapes) // a single one may be worse by chance
  {
    const auto mesh = Shape_generator::make_mesh(name, 5000);
    const auto change = [&](const std::size_t sets)
    {
      Parameters parameters;
      parameters.number_of_patch_sets = sets;
      std::vector<Labels> labels;
      for (const unsigned int seed : {1u, 2u, 3u, 4u})
      {
        parameters.seed = seed;
        labels.push_back(segmented(mesh, parameters).labels);
      }
      double sum = 0.;
      for (std::size_t a = 0; a < labels.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) sum += rand_distance(labels[a], labels[b]);
      return sum / 6.;
    };
    of_one += change(1);
    of_three += change(3);
  }
  BOOST_TEST_MESSAGE("change with the seed: " << of_one / 7. << " of one set, " << of_three / 7.
                                              << " of three");
  BOOST_CHECK_LT(of_three, of_one);
}

BOOST_AUTO_TEST_SUITE_END()
