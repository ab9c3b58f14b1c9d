// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "shapes_for_tests.h"

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

// What named parameters say, in any order and to any function. Calls that are refused: wrong_calls/.

BOOST_AUTO_TEST_SUITE(test_named_parameters)

namespace {

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace NP = CGAL::parameters;
using WCS::Level;
using WCS::Parameters;
using WCS::Result;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;

const Shape_generator::Labeled_mesh& shape()
{
  static const auto mesh = Shape_generator::make_mesh("dumbbell", 2000);
  return mesh;
}

const std::vector<Point>& points()
{
  static const auto result = []
  {
    std::vector<Point> points;
    for (const auto& p : shape().points) points.emplace_back(p[0], p[1], p[2]);
    return points;
  }();
  return result;
}

Mesh make_mesh()
{
  Mesh mesh;
  for (const Point& p : points()) mesh.add_vertex(p);
  for (const auto& f : shape().faces)
    mesh.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2]));
  return mesh;
}

const Mesh& mesh()
{
  static const Mesh result = make_mesh();
  return result;
}

/// labels of the faces of the mesh, beside it
struct Labels
{
  std::vector<int> values = std::vector<int>(mesh().number_of_faces(), -1);
  auto map()
  {
    return boost::make_function_property_map<Face, int&>([this](const Face f) -> int&
                                                         { return values[f]; });
  }
};

template <typename NamedParameters>
Result segment(const NamedParameters& np)
{
  Labels labels;
  Result result = CGAL::weakly_convex_segmentation(mesh(), labels.map(), np);
  BOOST_REQUIRE(labels.values == result.labels);
  return result;
}

/// few patches in one set, so that the tests are fast
Parameters coarse()
{
  Parameters parameters;
  parameters.number_of_patches = 30;
  parameters.number_of_patch_sets = 1;
  return parameters;
}

bool equal(const Result& a, const Result& b)
{
  return a.labels == b.labels && a.patches == b.patches;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_name_of_cgal_may_come_first_and_alone)
{
  Parameters other_seed = coarse();
  other_seed.seed = 7;
  const Result zero = segment(coarse()), seven = segment(other_seed);
  BOOST_REQUIRE(!equal(zero, seven));
  const auto segment_coarse = [](const auto& np)
  {
    Labels labels;
    return CGAL::weakly_convex_segmentation(mesh(), labels.map(), coarse(), np);
  };
  BOOST_CHECK(equal(segment_coarse(NP::random_seed(7)), seven));
  BOOST_CHECK(equal(segment_coarse(NP::default_values()), zero));
  const Mesh& input = mesh();
  Labels labels, of_default;
  CGAL::weakly_convex_segmentation(input, labels.map(), NP::random_seed(7));
  Parameters seed_only;
  seed_only.seed = 7;
  CGAL::weakly_convex_segmentation(input, of_default.map(), seed_only);
  BOOST_CHECK(labels.values == of_default.values);
}

BOOST_AUTO_TEST_CASE(names_in_any_order)
{
  Parameters expected = coarse();
  expected.seed = 3;
  expected.maximum_number_of_segments = 4;
  expected.minimum_number_of_segments = 2;
  expected.minimum_segment_share = 0.02;
  const Result result = segment(expected);
  std::size_t calls = 0;
  const auto count = [&calls](double)
  {
    ++calls;
    return true;
  };
  BOOST_CHECK(equal(result, segment(NP::segmentation_parameters(coarse())
                                        .random_seed(3)
                                        .maximum_number_of_segments(4)
                                        .minimum_number_of_segments(2)
                                        .callback(count)
                                        .minimum_segment_share(0.02))));
  BOOST_CHECK_GT(calls, 0u);
  calls = 0;
  WCS::Visitor visitor;
  BOOST_CHECK(equal(result, segment(NP::maximum_number_of_segments(4u)
                                        .minimum_number_of_segments(2u)
                                        .minimum_segment_share(0.02f)
                                        .visitor(std::ref(visitor))
                                        .callback(count)
                                        .random_seed(3u)
                                        .segmentation_parameters(coarse()))));
  BOOST_CHECK_GT(calls, 0u);
  BOOST_CHECK_THROW(segment(NP::segmentation_parameters(coarse()).maximum_number_of_segments(-1)),
                    std::invalid_argument);
  BOOST_CHECK_THROW(segment(NP::segmentation_parameters(coarse()).minimum_segment_share(2.)),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_is_named_wins)
{
  Parameters given = coarse();
  given.seed = 5;
  given.maximum_number_of_segments = 1;
  Parameters expected = coarse();
  expected.seed = 3;
  const Result result = segment(expected);
  BOOST_REQUIRE_GT(result.number_of_segments(), 1u);
  const auto names = NP::maximum_number_of_segments(0).random_seed(3);
  BOOST_CHECK(equal(segment(names.segmentation_parameters(given)), result));
  Labels labels;
  BOOST_CHECK(equal(CGAL::weakly_convex_segmentation(mesh(), labels.map(), given, names), result));
  const auto all_named = NP::segmentation_parameters(expected);
  BOOST_CHECK(
      equal(CGAL::weakly_convex_segmentation(mesh(), labels.map(), given, all_named), result));
  BOOST_CHECK(equal(WCS::Segmenter<>(mesh(), given, names).segment(), result));
}

BOOST_AUTO_TEST_CASE(the_level_is_that_of_the_map)
{
  const auto named = NP::segmentation_parameters(coarse());
  const Result segments = segment(named.level(Level::SEGMENTS));
  for (const Level level : {Level::PATCHES, Level::COMPONENTS})
  {
    Labels labels;
    const Result result =
        CGAL::weakly_convex_segmentation(mesh(), labels.map(), named.level(level));
    BOOST_CHECK(equal(result, segments));
    BOOST_CHECK(labels.values == result.labels_at(level));
    BOOST_CHECK(labels.values != result.labels);
  }
}

BOOST_AUTO_TEST_CASE(soups_and_segmenters)
{
  Parameters expected = coarse();
  expected.seed = 3;
  const Result result = segment(expected);
  const auto named = NP::segmentation_parameters(coarse()).random_seed(3);
  const auto& faces = shape().faces;
  BOOST_CHECK(equal(CGAL::weakly_convex_segmentation_of_soup(points(), faces, named), result));
  BOOST_CHECK(equal(WCS::Segmenter<>(points(), faces, named).segment(), result));
  BOOST_CHECK(equal(WCS::Segmenter<>(points(), faces, expected).segment(), result));
  const auto indices = boost::make_function_property_map<std::size_t>([](const std::size_t i)
                                                                      { return points()[i]; });
  const boost::counting_iterator<std::size_t> first(0), last(points().size());
  BOOST_CHECK(equal(CGAL::weakly_convex_segmentation_of_soup(
                        boost::make_iterator_range(first, last), faces, named.point_map(indices)),
                    result));

  WCS::Segmenter<> segmenter(mesh(), named);
  BOOST_CHECK(equal(segmenter.segment(), result));
  expected.maximum_number_of_segments = 2;
  BOOST_CHECK(
      equal(segmenter.segment(NP::maximum_number_of_segments(2)), segmenter.segment(expected)));
  BOOST_CHECK_EQUAL(segmenter.segment(expected).number_of_segments(), 2u);
  BOOST_CHECK(equal(segmenter.segment(), result)); // what was named before is not kept
}

BOOST_AUTO_TEST_CASE(faces_with_other_numbers)
{
  const auto named = NP::segmentation_parameters(coarse());
  const Result result = segment(named);
  const std::size_t n = mesh().number_of_faces();
  std::size_t reads = 0;
  const auto backwards = boost::make_function_property_map<Face>(
      [&reads, n](const Face f) { return ++reads, n - 1 - static_cast<std::size_t>(f); });
  BOOST_CHECK(equal(segment(named.face_index_map(backwards)), result));
  BOOST_CHECK_GE(reads, n);
  const auto same = boost::make_function_property_map<Face>([](Face) { return 0; });
  BOOST_CHECK_THROW(segment(named.face_index_map(same)), std::invalid_argument);
  const auto high = boost::make_function_property_map<Face>(
      [](const Face f) { return static_cast<std::size_t>(f) + 1; });
  BOOST_CHECK_THROW(segment(named.face_index_map(high)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_part_of_a_mesh)
{
  Mesh whole = make_mesh();
  std::vector<Face> kept;
  Mesh alone = make_mesh();
  for (const Face f : whole.faces())
    if (shape().labels[f] == 1)
      kept.push_back(f);
    else
      CGAL::Euler::remove_face(alone.halfedge(f), alone);
  BOOST_REQUIRE(kept.size() > 100 && kept.size() < whole.number_of_faces());
  const CGAL::Face_filtered_graph<Mesh> part(whole, kept);
  const auto named = NP::segmentation_parameters(coarse());
  Labels labels, expected;
  const Result result = CGAL::weakly_convex_segmentation(part, labels.map(), named);
  check_result(result, kept.size(), false);
  CGAL::weakly_convex_segmentation(alone, expected.map(), named); // with gaps between its numbers
  BOOST_CHECK(labels.values == expected.values);
  for (const Face f : whole.faces())
    BOOST_REQUIRE_EQUAL(labels.values[f] >= 0, shape().labels[f] == 1);
}

BOOST_AUTO_TEST_CASE(indices_that_are_stored_nowhere)
{
  const Shape_generator::Labeled_cloud cloud = Shape_generator::make_cloud("dumbbell", 2000);
  std::vector<std::pair<Point, Vector>> pairs;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const auto &p = cloud.points[i], &n = cloud.normals[i];
    pairs.push_back({Point(p[0], p[1], p[2]), Vector(n[0], n[1], n[2])});
  }
  const auto point = boost::make_function_property_map<std::size_t>([&](const std::size_t i)
                                                                    { return pairs[i].first; });
  const auto normal = boost::make_function_property_map<std::size_t>([&](const std::size_t i)
                                                                     { return pairs[i].second; });
  const boost::counting_iterator<std::size_t> first(0), last(pairs.size());
  std::vector<int> labels(pairs.size(), -1);
  const Result result = CGAL::weakly_convex_segmentation(
      boost::make_iterator_range(first, last), CGAL::make_property_map(labels),
      NP::segmentation_parameters(coarse()).normal_map(normal).point_map(point));
  BOOST_CHECK(labels == result.labels);
  using Pair = std::pair<Point, Vector>;
  const Result of_pairs =
      CGAL::weakly_convex_segmentation(pairs, boost::dummy_property_map(),
                                       NP::segmentation_parameters(coarse())
                                           .point_map(CGAL::First_of_pair_property_map<Pair>())
                                           .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
  BOOST_CHECK(equal(of_pairs, result));
}

BOOST_AUTO_TEST_SUITE_END()
