// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_KINDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_KINDS_H

#include "generators.h"

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::generators {

extern const Kind sphere_kind;
extern const Kind torus_kind;
extern const Kind knot_kind;
extern const Kind multi_torus_kind;
extern const Kind lattice_kind;
extern const Kind gyroid_kind;
extern const Kind sponge_kind;
extern const Kind plates_kind;
extern const Kind bars_kind;
extern const Kind chain_kind;
extern const Kind torus_link_kind;
extern const Kind ladder_kind;
extern const Kind shell_kind;
extern const Kind foam_kind;
extern const Kind interlaced_kind;
extern const Kind waves_kind;
extern const Kind scan_kind;
extern const Kind twins_kind;
extern const Kind hollow_kind;
extern const Kind random_kind;

/// throws `std::invalid_argument` if fewer faces are asked for than the kind needs at this genus,
/// or more than 32-bit indices can count.
void require_faces(const Request& request, const char* kind, double least);

/// throws `std::invalid_argument` if the kind has one genus only and another is asked for.
void require_genus(const Request& request, const char* kind, std::size_t only);

/// throws `std::invalid_argument` if a smaller genus is asked for.
void require_least_genus(const Request& request, const char* kind, std::size_t least);

/// throws `std::invalid_argument` unless there are parts, and each can have a handle.
void require_parts(const Request& request, const char* kind);

/// whether a closed manifold mesh is connected and has the given genus.
bool is_connected_of_genus(const Soup& soup, std::size_t genus);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_KINDS_H
