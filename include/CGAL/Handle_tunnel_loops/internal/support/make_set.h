// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MAKE_SET_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MAKE_SET_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// sorts the elements of a vector and leaves one of each, so that `is_in()` finds them.
template <typename T> void make_set(std::vector<T>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

template <typename T> bool is_in(const T& t, const std::vector<T>& set) {
  return std::binary_search(set.begin(), set.end(), t);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MAKE_SET_H
