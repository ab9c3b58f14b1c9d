// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_IO_BYTE_STREAM_H
#define SHAPE_IO_BYTE_STREAM_H

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <stdexcept>
#include <string>

// Bytes in memory as the stream that CGAL's readers want, and what to say where they fail.

namespace Shape_io {
namespace internal {

using Byte_stream = boost::iostreams::stream<boost::iostreams::array_source>;

inline void refuse_unless(const bool good, const std::string& format)
{
  if (!good)
    throw std::runtime_error("it is not a sound " + format +
                             " file, or only a part of one; check it or export the shape again");
}

} // namespace internal
} // namespace Shape_io

#endif // SHAPE_IO_BYTE_STREAM_H
