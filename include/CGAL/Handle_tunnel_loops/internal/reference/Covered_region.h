// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_COVERED_REGION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_COVERED_REGION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
What a field has covered: vertices, and links between neighbors.

Neighbors that are both covered are linked, but for those of one vertex, the center. The covered
neighbors of a vertex form runs along its ring. When the vertex is covered, its runs are linked to
it one after the other, so that the boundary of the region changes in one place at a time: a vertex
with many runs is as good as that many vertices with two.
*/
class Covered_region
{
public:
  explicit Covered_region(const Flat_mesh& mesh)
      : mesh_(mesh)
      , is_covered_(mesh.number_of_vertices(), 0) {}

  const Flat_mesh& mesh() const { return mesh_; }
  bool contains(Index v) const { return is_covered_[v] != 0; }

  /// adds a vertex and links it to the first of its runs, if it has any.
  void add(Index v) {
    find_runs(v);
    is_covered_[v] = 1;
    center_ = v;
    number_of_linked_runs_ = 1;
  }

  /// the number of runs of the vertex that was added last.
  Index number_of_runs() const { return static_cast<Index>(last_of_run_.size()); }

  /// the last vertex of a run, counterclockwise.
  Index last_of_run(Index run) const { return last_of_run_[run]; }

  void link_next_run() { ++number_of_linked_runs_; }

  /// whether neighbors are both covered, and linked.
  bool are_linked(Index u, Index v) const {
    if(!contains(u) || !contains(v))
      return false;
    if(u == center_ || v == center_)
      return run_[mesh_.ring(center_).position(u == center_ ? v : u)] < number_of_linked_runs_;
    return true;
  }

  /// The boundary crosses an edge wherever a covered vertex is not linked to its neighbor, close to
  /// the covered vertex if both are. It keeps the covered vertex on its left. This is the next edge
  /// that it crosses.
  Crossing next(const Crossing& c) const {
    const Index apex = apex_ahead(mesh_, c);
    return are_linked(c.left, apex) ? Crossing{apex, c.right, 0.5} : Crossing{c.left, apex, 0.5};
  }

private:
  void find_runs(Index v) {
    const Ring ring = mesh_.ring(v);
    run_.assign(ring.size(), 0);
    last_of_run_.clear();
    Index start = 0;
    while(start < ring.size() && contains(ring[start]))
      ++start;
    if(start == ring.size())
      return; // the whole ring
    for(Index i = ring.next(start); i != start; i = ring.next(i)) {
      if(!contains(ring[i]))
        continue;
      if(!contains(ring[ring.previous(i)]))
        last_of_run_.push_back(no_index);
      run_[i] = static_cast<Index>(last_of_run_.size()) - 1;
      last_of_run_.back() = ring[i];
    }
  }

  const Flat_mesh& mesh_;
  std::vector<char> is_covered_;
  Index center_ = no_index;
  std::vector<Index> run_; // by position in the ring of the center
  std::vector<Index> last_of_run_;
  Index number_of_linked_runs_ = 0;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_COVERED_REGION_H
