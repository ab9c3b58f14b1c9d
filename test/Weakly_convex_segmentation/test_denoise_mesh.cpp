// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/input/denoise_mesh.h>

#include "compiled_core.h"
#include "shapes_for_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

// Meshes whose vertices have noise, also more than their walls are thick.

BOOST_AUTO_TEST_SUITE(test_denoise_mesh)

namespace {

using namespace CGAL::Weakly_convex_segmentation;
using namespace CGAL::Weakly_convex_segmentation::internal;
using namespace Shapes_for_tests;

Raw_shape smoothed(const Raw_shape& raw)
{
  Raw_shape result;
  BOOST_REQUIRE(denoise_mesh(raw, {}, result));
  return result;
}

/// six times the volume: the normals are twice as long as the areas
double volume(const Raw_shape& raw)
{
  double sum = 0.;
  for (std::size_t f = 0; f < raw.positions.size(); ++f)
    sum += dot(raw.positions[f], raw.normals[f]);
  return sum;
}

/// the mean angle between the normals of two meshes, in degrees
double turned(const Raw_shape& a, const Raw_shape& b)
{
  double sum = 0.;
  for (std::size_t f = 0; f < a.normals.size(); ++f)
  {
    const double cosine =
        dot(a.normals[f], b.normals[f]) / (length(a.normals[f]) * length(b.normals[f]));
    sum += std::acos((std::max)(-1., (std::min)(1., cosine))) * 57.29577951308232;
  }
  return sum / static_cast<double>(a.normals.size());
}

} // namespace

BOOST_AUTO_TEST_CASE(meshes_without_noise_are_left_as_they_are)
{
  for (const std::string& name : Shape_generator::shape_names())
  {
    BOOST_TEST_CONTEXT(name)
    {
      const Raw_shape raw = faces_of_mesh(Shape_generator::make_mesh(name, 6000));
      Raw_shape result;
      BOOST_CHECK_LT(face_roughness(raw), 0.7 * mesh_noise_tolerance);
      BOOST_CHECK(!denoise_mesh(raw, {}, result));
      BOOST_CHECK(result.positions.empty());
    }
  }
}

BOOST_AUTO_TEST_CASE(points_have_no_faces_to_smooth)
{
  const Raw_shape raw =
      points_of_mesh(shaken(Shape_generator::make_mesh("dumbbell", 3000), 0.05, 1));
  Raw_shape result;
  BOOST_CHECK_GT(face_roughness(raw), mesh_noise_tolerance);
  BOOST_CHECK(!denoise_mesh(raw, {}, result));
}

BOOST_AUTO_TEST_CASE(noise_goes_and_the_shape_stays)
{
  for (const std::string name : {"dumbbell", "torus", "hand", "cup"})
  {
    BOOST_TEST_CONTEXT(name)
    {
      const auto mesh = Shape_generator::make_mesh(name, 8000);
      const Raw_shape clean = faces_of_mesh(mesh);
      const Raw_shape rough = faces_of_mesh(shaken(mesh, 0.02, 2));
      const Raw_shape smooth = smoothed(rough);
      BOOST_CHECK_GT(turned(rough, clean), 15.);
      BOOST_CHECK_LT(turned(smooth, clean), 0.5 * turned(rough, clean));
      BOOST_CHECK_LT(face_roughness(smooth), mesh_noise_tolerance);
      BOOST_CHECK_CLOSE(volume(smooth), volume(clean), 9.);
      BOOST_CHECK(smooth.links == rough.links);
      BOOST_CHECK(smooth.first_corner == rough.first_corner);
    }
  }
}

BOOST_AUTO_TEST_CASE(normals_that_were_turned_stay_turned)
{
  Raw_shape raw = faces_of_mesh(shaken(Shape_generator::make_mesh("dumbbell", 3000), 0.05, 3));
  const Raw_shape smooth = smoothed(raw);
  for (auto& n : raw.normals) n = {-n[0], -n[1], -n[2]};
  const Raw_shape of_turned = smoothed(raw);
  for (std::size_t f = 0; f < smooth.normals.size(); ++f)
    for (int c = 0; c < 3; ++c) BOOST_REQUIRE_EQUAL(of_turned.normals[f][c], -smooth.normals[f][c]);
}

BOOST_AUTO_TEST_CASE(the_order_of_the_faces_does_not_matter)
{
  auto mesh = shaken(Shape_generator::make_mesh("dumbbell", 3000), 0.05, 4);
  const Raw_shape smooth = smoothed(faces_of_mesh(mesh));
  std::reverse(mesh.faces.begin(), mesh.faces.end());
  const Raw_shape reversed = smoothed(faces_of_mesh(mesh));
  const std::size_t n = smooth.positions.size();
  for (std::size_t f = 0; f < n; ++f)
    BOOST_REQUIRE(smooth.positions[f] == reversed.positions[n - 1 - f]);
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite_are_refused_by_their_face)
{
  auto mesh = shaken(Shape_generator::make_mesh("dumbbell", 3000), 0.05, 5);
  mesh.points[mesh.faces[7][1]][1] = std::numeric_limits<double>::quiet_NaN();
  const Raw_shape raw = faces_of_mesh(mesh);
  std::size_t first = 0;
  while (!std::isnan(raw.positions[first][1])) ++first;
  Raw_shape result;
  BOOST_CHECK_EXCEPTION(denoise_mesh(raw, {}, result), std::invalid_argument,
                        [first](const std::exception& error)
                        {
                          const std::string element = "element " + std::to_string(first) + " ";
                          return std::string(error.what()).find(element) != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(parts_under_much_noise_are_those_of_the_shape)
{
  double sum = 0.; // of the errors of the default without denoising
  for (const std::string name : {"box", "dumbbell", "torus", "table", "cup", "airplane", "hand"})
  {
    BOOST_TEST_CONTEXT(name)
    {
      const auto mesh = Shape_generator::make_mesh(name, 12000);
      const Raw_shape rough = faces_of_mesh(shaken(mesh, 0.03, 6));
      const auto error = [&](const Raw_shape& raw, const Parameters& parameters) {
        return rand_distance(Compiled_core::segment_points(raw, parameters, {}).labels,
                             mesh.labels);
      };
      for (const Parameters& preset : {Parameters(), Parameters::training_free()})
      {
        double of_rough = 0.; // of five noises: a single one may be worse by chance
        for (const unsigned int seed : {3u, 4u, 5u, 6u, 7u})
          of_rough += error(faces_of_mesh(shaken(mesh, 0.03, seed)), preset) / 5.;
        BOOST_CHECK_LT(of_rough, error(faces_of_mesh(mesh), preset) + 0.06);
      }
      Parameters parameters = Parameters::training_free(); // the default bears some noise on some
      parameters.denoise = false;
      BOOST_CHECK_GT(error(rough, parameters), 0.15);
      parameters = Parameters();
      parameters.denoise = false;
      sum += error(rough, parameters);
    }
  }
  BOOST_CHECK_GT(sum / 7., 0.15);
}

BOOST_AUTO_TEST_SUITE_END()
