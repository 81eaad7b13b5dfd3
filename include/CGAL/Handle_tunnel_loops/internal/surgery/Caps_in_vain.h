// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_IN_VAIN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_IN_VAIN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Why a handle is not removed in some way: the later ones say more.
struct Obstacle
{
  enum Kind {
    NO_LOOP,
    NO_REGION,
    NO_CAPS,
    CAPS_CROSS,
    SURFACE_IN_THE_WAY,
    MORE_CROSSINGS,
    SHAPE,
    TOPOLOGY
  };
  Kind kind = NO_CAPS;
  std::string why = "the holes cannot be triangulated";

  /// keeps the one that says more.
  void take(const Obstacle& other) {
    if(other.kind > kind)
      *this = other;
  }
};

/*!
What was in the way of all caps of a region. As faces never change as long as they are there, and
those that come can only be in the way, too, the caps remain in vain as long as the faces are there
that they were made from, and for each of them one that it met; whatever else becomes of the
surface, and on another copy of it, too.
*/
struct Caps_in_vain
{
  std::vector<Index> out;           ///< the faces that were to be replaced
  std::vector<Edge_crossing> curve; ///< along which they were to be divided, if they were
  std::vector<Index> around;        ///< other faces that the caps were made from
  Intended_change intended;
  Obstacle obstacle = {};
  Box<3> reach = Box<3>::empty(); ///< holds all that was looked at
  bool met_each_other = false;
  std::vector<Index> met = {}; ///< of the faces that some of the caps met, the first one

  /// whether the faces are to be replaced in the same way.
  bool is_like(const Caps_in_vain& other) const {
    const Intended_change &a = intended, &b = other.intended;
    return out == other.out && a.may_remove == b.may_remove && a.may_add == b.may_add &&
           a.length == b.length &&
           std::equal(curve.begin(), curve.end(), other.curve.begin(), other.curve.end(),
                      [](const Edge_crossing& c, const Edge_crossing& d) {
                        return c.halfedge == d.halfedge && c.ratio == d.ratio &&
                               c.margin == d.margin;
                      });
  }

  /// whether all faces are there that tell that the caps are in vain.
  bool holds(const Surgery_mesh& mesh) const {
    const auto are_there = [&](const std::vector<Index>& faces) {
      return std::all_of(faces.begin(), faces.end(),
                         [&](Index f) { return f < mesh.face_bound() && mesh.is_alive(f); });
    };
    return are_there(out) && are_there(met) && are_there(around);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_IN_VAIN_H
