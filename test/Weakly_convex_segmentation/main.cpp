// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Boost.Test's own part, compiled once for all test programs.

#define BOOST_TEST_MODULE Weakly_convex_segmentation
#include <boost/test/included/unit_test.hpp>
