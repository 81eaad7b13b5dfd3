// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PARTED_WALLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PARTED_WALLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <iterator>
#include <set>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Tells channels from other handles and necks that were removed. A channel leads through the material
from an outer wall to an inner one. Once all channels between them have been filled, the walls are
pieces of the surface, one oriented outwards and one inwards, and each channel has a cap on both.
*/
class Parted_walls
{
public:
  /// on a mesh from which these were removed; faces were put in for them from a number on.
  Parted_walls(Execution execution,
               const Surgery_mesh& mesh,
               Index first_put_in,
               const std::vector<const std::vector<Removal_task>*>& tasks)
      : mesh_(mesh)
      , piece_(pieces(execution, mesh, [&](Index f) { return mesh.is_alive(f); }))
      , volume_(mesh.face_bound(), 0.)
      , ends_{first_put_in} {
    piece_.flatten(execution);
    for(Index f = 0; f < mesh.face_bound(); ++f)
      if(mesh.is_alive(f))
        volume_[piece_.root(f)] += volume_behind(f);
    for(const auto* some : tasks)
      for(const Removal_task& task : *some)
        if(task.state == Removal_task::State::REMOVED)
          ends_.insert(task.end_of_faces);
  }

  /// whether a handle or neck that was removed was a channel.
  bool was_channel(const Removal_task& task) {
    if(task.choices[task.choice].type != Loop_type::TUNNEL)
      return false; // a bridge in the hollow was cut
    const auto end = ends_.find(task.end_of_faces);
    bool is_outside = false, is_inside = false;
    for(Index f = *std::prev(end); f < *end; ++f)
      if(mesh_.is_alive(f))
        (volume_[piece_.root(f)] > 0. ? is_outside : is_inside) = true;
    return is_outside && is_inside;
  }

private:
  double volume_behind(Index f) const {
    const Surgery_mesh::Face& corners = mesh_.corners(f);
    return CGAL::volume(Surgery_mesh::Point(CGAL::ORIGIN), mesh_.point(corners[0]),
                        mesh_.point(corners[1]), mesh_.point(corners[2]));
  }

  const Surgery_mesh& mesh_;
  Concurrent_disjoint_sets piece_; // of faces
  std::vector<double> volume_;     // by the first face of each piece
  std::set<Index> ends_;           // of the faces that were put in for each, or for several
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PARTED_WALLS_H
