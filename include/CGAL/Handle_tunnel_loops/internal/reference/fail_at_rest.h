// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FAIL_AT_REST_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FAIL_AT_REST_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// is called where a field to the letter does not come on; no rule of the paper says what to do
/// then.
[[noreturn]] inline void fail_at_rest(std::size_t number_of_covered, std::size_t number) {
  throw Literal_failure_exception("the field came to rest when " +
                                  std::to_string(number_of_covered) + " of " +
                                  std::to_string(number) + " vertices were covered");
}

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FAIL_AT_REST_H
