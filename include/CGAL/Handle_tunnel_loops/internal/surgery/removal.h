// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loop_choice.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

// What programs use of this room: handles are removed from arrays, and bores found in them.

/// The loops of a handle.
struct Choice_of_handle
{
  Loop_choice handle, tunnel;
  bool is_handle_in_box = true, is_tunnel_in_box = true; ///< that the options ask for

  const Loop_choice& loop(Loop_type type) const {
    return type == Loop_type::TUNNEL ? tunnel : handle;
  }
};

template <typename Loop> bool lies_in_box(const Loop& loop, const Bbox_3& box) {
  return std::all_of(loop.points().begin(), loop.points().end(), [&](const auto& p) {
    const Bbox_3 b = p.bbox();
    return box.xmin() <= b.xmin() && b.xmax() <= box.xmax() && box.ymin() <= b.ymin() &&
           b.ymax() <= box.ymax() && box.zmin() <= b.zmin() && b.zmax() <= box.zmax();
  });
}

/// the loops of a pair, whose vertices have these numbers for surgery.
template <typename Pair, typename TriangleMesh, typename VertexIndexMap>
Choice_of_handle choice_of_handle(const Pair& pair,
                                  const TriangleMesh& tm,
                                  VertexIndexMap vertex_index,
                                  const std::optional<Bbox_3>& box = {}) {
  return {loop_choice(pair.handle(), tm, vertex_index),
          loop_choice(pair.tunnel(), tm, vertex_index), !box || lies_in_box(pair.handle(), *box),
          !box || lies_in_box(pair.tunnel(), *box)};
}

struct Removal_request
{
  Removal_options options;
  std::size_t genus = 0, components = 0; ///< before
  std::vector<Choice_of_handle> handles;
  bool are_loops_of_caller = false;        ///< which may be those of another mesh
  std::function<bool(std::size_t)> filter; ///< by number of the handle; empty if there is none
  std::function<bool(double)> callback;    ///< from 0.7 on, which finding the loops has taken
};

/// What has to be done to a mesh for it to become as surgery has left it.
struct Mesh_change
{
  struct New_vertex
  {
    Index number;
    Vector point;
  };

  struct New_face
  {
    Index number;
    std::array<Index, 3> corners, twins; ///< halfedge i leads from corner i
    Index origin;                        ///< the face that it is a part of, if there is one
    std::size_t patch;
  };

  Index vertex_bound = 0;
  Index first_new_face = 0;
  std::vector<Index> twins_of_caps; ///< of the faces of caps, which come before new ones
  std::vector<Index> faces_gone, vertices_gone;
  std::vector<New_vertex> new_vertices;
  std::vector<New_face> new_faces; ///< by number, which may leave gaps
};

struct Removal_result
{
  Removal_report report;
  Mesh_change change;
};

/// removes handles and necks. Throws `std::invalid_argument` if the request makes no sense,
/// `Interrupted_exception` if the callback says so.
Removal_result
removal_of_handles(Execution execution, Triangle_list triangles, const Removal_request& request);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_H
