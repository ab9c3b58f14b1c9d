// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_TEXT_LINES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_TEXT_LINES_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

// The words and numbers of text files, whatever their line ends.

namespace Shape_io {
namespace internal {

// The beginning of a word of a file as messages can show it.
inline std::string shown(const std::string_view word, const std::size_t most = 20)
{
  std::string result(word.substr(0, most));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return result;
}

// Whether the word is a number, and which. Too large ones are infinite, and refused later where the
// point is named.
inline bool is_number(const std::string_view word, double& number)
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

inline double number_of(const std::string_view word)
{
  double number = 0.;
  if (!is_number(word, number))
    throw std::runtime_error("'" + shown(word) +
                             "' is not a number; check the file or export the shape again");
  return number;
}

// The index of a point. What can't be one becomes one that is out of range, which is refused later.
inline std::size_t corner_index(const double number)
{
  constexpr double beyond = 1e15;
  return number >= 0. && number < beyond && number == std::floor(number)
             ? static_cast<std::size_t>(number)
             : std::size_t(-1);
}

// Goes through the lines that hold words. A line ends with a line feed, a carriage return or both;
// one that ends with a backslash goes on in the next. What follows a '#' is a comment.
class Text_lines
{
public:
  // Words are parted by blanks and tabs, and by the given further separators.
  explicit Text_lines(const std::string_view text, const std::string& more_separators = "")
    : m_text(text), m_separators(" \t\v\f" + more_separators)
  {}

  // Moves to the next line with words; returns false if there is none.
  bool next()
  {
    m_words.clear();
    while (m_words.empty() && m_next < m_text.size())
      while (take_line() && m_next < m_text.size())
      {}
    return !m_words.empty();
  }

  const std::vector<std::string_view>& words() const { return m_words; }
  // of the line's end, from 1 on
  std::size_t line_number() const { return m_line_number; }

  [[noreturn]] void refuse(const std::string& what) const
  {
    throw std::runtime_error("line " + std::to_string(m_line_number) + " " + what +
                             "; check the file or export the shape again");
  }

private:
  // Takes the words up to the next line end; returns whether the line goes on behind it.
  bool take_line()
  {
    const std::size_t end = (std::min)(m_text.find_first_of("\r\n", m_next), m_text.size());
    std::string_view line = m_text.substr(m_next, end - m_next);
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

  std::string_view m_text;
  std::string m_separators;
  std::size_t m_next = 0;
  std::size_t m_line_number = 0;
  std::vector<std::string_view> m_words;
};

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_TEXT_LINES_H
