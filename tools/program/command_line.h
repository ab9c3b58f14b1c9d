// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_COMMAND_LINE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_COMMAND_LINE_H

#include <boost/program_options.hpp>

#include <string>
#include <vector>

// How all programs read their command lines.

namespace Command_line {

namespace po = boost::program_options;

// "; did you mean 'word'?" with the candidate that is nearest to what was written, or nothing if none is near.
std::string suggestion(const std::string& written, const std::vector<std::string>& candidates);

// Reads options, and up to so many words without one (-1: any number), which are stored as `positional`. A number below
// zero is a value. With `help`, nothing else is asked for. Throws
// std::invalid_argument with what is wrong, and with the option that may have been meant.
po::variables_map parsed(const std::string& program, int argc, const char* const argv[],
                         const po::options_description& described,
                         const std::string& positional = "input", int most_words = 1);

} // namespace Command_line

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_COMMAND_LINE_H
