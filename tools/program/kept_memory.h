// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_KEPT_MEMORY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_KEPT_MEMORY_H

#include <cstdlib> // tells whether the C library is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace Program_memory {

// Lets what one stage frees stay with the program for the next. By default glibc gives large blocks back to the system
// each time, and to get as many pages anew takes a third of a run: of a million points, 2.4 s instead of 3.45 s.
inline void keep_freed()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

} // namespace Program_memory

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_KEPT_MEMORY_H
