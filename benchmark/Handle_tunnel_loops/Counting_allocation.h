#ifndef BENCHMARK_COUNTING_ALLOCATION_H
#define BENCHMARK_COUNTING_ALLOCATION_H

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <malloc.h>
#include <new>

/// \file Counting_allocation.h
/// Replaces the global operator new, to know how many bytes are in use and how many were at most.
/// To be included by one source file of a program.

namespace counting_allocation {

inline std::atomic<std::size_t> in_use{0}, peak{0};

inline void* allocate(std::size_t size) {
  void* p = std::malloc(size);
  if(p == nullptr)
    throw std::bad_alloc();
  const std::size_t now = in_use += malloc_usable_size(p);
  std::size_t seen = peak.load();
  while(now > seen && !peak.compare_exchange_weak(seen, now))
    ;
  return p;
}

inline void release(void* p) noexcept {
  if(p != nullptr)
    in_use -= malloc_usable_size(p);
  std::free(p);
}

/// forgets the peak; returns the bytes in use.
inline std::size_t restart() {
  peak = in_use.load();
  return in_use;
}

} // namespace counting_allocation

void* operator new(std::size_t size) { return counting_allocation::allocate(size); }
void* operator new[](std::size_t size) { return counting_allocation::allocate(size); }
void operator delete(void* p) noexcept { counting_allocation::release(p); }
void operator delete[](void* p) noexcept { counting_allocation::release(p); }
void operator delete(void* p, std::size_t) noexcept { counting_allocation::release(p); }
void operator delete[](void* p, std::size_t) noexcept { counting_allocation::release(p); }

#endif // BENCHMARK_COUNTING_ALLOCATION_H
