// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_CGAL_DIAMETERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_CGAL_DIAMETERS_H

#include "io/shape.h"

#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <stdexcept>
#include <vector>

// CGAL's shape diameter function of what was read as a soup of polygons.

namespace Segment_shape {

// One diameter a face. Throws std::invalid_argument for what is no oriented manifold of triangles, which
// CGAL's function needs.
std::vector<double> cgal_diameters(const Shape_io::Shape& shape,
                                   const CGAL::Weakly_convex_segmentation::Parameters& parameters);

} // namespace Segment_shape

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_CGAL_DIAMETERS_H
