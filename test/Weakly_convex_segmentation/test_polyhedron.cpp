// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weakly_convex_segmentation/mesh_diameters.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "shapes_for_tests.h"

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

// Meshes other than Surface_mesh: handles instead of indices, other kernels; CGAL's diameters of a
// mesh; points of a type that CGAL does not know.

BOOST_AUTO_TEST_SUITE(test_polyhedron)

namespace {

using Shapes_for_tests::rand_distance;

const Shape_generator::Labeled_mesh& two_spheres()
{
  static const auto mesh = Shape_generator::make_mesh("two_spheres", 2500);
  return mesh;
}

/// a mesh with its faces in the order of the shape
template <typename Kernel, typename Items = CGAL::Polyhedron_items_3>
struct Polyhedron
{
  using Mesh = CGAL::Polyhedron_3<Kernel, Items>;
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  Mesh mesh;
  std::vector<Face> faces;

  explicit Polyhedron(const Shape_generator::Labeled_mesh& shape)
  {
    std::vector<Vertex> vertices;
    for (const auto& p : shape.points)
    {
      vertices.push_back(add_vertex(mesh));
      vertices.back()->point() = typename Kernel::Point_3(p[0], p[1], p[2]);
    }
    for (const auto& f : shape.faces)
      faces.push_back(CGAL::Euler::add_face(
          std::vector<Vertex>{vertices[f[0]], vertices[f[1]], vertices[f[2]]}, mesh));
    BOOST_REQUIRE(CGAL::is_closed(mesh));
  }
};

template <typename Kernel, typename Items = CGAL::Polyhedron_items_3>
CGAL::Weakly_convex_segmentation::Result segment_polyhedron()
{
  const Polyhedron<Kernel, Items> shape(two_spheres());
  std::map<typename Polyhedron<Kernel, Items>::Face, int> labels;
  const auto result =
      CGAL::weakly_convex_segmentation(shape.mesh, boost::make_assoc_property_map(labels));
  check_result(result, shape.faces.size());
  BOOST_REQUIRE_EQUAL(labels.size(), shape.faces.size());
  for (std::size_t i = 0; i < shape.faces.size(); ++i)
    BOOST_REQUIRE_EQUAL(labels.at(shape.faces[i]), result.labels[i]);
  return result;
}

/// coordinates of an array
struct Array_traits
{
  template <std::size_t I>
  struct Compute
  {
    double operator()(const std::array<double, 3>& p) const { return p[I]; }
  };
  Compute<0> compute_x_3_object() const { return {}; }
  Compute<1> compute_y_3_object() const { return {}; }
  Compute<2> compute_z_3_object() const { return {}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(polyhedra_of_three_kernels_have_the_same_parts)
{
  const auto epick = segment_polyhedron<CGAL::Exact_predicates_inexact_constructions_kernel>();
  const auto simple = segment_polyhedron<CGAL::Simple_cartesian<double>>();
  BOOST_CHECK(epick.labels == simple.labels);
  const auto epeck = segment_polyhedron<CGAL::Exact_predicates_exact_constructions_kernel>();
  BOOST_CHECK(epeck.labels == simple.labels);
  // faces with numbers that nobody has set
  const auto with_numbers =
      segment_polyhedron<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>();
  BOOST_CHECK(with_numbers.labels == simple.labels);
  BOOST_CHECK_LT(rand_distance(epick.labels, two_spheres().labels), 0.1);
  const auto soup_points = [&]
  {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    for (const auto& p : two_spheres().points) points.emplace_back(p[0], p[1], p[2]);
    return points;
  }();
  const auto soup = CGAL::weakly_convex_segmentation_of_soup(soup_points, two_spheres().faces);
  BOOST_CHECK(soup.labels == epick.labels);
}

BOOST_AUTO_TEST_CASE(points_of_a_foreign_type_are_read_through_traits)
{
  const auto result = CGAL::weakly_convex_segmentation_of_soup(
      two_spheres().points, two_spheres().faces, {}, CGAL::parameters::geom_traits(Array_traits()));
  const auto simple = segment_polyhedron<CGAL::Simple_cartesian<double>>();
  BOOST_CHECK(result.labels == simple.labels);
}

BOOST_AUTO_TEST_CASE(diameters_can_be_those_of_cgal)
{
  using CGAL::Weakly_convex_segmentation::Parameters;
  using Kernel = CGAL::Simple_cartesian<double>;
  const Polyhedron<Kernel> shape(two_spheres()); // of radius 0.26, centers 0.48 apart
  Parameters parameters;
  parameters.diameter = CGAL::Weakly_convex_segmentation::Diameter_rule::GIVEN;
  std::vector<double> diameters =
      CGAL::Weakly_convex_segmentation::mesh_diameters(shape.mesh, parameters);
  BOOST_REQUIRE_EQUAL(diameters.size(), shape.faces.size());
  std::size_t measured = 0, wide = 0;
  for (const double d : diameters)
  {
    measured += d > 0. ? 1 : 0;
    wide += d > 0.35 && d < 1.01 ? 1 : 0;
  }
  BOOST_CHECK_GE(measured, shape.faces.size() * 96 / 100);
  BOOST_CHECK_GT(wide, measured * 9 / 10);

  CGAL::Weakly_convex_segmentation::Segmenter<> segmenter(shape.mesh, parameters);
  const auto without = segmenter.segment(parameters);
  for (const auto& segment : without.segments) BOOST_CHECK_EQUAL(segment.diameter, 0.);
  segmenter.set_diameters(diameters);
  const auto with = segmenter.segment(parameters);
  check_result(with, shape.faces.size());
  BOOST_CHECK_LT(rand_distance(with.labels, two_spheres().labels), 0.1);
  for (const auto& segment : with.segments)
    BOOST_CHECK(segment.diameter > 0.35 && segment.diameter < 0.6);
  for (double& d : diameters) d *= 0.5;
  segmenter.set_diameters(diameters);
  BOOST_CHECK_CLOSE(segmenter.segment(parameters).segments[0].diameter,
                    0.5 * with.segments[0].diameter, 10.);
  diameters.assign(diameters.size(), std::numeric_limits<double>::quiet_NaN());
  segmenter.set_diameters(diameters);
  BOOST_CHECK(segmenter.segment(parameters).labels == without.labels);
  diameters.pop_back();
  BOOST_CHECK_THROW(segmenter.set_diameters(diameters), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
