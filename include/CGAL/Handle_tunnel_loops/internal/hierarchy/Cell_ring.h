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

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_view.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <algorithm>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An edge from a vertex of one cell to one of another.
struct Gate
{
  Index from, to;
};

/// A cell beside another one.
struct Cell_neighbor
{
  Index cell;
  Gate gate;
  Index unused; ///< so that there is no byte without a value
  double way;   ///< how long it is, from centre to centre
};

/// A face where a cell meets two others, which follow each other counterclockwise.
struct Cell_corner
{
  Index neighbor, next;
  Index vertex, in_neighbor, in_next; ///< of the face
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

A workspace that can be used again, on the host or on a device.

\tparam Lists has types of lists, `Vertices`, `Corners` and `Order`, which are used as vectors are,
  and say whether something has found no room: `is_too_short()`. `Corners::sort()` is by neighbour.
*/
template <typename Lists> class Cell_ring_in
{
public:
  CGAL_HTL_HOST_DEVICE explicit Cell_ring_in(const Cell_view& cells)
      : cells_(cells) {}

  /// looks at a cell. Returns whether it is fit. Vertices alone are as fit as they are in the mesh.
  CGAL_HTL_HOST_DEVICE bool look(Index cell) {
    const long euler_characteristic = walk_through(cell);
    order_.clear();
    if(is_too_large())
      return false;
    if(are_alone())
      return link_as_in_mesh();
    return euler_characteristic == 1 && corners_.size() >= 3 && link_by_neighbors();
  }

  /// whether there was no room to look at all of it: then it may be fit all the same.
  CGAL_HTL_HOST_DEVICE bool is_too_large() const {
    return vertices_.is_too_short() || corners_.is_too_short();
  }

  /// puts down the mean of the vertices of the cell: x, y, z.
  CGAL_HTL_HOST_DEVICE void put_centre_of_mass(double* centre) const {
    const double part = 1. / double(vertices_.size());
    for(int k = 0; k < 3; ++k) {
      double sum = 0.;
      for(Index i = 0; i < vertices_.size(); ++i)
        sum += cells_.mesh.points[3 * std::size_t(vertices_[i]) + k];
      centre[k] = rounded_product(part, sum);
    }
  }

  /// the number of neighbours, if the cell is fit.
  CGAL_HTL_HOST_DEVICE Index size() const { return static_cast<Index>(order_.size()); }

  /// The i-th neighbour, if the cell is fit, and the shorter way to it: by an edge in the first or
  /// in the last of the faces where these two cells meet a third. The neighbour has the same two.
  CGAL_HTL_HOST_DEVICE Cell_neighbor neighbor(Index i) const {
    const Cell_corner &first = corner(i == 0 ? size() - 1 : i - 1), &last = corner(i);
    const Gate a = {first.vertex, first.in_next}, b = {last.vertex, last.in_neighbor};
    const double length_of_a = length(a), length_of_b = length(b);
    if(length_of_a <= length_of_b)
      return {last.neighbor, a, 0, length_of_a};
    return {last.neighbor, b, 0, length_of_b};
  }

private:
  CGAL_HTL_HOST_DEVICE const Cell_corner& corner(Index i) const { return corners_[order_[i]]; }

  // Finds the vertices, each behind its parent, and the corners. Returns V - E + F of what lies in
  // the cell.
  CGAL_HTL_HOST_DEVICE long walk_through(Index cell) {
    vertices_.clear();
    vertices_.push_back(cell);
    corners_.clear();
    long edges = 0, faces = 0; // once for each of their vertices
    for(Index i = 0; i < vertices_.size() && !is_too_large(); ++i) {
      const Index v = vertices_[i];
      const Ring ring = cells_.ring(v);
      Index u = ring[ring.size() - 1], a = cells_.cell(u);
      for(Index w : ring) {
        const Cell_link link = cells_[w];
        const Index b = link.cell;
        if(link.parent == v)
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

  CGAL_HTL_HOST_DEVICE double length(const Gate& gate) const {
    return way_to_centre(way_to_centre(cells_.mesh.edge_length(gate.from, gate.to), gate.from),
                         gate.to);
  }

  // Added to the length of a way that leads to a vertex.
  CGAL_HTL_HOST_DEVICE double way_to_centre(double sum, Index v) const {
    for(Index parent = cells_.parent(v); parent != no_index; parent = cells_.parent(v)) {
      sum += cells_.mesh.edge_length(v, parent);
      v = parent;
    }
    return sum;
  }

  CGAL_HTL_HOST_DEVICE bool are_alone() const {
    bool result = cells_.is_alone(vertices_[0]);
    if(result)
      for(Index u : cells_.ring(vertices_[0]))
        result = result && cells_.is_alone(u);
    return result;
  }

  // The corners are in their order already, but the first one, which lies before the ring's first
  // neighbour.
  CGAL_HTL_HOST_DEVICE bool link_as_in_mesh() {
    for(Index i = 1; i < corners_.size(); ++i)
      order_.push_back(i);
    order_.push_back(0);
    return true;
  }

  // By the neighbours, which are to be different: each corner before the one that begins with the
  // neighbour with which it ends.
  CGAL_HTL_HOST_DEVICE bool link_by_neighbors() {
    corners_.sort();
    const Index n = static_cast<Index>(corners_.size());
    for(Index i = 0; order_.size() < n;) {
      const Cell_corner& c = corners_[i];
      if(i + 1 < n && corners_[i + 1].neighbor == c.neighbor)
        return false;
      order_.push_back(i);
      i = first_from(c.next);
      if(i == n || corners_[i].neighbor != c.next || (i == 0 && order_.size() < n))
        return false;
    }
    return corner(n - 1).next == corner(0).neighbor;
  }

  // The first of the corners, which are sorted, with this neighbour or one that comes after it.
  CGAL_HTL_HOST_DEVICE Index first_from(Index neighbor) const {
    Index begin = 0, end = static_cast<Index>(corners_.size());
    while(begin < end) {
      const Index middle = begin + (end - begin) / 2;
      if(corners_[middle].neighbor < neighbor)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  Cell_view cells_;
  typename Lists::Vertices vertices_;
  typename Lists::Corners corners_;
  typename Lists::Order order_; // of the corners, around the cell
};

/// Lists on the host, of any length.
struct Long_lists
{
  template <typename T> struct List : std::vector<T>
  {
    static constexpr bool is_too_short() { return false; }
  };

  using Vertices = List<Index>;
  using Order = List<Index>;

  struct Corners : List<Cell_corner>
  {
    void sort() {
      std::sort(begin(), end(),
                [](const Cell_corner& a, const Cell_corner& b) { return a.neighbor < b.neighbor; });
    }
  };
};

using Cell_ring = Cell_ring_in<Long_lists>;

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RING_H
