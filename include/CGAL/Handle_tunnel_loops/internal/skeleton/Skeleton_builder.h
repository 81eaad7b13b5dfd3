// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Arcs_side_by_side.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loops_across.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Out_of_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Parts_of_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_draft.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_drawing.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Taken_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Own_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds a skeleton in the steps that the files of this folder are named after: balls in the middle of
the solid and the graph of these; cycles, which are a basis; inlets and limbs; joints as stars and
smooth arcs; and proves it.

All of this is done in the frame of the mesh itself, and what comes out is turned back and rounded,
and proved there. Where walls are so thin that the proof fails by rounding, it is done in the frame
of the caller, where nothing is rounded any more; and where it fails because of smoothing, with
less.
*/
class Skeleton_builder
{
public:
  Skeleton_builder(Execution execution,
                   const Flat_mesh& mesh,
                   const Own_frame& frame,
                   const std::vector<Vector>& places,
                   const std::vector<Flat_pair>& pairs,
                   const Skeleton_options& options,
                   const Face_number& face_number,
                   const std::function<void()>& look)
      : execution_(execution)
      , mesh_(mesh)
      , frame_(frame)
      , places_(places)
      , pairs_(pairs)
      , options_(options)
      , face_number_(face_number)
      , look_(look) {}

  Found_skeleton build() {
    if(!build_in(frame_, span_of(mesh_.points))) {
      const Own_frame frame = Own_frame::of_caller(places_);
      std::vector<Vector> points = places_;
      for(Vector& p : points)
        p = frame.into(p);
      build_in(frame, span_of(points));
    }
    return std::move(found_);
  }

private:
  // Returns whether it is no use to try in another frame.
  bool build_in(const Own_frame& frame, Span<const Vector> points) {
    const Solid_balls solid(execution_, mesh_, points,
                            loops_inside(mesh_, pairs_, &Flat_pair::tunnel));
    look_();
    const Loops_across across(mesh_, points, pairs_);
    const Taken_ways ways(execution_, solid, across, options_.shortest_limb);
    found_.number_of_balls = ways.graph().balls.size();
    const Loop_curtains curtains(execution_, across.loops);
    const Skeleton_drawing draw(execution_, solid, curtains);
    bool is_inside = true;
    for(const Smoothness smoothness :
        {Smoothness::straight, Smoothness::in_class, Smoothness::none}) {
      if(smoothness == Smoothness::in_class && !is_inside)
        continue; // on a surface that crosses itself
      look_();
      Skeleton_draft draft(ways.graph(), ways.is_taken(), ways.roots());
      if(smoothness != Smoothness::none) {
        draft.draw_stars(solid.wall());
        Arcs_side_by_side(solid.wall(), solid.spacing(), draft).join();
      }
      found_.skeleton = draw(draft, smoothness);
      found_.point_of_vertex =
          Parts_of_surface(execution_, solid, ways.graph(), found_.skeleton).points();
      is_inside = is_free(solid.wall(), found_.skeleton);
      take_out_of(execution_, frame, solid, places_, found_.skeleton);
      look_();
      certify();
      if(found_.certificate || fails_by_caps_alone())
        return true;
    }
    return !is_inside;
  }

  void certify() {
    std::vector<std::vector<Index>> walks;
    for(const Crossing_loop* loop : loops_inside(mesh_, pairs_, &Flat_pair::handle))
      walks.push_back(walk_beside(mesh_, *loop));
    found_.certificate = certify_skeleton(execution_, mesh_, places_, found_.skeleton, walks,
                                          face_number_, {}, &do_caps_meet_);
  }

  // Caps that meet something do so in any frame.
  bool fails_by_caps_alone() const {
    const Skeleton_certificate& c = found_.certificate;
    return do_caps_meet_ && c.connected && c.embedded && c.edges_outside.empty();
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const Own_frame& frame_;
  const std::vector<Vector>& places_;
  const std::vector<Flat_pair>& pairs_;
  Skeleton_options options_;
  const Face_number& face_number_;
  const std::function<void()>& look_;
  Found_skeleton found_;
  bool do_caps_meet_ = false;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_BUILDER_H
