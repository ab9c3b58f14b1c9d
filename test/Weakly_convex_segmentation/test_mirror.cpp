// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/pipeline.h>

#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Planes of reflection, and that both sides of them are segmented alike.

BOOST_AUTO_TEST_SUITE(test_mirror)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;
using Labels = std::vector<int>;

constexpr double tolerance = 0.008;

struct Found
{
  Oriented_points points;
  Neighbor_graph graph;
  Mirror mirror;

  explicit Found(const Raw_shape& raw)
    : points(orient_points(raw, false, {}, true)), graph(build_neighbor_graph(points, 10, false)),
      mirror(find_mirror(Motion_judge(points, graph.spacing), tolerance, false))
  {}
};

/// a mesh that is turned about an oblique axis, moved, and stretched along x beyond x = 0 by a factor
Shape_generator::Labeled_mesh moved(Shape_generator::Labeled_mesh mesh, const double factor = 1.)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (auto& p : mesh.points)
  {
    const double x = p[0] > 0. ? factor * p[0] : p[0];
    const double u = c * x - s * p[1], v = s * x + c * p[1];
    p = {u + 3., c * v - s * p[2] - 1., s * v + c * p[2] + 7.};
  }
  return mesh;
}

/// how differently a labeling of faces and its mirror image divide the shape: of each face's center, the label
/// of the face whose center is nearest to its image
double asymmetry(const Raw_shape& raw, const Labels& labels, const Symmetry_plane& plane)
{
  Labels mirrored;
  for (const Coordinates& p : raw.positions)
  {
    double height = 0.;
    for (std::size_t c = 0; c < 3; ++c) height += (p[c] - plane.point[c]) * plane.normal[c];
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < raw.positions.size(); ++i)
    {
      double squared = 0.;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double d = p[c] - 2. * height * plane.normal[c] - raw.positions[i][c];
        squared += d * d;
      }
      if (squared >= least) continue;
      least = squared;
      nearest = i;
    }
    mirrored.push_back(labels[nearest]);
  }
  return rand_distance(labels, mirrored);
}

/// a tube along x, narrow at x = -3 and x = 3, whose only plane of reflection is x = 0
Raw_shape waisted_tube()
{
  constexpr int rings = 120, around = 60;
  Raw_shape raw;
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < around; ++k)
    {
      const double x = 12. * (r + 0.5) / rings - 6., from_waist = std::abs(x) - 3.;
      const double turn = 2. * 3.14159265358979323846 * k / around;
      const double c = std::cos(turn), s = std::sin(turn);
      const double radius =
          (1. + 0.2 * c + 0.4 * s * c) * (1. - 0.4 * std::exp(-8. * from_waist * from_waist));
      add_point(raw, {x, radius * c, radius * s}, {0., c, s});
    }
  return raw;
}

/// the labels of points, each the image of the one that is as far from the other end
Labels agreed_labels(const std::vector<Labels>& cuts, const bool has_mirror)
{
  std::vector<Votes> votes;
  for (const Labels& cut : cuts) votes.push_back({cut});
  std::vector<Index> image;
  const auto last = static_cast<Index>(cuts.front().size()) - 1;
  for (Index i = 0; has_mirror && i <= last; ++i) image.push_back(last - i);
  return consensus_labels(votes, 0.45, 0., image);
}

} // namespace

BOOST_AUTO_TEST_CASE(planes_of_symmetric_shapes_are_found_however_they_lie)
{
  for (const char* name : {"figure", "airplane", "four_leg", "ant", "chair"})
  {
    const Found found(points_of_mesh(moved(Shape_generator::make_mesh(name, 8000))));
    BOOST_TEST_CONTEXT(name << ": residual " << found.mirror.fit.residual << ", "
                            << found.mirror.fit.agreeing << " agree")
    {
      BOOST_REQUIRE(!found.mirror.image.empty());
      double off = 0.;
      for (Index i = 0; i < found.points.size(); ++i)
        off += length(found.mirror.plane.image(found.points.positions[i]) -
                      found.points.positions[found.mirror.image[i]]);
      BOOST_CHECK_LT(off / static_cast<double>(found.points.size()), 0.02);
    }
  }
}

BOOST_AUTO_TEST_CASE(shapes_whose_sides_differ_have_none)
{
  const auto figure = Shape_generator::make_mesh("figure", 4000);
  const auto is_symmetric = [](const Shape_generator::Labeled_mesh& mesh)
  { return !Found(points_of_mesh(mesh)).mirror.image.empty(); };
  BOOST_CHECK(is_symmetric(figure));
  // one side half as large again; its front differs from its back anyway
  BOOST_CHECK(!is_symmetric(moved(figure, 1.5)));
  BOOST_CHECK(!is_symmetric(Shape_generator::make_mesh("hand", 4000)));
}

BOOST_AUTO_TEST_CASE(few_and_degenerate_points_have_a_mirror_or_none)
{
  for (const std::size_t count : {1u, 2u, 3u, 7u})
  {
    Raw_shape raw;
    for (std::size_t i = 0; i < count; ++i)
      add_point(raw, {static_cast<double>(i), 0., 0.}, {0., 0., 1.});
    const Found found(raw);
    BOOST_CHECK(found.mirror.image.empty() || found.mirror.image.size() == count);
    for (const Index i : found.mirror.image) BOOST_CHECK_LT(i, count);
  }
}

BOOST_AUTO_TEST_CASE(votes_about_one_side_count_for_the_other)
{
  // ten points a letter: A and D are each other's image, and so are B and C
  const auto cut = [](const int a, const int b, const int c, const int d)
  {
    Labels labels;
    for (const int l : {a, b, c, d}) labels.insert(labels.end(), 10, l);
    return labels;
  };
  const Labels one = cut(0, 1, 1, 1), both = cut(0, 1, 1, 2), none = cut(1, 1, 1, 1);
  const auto has_ends = [](const Labels& labels)
  { return std::make_pair(labels[0] != labels[10], labels[20] != labels[30]); };
  // three of five against none: three of ten
  const std::vector<Labels> few = {one, one, one, none, none};
  BOOST_CHECK(has_ends(agreed_labels(few, false)) == std::make_pair(true, false));
  BOOST_CHECK(has_ends(agreed_labels(few, true)) == std::make_pair(false, false));
  // four of five and two of five: six of ten
  const std::vector<Labels> more = {one, one, both, both, none};
  BOOST_CHECK(has_ends(agreed_labels(more, false)) == std::make_pair(true, false));
  BOOST_CHECK(has_ends(agreed_labels(more, true)) == std::make_pair(true, true));
  // half, which is more than 0.45: the first merge alone would pass, but after it the other one has 0.444
  const std::vector<Labels> half = {one, both, none};
  BOOST_CHECK(has_ends(agreed_labels(half, false)) == std::make_pair(true, false));
  BOOST_CHECK(has_ends(agreed_labels(half, true)) == std::make_pair(true, true));
}

BOOST_AUTO_TEST_CASE(what_lies_between_two_sides_goes_to_neither_but_slivers)
{
  // the middle of 20 + middle + 20 points is with the one side as often as with the other
  const auto goes_to_a_side = [](const std::size_t middle)
  {
    Labels with_first(20 + middle, 0), with_last(20, 0);
    with_first.insert(with_first.end(), 20, 1);
    with_last.insert(with_last.end(), middle + 20, 1);
    const Labels labels = agreed_labels({with_first, with_last}, true);
    BOOST_CHECK_NE(labels.front(), labels.back());
    return labels[20] == labels.front() || labels[20] == labels.back();
  };
  BOOST_CHECK(goes_to_a_side(1));
  BOOST_CHECK(goes_to_a_side(4)); // as the hinge of pliers, scanned with noise
  BOOST_CHECK(!goes_to_a_side(6));
}

BOOST_AUTO_TEST_CASE(a_border_is_put_where_its_image_costs_less)
{
  const Found found(waisted_tube());
  BOOST_REQUIRE(!found.mirror.image.empty());
  std::vector<double> heights;
  for (const Vector3& p : found.points.positions) heights.push_back(found.mirror.plane.height(p));
  const double unit = *std::max_element(heights.begin(), heights.end()) / 5.95;
  for (const double side : {-1., 1.})
  {
    Labels apart, alike, one_end;
    for (const double height : heights)
    {
      const double x = side * height / unit;
      apart.push_back(x < -3. ? 0 : x > 4. ? 2 : 1);
      alike.push_back(x < -3. ? 0 : x > 3. ? 2 : 1);
      one_end.push_back(x < -3. ? 0 : 1);
    }
    const auto matched = [&](Labels labels, const Parameters& parameters)
    {
      match_borders(found.graph, found.points, found.mirror, parameters, labels);
      return labels;
    };
    BOOST_CHECK(matched(apart, Parameters()) == alike);
    BOOST_CHECK(matched(alike, Parameters()) == alike);
    BOOST_CHECK(matched(one_end, Parameters()) == one_end);
    Parameters staying;
    staying.refinement = Refinement_rule::NONE;
    BOOST_CHECK(matched(apart, staying) == apart);
  }
}

BOOST_AUTO_TEST_CASE(both_sides_of_a_shape_are_segmented_alike)
{
  struct Listening : Visitor
  {
    std::vector<Symmetry_plane> planes;
    void symmetry_found(const Symmetry_plane& plane) override { planes.push_back(plane); }
  };
  double together = 0., apart = 0.; // a single shape may be symmetric by chance
  for (const char* name : {"figure", "airplane", "four_leg"})
  {
    const Raw_shape raw = points_of_mesh(moved(Shape_generator::make_mesh(name, 8000)));
    for (const bool is_fitted : {false, true})
      BOOST_TEST_CONTEXT(name << (is_fitted ? " by fitted" : ""))
      {
        Listening listening;
        Run_control control;
        control.visitor = &listening;
        Parameters parameters = is_fitted ? Parameters() : Parameters::training_free();
        const Result result = Compiled_core::segment_points(raw, parameters, control);
        BOOST_REQUIRE(result.symmetry_plane.has_value());
        BOOST_REQUIRE_EQUAL(listening.planes.size(), 1u);
        BOOST_CHECK(listening.planes.front().point == result.symmetry_plane->point);
        BOOST_CHECK_LE(result.symmetry_plane->residual, tolerance);
        const auto& n = result.symmetry_plane->normal;
        BOOST_CHECK_CLOSE(std::hypot(n[0], n[1], n[2]), 1., 1e-3);
        BOOST_CHECK_LT(asymmetry(raw, result.labels, *result.symmetry_plane), 0.005);
        parameters.symmetry_tolerance = 0.;
        const Result own = Compiled_core::segment_points(raw, parameters, {});
        BOOST_CHECK(!own.symmetry_plane);
        together += asymmetry(raw, result.labels, *result.symmetry_plane);
        apart += asymmetry(raw, own.labels, *result.symmetry_plane);
      }
  }
  BOOST_TEST_MESSAGE("asymmetry " << together / 6. << ", sides on their own " << apart / 6.);
  BOOST_CHECK_LT(together, 0.5 * apart);
}

BOOST_AUTO_TEST_SUITE_END()
