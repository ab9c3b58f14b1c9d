# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# For the folders of examples, tests and benchmarks: makes the package's target available where
# they are configured on their own, in CGAL's way. Call find_package(CGAL) first. Within the
# project the target is there already, and this does nothing.

if(NOT TARGET Weakly_convex_segmentation::Weakly_convex_segmentation)
  include("${CMAKE_CURRENT_LIST_DIR}/Weakly_convex_segmentation_dependencies.cmake")
  if(Weakly_convex_segmentation_MISSING)
    list(JOIN Weakly_convex_segmentation_MISSING ", " _wcs_missing)
    message(FATAL_ERROR "Missing: ${_wcs_missing}")
  endif()
  add_library(Weakly_convex_segmentation INTERFACE)
  add_library(Weakly_convex_segmentation::Weakly_convex_segmentation
              ALIAS Weakly_convex_segmentation)
  target_include_directories(Weakly_convex_segmentation
                             INTERFACE "${CMAKE_CURRENT_LIST_DIR}/../include")
  weakly_convex_segmentation_link_dependencies(Weakly_convex_segmentation)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
  endif()
endif()
