# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the package into a scratch prefix, then configures, builds and runs the project beside
# this file against it. Variables: PACKAGE_BINARY_DIR (the package's build), SOURCE_DIR (of the
# project), SCRATCH_DIR, CXX_COMPILER, GENERATOR.

set(prefix "${SCRATCH_DIR}/prefix")
set(build "${SCRATCH_DIR}/build")
file(REMOVE_RECURSE "${SCRATCH_DIR}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${PACKAGE_BINARY_DIR}" --prefix "${prefix}")
# Debug: everything else is built without the assertions of CGAL and the standard library.
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${build}" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    -DCMAKE_BUILD_TYPE=Debug)

# A copy that happens to be installed elsewhere would prove nothing.
load_cache("${build}" READ_WITH_PREFIX found_ Weakly_convex_segmentation_DIR)
string(FIND "${found_Weakly_convex_segmentation_DIR}" "${prefix}/" position)
if(NOT position EQUAL 0)
  message(FATAL_ERROR "found the package in ${found_Weakly_convex_segmentation_DIR}, "
                      "not in ${prefix}")
endif()

run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/outside_project")

# Who forgets about the build type, and would wait a hundred times as long for parts, is told so: CGAL's config
# does it, which ours finds. Once, and not without need.
foreach(type "" Release)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${SCRATCH_DIR}/told${type}" -G "${GENERATOR}"
            "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
            "-DCMAKE_BUILD_TYPE=${type}"
    OUTPUT_VARIABLE told ERROR_VARIABLE told COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "CMAKE_BUILD_TYPE[ \n]+is[ \n]+set" warnings "${told}")
  list(LENGTH warnings number)
  if(type STREQUAL "" AND NOT number EQUAL 1 OR type STREQUAL "Release" AND NOT number EQUAL 0)
    message(FATAL_ERROR "${number} warnings of the build type '${type}':\n${told}")
  endif()
endforeach()
