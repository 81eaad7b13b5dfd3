// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_HOMOLOGY_CLASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_HOMOLOGY_CLASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The value of loop `loop` on the directed edge of the smaller to the larger vertex index.
struct Chain_entry
{
  std::uint64_t edge;
  std::uint32_t loop;
  std::int32_t value;

  bool operator<(const Chain_entry& other) const {
    return edge != other.edge ? edge < other.edge : loop < other.loop;
  }
};

/// An edge that some loop runs along, and the pieces to its left and right.
struct Used_edge
{
  std::uint64_t edge;
  std::size_t first, last; ///< its entries among those of the chains
  Index left, right;
};

/// the words for a loop: loops 2k and 2k + 1 are the handle and the tunnel loop of pair k.
inline std::string name_of_loop(std::size_t loop) {
  return "pair " + std::to_string(loop / 2) + (loop % 2 == 0 ? ", handle" : ", tunnel");
}

/// adds up the entries of one loop on one edge, and lists the edges that remain, sorted.
std::vector<Used_edge> add_up_chains(Execution execution, std::vector<Chain_entry>& chains);

/// keeps one of the edges along which the same loops run between the same pieces: all that is
/// asked for is the same. In the order of the number of loops.
void keep_distinct_edges(Execution execution,
                         const std::vector<Chain_entry>& chains,
                         std::vector<Used_edge>& edges);

/// the numbers of those loops that do not bound, in ascending order: a loop bounds if it meets all
/// closed dual curves as often from the left as from the right.
std::vector<std::size_t> loops_that_do_not_bound(std::size_t number_of_loops,
                                                 const std::vector<Chain_entry>& chains,
                                                 const std::vector<Used_edge>& edges);

/// in words, why loops are no basis, as many as there should be; nothing if they are one. See
/// `Loop_certifier`.
std::vector<std::string> why_no_basis(std::size_t number_of_loops,
                                      const std::vector<Chain_entry>& chains,
                                      const std::vector<Used_edge>& edges);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_HOMOLOGY_CLASSES_H
