// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SHAPE_IO_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SHAPE_IO_H

// Reading of shapes and writing of their parts.

#include "io/atomic_file.h"
#include "io/part_colors.h"
#include "io/read_shape.h"
#include "io/shape.h"
#include "io/write_obj.h"
#include "io/write_parts.h"

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_SHAPE_IO_H
