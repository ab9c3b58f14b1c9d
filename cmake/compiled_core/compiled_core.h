// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef WEAKLY_CONVEX_SEGMENTATION_COMPILED_CORE_H
#define WEAKLY_CONVEX_SEGMENTATION_COMPILED_CORE_H

#include <CGAL/Weakly_convex_segmentation/Segmenter.h>
#include <CGAL/Weakly_convex_segmentation/internal/shape_analysis.h>

#include <memory>

// Functions of the core for tests and benchmarks, compiled once: see Segmenter_impl.h in the folder beside.

namespace Compiled_core {

namespace WCS = CGAL::Weakly_convex_segmentation;

/// `internal::segment_points()` for tests and benchmarks that have points of the library's own
WCS::Result segment_points(WCS::internal::Raw_shape raw, const WCS::Parameters& parameters,
                           const WCS::internal::Run_control& control = {});

/// `internal::analyze_shape()` for the same
std::unique_ptr<WCS::internal::Shape_analysis>
analyze_shape(WCS::internal::Raw_shape raw, const WCS::Parameters& parameters,
              const WCS::internal::Run_control& control = {});

} // namespace Compiled_core

#endif // WEAKLY_CONVEX_SEGMENTATION_COMPILED_CORE_H
