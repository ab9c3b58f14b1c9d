// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_MAX_FLOW_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_MAX_FLOW_H

// CGAL's max-flow in CGAL's own namespace for it: <CGAL/boost/graph/Alpha_expansion_MaxFlow_tag.h> does
// the same, but brings the Boost Graph Library's flows along, which take seconds to compile.

#include <CGAL/license/Surface_mesh_segmentation.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace MaxFlow {
#include <CGAL/Surface_mesh_segmentation/internal/auxiliary/graph.h>
}

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_MAX_FLOW_H
