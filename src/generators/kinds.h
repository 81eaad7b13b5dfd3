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

#include <string>

namespace CGAL::Handle_tunnel_loops::generators {

// What makes a mesh of the kind of that name.
Soup make_sphere(const Request& request);
Soup make_torus(const Request& request);
Soup make_knot(const Request& request);
Soup make_multi_torus(const Request& request);
Soup make_lattice(const Request& request);
Soup make_gyroid(const Request& request);
Soup make_sponge(const Request& request);
Soup make_plates(const Request& request);
Soup make_bars(const Request& request);
Soup make_hubs(const Request& request);
Soup make_fan(const Request& request);
Soup make_chain(const Request& request);
Soup make_torus_link(const Request& request);
Soup make_ladder(const Request& request);
Soup make_shell(const Request& request);
Soup make_foam(const Request& request);
Soup make_interlaced(const Request& request);
Soup make_waves(const Request& request);
Soup make_scan(const Request& request);
Soup make_twins(const Request& request);
Soup make_hollow(const Request& request);
Soup make_random(const Request& request);

/// throws `std::invalid_argument`: "a mesh of the kind '...' ", and why there is none.
[[noreturn]] void refuse(const char* kind, const std::string& why);

/// throws `std::invalid_argument` if fewer faces are asked for than the kind needs at this genus,
/// or more than 32-bit indices can count.
void require_faces(const Request& request, const char* kind, double least);

/// throws `std::invalid_argument` if the kind has one genus only and another is asked for.
void require_genus(const Request& request, const char* kind, std::size_t only);

/// throws `std::invalid_argument` if a smaller genus is asked for.
void require_least_genus(const Request& request, const char* kind, std::size_t least);

/// whether a closed manifold mesh is connected and has the given genus.
bool is_connected_of_genus(const Soup& soup, std::size_t genus);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_KINDS_H
