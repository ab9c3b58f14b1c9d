// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FLOAT_BITS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FLOAT_BITS_H

// Floats as integers in the same order, so that a distance and an index fit into one integer to be compared.

#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// returns the bits of a float from 0 on: they ascend with it.
inline std::uint32_t bits_of_float(const float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// Bits of a float that rounding may change, and of no interest where distances are compared: 1 / 16,384 of it.
constexpr std::uint32_t rounded_bits = 0x1ff;

/// returns the leading bits of a float from 0 on, which ascend with it. Many distances on regular and on symmetric
/// shapes are equal but for rounding: so they are equal, and something else than the last bit decides.
inline std::uint32_t leading_bits(const float value)
{
  // to the nearest: simple numbers are in the middle of those that are equal to them
  return (bits_of_float(value) + (rounded_bits + 1) / 2) & ~rounded_bits;
}
/// returns the bits of the largest float with the given leading bits.
inline std::uint32_t largest_bits(const std::uint32_t leading)
{
  return leading + rounded_bits / 2;
}

inline float float_of_bits(const std::uint32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FLOAT_BITS_H
