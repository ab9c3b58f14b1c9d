// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "draw/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Draw_parts {

namespace {

struct Row
{
  std::vector<Picture> pictures;
  int width = 0, height = 0; // of the pictures alone

  int gaps() const { return static_cast<int>(pictures.size()) + 1; }
};

std::vector<Row> rows_of(const std::vector<Picture>& pictures)
{
  const auto columns =
      static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(pictures.size()))));
  std::vector<Row> rows;
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    if (i % columns == 0) rows.emplace_back();
    Row& row = rows.back();
    row.pictures.push_back(trimmed(pictures[i]));
    row.width += row.pictures.back().width;
    row.height = (std::max)(row.height, row.pictures.back().height);
  }
  return rows;
}

void paste(const Picture& from, Picture& to, const int left, const int top)
{
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) to.at(left + x, top + y) = from.at(x, y);
}

} // namespace

Picture trimmed(const Picture& picture)
{
  int left = picture.width, right = -1, top = picture.height, bottom = -1;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.at(x, y) != paper)
      {
        left = (std::min)(left, x), right = (std::max)(right, x);
        top = (std::min)(top, y), bottom = (std::max)(bottom, y);
      }
  if (right < left) return picture;
  Picture result(right - left + 1, bottom - top + 1);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) result.at(x, y) = picture.at(left + x, top + y);
  return result;
}

Picture sheet(const std::vector<Picture>& pictures, const int gap)
{
  const std::vector<Row> rows = rows_of(pictures);
  int width = 0, height = gap;
  for (const Row& row : rows)
  {
    width = (std::max)(width, row.width + row.gaps() * gap);
    height += row.height + gap;
  }
  Picture result(width, height);
  int top = gap;
  for (const Row& row : rows)
  {
    const int between = (width - row.width) / row.gaps();
    int left = between;
    for (const Picture& picture : row.pictures)
    {
      paste(picture, result, left, top + (row.height - picture.height) / 2);
      left += picture.width + between;
    }
    top += row.height + gap;
  }
  return result;
}

void write_png(const Picture& picture, std::ostream& out)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0,
                                nullptr) == 0)
    throw std::runtime_error(std::string("no picture can be made (") + image.message +
                             "); take a smaller --size");
  out.write(bytes.data(), static_cast<std::streamsize>(size));
}

} // namespace Draw_parts
