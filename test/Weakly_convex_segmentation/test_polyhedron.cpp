// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE Polyhedron
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "shapes_for_tests.h"

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <vector>

// Meshes other than Surface_mesh: handles instead of indices, other kernels.

namespace {

using Shapes_for_tests::rand_distance;

const Shape_generator::Labeled_mesh& two_spheres()
{
  static const auto mesh = Shape_generator::make_mesh("two_spheres", 2500);
  return mesh;
}

template <typename Kernel>
CGAL::Weakly_convex_segmentation::Result segment_polyhedron()
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Face = typename boost::graph_traits<Polyhedron>::face_descriptor;
  using Vertex = typename boost::graph_traits<Polyhedron>::vertex_descriptor;
  Polyhedron mesh;
  std::vector<Vertex> vertices;
  for (const auto& p : two_spheres().points)
  {
    vertices.push_back(add_vertex(mesh));
    vertices.back()->point() = typename Kernel::Point_3(p[0], p[1], p[2]);
  }
  std::vector<Face> faces;
  for (const auto& f : two_spheres().faces)
    faces.push_back(CGAL::Euler::add_face(
        std::vector<Vertex>{vertices[f[0]], vertices[f[1]], vertices[f[2]]}, mesh));
  BOOST_REQUIRE(CGAL::is_closed(mesh));

  std::map<Face, int> labels;
  const auto result =
      CGAL::weakly_convex_segmentation(mesh, boost::make_assoc_property_map(labels));
  check_result(result, faces.size());
  BOOST_REQUIRE_EQUAL(labels.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    BOOST_REQUIRE_EQUAL(labels.at(faces[i]), result.labels[i]);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(polyhedra_of_two_kernels_have_the_same_parts)
{
  const auto epick = segment_polyhedron<CGAL::Exact_predicates_inexact_constructions_kernel>();
  const auto simple = segment_polyhedron<CGAL::Simple_cartesian<double>>();
  BOOST_CHECK(epick.labels == simple.labels);
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
