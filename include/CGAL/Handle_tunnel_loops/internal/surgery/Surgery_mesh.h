// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURGERY_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURGERY_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Box_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/triangles_apart.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
A closed oriented triangle mesh whose patches can be exchanged for others. Halfedges 3f, 3f + 1 and
3f + 2 lead around face f. Faces and vertices are numbered once and for all: what is taken out
leaves a gap, what is put in comes at the end, so that whatever is not touched keeps its number.

A surface with boundary has caps, fans of faces around hubs, as in `Flat_mesh`. They stay as they
are, and are not in the way of anything.
*/
class Surgery_mesh
{
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Face = std::array<Index, 3>;

  static Vector place_of(const Point& p) { return {p.x(), p.y(), p.z()}; }

  Surgery_mesh() = default;

  /// \p corners may leave gaps, faces with corners no_index; \p twins are those of halfedges.
  Surgery_mesh(std::vector<Point> points, std::vector<Face> corners, std::vector<Index> twins)
      : points_(std::move(points))
      , faces_(std::move(corners))
      , twins_(std::move(twins))
      , first_(points_.size(), no_index)
      , box_axes_(some_triangles()) {
    for(Index f = 0; f < face_bound(); ++f)
      number_of_faces_ += is_alive(f);
    forget_order();
  }

  /// has the halfedges around each vertex begin where they would in a mesh that is read like this.
  void forget_order() {
    for(Index h = 0; h < twins_.size(); ++h)
      if(is_alive(face(h)))
        first_[source(h)] = h;
  }

  /// closes each boundary curve, along halfedges without a twin, by a cap. The caps follow the
  /// vertices and faces, and the first halfedge of each of their faces is at the curve.
  void add_caps() {
    const Index end = 3 * face_bound();
    first_hub_ = vertex_bound();
    for(Index h = 0; h < end; ++h)
      if(is_alive(face(h)) && twins_[h] == no_index)
        add_cap(h);
    number_of_hubs_ = vertex_bound() - first_hub_;
  }

  /// says which vertices are hubs.
  void set_hubs(Index first, Index number) {
    first_hub_ = first;
    number_of_hubs_ = number;
  }

  // ---- numbers, gaps included

  Index vertex_bound() const { return static_cast<Index>(points_.size()); }
  Index face_bound() const { return static_cast<Index>(faces_.size()); }
  std::size_t number_of_faces() const { return number_of_faces_; }

  /// whether a vertex lies on the boundary of the surface.
  bool is_on_boundary(Index v) const {
    bool is_beside_hub = false;
    if(number_of_hubs_ > 0)
      for_each_outgoing(v, [&](Index h) { is_beside_hub = is_beside_hub || is_hub(target(h)); });
    return is_beside_hub;
  }

  // ---- connectivity

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static Index face(Index h) { return h / 3; }

  Index source(Index h) const { return faces_[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); }
  Index twin(Index h) const { return twins_[h]; }

  const Face& corners(Index f) const { return faces_[f]; }
  const Point& point(Index v) const { return points_[v]; }

  bool is_alive(Index f) const { return faces_[f][0] != no_index; }

  /// along which boxes around faces are small; as there were before any surgery.
  const Box_axes& box_axes() const { return box_axes_; }

  Index first_hub() const { return first_hub_; }
  Index number_of_hubs() const { return number_of_hubs_; }
  bool is_hub(Index v) const { return v - first_hub_ < number_of_hubs_; }

  /// whether a face that is alive belongs to a cap.
  bool is_in_cap(Index f) const {
    return number_of_hubs_ > 0 &&
           (is_hub(faces_[f][0]) || is_hub(faces_[f][1]) || is_hub(faces_[f][2]));
  }

  /// a halfedge from a vertex, if it has any.
  Index outgoing(Index v) const { return first_[v]; }

  /// calls `f(h)` for each halfedge from a vertex, clockwise.
  template <typename Function> void for_each_outgoing(Index v, const Function& f) const {
    const Index begin = first_[v];
    if(begin == no_index)
      return;
    Index h = begin;
    do {
      f(h);
      h = next(twins_[h]);
    } while(h != begin);
  }

  /// the halfedge from one vertex to another, if there is one.
  Index halfedge(Index from, Index to) const {
    Index found = no_index;
    for_each_outgoing(from, [&](Index h) {
      if(target(h) == to)
        found = h;
    });
    return found;
  }

  // ---- surgery

  Index add_vertex(const Point& p) {
    points_.push_back(p);
    first_.push_back(no_index);
    return vertex_bound() - 1;
  }

  /// the face that there was before any surgery, which a face is, or is a part of; none of one that
  /// is no part of any.
  Index origin(Index f) const { return f < first_put_in_ ? f : origins_[f - first_put_in_]; }

  /// takes out faces and puts others in their place, which have the same boundary; the first of
  /// these are parts of \p parents, each of one. Returns the number of the first of these; they
  /// follow each other.
  Index replace(const std::vector<Index>& out,
                const std::vector<Face>& in,
                const std::vector<Index>& parents = {}) {
    CGAL_precondition(std::is_sorted(out.begin(), out.end()));
    const Index_range_set is_out(out);
    std::vector<Open_side> open;
    for(Index f : out)
      open_neighbors(f, is_out, open);
    for(Index f : out)
      take_out(f);
    const Index first_face = face_bound();
    first_put_in_ = (std::min)(first_put_in_, first_face);
    for(std::size_t i = 0; i < in.size(); ++i) {
      origins_.push_back(i < parents.size() ? origin(parents[i]) : no_index);
      put_in(in[i], open);
    }
    glue(open);
    for(const Open_side& side : open)
      first_[source(side.halfedge)] = side.halfedge;
    return first_face;
  }

private:
  // The same each time.
  std::vector<Corner_points> some_triangles() const {
    constexpr Index enough = 512;
    std::vector<Corner_points> some;
    for(Index f = 0; f < face_bound(); f += face_bound() / enough + 1)
      if(is_alive(f)) {
        some.emplace_back();
        for(std::size_t k = 0; k < 3; ++k)
          some.back()[k] = place_of(points_[faces_[f][k]]);
      }
    return some;
  }

  // Along the boundary from one of its halfedges on.
  void add_cap(Index first) {
    const Index hub = add_vertex(Point(CGAL::ORIGIN)), begin = 3 * face_bound();
    Kernel::Vector_3 sum(0., 0., 0.);
    Index h = first;
    do {
      const Index own = 3 * face_bound();
      sum = sum + (points_[target(h)] - CGAL::ORIGIN);
      faces_.push_back({target(h), source(h), hub});
      twins_.insert(twins_.end(), {h, own + 5, own - 2}); // of the faces after and before
      twins_[h] = own;
      for(Index g : {own, own + 1, own + 2})
        first_[source(g)] = g;
      ++number_of_faces_;
      for(h = previous(h); h != first && twins_[h] != no_index;)
        h = previous(twins_[h]);
    } while(h != first);
    const Index end = 3 * face_bound();
    twins_[end - 2] = begin + 2;
    twins_[begin + 2] = end - 2;
    points_[hub] = CGAL::ORIGIN + sum / ((end - begin) / 3);
  }

  // A side of a patch, or of what is around it.
  struct Open_side
  {
    std::uint64_t ends; // the smaller one first
    Index halfedge;
  };

  void add_side(Index h, std::vector<Open_side>& open) const {
    const auto [low, high] = std::minmax({source(h), target(h)});
    open.push_back({std::uint64_t(low) << 32 | high, h});
  }

  void open_neighbors(Index f, const Index_range_set& out, std::vector<Open_side>& open) const {
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
      if(!out.contains(face(twins_[h])))
        add_side(twins_[h], open);
  }

  void take_out(Index f) {
    for(Index v : faces_[f])
      first_[v] = no_index;
    faces_[f].fill(no_index);
    --number_of_faces_;
  }

  void put_in(const Face& corners, std::vector<Open_side>& open) {
    const Index f = face_bound();
    faces_.push_back(corners);
    twins_.insert(twins_.end(), 3, no_index);
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
      add_side(h, open);
    ++number_of_faces_;
  }

  void glue(std::vector<Open_side>& open) {
    std::sort(open.begin(), open.end(),
              [](const Open_side& a, const Open_side& b) { return a.ends < b.ends; });
    CGAL_assertion(open.size() % 2 == 0);
    for(std::size_t i = 0; i < open.size(); i += 2) {
      const Index g = open[i].halfedge, h = open[i + 1].halfedge;
      CGAL_assertion_msg(source(g) == target(h) && target(g) == source(h),
                         "a patch does not fit its place");
      twins_[g] = h;
      twins_[h] = g;
    }
  }

  std::vector<Point> points_;
  std::vector<Face> faces_;  // corners, or no_index
  std::vector<Index> twins_; // by halfedge
  std::vector<Index> first_; // a halfedge from each vertex
  Index first_put_in_ = no_index;
  std::vector<Index> origins_; // of faces that were put in
  std::size_t number_of_faces_ = 0;
  Index first_hub_ = 0, number_of_hubs_ = 0;
  Box_axes box_axes_;
};

/// the vertices of some faces, in ascending order.
inline std::vector<Index> vertices_of(const Surgery_mesh& mesh, const std::vector<Index>& faces) {
  std::vector<Index> vertices;
  for(Index f : faces)
    vertices.insert(vertices.end(), mesh.corners(f).begin(), mesh.corners(f).end());
  make_set(vertices);
  return vertices;
}

/// What is read, with room for caps: numbers are not given twice, and to make room later takes
/// twice as much. It is in a unit of its own, a power of two, so that it is the same at all scales:
/// products of its coordinates are numbers still. Boundary curves get caps, which follow the
/// vertices and faces.
inline Surgery_mesh surgery_mesh_of(const Triangle_list& triangles, double& unit) {
  const auto with_room = [](std::size_t n) { return n + n / 4; };
  const auto is_there = [&](std::size_t v) { return triangles.arriving[v] != no_index; };
  const std::size_t number_of_vertices = triangles.arriving.size();
  double size = 0.;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    for(std::size_t d = 0; is_there(v) && d < 3; ++d)
      size = (std::max)(size, std::abs(triangles.points[v][d]));
  const int exponent = size > 0. ? std::ilogb(size) : 0;
  unit = std::ldexp(1., exponent);
  std::vector<Surgery_mesh::Point> points;
  points.reserve(with_room(number_of_vertices));
  for(std::size_t v = 0; v < number_of_vertices; ++v) {
    const Vector p = is_there(v) ? triangles.points[v] : Vector{0., 0., 0.};
    points.emplace_back(std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent),
                        std::ldexp(p[2], -exponent));
  }
  std::vector<Surgery_mesh::Face> corners;
  corners.reserve(with_room(triangles.number_of_faces()));
  const auto& target = triangles.target;
  for(std::size_t h = 0; h < target.size(); h += 3)
    corners.push_back({target[h + 2], target[h], target[h + 1]});
  std::vector<Index> twins;
  twins.reserve(3 * with_room(triangles.number_of_faces()));
  twins.assign(triangles.opposite.begin(), triangles.opposite.end());
  Surgery_mesh mesh(std::move(points), std::move(corners), std::move(twins));
  mesh.add_caps();
  return mesh;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURGERY_MESH_H
