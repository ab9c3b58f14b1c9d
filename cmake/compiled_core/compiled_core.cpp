// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compiled_core.h"

#include "../../include/CGAL/Weakly_convex_segmentation/internal/Segmenter_impl.h"

#include <utility>

template class CGAL::Weakly_convex_segmentation::Segmenter<CGAL::Sequential_tag>;
template class CGAL::Weakly_convex_segmentation::Segmenter<CGAL::Parallel_tag>;

namespace Compiled_core {

WCS::Result segment_points(WCS::internal::Raw_shape raw, const WCS::Parameters& parameters,
                           const WCS::internal::Run_control& control)
{
  return WCS::internal::segment_points(std::move(raw), parameters, control);
}

std::unique_ptr<WCS::internal::Shape_analysis>
analyze_shape(WCS::internal::Raw_shape raw, const WCS::Parameters& parameters,
              const WCS::internal::Run_control& control)
{
  return WCS::internal::analyze_shape(std::move(raw), parameters, control);
}

} // namespace Compiled_core
