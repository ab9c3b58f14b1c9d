// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace Shape_io {
namespace internal {

std::string shown(const std::string_view word, const std::size_t most)
{
  std::string result(word.substr(0, most));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  return result;
}

bool is_number(const std::string_view word, double& number)
{
  const char* first = word.data();
  const char* const last = first + word.size();
  if (first != last && *first == '+') ++first;
  const std::from_chars_result end = std::from_chars(first, last, number);
  if (end.ec == std::errc::result_out_of_range)
    number = std::strtod(std::string(first, last).c_str(), nullptr);
  else if (end.ec != std::errc())
    return false;
  return end.ptr == last;
}

double number_of(const std::string_view word)
{
  double number = 0.;
  if (!is_number(word, number))
    throw std::runtime_error("'" + shown(word) +
                             "' is not a number; check the file or export the shape again");
  return number;
}

std::size_t corner_index(const double number)
{
  constexpr double beyond = 1e15;
  return number >= 0. && number < beyond && number == std::floor(number)
             ? static_cast<std::size_t>(number)
             : std::size_t(-1);
}

Text_lines::Text_lines(const std::string_view text, const std::string& more_separators)
  : m_text(text), m_separators(" \t\v\f" + more_separators)
{}

bool Text_lines::next()
{
  m_words.clear();
  while (m_words.empty() && m_next < m_text.size())
  {
    m_first = m_next;
    while (take_line() && m_next < m_text.size())
    {}
  }
  return !m_words.empty();
}

void Text_lines::refuse(const std::string& what) const
{
  throw std::runtime_error("line " + std::to_string(m_line_number) + " " + what +
                           "; check the file or export the shape again");
}

bool Text_lines::take_line()
{
  const std::size_t end = (std::min)(m_text.find_first_of("\r\n", m_next), m_text.size());
  std::string_view line = m_text.substr(m_next, end - m_next);
  m_end = end;
  m_next = end + 1;
  if (m_next < m_text.size() && m_text[end] == '\r' && m_text[m_next] == '\n') ++m_next;
  ++m_line_number;
  line = line.substr(0, line.find('#'));
  const std::size_t last = line.find_last_not_of(m_separators);
  const bool goes_on = last != std::string_view::npos && line[last] == '\\';
  if (goes_on) line = line.substr(0, last);
  for (std::size_t first = line.find_first_not_of(m_separators); first != std::string_view::npos;)
  {
    const std::size_t behind = (std::min)(line.find_first_of(m_separators, first), line.size());
    m_words.push_back(line.substr(first, behind - first));
    first = line.find_first_not_of(m_separators, behind);
  }
  return goes_on;
}

} // namespace internal
} // namespace Shape_io
