// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program/command_line.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace Command_line {

namespace {

// How many letters have to be put in, taken out or replaced.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = (std::min)({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

// A number below zero is no option.
std::vector<po::option> read_negative_number(std::vector<std::string>& arguments)
{
  const std::string first = arguments.front();
  if (first.size() < 2 || first[0] != '-' || first.find_first_of(".0123456789") != 1) return {};
  po::option number;
  number.value = {first};
  number.original_tokens = {first};
  arguments.erase(arguments.begin());
  return {number};
}

std::vector<std::string> names_of(const po::options_description& described)
{
  std::vector<std::string> names;
  for (const auto& option : described.options()) names.push_back("--" + option->long_name());
  return names;
}

std::string without_value(const std::string& option) { return option.substr(0, option.find('=')); }

} // namespace

std::string suggestion(const std::string& written, const std::vector<std::string>& candidates)
{
  std::string best;
  std::size_t least = written.size() / 3 + 1; // more letters than that are no slip
  for (const std::string& candidate : candidates)
  {
    // the beginning of a word counts as near, as what follows may have been left out
    const bool is_beginning =
        written.size() > 3 && candidate.compare(0, written.size(), written) == 0;
    const std::size_t distance = is_beginning ? 1 : edit_distance(written, candidate);
    if (distance > least || (distance == least && !best.empty())) continue;
    least = distance;
    best = candidate;
  }
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

po::variables_map parsed(const std::string& program, const int argc, const char* const argv[],
                         const po::options_description& described, const std::string& positional,
                         const int most_words)
{
  const auto refuse = [&](const std::string& what)
  { throw std::invalid_argument(what + "; see " + program + " --help"); };
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::options_description all;
  all.add(described);
  if (most_words == 1)
    all.add_options()(positional.c_str(), po::value<std::string>());
  else
    all.add_options()(positional.c_str(), po::value<std::vector<std::string>>());
  po::positional_options_description words;
  words.add(positional.c_str(), most_words);
  po::variables_map given;
  try
  {
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(words)
                  .style(style)
                  .extra_style_parser(read_negative_number)
                  .run(),
              given);
    if (given.count("help") == 0) po::notify(given);
  }
  catch (const po::unknown_option& error)
  {
    const std::string written = without_value(error.get_option_name());
    refuse("there is no option '" + written + "'" + suggestion(written, names_of(described)));
  }
  catch (const po::too_many_positional_options_error&)
  {
    refuse("there is more than one input file");
  }
  catch (const po::error& error)
  {
    refuse(error.what());
  }
  return given;
}

} // namespace Command_line
