// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <algorithm>
#include <cstddef>
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

/*!
The fronts: the components of the boundary of a region (paper, section 5).

The boundary has a piece in each triangle with one or two covered vertices. These are the nodes of a
graph; they are adjacent where they share a crossed edge, and its connected components are the
fronts. Each is a simple closed curve, however coarse the mesh, so that it is found by following it.
(A triangle with vertices that are covered but not linked may have more than one piece. So the nodes
are the places at which the boundary comes into a triangle.)
*/
class Fronts
{
public:
  explicit Fronts(const Covered_region& region)
      : region_(region)
      , node_(region.mesh().neighbor.size(), no_index) {
    find_nodes();
    front_.resize(crossings_.size(), no_index);
    for(const Crossing& start : crossings_)
      if(front(start) == no_index) {
        for(const Crossing& c : loop(start))
          front_[node(c)] = number_;
        ++number_;
      }
  }

  Index number_of_fronts() const { return number_; }

  /// all edges that are crossed.
  const std::vector<Crossing>& crossings() const { return crossings_; }

  /// the number of the front that crosses an edge.
  Index front(const Crossing& c) const { return front_[node(c)]; }

  /// the front from one of its crossings on, with the covered vertices on its left.
  Crossing_loop loop(const Crossing& start) const {
    Crossing_loop loop;
    Crossing c = start;
    do {
      loop.push_back(c);
      c = region_.next(c);
    } while(c.left != start.left || c.right != start.right);
    return loop;
  }

private:
  void find_nodes() {
    const Flat_mesh& mesh = region_.mesh();
    for(Index u = 0; u < mesh.number_of_vertices(); ++u)
      if(region_.contains(u))
        for(Index i = mesh.row_begin[u]; i < mesh.row_begin[u + 1]; ++i)
          if(!region_.are_linked(u, mesh.neighbor[i])) {
            node_[i] = static_cast<Index>(crossings_.size());
            crossings_.push_back({u, mesh.neighbor[i], 0.5});
          }
  }

  Index node(const Crossing& c) const { return node_[slot(region_.mesh(), c.left, c.right)]; }

  const Covered_region& region_;
  std::vector<Index> node_; // by slot
  std::vector<Crossing> crossings_;
  std::vector<Index> front_; // by node
  Index number_ = 0;
};

/// Two fronts have met: a handle. `loop` is the shorter of the two, with what was covered on the
/// left.
struct Front_meeting
{
  Crossing_loop loop;
  Index saddle;           ///< the vertex at which they met
  Index foot_a, foot_b;   ///< covered neighbors of the saddle, behind either front
  std::vector<char> area; ///< the vertices that any layer but the base had come to
};

/// where the base layer has eroded.
template <typename Values> std::vector<char> area_of(const Values& covered) {
  std::vector<char> area(static_cast<std::size_t>(covered.size()));
  for(std::size_t v = 0; v < area.size(); ++v)
    area[v] = covered[v] > 0.;
  return area;
}

/// a front on the line on which the field has the value of the threshold.
template <typename Values> Crossing_loop placed(Crossing_loop loop, const Values& covered) {
  for(Crossing& c : loop) {
    const double drop = covered[c.left] - covered[c.right];
    const double ratio = drop > 0. ? (covered[c.left] - threshold) / drop : 0.5;
    c.ratio = (std::min)(0.99, (std::max)(0.01, ratio));
  }
  return loop;
}

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H
