// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_PICTURE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_PICTURE_H

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

// Pictures of pixels, on one sheet or alone, as PNG.

namespace Draw_parts {

using Color = std::array<unsigned char, 3>;

constexpr Color paper = {250, 249, 246};

struct Picture
{
  int width = 0, height = 0;
  std::vector<Color> pixels; ///< row by row

  Picture() = default;
  Picture(const int w, const int h)
    : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), paper)
  {}
  Color& at(const int x, const int y) { return pixels[index(x, y)]; }
  const Color& at(const int x, const int y) const { return pixels[index(x, y)]; }

private:
  std::size_t index(const int x, const int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// the picture without the paper around what is drawn
Picture trimmed(const Picture& picture);

/// pictures in rows, about as many as columns, evenly spread.
Picture sheet(const std::vector<Picture>& pictures, int gap);

void write_png(const Picture& picture, std::ostream& out);

} // namespace Draw_parts

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_PICTURE_H
