// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_RUN_PROGRAM_H
#define TEST_RUN_PROGRAM_H

#include "scratch_folder.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <sys/wait.h>

// Runs the programs as a user does. They are in the folder that the environment variable WCS_BIN_DIR
// names; CTest sets it. Include it after Boost.Test.

using Words = std::vector<std::string>;

struct Outcome
{
  int exit_code;
  std::string out, err;
};

inline std::string quoted(const std::string& word)
{
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

// Runs a program in the folder, with standard input from a file there; its output goes to files
// beside, not in, the folder.
inline Outcome run(const Scratch_folder& folder, const std::string& program,
                   const Words& words = {}, const std::string& input = "/dev/null")
{
  const char* const bin_dir = std::getenv("WCS_BIN_DIR");
  BOOST_REQUIRE_MESSAGE(bin_dir, "set WCS_BIN_DIR to the folder of the programs");
  const Scratch_folder output;
  std::string command = "cd " + quoted(folder.path().string()) + " && " +
                        quoted(std::string(bin_dir) + "/" + program);
  for (const std::string& word : words) command += " " + quoted(word);
  command +=
      " >" + quoted(output.file("out")) + " 2>" + quoted(output.file("err")) + " <" + quoted(input);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output.read("out"), output.read("err")};
}

#endif // TEST_RUN_PROGRAM_H
