// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_TRIANGLE_LIST_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_TRIANGLE_LIST_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A triangle mesh as the certificate sees it: a list of triangles, read face by face. It has
/// nothing in common with the arrays of the solver, which are read vertex by vertex. Halfedge i of
/// face f has the number 3 f + i; vertices have the caller's indices, which may leave gaps.
struct Triangle_list
{
  Uninitialized_vector<Index> target;   ///< by halfedge
  Uninitialized_vector<Index> opposite; ///< by halfedge, `no_index` on the boundary
  Uninitialized_vector<Index> arriving; ///< by vertex, a halfedge, `no_index` if it has no face
  Uninitialized_vector<Vector> points;  ///< by vertex, rounded to doubles if they are none
  /// vertices from this one on stand for boundary curves, and their faces are caps.
  Index first_hub = no_index;

  std::size_t number_of_faces() const { return target.size() / 3; }
  bool is_closed = true;
};

/// A step of a loop of the caller: a place on a halfedge of the list, or on its opposite one.
struct Listed_step
{
  Index halfedge = no_index; ///< none if the step is on no edge
  bool is_opposite = false;
  double ratio = 0.;
};

using Listed_loop = std::vector<Listed_step>;

[[noreturn]] void throw_not_triangulated(std::size_t u, std::size_t v);

/// Reads a `Triangle_list`, and loops on it. Throws `Invalid_mesh_exception` if a face is not a
/// triangle.
template <typename TriangleMesh, typename FaceIndexMap> class Triangle_reader
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  Triangle_reader(const TriangleMesh& tm, FaceIndexMap face_index)
      : tm_(tm)
      , face_index_(face_index) {
    std::size_t bound = 0;
    for(face_descriptor f : faces(tm_)) {
      bound = (std::max)(bound, std::size_t(get(face_index_, f)) + 1);
      ++number_of_faces_;
    }
    if(bound == number_of_faces_)
      return;
    number_.assign(bound, no_index);
    Index number = 0;
    for(face_descriptor f : faces(tm_))
      number_[get(face_index_, f)] = number++;
  }

  template <typename VertexIndexMap, typename VertexPointMap>
  Triangle_list read(Execution execution,
                     VertexIndexMap vertex_index,
                     VertexPointMap point,
                     bool with_points = true) const {
    Triangle_list list;
    list.target.resize(3 * number_of_faces_);
    list.opposite.resize(3 * number_of_faces_);
    std::atomic<bool> are_triangles{true}, is_closed{true};
    parts_of(faces(tm_)).for_each(execution, [&](face_descriptor f) {
      halfedge_descriptor h = halfedge(f, tm_);
      for(Index n = 3 * number_of_face(f), i = 0; i < 3; ++i, ++n, h = next(h, tm_)) {
        list.target[n] = static_cast<Index>(get(vertex_index, target(h, tm_)));
        const halfedge_descriptor other = opposite(h, tm_);
        if(is_border(other, tm_)) {
          list.opposite[n] = no_index;
          is_closed = false;
        } else
          list.opposite[n] = number(other);
      }
      if(h != halfedge(f, tm_))
        are_triangles = false;
    });
    for(halfedge_descriptor h : halfedges(tm_))
      if(are_triangles)
        break;
      else if(!is_border(h, tm_) && next(next(next(h, tm_), tm_), tm_) != h)
        throw_not_triangulated(get(vertex_index, source(h, tm_)),
                               get(vertex_index, target(h, tm_)));
    list.is_closed = is_closed;
    std::size_t bound = 0;
    for(vertex_descriptor v : vertices(tm_))
      bound = (std::max)(bound, std::size_t(get(vertex_index, v)) + 1);
    list.arriving.assign(bound, no_index);
    list.points.resize(with_points ? bound : 0);
    using Coordinate = std::decay_t<decltype(get(point, *vertices(tm_).begin()).x())>;
    // Exact numbers may share what they are computed from, and know nothing of threads.
    parts_of(vertices(tm_))
        .for_each(std::is_floating_point<Coordinate>::value ? execution : Execution(),
                  [&](vertex_descriptor v) {
                    const std::size_t i = get(vertex_index, v);
                    if(with_points)
                      list.points[i] = coordinates(point, v);
                    halfedge_descriptor h = halfedge(v, tm_);
                    if(h == Graph_traits::null_halfedge())
                      return;
                    if(is_border(h, tm_))
                      h = opposite(next(h, tm_), tm_);
                    list.arriving[i] = number(h);
                  });
    return list;
  }

  /// a range of steps with members `halfedge` and `ratio`.
  template <typename Loop> Listed_loop listed(const Loop& loop) const {
    Listed_loop steps;
    steps.reserve(loop.steps().size());
    for(const auto& step : loop.steps())
      if(step.halfedge == Graph_traits::null_halfedge())
        steps.push_back({no_index, false, step.ratio});
      else if(is_border(step.halfedge, tm_))
        steps.push_back({number(opposite(step.halfedge, tm_)), true, step.ratio});
      else
        steps.push_back({number(step.halfedge), false, step.ratio});
    return steps;
  }

  /// the loops of pairs, handles and tunnels in turn.
  template <typename PairRange> std::vector<Listed_loop> loops_of(const PairRange& pairs) const {
    std::vector<Listed_loop> loops;
    for(const auto& pair : pairs) {
      loops.push_back(listed(pair.handle()));
      loops.push_back(listed(pair.tunnel()));
    }
    return loops;
  }

  std::size_t number_of_faces() const { return number_of_faces_; }

  /// in the list.
  Index number_of_face(face_descriptor f) const {
    const Index i = static_cast<Index>(get(face_index_, f));
    return number_.empty() ? i : number_[i];
  }

private:
  // Of a halfedge with a face.
  Index number(halfedge_descriptor h) const {
    const face_descriptor f = face(h, tm_);
    const halfedge_descriptor first = halfedge(f, tm_);
    return 3 * number_of_face(f) + (h == first ? 0 : h == next(first, tm_) ? 1 : 2);
  }

  const TriangleMesh& tm_;
  FaceIndexMap face_index_;
  std::size_t number_of_faces_ = 0;
  std::vector<Index> number_; // by the caller's index, if these leave gaps
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_TRIANGLE_LIST_H
