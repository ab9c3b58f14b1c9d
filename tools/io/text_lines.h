// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_TEXT_LINES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_TEXT_LINES_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// The words and numbers of text files, whatever their line ends.

namespace Shape_io {
namespace internal {

// The beginning of a word of a file as messages can show it.
std::string shown(std::string_view word, std::size_t most = 20);

// Whether the word is a number, and which. Too large ones are infinite, and refused later where the
// point is named.
bool is_number(std::string_view word, double& number);

double number_of(std::string_view word);

// The index of a point. What can't be one becomes one that is out of range, which is refused later.
std::size_t corner_index(double number);

// Goes through the lines that hold words. A line ends with a line feed, a carriage return or both;
// one that ends with a backslash goes on in the next. What follows a '#' is a comment.
class Text_lines
{
public:
  // Words are parted by blanks and tabs, and by the given further separators.
  explicit Text_lines(std::string_view text, const std::string& more_separators = "");

  // Moves to the next line with words; returns false if there is none.
  bool next();

  const std::vector<std::string_view>& words() const { return m_words; }
  // All of the line, with its blanks and comments; several lines where it goes on.
  std::string_view text() const { return m_text.substr(m_first, m_end - m_first); }
  // of the line's end, from 1 on
  std::size_t line_number() const { return m_line_number; }

  [[noreturn]] void refuse(const std::string& what) const;

private:
  // Takes the words up to the next line end; returns whether the line goes on behind it.
  bool take_line();

  std::string_view m_text;
  std::string m_separators;
  std::size_t m_first = 0, m_end = 0, m_next = 0;
  std::size_t m_line_number = 0;
  std::vector<std::string_view> m_words;
};

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_TEXT_LINES_H
