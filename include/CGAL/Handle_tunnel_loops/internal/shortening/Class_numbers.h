// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_CLASS_NUMBERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_CLASS_NUMBERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_halfedges.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Tells the classes of closed walks along edges in the first homology group of a surface with
boundary, its caps taken away.

Faces are collapsed from the boundary on, each by an edge that has no other face any more. What is
left is a graph: two walks are homologous if and only if, once they are pushed along with the faces,
they run equally often along each edge outside of a spanning forest of it. That is exact.

For a search there is a number on each halfedge, with the other sign on its twin, and with the sum 0
around each face, so that the sum along a closed walk depends on its class only. Outside of the
forest these are random numbers of 64 bits: that walks of two given classes have the same sum is as
likely as one in 2^64.
*/
class Class_numbers
{
public:
  /// Linear in the size of the mesh.
  Class_numbers(Execution execution, const Flat_mesh& mesh)
      : mesh_(mesh)
      , halfedges_(execution, mesh)
      , numbers_(halfedges_.size(), 0) {
    collapse();
    number_graph();
    for(std::size_t i = collapses_.size(); i-- > 0;) {
      const Index second = halfedges_.next(collapses_[i]), third = halfedges_.next(second);
      set_number(collapses_[i], 0 - numbers_[second] - numbers_[third]);
    }
  }

  const Flat_halfedges& halfedges() const { return halfedges_; }

  std::uint64_t of_halfedge(Index h) const { return numbers_[h]; }

  std::uint64_t of_walk(const std::vector<Index>& walk) const {
    std::uint64_t sum = 0;
    for_each_halfedge(walk, [&](Index h) { sum += numbers_[h]; });
    return sum;
  }

  /// Exact; linear in the size of the mesh.
  bool are_homologous(const std::vector<Index>& a, const std::vector<Index>& b) const {
    std::vector<std::int64_t> chain(halfedges_.size(), 0); // of an edge, on one of its halfedges
    for_each_halfedge(a, [&](Index h) { add(h, 1, chain); });
    for_each_halfedge(b, [&](Index h) { add(h, -1, chain); });
    for(const Index first : collapses_)
      if(const std::int64_t times = coefficient(first, chain)) {
        const Index second = halfedges_.next(first);
        for(const Index h : {first, second, halfedges_.next(second)})
          add(h, -times, chain);
      }
    // A cycle on a forest is zero.
    for(const Index h : outside_forest_)
      if(coefficient(h, chain) != 0)
        return false;
    return true;
  }

private:
  template <typename Function>
  void for_each_halfedge(const std::vector<Index>& walk, const Function& f) const {
    for(std::size_t i = 0; i < walk.size(); ++i)
      f(halfedges_.between(walk[i], walk[i + 1 == walk.size() ? 0 : i + 1]));
  }

  void add(Index h, std::int64_t times, std::vector<std::int64_t>& chain) const {
    const Index twin = halfedges_.twin(h);
    (h < twin ? chain[h] : chain[twin]) += h < twin ? times : -times;
  }

  std::int64_t coefficient(Index h, const std::vector<std::int64_t>& chain) const {
    const Index twin = halfedges_.twin(h);
    return h < twin ? chain[h] : -chain[twin];
  }

  void set_number(Index h, std::uint64_t number) {
    numbers_[h] = number;
    numbers_[halfedges_.twin(h)] = 0 - number;
  }

  void collapse() {
    std::vector<char> is_gone(mesh_.number_of_faces(), 0);
    std::vector<Index> open; // beyond the edge of each the face is gone
    const Index end = mesh_.first_hub + mesh_.number_of_hubs;
    for(Index hub = mesh_.first_hub; hub < end; ++hub)
      for(Index h = halfedges_.begin(hub); h < halfedges_.end(hub); ++h) {
        is_gone[halfedges_.face(h)] = 1;
        open.push_back(halfedges_.twin(halfedges_.next(h)));
      }
    for(std::size_t i = 0; i < open.size(); ++i) {
      const Index h = open[i], second = halfedges_.next(h);
      if(is_gone[halfedges_.face(h)])
        continue;
      is_gone[halfedges_.face(h)] = 1;
      collapses_.push_back(h);
      open.push_back(halfedges_.twin(second));
      open.push_back(halfedges_.twin(halfedges_.next(second)));
    }
  }

  // The edges that are left, spokes of the caps excepted.
  void number_graph() {
    std::vector<char> is_left(halfedges_.size(), 1);
    for(const Index h : collapses_)
      is_left[h] = is_left[halfedges_.twin(h)] = 0;
    Sets_of_indices parts(mesh_.number_of_vertices());
    std::mt19937_64 random;
    for(Index h = 0; h < halfedges_.size(); ++h) {
      const Index u = halfedges_.source(h), v = halfedges_.target(h);
      if(!is_left[h] || h > halfedges_.twin(h) || mesh_.is_spoke(u, v))
        continue;
      if(!parts.unite(u, v)) {
        outside_forest_.push_back(h);
        set_number(h, random());
      }
    }
  }

  const Flat_mesh& mesh_;
  const Flat_halfedges halfedges_;
  std::vector<Index> collapses_;      // halfedges of faces, in order
  std::vector<Index> outside_forest_; // edges that are left, each by a halfedge
  std::vector<std::uint64_t> numbers_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_CLASS_NUMBERS_H
