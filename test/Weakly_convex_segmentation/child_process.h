// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_CHILD_PROCESS_H
#define TEST_CHILD_PROCESS_H

#include <boost/core/demangle.hpp>

#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include <sys/wait.h>
#include <unistd.h>

// Something that may crash, in a process of its own.

namespace internal {

[[noreturn]] inline void run_child(const int pipe, const std::function<std::string()>& action)
{
  // else Boost.Test would go on with the tests here
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM})
    ::signal(signal, SIG_DFL);
  ::alarm(60);
  if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(2);
  std::string text;
  try
  {
    text = action();
  }
  catch (const std::exception& error)
  {
    text = "throws " + boost::core::demangle(typeid(error).name());
  }
  const bool is_told = ::write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::_exit(is_told ? 0 : 1);
}

} // namespace internal

/// returns what the action returns, or how it ended else. It may return some thousand characters.
inline std::string in_child(const std::function<std::string()>& action)
{
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe to a child process can be made");
  std::cout.flush(); // else the child has it too
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no child process can be started");
  if (child == 0) internal::run_child(ends[1], action);
  ::close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t got; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return "ends by signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "exit code " + std::to_string(WEXITSTATUS(status));
  return text;
}

#endif // TEST_CHILD_PROCESS_H
