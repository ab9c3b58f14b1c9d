// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_RUN_IN_CHILD_PROCESS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_RUN_IN_CHILD_PROCESS_H

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

// A method in a process of its own: what it crashes or how long it takes does not matter to the others,
// and its memory is measured apart.

namespace Run_in_child_process {

/// What one method gives: a label a face, and the CPU seconds that it took.
struct Labeling
{
  std::string method;
  std::vector<int> labels;
  double cpu_seconds = 0.;
};

struct Outcome
{
  std::vector<Labeling> labelings;
  std::string failure;          ///< empty if all went well
  double peak_megabytes = 0.;   ///< of the child, what it shares with its parent included
  double parent_megabytes = 0.; ///< what the parent had when the child began
};

namespace internal {

inline void write_all(const int pipe, const void* data, std::size_t size)
{
  const char* bytes = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t written = ::write(pipe, bytes, size);
    if (written <= 0) ::_exit(3); // the parent is gone
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

template <typename Number>
void write_vector(const int pipe, const std::vector<Number>& values)
{
  const std::uint64_t size = values.size();
  write_all(pipe, &size, sizeof size);
  write_all(pipe, values.data(), values.size() * sizeof(Number));
}

inline void write_text(const int pipe, const std::string& text)
{
  write_vector(pipe, std::vector<char>(text.begin(), text.end()));
}

/// Takes values out of what the child sent.
class Reader
{
public:
  explicit Reader(std::vector<char> bytes) : m_bytes(std::move(bytes)) {}
  bool is_at_end() const { return m_position == m_bytes.size(); }

  template <typename Number>
  std::vector<Number> vector()
  {
    std::uint64_t size = 0;
    take(&size, sizeof size);
    if (size > m_bytes.size()) throw std::runtime_error("it ended before it was done");
    std::vector<Number> values(static_cast<std::size_t>(size));
    take(values.data(), values.size() * sizeof(Number));
    return values;
  }
  std::string text()
  {
    const std::vector<char> bytes = vector<char>();
    return std::string(bytes.begin(), bytes.end());
  }

private:
  void take(void* target, const std::size_t size)
  {
    if (size > m_bytes.size() - m_position) throw std::runtime_error("it ended before it was done");
    char* bytes = static_cast<char*>(target);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = m_bytes[m_position++];
  }
  std::vector<char> m_bytes;
  std::size_t m_position = 0;
};

inline std::vector<char> read_all(const int pipe)
{
  std::vector<char> bytes;
  std::vector<char> buffer(1 << 16);
  while (true)
  {
    const ssize_t got = ::read(pipe, buffer.data(), buffer.size());
    if (got <= 0) return bytes;
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + got);
  }
}

[[noreturn]] inline void run_child(const int pipe,
                                   const std::function<std::vector<Labeling>()>& method,
                                   const unsigned int seconds)
{
  ::alarm(seconds);
  try
  {
    const std::vector<Labeling> labelings = method();
    write_text(pipe, "");
    for (const Labeling& labeling : labelings)
    {
      write_text(pipe, labeling.method);
      write_vector(pipe, labeling.labels);
      write_vector(pipe, std::vector<double>{labeling.cpu_seconds});
    }
  }
  catch (const std::exception& error)
  {
    const std::string message = error.what();
    write_text(pipe, message.empty() ? "an exception without a message" : message);
  }
  ::_exit(0);
}

/// why the child did not end by itself, or nothing
inline std::string cause_of_death(const int status, const unsigned int seconds)
{
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "stopped after " + std::to_string(seconds) + " s";
  if (WIFSIGNALED(status)) return "ended by signal " + std::to_string(WTERMSIG(status));
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return "it ended before it was done";
  return "";
}

inline double megabytes_now()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.;
}

} // namespace internal

/// runs `method` in a child that is stopped after so many seconds of wall time.
/// \throws std::runtime_error if no child can be started
inline Outcome run(const std::function<std::vector<Labeling>()>& method, const unsigned int seconds)
{
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe to a child process can be made");
  Outcome outcome;
  outcome.parent_megabytes = internal::megabytes_now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no child process can be started");
  if (child == 0)
  {
    ::close(ends[0]);
    internal::run_child(ends[1], method, seconds);
  }
  ::close(ends[1]);
  internal::Reader reader(internal::read_all(ends[0]));
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  outcome.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024.;
  outcome.failure = internal::cause_of_death(status, seconds);
  try
  {
    if (outcome.failure.empty()) outcome.failure = reader.text();
    while (outcome.failure.empty() && !reader.is_at_end())
    {
      Labeling labeling;
      labeling.method = reader.text();
      labeling.labels = reader.vector<int>();
      labeling.cpu_seconds = reader.vector<double>().at(0);
      outcome.labelings.push_back(std::move(labeling));
    }
  }
  catch (const std::exception& error)
  {
    outcome.failure = error.what();
  }
  return outcome;
}

} // namespace Run_in_child_process

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_COMMON_RUN_IN_CHILD_PROCESS_H
