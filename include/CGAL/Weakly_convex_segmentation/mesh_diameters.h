// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_DIAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_DIAMETERS_H

#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh_segmentation/internal/SDF_calculation.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// measures CGAL's shape diameter function on some faces of a triangle mesh, spread evenly over their
/// order, for `Segmenter::set_diameters()`.
///
/// It takes a header of its own as few need it and it brings CGAL's mesh segmentation along.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh a triangle mesh, closed for meaningful diameters; it is not changed
/// \param parameters gives the number of faces (`Parameters::diameter_samples`), the rays a face
///   (`Parameters::diameter_rays`) and the opening angle of the cone (`Parameters::diameter_cone_angle`)
/// \returns one value a face, in the order of `faces(mesh)` and in units of the mesh: -1 if no ray hit, not a
///   number if not sampled; nothing for a mesh without faces
///
/// Complexity: O(f log f) for f faces, and O(log f) a ray. The function is reentrant.
template <typename TriangleMesh>
std::vector<double> mesh_diameters(const TriangleMesh& mesh, const Parameters& parameters = {})
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type;
  using Kernel =
      typename CGAL::Kernel_traits<typename boost::property_traits<Point_map>::value_type>::Kernel;

  std::vector<face_descriptor> all(faces(mesh).begin(), faces(mesh).end());
  std::vector<double> diameters(all.size(), std::numeric_limits<double>::quiet_NaN());
  if (all.empty()) return diameters;
  const std::size_t count = (std::min)(all.size(), parameters.diameter_samples);
  std::vector<face_descriptor> sample;
  for (std::size_t s = 0; s < count; ++s)
    sample.push_back(all[(2 * s + 1) * all.size() / (2 * count)]);

  std::unordered_map<face_descriptor, double> values;
  const CGAL::internal::SDF_calculation<TriangleMesh, Point_map, Kernel> calculation(
      mesh, get(CGAL::vertex_point, mesh), false, false, Kernel());
  calculation.calculate_sdf_values(
      sample.begin(), sample.end(), parameters.diameter_cone_angle * (CGAL_PI / 180.),
      parameters.diameter_rays, boost::make_assoc_property_map(values));
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    const auto it = values.find(all[f]);
    if (it != values.end()) diameters[f] = it->second;
  }
  return diameters;
}

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_MESH_DIAMETERS_H
