// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "io/shape_io.h"
#include "scratch_folder.h"

#include <algorithm>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_text_files)

namespace {

const std::string off = "OFF\n# comment\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string obj = "# comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n";
const std::string xyz = "0 0 0\n1 0 0\n0 1 0\n";

template <typename Change>
void check_all(const Change& change)
{
  const Scratch_folder folder;
  for (const auto& [name, text] : {std::make_pair("t.off", off), {"t.obj", obj}, {"t.xyz", xyz}})
  {
    const auto shape = Shape_io::read_shape(folder.write(name, change(text)));
    BOOST_REQUIRE_EQUAL(shape.points.size(), 3u);
    BOOST_TEST(shape.points[1].x() == 1);
    BOOST_TEST(shape.points[2].y() == 1);
    BOOST_TEST(shape.is_mesh() == (text != xyz));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(byte_order_mark)
{
  check_all([](const std::string& text) { return "\xEF\xBB\xBF" + text; });
}

BOOST_AUTO_TEST_CASE(old_mac_line_ends)
{
  check_all(
      [](std::string text)
      {
        std::replace(text.begin(), text.end(), '\n', '\r');
        return text;
      });
}

BOOST_AUTO_TEST_SUITE_END()
