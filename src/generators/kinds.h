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

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

// One per file of the same name.
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

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_KINDS_H
