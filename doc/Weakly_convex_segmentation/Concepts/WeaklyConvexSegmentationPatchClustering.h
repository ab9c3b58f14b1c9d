// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgWeaklyConvexSegmentationConcepts
\cgalConcept

What the named parameter `patch_clustering` of `CGAL::weakly_convex_segmentation()` asks for: a function object
that divides a graph into clusters, which become the patches. A lambda may be one.

The work is in two steps. The model is called once for each connected piece of the graph, and does what does not
depend on chance, such as computing eigenvectors. It returns a function object, which is called once for each set
of patches (`CGAL::Weakly_convex_segmentation::Patch_parameters::number_of_patch_sets`), with another seed each time.
The sets of patches should differ, as the segments are what most of them agree on.

Clusters need not be connected in the surface, and their number need not be the wanted one: they are divided
into their connected pieces, and pieces with fewer than
5 points are given to a neighbor.

A model is copy constructible. It is called by one thread at a time. What it returns is copy constructible,
too, and with `CGAL::Parallel_tag` may be called by several threads at once. Both are deterministic: the same
graph, number and seed give the same clusters. Exceptions end the run and pass through to the caller.

\cgalHasModel `CGAL::Weakly_convex_segmentation::Spectral_patch_clustering`
\cgalHasModel `CGAL::Weakly_convex_segmentation::Voronoi_patch_clustering`

\sa `CGAL::Weakly_convex_segmentation::Convexity_graph`
*/
class WeaklyConvexSegmentationPatchClustering
{
public:
  /// returns a function object with
  /// `std::vector<std::uint32_t> operator()(unsigned int seed) const`, which returns the cluster of each node.
  ///
  /// \param graph a connected piece of the point-convexity graph. It is valid during the call only: the function
  ///   object that is returned must not refer to it.
  /// \param number_of_clusters the wanted number, which is the piece's share of
  ///   `CGAL::Weakly_convex_segmentation::Parameters::number_of_patches` by its points
  ///
  /// \pre `graph` is connected, each node has an edge, all weights are over 0.
  /// \pre `number_of_clusters` is at least 2, and `graph` has at least `number_of_clusters + 2` nodes. Smaller
  ///   pieces are not asked for.
  /// \post The function object returns `graph.number_of_nodes` clusters, in the order of the nodes; another number
  ///   is refused with a `std::invalid_argument`. Clusters are numbered from 0, in any order and with
  ///   gaps, but below the number of nodes.
  ///
  /// Complexity: near linear in the number of edges is expected. All pieces together have about
  /// `CGAL::Weakly_convex_segmentation::Parameters::number_of_supervoxels` nodes, whatever the size of the shape,
  /// and more only where it has more pieces than that.
  unspecified_type operator()(const CGAL::Weakly_convex_segmentation::Convexity_graph& graph,
                              std::size_t number_of_clusters) const;
};
