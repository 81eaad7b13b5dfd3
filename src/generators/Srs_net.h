// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SRS_NET_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SRS_NET_H

#include "Field.h"
#include "Random.h"

#include <CGAL/number_type_config.h>

#include <array>
#include <cstddef>
#include <map>

namespace CGAL::Handle_tunnel_loops::generators {

/// A node of the net srs, in units of an eighth of the period.
using Srs_node = std::array<int, 3>;

/*!
The net srs, the periodic graph along which the solid sin x cos y + sin y cos z + sin z cos x > 0
runs: its nodes are the maxima of that function, eight to a period of 2 pi, and each has three
neighbours. Verified numerically: the points of the solid that are closest to a node have only
neighbours of it as their next closest node, so that cutting the solid in the middle of an edge of
the net cuts one neck.
*/
struct Srs_net
{
  static constexpr int period = 8;
  static constexpr double unit = CGAL_PI / 4.;
  static constexpr double edge_length = unit * 2. * 1.41421356237309504880;
  static constexpr int nodes_per_period = 8;

  static const std::array<Srs_node, nodes_per_period>& nodes();

  /// the steps from a node, given by its number in `nodes()`, to its neighbours.
  static const std::array<Srs_node, 3>& steps(int node);

  /// the number of a node in `nodes()`, whatever its period.
  static int number(const Srs_node& node);

  static Vector position(const Srs_node& node) { return Vector(node[0], node[1], node[2]) * unit; }

  static Srs_node plus(const Srs_node& a, const Srs_node& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }
};

/// A finite connected part of the net: its nodes, each with the set of the steps, as bits, along
/// which it has an edge.
using Srs_subgraph = std::map<Srs_node, unsigned>;

/// a part of the net with a given number of independent cycles, grown like a box around a random
/// point.
Srs_subgraph grow_srs_subgraph(std::size_t cycles, Random& random);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SRS_NET_H
