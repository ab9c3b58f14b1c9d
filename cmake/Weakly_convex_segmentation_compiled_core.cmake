# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# For our own programs only, which are many: the core of the library compiled once, and the headers of other
# libraries parsed once. It needs the package's target and defines
#
#   weakly_convex_segmentation_use_compiled_core(<target>...)
#   weakly_convex_segmentation_use_compiled_core_in(<folder>)     all programs of a folder
#
# Where the compiler only checks, every source is taken as a user's would be: nothing is precompiled.

if(NOT TARGET Weakly_convex_segmentation_compiled_core)
  set(Weakly_convex_segmentation_CORE_DIR "${CMAKE_CURRENT_LIST_DIR}/compiled_core"
      CACHE INTERNAL "Folder of the core that our own programs share")
  find_package(nlohmann_json QUIET)
  add_library(Weakly_convex_segmentation_compiled_core STATIC
              "${Weakly_convex_segmentation_CORE_DIR}/compiled_core.cpp")
  target_include_directories(Weakly_convex_segmentation_compiled_core
                             BEFORE PUBLIC "${Weakly_convex_segmentation_CORE_DIR}")
  target_link_libraries(
    Weakly_convex_segmentation_compiled_core
    PUBLIC Weakly_convex_segmentation::Weakly_convex_segmentation
           $<TARGET_NAME_IF_EXISTS:nlohmann_json::nlohmann_json>)
  if(NOT WCS_SYNTAX_ONLY)
    target_precompile_headers(Weakly_convex_segmentation_compiled_core
                              PRIVATE "${Weakly_convex_segmentation_CORE_DIR}/third_party.h")
  endif()
endif()

function(weakly_convex_segmentation_use_compiled_core)
  foreach(target IN LISTS ARGN)
    target_link_libraries(${target} PRIVATE Weakly_convex_segmentation_compiled_core)
    # before the header of the same name
    target_include_directories(${target} BEFORE PRIVATE "${Weakly_convex_segmentation_CORE_DIR}")
    # CGAL's own macro for its examples defines where its data are, which its headers know, too
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(NOT WCS_SYNTAX_ONLY AND NOT libraries MATCHES "CGAL::Data")
      target_precompile_headers(${target} REUSE_FROM Weakly_convex_segmentation_compiled_core)
    endif()
  endforeach()
endfunction()

function(weakly_convex_segmentation_use_compiled_core_in folder)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      weakly_convex_segmentation_use_compiled_core(${target})
    endif()
  endforeach()
endfunction()
