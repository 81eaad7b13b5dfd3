// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_HOST_MEMORY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_HOST_MEMORY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <algorithm>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What executors have in common whose memory is that of the host.
struct Host_memory
{
  template <typename T> static void upload(const Span<T>& to, const T* from) {
    std::copy(from, from + to.size(), to.begin());
  }
  template <typename T> static void download(T* to, const Span<T>& from) {
    std::copy(from.begin(), from.end(), to);
  }
  template <typename T> static void fill(const Span<T>& span, const T& value) {
    std::fill(span.begin(), span.end(), value);
  }
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_HOST_MEMORY_H
