// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_RAW_SHAPE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_RAW_SHAPE_H

// The input of the method (sections 3 and 6) as flat arrays: points with normals, or a mesh as one point a face.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/coordinates.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// What is read through the property maps of the caller, in input order.
struct Raw_shape
{
  std::vector<Coordinates> positions;
  std::vector<Coordinates> normals;        ///< of any length; zero where there is none
  std::vector<std::array<Index, 2>> links; ///< pairs of faces that share an edge
  std::vector<Index> element_of;      ///< input element of each point; empty if they are the same
  std::size_t number_of_elements = 0; ///< if some have no point; else 0
  std::vector<char> is_double;        ///< of each face: another has the same corners; or empty
  std::vector<char> is_far;           ///< of each point: it has no say in the extent; or empty
  std::vector<std::size_t> first_corner; ///< of each face in `corners`, and the end; or empty
  std::vector<Coordinates> corners;      ///< of all faces
  std::vector<Index> solids;             ///< of each point, see `find_solids()`; or empty
  int exponent = 0; ///< lengths of the input are those here, times 2 to the power of this
};

/// What is kept of a mesh for its borders.
struct Mesh_faces
{
  std::vector<std::size_t> first_corner; ///< as in `Raw_shape`; empty if there are no faces
  std::vector<Coordinates> corners;
  std::vector<std::array<Index, 2>> links;
};

/// \throws std::invalid_argument if a coordinate is not finite.
inline void check_finite(const std::vector<Coordinates>& vectors, const char* what,
                         const bool parallel = false)
{
  const auto first_bad = map_blocks(vectors.size(), parallel,
                                    [&vectors](const std::size_t begin, const std::size_t end)
                                    {
                                      std::size_t i = begin;
                                      for (; i < end; ++i)
                                        for (const double c : vectors[i])
                                          if (!std::isfinite(c)) return i;
                                      return vectors.size();
                                    });
  for (const std::size_t i : first_bad)
    if (i < vectors.size())
      throw std::invalid_argument("the " + std::string(what) + " of element " + std::to_string(i) +
                                  " is not finite; remove or repair the element");
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_INPUT_RAW_SHAPE_H
