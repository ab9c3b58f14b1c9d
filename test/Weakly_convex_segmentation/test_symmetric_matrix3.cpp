// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The axes of clouds of points against Eigen's, which they have to equal bit by bit.

#include <boost/test/unit_test.hpp>

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Symmetric_matrix3.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_symmetric_matrix3)

using namespace CGAL::Weakly_convex_segmentation::internal;

namespace {

void check_axes(const std::vector<Double3>& points)
{
  Double3 sum;
  Symmetric_matrix3 squares;
  Eigen::Vector3d eigen_sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d eigen_squares = Eigen::Matrix3d::Zero();
  for (const Double3& p : points)
  {
    sum += p;
    squares += Symmetric_matrix3(p);
    const Eigen::Vector3d x(p.x, p.y, p.z);
    eigen_sum += x;
    eigen_squares += x * x.transpose();
  }
  const double count = static_cast<double>(points.size());
  const Symmetric_matrix3 covariance = squares / count - Symmetric_matrix3(sum / count);
  const Principal_axes axes(covariance);
  const Eigen::Vector3d center = eigen_sum / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(eigen_squares / count - center * center.transpose());
  for (int c = 0; c < 3; ++c)
  {
    BOOST_REQUIRE_EQUAL(axes.values()[c], solver.eigenvalues()[c]);
    BOOST_REQUIRE_EQUAL(axes.longest()[c], solver.eigenvectors()(c, 2));
  }
  // of two axes that are short alike, ours may be another one than Eigen's
  const Double3 shortest = axes.shortest();
  const Double3 image{dot(covariance.column(0), shortest), dot(covariance.column(1), shortest),
                      dot(covariance.column(2), shortest)};
  BOOST_REQUIRE_CLOSE(length(shortest), 1., 1e-9);
  BOOST_REQUIRE_SMALL(length(image - axes.values().x * shortest), 1e-7 * axes.values().z + 1e-30);
  BOOST_REQUIRE_EQUAL(length(sum), eigen_sum.norm());
}

} // namespace

BOOST_AUTO_TEST_CASE(axes_are_those_of_eigen)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  const Double3 shapes[] = {{1., 1., 1.}, {1., 1., 0.},   {1., 0., 0.},
                            {0., 1., 1.}, {1., 1e-6, 1.}, {1e-9, 1., 1.}};
  for (int i = 0; i < 60000; ++i)
  {
    const Double3& shape = shapes[i % 6];
    std::vector<Double3> points;
    for (int k = 0; k <= i % 7; ++k)
      points.push_back({shape.x * coordinate(random), shape.y * coordinate(random),
                        shape.z * coordinate(random)});
    check_axes(points);
  }
}

BOOST_AUTO_TEST_CASE(equal_axes_are_those_of_eigen)
{
  check_axes(
      {{1., 0., 0.}, {-1., 0., 0.}, {0., 1., 0.}, {0., -1., 0.}, {0., 0., 1.}, {0., 0., -1.}});
  check_axes({{1., 0., 0.}, {-1., 0., 0.}, {0., 1., 0.}, {0., -1., 0.}});
  check_axes(
      {{0., 0., 2.}, {0., 0., -2.}, {0., 1., 0.}, {0., -1., 0.}, {1., 0., 0.}, {-1., 0., 0.}});
  check_axes({{3., 3., 3.}});
}

BOOST_AUTO_TEST_SUITE_END()
