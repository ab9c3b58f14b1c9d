// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_IO_SHAPE_IO_H
#define SHAPE_IO_SHAPE_IO_H

// Reading of shapes and writing of their parts.

#include "atomic_file.h"
#include "part_colors.h"
#include "read_shape.h"
#include "shape.h"
#include "write_parts.h"

#endif // SHAPE_IO_SHAPE_IO_H
