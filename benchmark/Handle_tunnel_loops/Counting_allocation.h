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

inline std::atomic<bool> is_counting{false};
inline std::atomic<std::ptrdiff_t> in_use{0}, peak{0};
inline std::atomic<std::size_t> number{0};

inline void* allocate(std::size_t size) {
  void* p = std::malloc(size);
  if(p == nullptr)
    throw std::bad_alloc();
  if(is_counting.load(std::memory_order_relaxed)) {
    ++number;
    const std::ptrdiff_t now = in_use += static_cast<std::ptrdiff_t>(malloc_usable_size(p));
    std::ptrdiff_t seen = peak.load();
    while(now > seen && !peak.compare_exchange_weak(seen, now))
      ;
  }
  return p;
}

inline void release(void* p) noexcept {
  if(p != nullptr && is_counting.load(std::memory_order_relaxed))
    in_use -= static_cast<std::ptrdiff_t>(malloc_usable_size(p));
  std::free(p);
}

/// the largest number of bytes that are allocated at one time while `f()` runs, beyond those
/// before.
template <typename Function> std::size_t peak_bytes(const Function& f) {
  in_use = peak = 0;
  is_counting = true;
  f();
  is_counting = false;
  return static_cast<std::size_t>(peak);
}

/// how often memory is allocated while `f()` runs.
template <typename Function> std::size_t number_of_allocations(const Function& f) {
  number = 0;
  peak_bytes(f);
  return number;
}

} // namespace counting_allocation

void* operator new(std::size_t size) { return counting_allocation::allocate(size); }
void* operator new[](std::size_t size) { return counting_allocation::allocate(size); }
void operator delete(void* p) noexcept { counting_allocation::release(p); }
void operator delete[](void* p) noexcept { counting_allocation::release(p); }
void operator delete(void* p, std::size_t) noexcept { counting_allocation::release(p); }
void operator delete[](void* p, std::size_t) noexcept { counting_allocation::release(p); }

#endif // BENCHMARK_COUNTING_ALLOCATION_H
