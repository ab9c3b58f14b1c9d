// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/gunzip.h"

// Set by CMake where it finds the library.
#ifdef WCS_HAS_GZIP
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#endif

#include <ios>
#include <stdexcept>
#include <string>

namespace Shape_io {
namespace internal {

bool is_gzip(const std::string& bytes) { return bytes.compare(0, 2, "\x1f\x8b") == 0; }

#ifdef WCS_HAS_GZIP

bool can_gunzip() { return true; }

std::string gunzip(const std::string& bytes)
{
  namespace streams = boost::iostreams;
  if (!is_gzip(bytes))
    throw std::runtime_error("it is not compressed by gzip; take .gz off its name, or compress it");
  std::string result;
  try
  {
    streams::filtering_istream stream;
    stream.push(streams::gzip_decompressor());
    stream.push(streams::array_source(bytes.data(), bytes.size()));
    stream.exceptions(std::ios::badbit); // what the filter throws comes through
    streams::copy(stream, streams::back_inserter(result));
  }
  catch (const std::ios::failure&) // also of Boost's
  {
    throw std::runtime_error("its gzip data are damaged or cut off; copy or compress it again");
  }
  if (result.empty()) throw std::runtime_error("the file is empty; copy or export it again");
  return result;
}

#else

bool can_gunzip() { return false; }

std::string gunzip(const std::string&)
{
  throw std::runtime_error(
      "this build reads no .gz (it was configured without Boost.Iostreams; Debian: "
      "libboost-iostreams-dev); decompress it by gunzip");
}

#endif

} // namespace internal
} // namespace Shape_io
