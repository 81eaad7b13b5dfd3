// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOP_CHOICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOP_CHOICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A place on an edge: `source + ratio * (target - source)`.
struct Place_on_edge
{
  Index source, target;
  double ratio;
};

/// A loop that a handle may be removed along.
struct Loop_choice
{
  Loop_type type;
  double length;
  std::vector<Place_on_edge> places;
  bool is_allowed = true; ///< or only here because it crosses the other one once
};

/// a loop on a mesh of any kind; its vertices have these numbers here.
template <typename Loop, typename TriangleMesh, typename VertexIndexMap>
Loop_choice loop_choice(const Loop& loop, const TriangleMesh& tm, VertexIndexMap number) {
  Loop_choice choice{loop.type(), loop.length(), {}};
  for(const auto& step : loop.steps())
    if(step.halfedge == boost::graph_traits<TriangleMesh>::null_halfedge()) // it is nowhere
      choice.places.push_back({no_index, no_index, step.ratio});
    else
      choice.places.push_back({static_cast<Index>(get(number, source(step.halfedge, tm))),
                               static_cast<Index>(get(number, target(step.halfedge, tm))),
                               step.ratio});
  return choice;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOP_CHOICE_H
