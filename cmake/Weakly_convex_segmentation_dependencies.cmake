# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Finds the libraries that the package stands on and defines
#
#   weakly_convex_segmentation_link_dependencies(<interface target>)
#
# which adds them to a target. Used by the build and, installed, by the package's CMake config, so
# that both find the same things. `WCS_WITH_TBB` (ON unless set) uses TBB where it is found;
# `WCS_QUIET` is handed on to find_package, `Weakly_convex_segmentation_MISSING` names what is not
# there.

if(NOT DEFINED WCS_WITH_TBB)
  set(WCS_WITH_TBB ON)
endif()

set(Weakly_convex_segmentation_MISSING "")

if(NOT TARGET CGAL::CGAL)
  find_package(CGAL 5.5 QUIET)
endif()
if(NOT TARGET CGAL::CGAL)
  list(APPEND Weakly_convex_segmentation_MISSING "CGAL 5.5 or later (Debian: libcgal-dev)")
endif()

find_package(Eigen3 3.3 QUIET)
if(TARGET CGAL::CGAL AND NOT TARGET CGAL::Eigen3_support)
  include(CGAL_Eigen3_support)
endif()
if(NOT TARGET CGAL::Eigen3_support)
  list(APPEND Weakly_convex_segmentation_MISSING "Eigen 3.3 or later (Debian: libeigen3-dev)")
endif()

# Debian's package has a CMake config; elsewhere the headers may lie alone. Those of Spectra before 1.0, whose
# interface is another one, have no Version.h.
if(NOT TARGET Spectra::Spectra)
  find_package(Spectra 1.0 QUIET)
endif()
if(NOT TARGET Spectra::Spectra)
  find_path(Weakly_convex_segmentation_SPECTRA_INCLUDE_DIR Spectra/Util/Version.h)
  mark_as_advanced(Weakly_convex_segmentation_SPECTRA_INCLUDE_DIR)
  if(NOT Weakly_convex_segmentation_SPECTRA_INCLUDE_DIR)
    list(APPEND Weakly_convex_segmentation_MISSING "Spectra 1.0 or later (Debian: libspectra-dev)")
  endif()
endif()

if(WCS_WITH_TBB)
  find_package(TBB QUIET)
  if(TARGET CGAL::CGAL AND TBB_FOUND AND NOT TARGET CGAL::TBB_support)
    include(CGAL_TBB_support)
  endif()
endif()

function(weakly_convex_segmentation_link_dependencies target)
  target_compile_features(${target} INTERFACE cxx_std_17)
  target_link_libraries(${target} INTERFACE CGAL::CGAL CGAL::Eigen3_support)
  if(TARGET Spectra::Spectra)
    target_link_libraries(${target} INTERFACE Spectra::Spectra)
  else()
    target_include_directories(${target} SYSTEM INTERFACE
                               "${Weakly_convex_segmentation_SPECTRA_INCLUDE_DIR}")
  endif()
  if(WCS_WITH_TBB AND TARGET CGAL::TBB_support)
    target_link_libraries(${target} INTERFACE CGAL::TBB_support)
  endif()
endfunction()
