// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SWEPT_FUNCTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SWEPT_FUNCTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/contour_above.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Contour_girths.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A function on the vertices, its Reeb graph, and how long its contours are.
class Swept_function
{
public:
  /// The mesh must outlive it.
  Swept_function(Execution execution, const Flat_mesh& mesh, std::vector<float> values)
      : mesh_(mesh)
      , values_(std::move(values))
      , order_(
            execution, mesh, [&](Index v) { return ordering_key(static_cast<double>(values_[v])); })
      , stars_(sweep_stars(execution, mesh, order_))
      , graph_(Reeb_sweep(mesh, order_, stars_, most_steps(mesh), no_samples).run())
      , girths_(mesh, order_, stars_, graph_, values_) {}

  Swept_function(const Swept_function&) = delete;
  Swept_function& operator=(const Swept_function&) = delete;

  const std::vector<float>& values() const { return values_; }
  const Sweep_order& order() const { return order_; }
  const Flat_reeb_graph& graph() const { return graph_; }

  /// the contours that are by a part shorter than those beside them, on either side up to a shorter
  /// one.
  std::vector<Crossing_loop> shortest_contours(double part) const {
    const auto is_saddle = [&](Index node) { return graph_.nodes[node].kind == Node_kind::SADDLE; };
    std::vector<Crossing_loop> contours;
    for(Index arc = 0; arc < graph_.arcs.size(); ++arc) {
      const Index first = girths_.first(arc), last = girths_.last(arc);
      // Where a contour parts, the two are about as long together.
      const bool is_held_below = is_saddle(graph_.arcs[arc].lower),
                 is_held_above = is_saddle(graph_.arcs[arc].upper);
      for(Index i = first; i <= last; ++i)
        if(girths_.all()[i].vertex != no_index && !mesh_.is_hub(girths_.all()[i].vertex) &&
           is_held(i, first, is_held_below, part) && is_held(i, last, is_held_above, part))
          contours.push_back(contour_above(mesh_, order_, values_, girths_.all()[i].vertex));
    }
    return contours;
  }

private:
  // On the way to an end of its arc. Of contours that are equally short the first is one.
  bool is_held(Index spot, Index end, bool is_held_at_end, double part) const {
    const std::vector<Girth_at>& all = girths_.all();
    const float girth = all[spot].girth;
    const auto is_shorter = [&](Index i) {
      return all[i].girth < girth || (all[i].girth == girth && i < spot);
    };
    for(Index i = spot; i != end;) {
      i = end < spot ? i - 1 : i + 1;
      if(is_shorter(i))
        return false;
      if(all[i].girth >= (1. + part) * girth)
        return true;
    }
    return is_held_at_end;
  }

  static std::uint64_t most_steps(const Flat_mesh& mesh) {
    return 8 * std::uint64_t(mesh.neighbor.size());
  }

  static constexpr double no_samples = (std::numeric_limits<float>::max)();

  const Flat_mesh& mesh_;
  std::vector<float> values_;
  Sweep_order order_;
  std::vector<Star> stars_;
  Flat_reeb_graph graph_;
  Contour_girths girths_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SWEPT_FUNCTION_H
