// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/mesh_diameters.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/weakly_convex_segmentation.h>

#include "check_result.h"
#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

// CGAL's shape diameter function, and segmentations with it in place of our own diameters.

BOOST_AUTO_TEST_SUITE(test_mesh_diameters)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// a round bar along the z axis with fans at its ends
Mesh cylinder(const double radius, const double length)
{
  Mesh mesh;
  CGAL::make_regular_prism(64, mesh, Kernel::Point_3(0., 0., 0.), length, radius, true);
  if (!CGAL::is_triangle_mesh(mesh)) throw std::logic_error("the generator makes triangles");
  return mesh;
}

Mesh mesh_of(const Shape_generator::Labeled_mesh& shape)
{
  Mesh mesh;
  for (const auto& p : shape.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  const auto vertex = [](const std::size_t v)
  { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); };
  for (const auto& f : shape.faces) mesh.add_face(vertex(f[0]), vertex(f[1]), vertex(f[2]));
  return mesh;
}

Parameters narrow_cone()
{
  Parameters parameters;
  parameters.diameter_cone_angle = 2.;
  return parameters;
}

std::unique_ptr<Shape_analysis> analyzed(const Shape_generator::Labeled_mesh& shape,
                                         const Parameters& parameters)
{
  return Compiled_core::analyze_shape(faces_of_mesh(shape), parameters, Run_control());
}

bool are_equal(const Ray_hit& a, const Ray_hit& b)
{
  return a.found() == b.found() && a.distance == b.distance;
}

} // namespace

// Lines inwards from the side of a bar end after its thickness, from its ends after its length.
BOOST_AUTO_TEST_CASE(diameters_of_a_cylinder_are_known)
{
  const double radius = 0.5, length = 3.;
  const Mesh mesh = cylinder(radius, length);
  const std::vector<double> diameters = mesh_diameters(mesh, narrow_cone());
  BOOST_REQUIRE_EQUAL(diameters.size(), mesh.number_of_faces());
  std::size_t ends = 0;
  for (const auto f : mesh.faces())
  {
    double low = 1e9, high = -1e9;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      low = std::min(low, mesh.point(v).y());
      high = std::max(high, mesh.point(v).y());
    }
    const bool is_end = high - low < 1e-9;
    ends += is_end ? 1 : 0;
    BOOST_CHECK_CLOSE(diameters[f], is_end ? length : 2. * radius, 2.);
  }
  BOOST_CHECK_EQUAL(ends, 128u);
}

BOOST_AUTO_TEST_CASE(any_face_graph_has_the_same_diameters)
{
  const Mesh mesh = mesh_of(Shape_generator::make_mesh("two_spheres", 1500));
  const std::vector<double> usual = mesh_diameters(mesh);
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  const std::vector<double> of_polyhedron = mesh_diameters(polyhedron);
  CGAL::Surface_mesh<Epick::Point_3> epick;
  CGAL::copy_face_graph(mesh, epick);
  const std::vector<double> other = mesh_diameters(epick);
  for (std::size_t f = 0; f < usual.size(); ++f)
  {
    BOOST_CHECK_CLOSE(of_polyhedron[f], usual[f], 1e-6);
    BOOST_CHECK_CLOSE(other[f], usual[f], 1e-6);
  }

  Mesh larger = mesh;
  const auto doubled =
      larger.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:doubled").first;
  for (const auto v : larger.vertices())
    doubled[v] = CGAL::ORIGIN + 2. * (larger.point(v) - CGAL::ORIGIN);
  const std::vector<double> twice = mesh_diameters(
      larger, Parameters(), CGAL::parameters::vertex_point_map(doubled).geom_traits(Kernel()));
  for (std::size_t f = 0; f < usual.size(); ++f) BOOST_CHECK_CLOSE(twice[f], 2. * usual[f], 1e-6);
  BOOST_CHECK(mesh_diameters(Mesh()).empty());
}

// The hits stay, and a sample without a diameter has none.
BOOST_AUTO_TEST_CASE(given_diameters_replace_nothing_but_diameters)
{
  const auto shape = Shape_generator::make_mesh("figure", 4000);
  const auto own = analyzed(shape, Parameters());
  for (const Diameter_rule rule :
       {Diameter_rule::GIVEN, Diameter_rule::WHOLE_SHAPE, Diameter_rule::OWN_POINTS})
  {
    Parameters parameters;
    parameters.diameter = rule;
    const auto given = analyzed(shape, parameters);
    std::vector<double> diameters(shape.faces.size(), 7.);
    diameters[0] = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t f = 1; f < diameters.size(); f += 2) diameters[f] = f % 4 == 1 ? -1. : 0.;
    use_diameters(*given, diameters, false);
    BOOST_REQUIRE_EQUAL(given->diameters.size(), own->diameters.size());
    std::size_t missing = 0, found = 0;
    for (std::size_t s = 0; s < own->diameters.size(); ++s)
    {
      const Diameter_sample &a = given->diameters[s], &b = own->diameters[s];
      BOOST_REQUIRE_EQUAL(a.point, b.point);
      BOOST_REQUIRE(are_equal(a.inwards, b.inwards) && are_equal(a.outwards, b.outwards));
      found += b.inwards.found() ? 1 : 0;
      missing += a.diameter == 0.f ? 1 : 0;
      if (a.diameter != 0.f)
        BOOST_REQUIRE_CLOSE(a.diameter, static_cast<float>(7. / given->input.extent), 1e-3f);
    }
    BOOST_CHECK_GT(found, own->diameters.size() / 2);
    BOOST_CHECK_GT(missing, own->diameters.size() / 4);
    BOOST_CHECK_LT(missing, own->diameters.size() * 3 / 4);
  }
}

// With our own diameters given back nothing changes: neither closure nor anything else is lost.
BOOST_AUTO_TEST_CASE(own_diameters_that_are_given_back_change_nothing)
{
  for (const char* name : {"default", "training_free"}) BOOST_TEST_CONTEXT(name)
    {
      Parameters parameters = Parameters::preset(name);
      const auto shape = Shape_generator::make_mesh("airplane", 1500); // all points have a diameter
      const auto own = analyzed(shape, parameters);
      std::vector<double> diameters(shape.faces.size(), 0.);
      for (const Diameter_sample& s : own->diameters)
        diameters[own->input.elements[s.point]] = s.diameter * own->input.extent;
      Segmenter<> usual(mesh_of(shape), parameters);
      const Result expected = usual.segment(parameters);
      parameters.diameter = Diameter_rule::GIVEN;
      Segmenter<> segmenter(mesh_of(shape), parameters);
      const Result without = segmenter.segment(parameters);
      segmenter.set_diameters(diameters);
      BOOST_CHECK(segmenter.segment(parameters).labels == expected.labels);
      for (const Segment& s : without.segments) BOOST_CHECK_EQUAL(s.diameter, 0.);
      // a shape that has none measures them when they are asked for
      Segmenter<> late(mesh_of(shape), parameters);
      parameters.diameter = Diameter_rule::WHOLE_SHAPE;
      BOOST_CHECK(late.segment(parameters).labels == expected.labels);
    }
}

BOOST_AUTO_TEST_CASE(all_presets_have_sensible_parts_with_diameters_of_cgal)
{
  for (const char* name : {"default", "training_free", "paper"})
    for (const char* shape_name : {"two_spheres", "dumbbell", "hand"})
      BOOST_TEST_CONTEXT(name << " " << shape_name)
      {
        const auto shape = Shape_generator::make_mesh(shape_name, 4000);
        const Mesh mesh = mesh_of(shape);
        Parameters parameters = Parameters::preset(name);
        Segmenter<> segmenter(mesh, parameters);
        const double usual = rand_distance(segmenter.segment(parameters).labels, shape.labels);
        parameters.diameter = Diameter_rule::GIVEN;
        segmenter.set_diameters(mesh_diameters(mesh, parameters));
        const Result result = segmenter.segment(parameters);
        check_result(result, shape.faces.size());
        BOOST_CHECK_GE(result.number_of_segments(), 2u);
        BOOST_CHECK_LT(rand_distance(result.labels, shape.labels), usual + 0.05);
        for (const Segment& s : result.segments) BOOST_CHECK_GT(s.diameter, 0.);
      }
}

BOOST_AUTO_TEST_SUITE_END()
