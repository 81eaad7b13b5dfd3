// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_OWN_NUMBERING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_OWN_NUMBERING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Numbers of vertices by where they are, so that what is computed does not depend on the numbers
/// that the caller gave them: along a space-filling curve, and in one of its cells along a line,
/// both in general position. Hubs keep their numbers.
class Own_numbering
{
public:
  Own_numbering(Execution execution, const Flat_mesh& mesh)
      : execution_(execution) {
    const auto& points = mesh.points;
    const Index n = mesh.first_hub;
    Box<3> all = Box<3>::empty();
    for(Index v = 0; v < n; ++v)
      all.extend({points[v], points[v]});
    // Of the vertices of regular meshes, none is where rounding decides on the cell.
    const auto part = [&](int d, double x) { return 0.0137 + 0.9719 * all.part(d, x); };
    const auto place = [&](std::size_t v) {
      const Vector& p = points[v];
      return Vector{part(0, p[0]), part(1, p[1]), part(2, p[2])};
    };
    order_ = space_filling_order(execution, n, place);
    const auto along_line = [&](Index v) {
      const Vector& p = points[v];
      return std::make_tuple(p[0] + 0.6171 * p[1] + 0.3731 * p[2], p, v);
    };
    const auto cell = [&](Index i) { return cell_of_curve(place(order_[i])); };
    for(Index begin = 0, end = 0; begin < n; begin = end) {
      const std::uint32_t first = cell(begin);
      for(end = begin + 1; end < n && cell(end) == first;)
        ++end;
      std::sort(order_.begin() + begin, order_.begin() + end,
                [&](Index a, Index b) { return along_line(a) < along_line(b); });
    }
    for(Index hub = n; hub < points.size(); ++hub)
      order_.push_back(hub);
  }

  /// what has been by vertex, in the new order.
  template <typename Values> void apply(Values& by_vertex) const {
    Values sorted(by_vertex.size());
    for_each_index(execution_, by_vertex.size(),
                   [&](std::size_t v) { sorted[v] = by_vertex[order_[v]]; });
    by_vertex = std::move(sorted);
  }

  /// by new number, the one before.
  const Uninitialized_vector<Index>& order() const { return order_; }

  /// numbers the vertices of a mesh anew. Each ring begins with its smallest number.
  void apply(Flat_mesh& mesh) const {
    const std::size_t n = order_.size();
    Uninitialized_vector<Index> number(n), row_begin(n + 1), neighbor(mesh.neighbor.size());
    for_each_index(execution_, n, [&](std::size_t v) {
      number[order_[v]] = static_cast<Index>(v);
      row_begin[v] = mesh.ring(order_[v]).size();
    });
    row_begin[n] = 0;
    sum_before_each(execution_, row_begin);
    for_each_index(execution_, n, [&](std::size_t v) {
      const Ring ring = mesh.ring(order_[v]);
      const auto begin = neighbor.begin() + row_begin[v];
      std::transform(ring.begin(), ring.end(), begin, [&](Index u) { return number[u]; });
      std::rotate(begin, std::min_element(begin, begin + ring.size()), begin + ring.size());
    });
    mesh.row_begin = std::move(row_begin);
    mesh.neighbor = std::move(neighbor);
    apply(mesh.points);
    std::iota(mesh.original.begin(), mesh.original.end(), Index(0)); // decide between equal values
    apply(mesh.component);
    for(Index v = static_cast<Index>(n); v-- > 0;)
      mesh.seeds[mesh.component[v]] = v; // the first
    mesh.places_in_long_rings.clear();
    mesh.find_places_in_long_rings();
  }

private:
  Execution execution_;
  Uninitialized_vector<Index> order_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_OWN_NUMBERING_H
