# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The library that the programs in tools/, the tests and the benchmarks share, compiled once. Within the
# project the first of them makes it; a folder that is configured on its own makes its own one. Include
# it after Weakly_convex_segmentation_standalone.cmake.

find_package(Boost REQUIRED COMPONENTS program_options)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)

if(NOT TARGET Weakly_convex_segmentation_tools)
  set(_wcs_tools "${CMAKE_CURRENT_LIST_DIR}/../tools")
  file(GLOB _wcs_tools_sources CONFIGURE_DEPENDS "${_wcs_tools}/*/*.cpp")
  add_library(Weakly_convex_segmentation_tools STATIC ${_wcs_tools_sources})
  target_include_directories(Weakly_convex_segmentation_tools PUBLIC "${_wcs_tools}")
  target_link_libraries(Weakly_convex_segmentation_tools
                        PUBLIC Weakly_convex_segmentation::Weakly_convex_segmentation
                               nlohmann_json::nlohmann_json
                        PRIVATE Boost::program_options PNG::PNG)
endif()
