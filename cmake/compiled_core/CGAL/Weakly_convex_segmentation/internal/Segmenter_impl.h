// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef WEAKLY_CONVEX_SEGMENTATION_COMPILED_SEGMENTER_IMPL_H
#define WEAKLY_CONVEX_SEGMENTATION_COMPILED_SEGMENTER_IMPL_H

// The library is header-only. Our own programs are many: they share what does not depend on the types of
// the input, compiled once in compiled_core.cpp. The build puts this header before the one of the same name
// for them, so that they look as a user's; without it they compile too, each with all of the library.

extern template class CGAL::Weakly_convex_segmentation::Segmenter<CGAL::Sequential_tag>;
extern template class CGAL::Weakly_convex_segmentation::Segmenter<CGAL::Parallel_tag>;

#endif // WEAKLY_CONVEX_SEGMENTATION_COMPILED_SEGMENTER_IMPL_H
