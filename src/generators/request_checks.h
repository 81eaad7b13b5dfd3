// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_REQUEST_CHECKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_REQUEST_CHECKS_H

#include "generators.h"

#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// throws `std::invalid_argument` if fewer faces are asked for than the kind needs at this genus,
/// or more than 32-bit indices can count.
void require_faces(const Request& request, const char* kind, double least);

/// throws `std::invalid_argument` if the kind has one genus only and another is asked for.
void require_genus(const Request& request, const char* kind, std::size_t only);

/// throws `std::invalid_argument` if a smaller genus is asked for.
void require_least_genus(const Request& request, const char* kind, std::size_t least);

/// throws `std::invalid_argument` unless there are parts, and each can have a handle.
void require_parts(const Request& request, const char* kind);

/// throws `std::invalid_argument` if of what the kind looks at more is asked for than faces, none
/// of which can serve two: then no sum or product of what a kind needs is out of range.
void require_no_more_than_faces(const Request& request, const Kind& kind);

/// whether a closed manifold mesh is connected and has the given genus.
bool is_connected_of_genus(const Soup& soup, std::size_t genus);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_REQUEST_CHECKS_H
