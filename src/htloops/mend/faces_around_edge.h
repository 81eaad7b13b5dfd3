// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FACES_AROUND_EDGE_H
#define HTLOOPS_FACES_AROUND_EDGE_H

#include "mend/face_pieces.h"
#include "read/edge_table.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htloops {

/// which faces at an edge with more than two are neighbors: pairs of halfedges, as they are in the
/// soup. The rest stays without neighbor.
///
/// Going around the edge, one that runs downwards and one that runs upwards after it are a pair,
/// between which there is solid: solids that meet at the edge come apart. Faces of one piece are
/// paired first, the largest piece before the others, so that a surface goes on where a fin stands
/// on it. `is_turned` tells which faces are to be seen turned. Decided exactly.
std::vector<std::array<std::uint32_t, 2>> pairs_around_edge(const Soup& soup,
                                                            const Edge_table::Edge& edge,
                                                            Face_pieces& pieces,
                                                            const std::vector<bool>& is_turned);

} // namespace htloops

#endif // HTLOOPS_FACES_AROUND_EDGE_H
