// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swaps the line of sight: triangles of the closed mesh are in the way, not disks, and lines are counted.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weakly_convex_segmentation/Mesh_line_of_sight.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A model of WeaklyConvexSegmentationLineOfSight; it is copied, so the count is kept outside of it.
class Counted_line_of_sight
{
  WCS::Mesh_line_of_sight<Mesh> m_exact;
  std::size_t* m_count;

public:
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  Counted_line_of_sight(const Mesh& mesh, std::size_t& count) : m_exact(mesh), m_count(&count) {}
  bool sees(const Point_3& p, const Point_3& q) const
  {
    ++*m_count;
    return m_exact.sees(p, q);
  }
  double distance_to_exit(const Point_3& p, const Vector_3& d) const
  {
    return m_exact.distance_to_exit(p, d);
  }
  double distance_to_entry(const Point_3& p, const Vector_3& d) const
  {
    return m_exact.distance_to_entry(p, d);
  }
};

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("dumbbell.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.number_of_faces() == 0)
    throw std::runtime_error("no manifold mesh can be read from " + filename);
  auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label").first;

  std::size_t lines = 0;
  const auto result = CGAL::weakly_convex_segmentation(
      mesh, label, CGAL::parameters::line_of_sight(Counted_line_of_sight(mesh, lines)));
  std::cout << result.number_of_segments() << " segments by " << lines << " exact lines of sight\n";
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << "own_line_of_sight: " << error.what() << '\n';
  return EXIT_FAILURE;
}
