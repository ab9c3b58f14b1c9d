// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/survives.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <functional>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Scenes {

namespace {

[[noreturn]] void work_as_child(const std::function<void()>& work, const unsigned int seconds)
{
  // nothing is to be seen of it, nor of what the caller had not printed yet
  const int nowhere = open("/dev/null", O_WRONLY);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, output);
  // a crash is to be one, without a file of the memory and without the handlers of who called
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const rlimit time = {seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM})
    std::signal(number, SIG_DFL);
  try
  {
    work();
  }
  catch (...) // the caller meets it again
  {}
  _exit(EXIT_SUCCESS);
}

} // namespace

bool survives(const std::function<void()>& work, const unsigned int seconds)
{
  const pid_t child = fork();
  if (child == 0) work_as_child(work, seconds);
  if (child < 0) return true;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return true;
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

} // namespace Scenes
