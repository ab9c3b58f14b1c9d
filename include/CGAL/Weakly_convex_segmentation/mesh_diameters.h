// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_DIAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_DIAMETERS_H

// CGAL's shape diameter function, in place of the diameters of this package.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// measures CGAL's shape diameter function, `CGAL::sdf_values()` without postprocessing, on all faces of a
/// triangle mesh, for `Segmenter::set_diameters()`.
///
/// It takes a header of its own as few need it and it brings CGAL's mesh segmentation along. All faces are
/// measured, though a sample would do, as the public function has no choice of faces: with it a segmentation
/// of the Princeton benchmark's meshes takes three to four times as long (`benchmark_psb --diameters cgal`).
/// Rays are cast against the orientation of the faces, so that meshes that are inside out have few diameters.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh a triangle mesh, closed for meaningful diameters; it is not changed
/// \param parameters gives the rays a face and the opening angle of the cone
///   (`Parameters::diameter_cone_angle`)
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map from the vertices of the mesh to points, which can be default
///       constructed and assigned}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{a model of `SegmentationGeomTraits` for these points}
///     \cgalParamDefault{the kernel of the points}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns one value a face, in the order of `faces(mesh)` and in units of the mesh: -1 if no ray hit;
///   nothing for a mesh without faces
///
/// Complexity: O(f log f) for f faces, with 10 rays each. The function is reentrant.
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
std::vector<double> mesh_diameters(const TriangleMesh& mesh, const Parameters& parameters = {},
                                   const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  std::vector<double> diameters;
  if (faces(mesh).begin() == faces(mesh).end()) return diameters;
  const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  const auto traits = choose_parameter(get_parameter(np, CGAL::internal_np::geom_traits),
                                       typename CGAL::Kernel_traits<Point>::Kernel());
  const auto values = get(CGAL::dynamic_face_property_t<double>(), mesh);
  constexpr std::size_t rays = 10; // a face, as many as our own diameters are measured with
  CGAL::sdf_values(mesh, values, parameters.diameter_cone_angle * (CGAL_PI / 180.), rays, false,
                   points, traits);
  for (const auto f : faces(mesh)) diameters.push_back(get(values, f));
  return diameters;
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_DIAMETERS_H
