# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Lets the compiler check the calls beside this file: the right ones without an error, and each of the
# wrong ones with one error. Variables: SOURCE, CXX_COMPILER, INCLUDE_DIRS (separated by commas).

string(REPLACE "," ";" directories "${INCLUDE_DIRS}")
list(TRANSFORM directories PREPEND "-I")
set(check "${CXX_COMPILER}" -std=c++17 -fsyntax-only ${directories} "${SOURCE}")

execute_process(COMMAND ${check} RESULT_VARIABLE result ERROR_VARIABLE messages)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the right calls are refused:\n${messages}")
endif()

set(ENV{LC_ALL} C)
execute_process(COMMAND ${check} -DWRONG RESULT_VARIABLE result ERROR_VARIABLE messages)
if(result EQUAL 0)
  message(FATAL_ERROR "the wrong calls are accepted")
endif()

# A text is wrong as often as it is expected; no other error follows from one.
file(STRINGS "${SOURCE}" expected REGEX "^ *// error: ")
list(TRANSFORM expected REPLACE "^ *// error: " "")
list(LENGTH expected number_expected)
string(REGEX MATCHALL "error: " errors "${messages}")
list(LENGTH errors number)
if(NOT number EQUAL number_expected)
  message(FATAL_ERROR "${number} errors, not ${number_expected}:\n${messages}")
endif()
list(REMOVE_DUPLICATES expected)
foreach(text IN LISTS expected)
  string(FIND "${messages}" "${text}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "no error tells that ${text}:\n${messages}")
  endif()
endforeach()
message(STATUS "${number} wrong calls, ${number} errors")
