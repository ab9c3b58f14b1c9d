// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that the compiler has to refuse, each with one error. Without WRONG it has to accept the rest. See
// run.cmake, which reads what is expected after "error:" in the comments.

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace WCS = CGAL::Weakly_convex_segmentation;
namespace NP = CGAL::parameters;
using CGAL::weakly_convex_segmentation;
using CGAL::weakly_convex_segmentation_of_soup;
using WCS::Segmenter;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Set = CGAL::Point_set_3<Point>;
using Pair = std::pair<Point, Vector>;
using Points = std::vector<Point>;
using Pairs = std::vector<Pair>;
using Triangles = std::vector<std::vector<std::size_t>>;
using Face_labels = Mesh::Property_map<Mesh::Face_index, int>;
using Face_names = Mesh::Property_map<Mesh::Face_index, std::string>;
using Vertex_labels = Mesh::Property_map<Mesh::Vertex_index, int>;
using Edge_marks = Mesh::Property_map<Mesh::Edge_index, bool>;
using Set_labels = Set::Property_map<int>;

const CGAL::First_of_pair_property_map<Pair> first;
const CGAL::Second_of_pair_property_map<Pair> second;
const boost::dummy_property_map nowhere;

void right(const Mesh& mesh, const Face_labels labels, const Set& set, const Set_labels set_labels,
           const Pairs& pairs, const Triangles& triangles)
{
  weakly_convex_segmentation(mesh, labels, NP::level(WCS::Level::PATCHES).random_seed(1));
  weakly_convex_segmentation(mesh, labels, {}, NP::vertex_point_map(mesh.points()));
  weakly_convex_segmentation(set, set_labels, NP::minimum_segment_share(0.1).random_seed(1));
  weakly_convex_segmentation(pairs, nowhere, NP::point_map(first).normal_map(second));
  weakly_convex_segmentation_of_soup(pairs, triangles, NP::point_map(first));
}

#ifdef WRONG
void wrong(const Mesh& mesh, const Face_labels labels, const Vertex_labels vertex_labels,
           const Face_names names, const Edge_marks marks, const Set& set, const Points& points,
           const Pairs& pairs, const Triangles& triangles)
{
  // error: Parallel_tag is enabled but TBB is unavailable.
  weakly_convex_segmentation<CGAL::Parallel_tag>(mesh, labels);
  // error: the last argument is neither Parameters nor named parameters
  weakly_convex_segmentation(mesh, labels, 7);
  // error: the input is neither a range of points nor a mesh
  weakly_convex_segmentation(WCS::Parameters(), labels);
  // error: the polygons are not a range of ranges of indices of points
  weakly_convex_segmentation_of_soup(points, mesh);
  // error: point_map and normal_map are for points: a mesh has a vertex_point_map
  weakly_convex_segmentation(mesh, labels, NP::normal_map(second));
  // error: vertex_point_map and face_index_map are for meshes
  weakly_convex_segmentation(points, nowhere, {}, NP::vertex_point_map(mesh.points()));
  // error: point_map and normal_map are not for a CGAL::Point_set_3, which has its own
  weakly_convex_segmentation(set, nowhere, NP::level(WCS::Level::PATCHES).point_map(first));
  // error: one of the named parameters is not read here
  weakly_convex_segmentation(mesh, labels, NP::edge_is_constrained_map(marks));
  // error: the elements of the range, or what point_map gives for them, are not points
  weakly_convex_segmentation(pairs, nowhere);
  // error: normal_map does not give vectors for the elements of the range
  weakly_convex_segmentation(points, nowhere, NP::normal_map(second));
  // error: vertex_point_map does not give points for the vertices of the mesh
  weakly_convex_segmentation(mesh, labels, NP::vertex_point_map(first));
  // error: the label map is not a WritablePropertyMap
  weakly_convex_segmentation(mesh, vertex_labels);

  // the same mistakes in other places
  // error: the label map is not a WritablePropertyMap
  weakly_convex_segmentation(mesh, names);
  // error: one of the named parameters is not read here
  Segmenter<> of_mesh(mesh, NP::level(WCS::Level::PATCHES));
  // error: one of the named parameters is not read here
  of_mesh.segment(NP::random_seed(1));
  // error: one of the named parameters is not read here
  weakly_convex_segmentation_of_soup(points, triangles, NP::normal_map(second));
}
#endif
