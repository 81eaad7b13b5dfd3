// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Memory of the tool, on Linux. Most of it is arrays of many megabytes, each written once. In pages
// of 4 kB each page is a fault, which takes a microsecond in a virtual machine: two thirds of the
// time for a mesh of ten million faces. So large blocks ask for pages of 2 MB, which a system may
// give or not; and what is freed is kept, unless GLIBC_TUNABLES says otherwise.

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <malloc.h>
#include <sys/mman.h>

namespace {

constexpr std::size_t size_of_page = std::size_t(1) << 21;
constexpr std::size_t least_size = size_of_page / 2;

void ask_for_large_pages(void* block, std::size_t size) {
  const auto begin = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t first = (begin + size_of_page - 1) / size_of_page * size_of_page;
  const std::uintptr_t last = (begin + size) / size_of_page * size_of_page;
  const int error = errno; // of the caller; this is a wish, which may fail
  if(first < last)
    madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  errno = error;
}

#ifdef __GLIBC__
// Blocks of up to 32 MB, the most that it takes, are not mapped each for itself.
bool keep_memory() {
  if(sizeof(void*) < 8 || std::getenv("GLIBC_TUNABLES") != nullptr)
    return false;
  return mallopt(M_MMAP_THRESHOLD, 1 << 25) == 1 && mallopt(M_TRIM_THRESHOLD, 1 << 30) == 1;
}

const bool is_memory_kept = keep_memory();
#endif

} // namespace

void* operator new(std::size_t size) {
  for(;;) {
    if(void* block = std::malloc((std::max)(size, std::size_t(1)))) {
      if(size >= least_size)
        ask_for_large_pages(block, size);
      return block;
    }
    const std::new_handler handler = std::get_new_handler();
    if(handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
