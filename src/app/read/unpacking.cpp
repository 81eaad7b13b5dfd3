// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/unpacking.h"

#include "interrupt.h"
#include "read/input_file.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <new>

#if __has_include(<sys/resource.h>) && __has_include(<unistd.h>)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace htloops {
namespace {

// Of the machine; some systems do not say.
std::uint64_t memory_of_machine() {
#ifdef _SC_PHYS_PAGES
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  if(pages > 0 && size > 0)
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
#endif
  return std::uint64_t(16) << 30;
}

// Of the container that the program runs in, if it is in one; and as the shell has limited it.
std::uint64_t memory_allowed() {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  return std::uint64_t(1) << 28; // or most of the time would go into large inputs
#endif
  std::uint64_t allowed = (std::numeric_limits<std::uint64_t>::max)();
  std::ifstream limit_of_container("/sys/fs/cgroup/memory.max");
  if(std::uint64_t bytes = 0; limit_of_container >> bytes)
    allowed = bytes;
#ifdef RLIMIT_AS
  rlimit limit{};
  if(getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    allowed = (std::min)(allowed, static_cast<std::uint64_t>(limit.rlim_cur));
#endif
  return allowed;
}

std::string in_megabytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

} // namespace

std::size_t most_bytes_of_few() {
  const std::uint64_t most = (std::min)(memory_of_machine(), memory_allowed()) / 4;
  return static_cast<std::size_t>(
      (std::min)(most, std::uint64_t((std::numeric_limits<std::size_t>::max)())));
}

void check_room(const std::string& file, std::size_t bytes) {
  static const std::size_t most = most_bytes_of_few();
  if(bytes > most)
    fail_to_read(file, "its content would take more than " + in_megabytes(most) +
                           ", a quarter of the available memory");
}

std::optional<std::string> unpacked(const std::string& file,
                                    std::string_view bytes,
                                    htl_window::Frame frame,
                                    std::size_t bytes_before) {
  try {
    return htl_window::inflated(bytes, frame, [&](std::size_t size) {
      throw_if_interrupted();
      check_room(file, bytes_before + size);
    });
  } catch(const std::bad_alloc&) {
    fail_to_read(file, "there is no memory left to unpack it");
  }
}

} // namespace htloops
