// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of parts that need no people, on shapes whose measures are known.

#include <boost/test/unit_test.hpp>

#include "parts/asymmetry.h"
#include "parts/border_lines.h"
#include "parts/overcutting.h"
#include "parts/part_pieces.h"
#include "parts/part_report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_part_measures)

namespace {

namespace PM = Part_measures;
namespace SM = Segmentation_metrics;

constexpr double pi = 3.14159265358979323846;

/// Labels by the centroids of the faces.
using Labeler = std::function<int(const SM::Point&)>;

SM::Segmentation label(const SM::Mesh& mesh, const Labeler& labeler)
{
  SM::Segmentation labels;
  for (const auto& [a, b, c] : mesh.faces)
  {
    SM::Point p{};
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = (mesh.points[a][k] + mesh.points[b][k] + mesh.points[c][k]) / 3.;
    labels.push_back(labeler(p));
  }
  return labels;
}

/// a grid of columns and rows, bent by `place`; closed where the last column is the first
SM::Mesh grid(const std::size_t columns, const std::size_t rows, const bool closed,
              const std::function<SM::Point(double, double)>& place)
{
  SM::Mesh mesh;
  const std::size_t width = closed ? columns : columns + 1;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i < width; ++i)
      mesh.points.push_back(place(static_cast<double>(i) / static_cast<double>(columns),
                                  static_cast<double>(j) / static_cast<double>(rows)));
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
    {
      const std::size_t a = j * width + i, b = j * width + (i + 1) % width;
      mesh.faces.push_back({a, b, a + width});
      mesh.faces.push_back({b, b + width, a + width});
    }
  return mesh;
}

/// a body about the x axis, of so many lengths; its ends are rounded
SM::Mesh body(const double length, const std::function<double(double)>& radius)
{
  const auto place = [&](const double around, const double along)
  {
    const double x = length * along, end = (std::min)(x, length - x);
    const double r = radius(x) * (end < 1. ? std::sqrt(end * (2. - end)) : 1.);
    const double angle = 2. * pi * around;
    return SM::Point{x, r * std::cos(angle), r * std::sin(angle)};
  };
  return grid(48, static_cast<std::size_t>(10. * length), true, place);
}

/// a sheet of 4 by 1
SM::Mesh sheet()
{
  return grid(40, 10, false,
              [](const double u, const double v) {
                return SM::Point{4. * u, v, 0.};
              });
}

/// a body that is thicker at one end, and flatter above than below: only y can be turned round
SM::Mesh lopsided_body()
{
  SM::Mesh mesh = body(6., [](double) { return 1.; });
  for (SM::Point& p : mesh.points)
  {
    p[1] *= 0.6 + 0.2 * p[0];
    p[2] *= p[2] > 0. ? 0.5 : 1. + 0.1 * p[0];
  }
  return mesh;
}

std::optional<double> asymmetry(const SM::Mesh& mesh, const Labeler& labeler)
{
  const PM::Sampled_surface surface(mesh);
  const auto image = PM::find_mirror_image(surface);
  if (!image) return std::nullopt;
  return PM::asymmetry(*image, PM::Part_labels(label(mesh, labeler), mesh.faces.size()));
}

PM::Border_sums borders(const SM::Mesh& mesh, const Labeler& labeler)
{
  const PM::Sampled_surface surface(mesh);
  const PM::Part_labels labels(label(mesh, labeler), mesh.faces.size());
  return PM::measure_borders(surface,
                             PM::find_borders(mesh, SM::compute_mesh_geometry(mesh), labels));
}

std::vector<PM::Overcut_part> overcuts(const SM::Mesh& mesh, const Labeler& labeler)
{
  const PM::Sampled_surface surface(mesh);
  const SM::Mesh_geometry geometry = SM::compute_mesh_geometry(mesh);
  const PM::Part_labels labels(label(mesh, labeler), mesh.faces.size());
  const auto diameters = PM::sample_diameters(surface);
  return PM::find_overcuts(PM::find_pieces(geometry, surface,
                                           PM::find_borders(mesh, geometry, labels), diameters,
                                           labels),
                           diameters);
}

/// the labels of cuts across the x axis
Labeler cuts(const std::vector<double>& at)
{
  return [at](const SM::Point& p)
  { return static_cast<int>(std::upper_bound(at.begin(), at.end(), p[0]) - at.begin()); };
}

void check_one(const std::vector<PM::Overcut_part>& found, const int part, const PM::Overcut kind)
{
  BOOST_REQUIRE(found.size() == 1u);
  BOOST_TEST(found[0].label == part);
  BOOST_TEST(PM::overcut_name(found[0].kind) == PM::overcut_name(kind));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_plane_of_reflection_is_found)
{
  const auto plane = PM::find_mirror_plane(PM::Sampled_surface(lopsided_body()));
  BOOST_REQUIRE(plane.has_value());
  BOOST_TEST(std::abs(plane->normal.y()) > 0.999);
  BOOST_TEST(std::abs(plane->offset) < 0.01);
  BOOST_TEST(plane->residual < 0.004);
}

BOOST_AUTO_TEST_CASE(a_shape_without_a_plane_of_reflection_has_none)
{
  SM::Mesh mesh = lopsided_body();
  for (SM::Point& p : mesh.points) p[1] += p[1] > 0. ? 0.3 * p[0] : 0.; // one side goes off
  BOOST_TEST(!PM::find_mirror_plane(PM::Sampled_surface(mesh)).has_value());
}

BOOST_AUTO_TEST_CASE(labels_that_are_the_same_on_both_sides_are_symmetric)
{
  const SM::Mesh mesh = lopsided_body();
  const auto across = asymmetry(mesh, cuts({2., 4.}));
  const auto sides = asymmetry(mesh, [](const SM::Point& p) { return p[1] > 0. ? 1 : 0; });
  BOOST_REQUIRE((across && sides));
  BOOST_TEST(*across < 0.005);
  BOOST_TEST(*sides < 0.02); // some samples lie next to the plane
}

BOOST_AUTO_TEST_CASE(labels_of_one_side_only_are_as_asymmetric_as_they_are_large)
{
  const SM::Mesh mesh = lopsided_body();
  const Labeler quarter = [](const SM::Point& p) { return p[0] > 3. && p[1] > 0. ? 1 : 0; };
  const SM::Mesh_geometry geometry = SM::compute_mesh_geometry(mesh);
  const SM::Segmentation labels = label(mesh, quarter);
  double part = 0., all = 0.;
  for (std::size_t f = 0; f < labels.size(); ++f)
  {
    all += geometry.face_areas[f];
    if (labels[f] == 1) part += geometry.face_areas[f];
  }
  // pairs of a point of the part, or of its image, with one of neither
  const double share = part / all, expected = 4. * share * (1. - 2. * share);
  const auto found = asymmetry(mesh, quarter);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(std::abs(*found - expected) < 0.02);
}

BOOST_AUTO_TEST_CASE(a_straight_border_is_not_rough)
{
  const PM::Border_sums straight = borders(sheet(), cuts({2.}));
  BOOST_TEST(straight.length == 1., boost::test_tools::tolerance(1e-9));
  BOOST_TEST(straight.roughness() == 1., boost::test_tools::tolerance(1e-9));
  BOOST_TEST(straight.mean_turn() < 1e-6);
  BOOST_TEST(straight.concave_share() == 0.);
}

BOOST_AUTO_TEST_CASE(a_border_in_steps_is_rough)
{
  const auto steps = [](const SM::Point& p)
  { return std::floor(10. * p[0]) > std::floor(10. * p[1]) + 10. ? 1 : 0; };
  const PM::Border_sums stairs = borders(sheet(), steps);
  BOOST_TEST(stairs.roughness() > 1.25);
  BOOST_TEST(stairs.roughness() < 1.45); // the square root of 2, but for the ends
  BOOST_TEST(stairs.mean_turn() == 90., boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_border_in_a_crease_is_concave)
{
  SM::Mesh mesh = sheet();
  for (SM::Point& p : mesh.points) p[2] = std::abs(p[0] - 2.);
  BOOST_TEST(borders(mesh, cuts({2.})).concave_share() == 1.);
  for (SM::Point& p : mesh.points) p[2] = -p[2];
  BOOST_TEST(borders(mesh, cuts({2.})).concave_share() == 0.);
}

BOOST_AUTO_TEST_CASE(a_short_piece_of_a_trunk_is_a_band)
{
  const SM::Mesh mesh = body(10., [](double) { return 1.; });
  check_one(overcuts(mesh, cuts({4.8, 5.3})), 1, PM::Overcut::TRUNK_BAND);
  BOOST_TEST(overcuts(mesh, cuts({5.})).empty());
}

BOOST_AUTO_TEST_CASE(a_short_piece_of_a_limb_is_a_ring)
{
  const auto club = [](const double x) { return x < 4. ? 2. : x < 5. ? 6. - x : 1.; };
  check_one(overcuts(body(14., club), cuts({4.5, 9.3, 9.8})), 2, PM::Overcut::RING);
}

BOOST_AUTO_TEST_CASE(the_middle_of_an_even_tube_is_a_piece_of_it)
{
  check_one(overcuts(body(12., [](double) { return 1.; }), cuts({4., 8.})), 1,
            PM::Overcut::TUBE_PIECE);
  const auto swollen = [](const double x) { return x < 4. || x > 8. ? 0.6 : 1.; };
  BOOST_TEST(overcuts(body(12., swollen), cuts({4., 8.})).empty());
}

BOOST_AUTO_TEST_CASE(a_narrow_patch_between_parts_is_a_strip_or_a_sliver)
{
  const SM::Mesh mesh = body(8., [](double) { return 1.; });
  const auto patch = [](const double width)
  {
    return [width](const SM::Point& p)
    {
      const bool inside = p[2] > 0. && std::abs(p[1]) < width / 2. && std::abs(p[0] - 4.) < 2.;
      return inside ? 2 : p[0] > 4. ? 1 : 0;
    };
  };
  check_one(overcuts(mesh, patch(0.6)), 2, PM::Overcut::STRIP);
  check_one(overcuts(mesh, patch(0.3)), 2, PM::Overcut::SLIVER);
}

BOOST_AUTO_TEST_CASE(means_are_over_meshes_however_many_labelings_they_have)
{
  std::vector<PM::Labeling_row> rows(3);
  rows[0].mesh = rows[1].mesh = "a";
  rows[2].mesh = "b";
  for (PM::Labeling_row& row : rows) row.set = "s";
  rows[0].parts = 2;
  rows[1].parts = 4;
  rows[2].parts = 7;
  rows[0].asymmetry = 0.1;
  rows[1].asymmetry = 0.3;
  rows[1].overcuts = {{0, PM::Overcut::RING}, {1, PM::Overcut::RING}};
  const PM::Set_summary summary = PM::summarize(rows, "s");
  BOOST_TEST(summary.meshes == 2u);
  BOOST_TEST(summary.parts == 5.);
  BOOST_TEST(summary.asymmetric.size() == 1u);
  BOOST_TEST(summary.asymmetry == 0.2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(summary.overcuts[static_cast<std::size_t>(PM::Overcut::RING)] == 0.5);
  BOOST_TEST(PM::summarize(rows, "none").meshes == 0u);
}

BOOST_AUTO_TEST_CASE(labels_of_another_mesh_are_refused)
{
  BOOST_CHECK_THROW(PM::Part_labels({0, 1}, 3), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
