// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An edge from a vertex of one cell to one of another.
struct Gate
{
  Index from, to;
};

/*!
What is around a cell: its neighbours in counterclockwise order, if it is fit to be a vertex of a
coarse mesh.

It is if it is a disc and each neighbour is beside it once. The cell is connected. With the edges
and faces that lie wholly in it, it is what a neighbourhood of it shrinks to, which so is a disc if
V - E + F = 1. Three cells meet in each face with corners in three cells; between two of these, one
after the other around the disc, lies one neighbour. If the neighbours are at least three, no two of
them the same, the faces can be put into their order by the neighbours alone, and are the faces
around a vertex.

A workspace that can be used again.
*/
class Cell_ring
{
public:
  Cell_ring(const Flat_mesh& mesh, const Cells& cells)
      : mesh_(mesh)
      , cells_(cells) {}

  /// looks at a cell. Returns whether it is fit. Vertices alone are as fit as they are in the mesh.
  bool look(Index cell) {
    const long euler_characteristic = walk_through(cell);
    if(are_alone())
      return link_as_in_mesh();
    return euler_characteristic == 1 && corners_.size() >= 3 && link_by_neighbors();
  }

  /// the mean of the vertices of the cell.
  Vector centre_of_mass() const {
    Vector sum = {0., 0., 0.};
    for(Index v : vertices_)
      sum = sum + mesh_.points[v];
    return 1. / double(vertices_.size()) * sum;
  }

  std::size_t size() const { return corners_.size(); }
  /// the i-th neighbour, if the cell is fit.
  Index neighbor(std::size_t i) const { return corners_[i].neighbor; }

  /// The shorter way to the i-th neighbour, and how long it is from centre to centre: by an edge
  /// in the first or in the last of the faces where these two cells meet a third. The neighbour has
  /// the same two.
  std::pair<Gate, double> way(std::size_t i) const {
    const Corner &first = corners_[i == 0 ? size() - 1 : i - 1], &last = corners_[i];
    const Gate a = {first.vertex, first.in_next}, b = {last.vertex, last.in_neighbor};
    const double length_of_a = length(a), length_of_b = length(b);
    return length_of_a <= length_of_b ? std::make_pair(a, length_of_a)
                                      : std::make_pair(b, length_of_b);
  }

private:
  // A face where a cell meets two others, which follow each other counterclockwise.
  struct Corner
  {
    Index neighbor, next;
    Index vertex, in_neighbor, in_next; // of the face
  };

  // Finds the vertices, each behind its parent, and the corners. Returns V - E + F of what lies in
  // the cell.
  long walk_through(Index cell) {
    vertices_.assign(1, cell);
    corners_.clear();
    long edges = 0, faces = 0; // once for each of their vertices
    for(std::size_t i = 0; i < vertices_.size(); ++i) {
      const Index v = vertices_[i];
      const Ring ring = mesh_.ring(v);
      Index u = ring[ring.size() - 1], a = cells_.cell(u);
      for(Index w : ring) {
        const auto [b, parent] = cells_[w];
        if(parent == v)
          vertices_.push_back(w);
        edges += b == cell;
        faces += a == cell && b == cell;
        if(a != cell && b != cell && a != b)
          corners_.push_back({a, b, v, u, w});
        u = w;
        a = b;
      }
    }
    return static_cast<long>(vertices_.size()) - edges / 2 + faces / 3;
  }

  double length(const Gate& gate) const {
    double sum = mesh_.edge_length(gate.from, gate.to);
    for(Index v : {gate.from, gate.to})
      for(; cells_.parent(v) != no_index; v = cells_.parent(v))
        sum += mesh_.edge_length(v, cells_.parent(v));
    return sum;
  }

  bool are_alone() const {
    const Index v = vertices_.front();
    const Ring ring = mesh_.ring(v);
    return cells_.is_alone(v) &&
           std::all_of(ring.begin(), ring.end(), [&](Index u) { return cells_.is_alone(u); });
  }

  // The corners are in their order already, but the first one, which lies before the ring's first
  // neighbour.
  bool link_as_in_mesh() {
    std::rotate(corners_.begin(), corners_.begin() + 1, corners_.end());
    return true;
  }

  // By the neighbours, which are to be different: each corner before the one that begins with the
  // neighbour with which it ends.
  bool link_by_neighbors() {
    const auto is_before = [](const Corner& a, const Corner& b) { return a.neighbor < b.neighbor; };
    std::sort(corners_.begin(), corners_.end(), is_before);
    linked_.clear();
    for(std::size_t i = 0; linked_.size() < corners_.size();) {
      const Corner& c = corners_[i];
      if(i + 1 < corners_.size() && corners_[i + 1].neighbor == c.neighbor)
        return false;
      linked_.push_back(c);
      i = std::lower_bound(corners_.begin(), corners_.end(), Corner{c.next, 0, 0, 0, 0},
                           is_before) -
          corners_.begin();
      if(i == corners_.size() || corners_[i].neighbor != c.next ||
         (i == 0 && linked_.size() < corners_.size()))
        return false;
    }
    corners_.swap(linked_);
    return corners_.back().next == corners_.front().neighbor;
  }

  const Flat_mesh& mesh_;
  const Cells& cells_;
  std::vector<Index> vertices_;
  std::vector<Corner> corners_, linked_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RING_H
