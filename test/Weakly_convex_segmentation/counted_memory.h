// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COUNTED_MEMORY_H
#define TEST_COUNTED_MEMORY_H

#include <cstddef>
#include <cstdlib>
#include <new>

// Replaces operator new for the program: what is allocated is counted, the n-th allocation can be made to
// fail, and more than a gigabyte at once is never given. For one file of a program, and for one thread.

namespace Counted_memory {

inline long live_count = 0;
inline long total_count = 0;
inline long until_failure = -1; ///< none fails if it is negative

inline long live() { return live_count; }
inline long total() { return total_count; } ///< those that were asked for, released or not

/// lets the n-th allocation from now on fail, counted from 0, while it lives
class Failure
{
public:
  explicit Failure(const long n) { until_failure = n; }
  ~Failure() { until_failure = -1; }
  Failure(const Failure&) = delete;
  Failure& operator=(const Failure&) = delete;
};

inline void* allocate(const std::size_t size)
{
  constexpr std::size_t most = std::size_t(1) << 30;
  ++total_count;
  if (size > most || (until_failure >= 0 && until_failure-- == 0)) throw std::bad_alloc();
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  ++live_count;
  return memory;
}

inline void release(void* memory)
{
  if (memory != nullptr) --live_count;
  std::free(memory);
}

} // namespace Counted_memory

void* operator new(const std::size_t size) { return Counted_memory::allocate(size); }
void* operator new[](const std::size_t size) { return Counted_memory::allocate(size); }
// as the standard library has it, but for AddressSanitizer
void* operator new(const std::size_t size, const std::nothrow_t&) noexcept
{
  try
  {
    return Counted_memory::allocate(size);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { Counted_memory::release(memory); }
void operator delete[](void* memory) noexcept { Counted_memory::release(memory); }
void operator delete(void* memory, std::size_t) noexcept { Counted_memory::release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { Counted_memory::release(memory); }

#endif // TEST_COUNTED_MEMORY_H
