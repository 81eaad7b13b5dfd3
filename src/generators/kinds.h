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

// The functions that make meshes, one for each kind.
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

/// a number with its noun: "1 handle", "3 handles".
inline std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// throws `std::invalid_argument`: "a mesh of the kind '...' ", followed by the reason.
[[noreturn]] void refuse(const char* kind, const std::string& why);

/// throws `std::invalid_argument` if the request has fewer faces than such a mesh needs, or more
/// than 32-bit indices can count. The message describes the mesh by its genus, or by `mesh`, such
/// as "with 3 necks".
void require_faces(const Request& request,
                   const char* kind,
                   double least,
                   const std::string& mesh = std::string());

/// throws `std::invalid_argument` if the request has another genus than the only one of the kind.
void require_genus(const Request& request, const char* kind, std::size_t only);

/// throws `std::invalid_argument` if the request has a smaller genus.
void require_least_genus(const Request& request, const char* kind, std::size_t least);

/// whether a closed manifold mesh is connected and has the given genus.
bool is_connected_of_genus(const Soup& soup, std::size_t genus);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_KINDS_H
