// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GUNZIP_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GUNZIP_H

#include <string>

// Files compressed by gzip, by Boost.Iostreams where the build has it.

namespace Shape_io {
namespace internal {

bool can_gunzip();

// By the first bytes.
bool is_gzip(const std::string& bytes);

// Throws std::runtime_error if the bytes are not all of a gzip file, or if can_gunzip() is false.
std::string gunzip(const std::string& bytes);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_GUNZIP_H
