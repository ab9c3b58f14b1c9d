// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_CONVEXITY_GRAPH_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_CONVEXITY_GRAPH_H

// The graph whose clusters are the initial patches.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {

/// \ingroup PkgWeaklyConvexSegmentationRef
/// A connected piece of the point-convexity graph (section 4 of the paper): its nodes are small cells of
/// points or the points themselves, and its edges join neighbors, with a high weight where the surface is
/// convex between them.
struct Convexity_graph
{
  /// An undirected edge, which is listed once.
  struct Edge
  {
    std::uint32_t first, second; ///< different nodes, from 0 on
    double weight;               ///< over 0
  };
  std::size_t number_of_nodes = 0;
  std::vector<Edge> edges; ///< each node has one at least
  /// where each node lies, as the number of a voxel of a coarse grid; may be empty. What is chosen by these numbers
  /// instead of by those of the nodes stays the same on a shape that was moved a little
  std::vector<std::uint32_t> places = {};
};

} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_CONVEXITY_GRAPH_H
