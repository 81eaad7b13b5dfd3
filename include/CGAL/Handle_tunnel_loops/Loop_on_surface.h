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
/// The types of loops. A handle loop bounds a surface in the solid, and a tunnel loop bounds a
/// surface in the space outside of it. A short loop may bound on neither side
/// (`Handle_tunnel_loops::Loop_linking` reports it); then the loop of the pair that is more like a
/// handle loop has the type `HANDLE`, and the other one the type `TUNNEL`. Boundary curves and
/// their waists have the type `BOUNDARY`.
enum class Loop_type { HANDLE, TUNNEL, BOUNDARY };

/*!
\ingroup PkgHandleTunnelLoopsRef

A closed polyline on a triangle mesh: a cyclic sequence of steps. Each step lies on an edge or at a
vertex, and consecutive steps, including the last and the first, lie on a common face.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
class Loop_on_surface
{
public:
  /// The halfedge descriptor of the mesh.
  using Halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  /// The point type of the mesh.
  using Point = Point_;

  /// A point on the mesh: `source(halfedge) + ratio * (target(halfedge) - source(halfedge))`.
  struct Step
  {
    Halfedge_descriptor halfedge; ///< the halfedge that contains the point
    double ratio;                 ///< in [0, 1]; 0 is the source vertex, 1 the target vertex

    /// Returns whether the step is at a vertex.
    bool is_vertex() const { return ratio == 0. || ratio == 1.; }
  };

  /// Constructs an empty loop.
  Loop_on_surface() = default;

  /// Constructs a loop from the values that its member functions return.
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

  /// Returns the steps, in cyclic order; the first one is not repeated at the end.
  const std::vector<Step>& steps() const { return steps_; }

  /// Returns the point of each step.
  const std::vector<Point>& points() const { return points_; }

  /// Returns the number of steps.
  std::size_t size() const { return steps_.size(); }

  /// Returns the length of the closed polyline, in the unit of the coordinates.
  double length() const { return length_; }

  /// Returns whether the loop is a handle loop, a tunnel loop, or belongs to a boundary curve.
  Loop_type type() const { return type_; }

  /// Returns the position of the pair of this loop in the output, or the number of the boundary
  /// curve that the loop belongs to.
  std::size_t pair_index() const { return pair_index_; }

  /// Returns the same loop with another type.
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

A handle loop and its tunnel loop.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
class Handle_tunnel_pair
{
public:
  /// The type of the loops.
  using Loop = Loop_on_surface<TriangleMesh, Point_>;

  /// Constructs a pair of empty loops.
  Handle_tunnel_pair() = default;

  /// Constructs a pair from its handle loop and its tunnel loop.
  Handle_tunnel_pair(Loop handle, Loop tunnel)
      : handle_(std::move(handle))
      , tunnel_(std::move(tunnel)) {}

  /// Returns the handle loop.
  const Loop& handle() const { return handle_; }

  /// Returns the tunnel loop.
  const Loop& tunnel() const { return tunnel_; }

  /// Returns the loop of the given type.
  const Loop& loop(Loop_type type) const { return type == Loop_type::HANDLE ? handle_ : tunnel_; }

  /// Returns the pair with the handle loop and the tunnel loop exchanged.
  Handle_tunnel_pair exchanged() const {
    return Handle_tunnel_pair(tunnel_.with_type(Loop_type::HANDLE),
                              handle_.with_type(Loop_type::TUNNEL));
  }

  /// Returns the other loop of the pair.
  const Loop& partner(const Loop& loop) const {
    return loop.type() == Loop_type::HANDLE ? tunnel_ : handle_;
  }

private:
  Loop handle_, tunnel_;
};

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOP_ON_SURFACE_H
