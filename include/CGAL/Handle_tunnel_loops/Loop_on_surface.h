// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_LOOP_ON_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_LOOP_ON_SURFACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgHandleTunnelLoopsRef
/// The kinds of loops: a handle loop bounds a surface in the solid inside the surface, a tunnel
/// loop bounds one in the space outside it. A short loop need not bound on either side
/// (`Handle_tunnel_loops::Loop_linking` tells); then these are the names of the loop that is more
/// like a handle, and of the other. Boundary curves are of a kind of their own.
enum class Loop_type { HANDLE, TUNNEL, BOUNDARY };

/*!
\ingroup PkgHandleTunnelLoopsRef

A closed polyline on a triangle mesh: a cyclic sequence of steps, each on an edge or at a vertex,
where consecutive steps (and the last and the first) lie on a common face.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
class Loop_on_surface
{
public:
  using Halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Point = Point_;

  /// A place on the mesh: `source(halfedge) + ratio * (target(halfedge) - source(halfedge))`.
  struct Step
  {
    Halfedge_descriptor halfedge; ///< the halfedge that carries the place
    double ratio;                 ///< in [0, 1]; 0 is the source vertex, 1 the target vertex

    /// whether the step is at a vertex.
    bool is_vertex() const { return ratio == 0. || ratio == 1.; }
  };

  Loop_on_surface() = default;

  Loop_on_surface(std::vector<Step> steps,
                  std::vector<Point> points,
                  double length,
                  Loop_type type,
                  std::size_t pair_index)
      : steps_(std::move(steps))
      , points_(std::move(points))
      , length_(length)
      , type_(type)
      , pair_index_(pair_index) {}

  /// the steps, in cyclic order; the first is not repeated at the end.
  const std::vector<Step>& steps() const { return steps_; }

  /// the point of each step.
  const std::vector<Point>& points() const { return points_; }

  /// the number of steps.
  std::size_t size() const { return steps_.size(); }

  /// the length of the closed polyline, in the unit of the coordinates.
  double length() const { return length_; }

  /// whether the loop is a handle or a tunnel loop, or follows a boundary curve.
  Loop_type type() const { return type_; }

  /// the position, in the output, of the pair that this loop belongs to, or of the loop itself if
  /// it follows a boundary curve.
  std::size_t pair_index() const { return pair_index_; }

  /// the same loop with another type.
  Loop_on_surface with_type(Loop_type type) const {
    return Loop_on_surface(steps_, points_, length_, type, pair_index_);
  }

private:
  std::vector<Step> steps_;
  std::vector<Point> points_;
  double length_ = 0.;
  Loop_type type_ = Loop_type::HANDLE;
  std::size_t pair_index_ = 0;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

A handle loop and the tunnel loop that belongs to it.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
class Handle_tunnel_pair
{
public:
  using Loop = Loop_on_surface<TriangleMesh, Point_>;

  Handle_tunnel_pair() = default;

  Handle_tunnel_pair(Loop handle, Loop tunnel)
      : handle_(std::move(handle))
      , tunnel_(std::move(tunnel)) {}

  const Loop& handle() const { return handle_; }
  const Loop& tunnel() const { return tunnel_; }

  /// the loop of the given type.
  const Loop& loop(Loop_type type) const { return type == Loop_type::HANDLE ? handle_ : tunnel_; }

  /// the pair with handle and tunnel loop exchanged.
  Handle_tunnel_pair exchanged() const {
    return Handle_tunnel_pair(tunnel_.with_type(Loop_type::HANDLE),
                              handle_.with_type(Loop_type::TUNNEL));
  }

  /// the other loop of the pair.
  const Loop& partner(const Loop& loop) const {
    return loop.type() == Loop_type::HANDLE ? tunnel_ : handle_;
  }

private:
  Loop handle_, tunnel_;
};

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOP_ON_SURFACE_H
