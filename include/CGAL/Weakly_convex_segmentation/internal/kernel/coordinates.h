// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_COORDINATES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_COORDINATES_H

// The caller's coordinates as flat arrays.

#include <CGAL/Weakly_convex_segmentation/internal/kernel/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

using Coordinates = std::array<double, 3>;

/// returns the power of two that brings coordinates to about 1 where areas or volumes of them might
/// overflow or vanish; 0, for which nothing changes, if they are between 2^-100 and 2^100.
inline int unusual_exponent(const std::vector<Coordinates>& coordinates,
                            const bool parallel = false)
{
  constexpr int usual = 100;
  double largest = 0.;
  for (const double of_block : map_blocks(coordinates.size(), parallel,
                                          [&](const std::size_t begin, const std::size_t end)
                                          {
                                            double own = 0.;
                                            for (std::size_t i = begin; i < end; ++i)
                                              for (const double c : coordinates[i])
                                                if (std::isfinite(c))
                                                  own = (std::max)(own, std::abs(c));
                                            return own;
                                          }))
    largest = (std::max)(largest, of_block);
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::abs(exponent) > usual ? exponent : 0;
}

inline Coordinates scaled(const Coordinates& p, const int exponent)
{
  return {std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent)};
}

/// returns `coordinates_of` each element, on several threads if asked for and the elements can be reached
/// at once.
template <typename Range, typename Function>
std::vector<Coordinates> read_coordinates(const Range& range, const bool parallel,
                                          const Function& coordinates_of)
{
  const auto first = range.begin();
  using Iterator = std::decay_t<decltype(first)>;
  const auto size = static_cast<std::size_t>(std::distance(first, range.end()));
  std::vector<Coordinates> result;
  if constexpr (std::is_base_of_v<std::random_access_iterator_tag,
                                  typename std::iterator_traits<Iterator>::iterator_category>)
    if (parallel)
    {
      using Step = typename std::iterator_traits<Iterator>::difference_type;
      result.resize(size);
      parallel_for(
          size, parallel,
          [&](const std::size_t i) { result[i] = coordinates_of(*(first + static_cast<Step>(i))); },
          4096);
      return result;
    }
  result.reserve(size);
  for (const auto& element : range) result.push_back(coordinates_of(element));
  return result;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_COORDINATES_H
