// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Sparse_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A line of a copy and an edge of a walk that meet although they should be apart; or, where the
/// edge is one that the copy crosses, two faces that lie on each other.
struct Contact
{
  static constexpr std::size_t no_corner = static_cast<std::size_t>(-1);
  std::size_t corner, edge;

  bool operator<(const Contact& c) const {
    return edge != c.edge ? edge < c.edge : corner < c.corner;
  }
};

/// What `Linking_numbers` finds.
struct Linking
{
  Sparse_matrix intersections, linking, defect;
  std::vector<Contact> contacts;
  bool has_too_many_contacts = false;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_H
