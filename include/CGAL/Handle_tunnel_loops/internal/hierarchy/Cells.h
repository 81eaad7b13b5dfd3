// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_view.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The vertices of a mesh in cells. A cell is named by the vertex in its centre, from which its
/// vertices form a tree along edges.
class Cells
{
public:
  /// all vertices are open: in no cell.
  Cells(Execution execution, const Flat_mesh& mesh)
      : mesh_(mesh)
      , links_(mesh.number_of_vertices())
      , is_alone_(mesh.number_of_vertices()) {
    open_all(execution);
  }

  /// the cells beside the mesh; they stay where they are.
  Cell_view view() const {
    return {view_of(mesh_), {links_.data(), links_.size()}, {is_alone_.data(), is_alone_.size()}};
  }

  /// where somebody else may put down cells, and which of them are vertices for good.
  Span<Cell_link> links() { return {links_.data(), links_.size()}; }
  Span<char> are_vertices() { return {is_alone_.data(), is_alone_.size()}; }

  Index cell(Index v) const { return links_[v].cell; }
  Index parent(Index v) const { return links_[v].parent; }
  bool is_centre(Index v) const { return cell(v) == v; }

  /// begins a cell at a vertex.
  void add_cell(Index v) { links_[v] = {v, no_index}; }

  /// makes a vertex a cell for good, which does not grow.
  void add_vertex(Index v) {
    add_cell(v);
    is_alone_[v] = 1;
  }
  bool is_alone(Index v) const { return is_alone_[v] != 0; }

  /// takes all vertices out of their cells.
  void open_all(Execution execution) {
    for_each_index(execution, links_.size(), [this](std::size_t v) {
      open(static_cast<Index>(v));
      is_alone_[v] = 0;
    });
  }

  /// takes a vertex out of its cell.
  void open(Index v) { links_[v] = {no_index, no_index}; }

  /// lets the cells for which `may_grow(cell)` holds take the open vertices that are given, ring by
  /// ring; of several cells beside a vertex the one with the least name takes it. Those are left
  /// open that no cell comes to.
  template <typename Predicate>
  void grow(Execution execution, Uninitialized_vector<Index> open, const Predicate& may_grow) {
    Uninitialized_vector<Cell_link> links;
    for(std::size_t before = 0; before != open.size();) {
      before = open.size();
      links.resize(before);
      for_each_index(execution, before, [&](std::size_t i) { links[i] = link(open[i], may_grow); });
      open = collect_many<Uninitialized_vector<Index>>(execution, before,
                                                       [&](std::size_t begin, std::size_t end) {
                                                         std::vector<Index> left;
                                                         for(std::size_t i = begin; i < end; ++i)
                                                           if(!take(open[i], links[i]))
                                                             left.push_back(open[i]);
                                                         return left;
                                                       });
    }
  }

  /// puts the vertices of a cell into `vertices`, each behind its parent.
  void list(Index cell, std::vector<Index>& vertices) const {
    vertices.assign(1, cell);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      for(Index u : mesh_.ring(vertices[i]))
        if(parent(u) == vertices[i])
          vertices.push_back(u);
  }

private:
  template <typename Predicate> Cell_link link(Index v, const Predicate& may_grow) const {
    return least_link(
        mesh_.ring(v), [this](Index u) { return cell(u); },
        [&](Index c) { return !is_alone(c) && may_grow(c); });
  }

  bool take(Index v, const Cell_link& link) {
    links_[v] = link;
    return link.cell != no_index;
  }

  const Flat_mesh& mesh_;
  Uninitialized_vector<Cell_link> links_; // by vertex
  Uninitialized_vector<char> is_alone_;   // by vertex
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELLS_H
