// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CROSSES_ITSELF_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CROSSES_ITSELF_H

#include "generators.h"

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// whether triangles of a closed surface meet where they are not neighbours. About as slow as
/// making a mesh.
bool crosses_itself(const Soup& soup);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CROSSES_ITSELF_H
