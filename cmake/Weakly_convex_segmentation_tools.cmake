# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The library that the programs in tools/, the tests and the benchmarks share, compiled once. Within the
# project the first of them makes it; a folder that is configured on its own makes its own one. Include
# it after Weakly_convex_segmentation_standalone.cmake.

find_package(Boost REQUIRED COMPONENTS program_options OPTIONAL_COMPONENTS iostreams)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
# Without assimp and Boost's iostreams the files of their formats are refused, with a word on what is missing.
find_package(assimp QUIET)

if(NOT TARGET Weakly_convex_segmentation_tools)
  set(_wcs_tools "${CMAKE_CURRENT_LIST_DIR}/../tools")
  file(GLOB _wcs_tools_sources CONFIGURE_DEPENDS "${_wcs_tools}/*/*.cpp")
  if(NOT TARGET assimp::assimp)
    message(STATUS "assimp was not found: glTF, GLB, 3MF, DAE and FBX are not read (Debian: libassimp-dev)")
    list(FILTER _wcs_tools_sources EXCLUDE REGEX "/scenes/")
  endif()
  if(NOT TARGET Boost::iostreams)
    message(STATUS "Boost.Iostreams was not found: .gz is not read (Debian: libboost-iostreams-dev)")
  endif()
  add_library(Weakly_convex_segmentation_tools STATIC ${_wcs_tools_sources})
  target_include_directories(Weakly_convex_segmentation_tools PUBLIC "${_wcs_tools}")
  target_link_libraries(Weakly_convex_segmentation_tools
                        PUBLIC Weakly_convex_segmentation::Weakly_convex_segmentation
                               nlohmann_json::nlohmann_json
                        PRIVATE Boost::program_options PNG::PNG)
  if(TARGET assimp::assimp)
    target_link_libraries(Weakly_convex_segmentation_tools PRIVATE assimp::assimp)
    set_source_files_properties("${_wcs_tools}/io/read_scene.cpp" PROPERTIES COMPILE_DEFINITIONS WCS_HAS_ASSIMP)
  endif()
  if(TARGET Boost::iostreams)
    target_link_libraries(Weakly_convex_segmentation_tools PRIVATE Boost::iostreams)
    set_source_files_properties("${_wcs_tools}/io/gunzip.cpp" PROPERTIES COMPILE_DEFINITIONS WCS_HAS_GZIP)
  endif()
endif()
