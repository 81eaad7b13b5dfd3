// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "system/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#elif __has_include(<sys/resource.h>) && __has_include(<unistd.h>)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace htloops {

std::uint64_t memory_of_machine() {
#if defined(_WIN32)
  MEMORYSTATUSEX status = {};
  status.dwLength = sizeof status;
  if(GlobalMemoryStatusEx(&status) != 0)
    return status.ullTotalPhys;
#elif defined(_SC_PHYS_PAGES)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  if(pages > 0 && size > 0)
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
#endif
  return std::uint64_t(16) << 30;
}

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

} // namespace htloops
