// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MESH_LINK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MESH_LINK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Reads a mesh into a `Surgery_mesh`, and changes it later as that has been changed: what was taken
out is removed, what was put in is added, the rest is not touched. The vertices and faces of the
mesh have the numbers that its index maps give them.

Boundary curves get caps, which follow the vertices and faces of the mesh.

It is read in a unit of its own, a power of two, so that it is the same at all scales: products of
its coordinates are numbers still. Vertices that stay are not touched by that.

\tparam TriangleMesh a model of `MutableFaceGraph`, a triangle mesh; or a constant model of
  `FaceListGraph`, which can be read only
*/
template <typename TriangleMesh, typename VertexPointMap> class Mesh_link
{
  using Graph_traits = boost::graph_traits<std::remove_const_t<TriangleMesh>>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  Mesh_link(TriangleMesh& tm, VertexPointMap point)
      : tm_(tm)
      , point_(point) {}

  /// of lengths in the copy; after it was read.
  double unit() const { return std::ldexp(1., exponent_); }

  /// coordinates are taken as doubles.
  template <typename VertexIndexMap, typename FaceIndexMap>
  Surgery_mesh read(Execution execution, VertexIndexMap vertex_index, FaceIndexMap face_index) {
    for(vertex_descriptor v : vertices(tm_))
      if(halfedge(v, tm_) != Graph_traits::null_halfedge()) // isolated ones are left alone
        put_at(vertices_, get(vertex_index, v), v, Graph_traits::null_vertex());
    for(face_descriptor f : faces(tm_))
      put_at(faces_, get(face_index, f), f, Graph_traits::null_face());
    // With room for caps: numbers are not given twice, and to make room later takes twice as much.
    const auto with_room = [](std::size_t n) { return n + n / 4; };
    std::vector<Surgery_mesh::Point> points;
    points.reserve(with_room(vertices_.size()));
    points.resize(vertices_.size());
    for_each_index(execution, vertices_.size(), [&](std::size_t v) {
      if(vertices_[v] != Graph_traits::null_vertex())
        points[v] = as_double(get(point_, vertices_[v]));
    });
    choose_unit(points);
    if(exponent_ != 0)
      for(Surgery_mesh::Point& p : points)
        p = scaled(p, -exponent_);
    std::vector<Surgery_mesh::Face> corners;
    corners.reserve(with_room(faces_.size()));
    corners.resize(faces_.size());
    std::vector<Index> twins;
    twins.reserve(3 * with_room(faces_.size()));
    twins.resize(3 * faces_.size(), no_index);
    for_each_index(execution, faces_.size(), [&](std::size_t f) {
      corners[f].fill(no_index);
      if(faces_[f] == Graph_traits::null_face())
        return;
      halfedge_descriptor h = halfedge(faces_[f], tm_);
      for(std::size_t i = 0; i < 3; ++i, h = next(h, tm_)) {
        corners[f][i] = static_cast<Index>(get(vertex_index, source(h, tm_)));
        if(!is_border(opposite(h, tm_), tm_))
          twins[3 * f + i] = number(opposite(h, tm_), face_index);
      }
    });
    Surgery_mesh mesh(std::move(points), std::move(corners), std::move(twins));
    mesh.add_caps();
    number_of_faces_ = mesh.face_bound();
    for(Index f = static_cast<Index>(faces_.size()); f < number_of_faces_; ++f)
      borders_.push_back(opposite(halfedge_of(mesh.twin(3 * f)), tm_));
    return mesh;
  }

  /// a face by its number, as it was read.
  face_descriptor face_read(Index number) const { return faces_[number]; }

  /// calls `f` with the faces and `v` with the vertices that are added, numbers first. Leaves the
  /// mesh as it is if there is no memory for what is to be added.
  template <typename OnVertex, typename OnFace>
  void write_back(const Surgery_mesh& mesh, const OnVertex& on_vertex, const OnFace& on_face) {
    Additions additions(tm_);
    make_additions(mesh, additions);
    remove_what_is_gone(mesh);
    connect(mesh, additions);
    // From now on they stay, whatever the functions throw.
    const auto vertices = std::exchange(additions.vertices, {});
    const auto faces = std::exchange(additions.faces, {});
    additions.edges.clear();
    for(const auto& [number, v] : vertices)
      on_vertex(number, v);
    for(const auto& [number, f] : faces)
      on_face(number, f);
  }

private:
  // Elements that belong to nothing yet; they go again if that remains so.
  struct Additions
  {
    explicit Additions(TriangleMesh& mesh)
        : tm(mesh) {}
    Additions(const Additions&) = delete;
    Additions& operator=(const Additions&) = delete;
    ~Additions() {
      for(const auto& [number, f] : faces)
        remove_face(f, tm);
      for(const auto& e : edges)
        remove_edge(e, tm);
      for(const auto& [number, v] : vertices)
        remove_vertex(v, tm);
    }

    TriangleMesh& tm;
    std::vector<std::pair<Index, vertex_descriptor>> vertices;
    std::vector<typename Graph_traits::edge_descriptor> edges;
    std::vector<std::pair<Index, face_descriptor>> faces;
    std::vector<halfedge_descriptor> halfedges; // of the faces
  };

  template <typename T> static void put_at(std::vector<T>& all, std::size_t i, T t, T none) {
    if(all.size() <= i)
      all.resize(i + 1, none);
    all[i] = t;
  }

  static Surgery_mesh::Point as_double(const Point& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  void choose_unit(const std::vector<Surgery_mesh::Point>& points) {
    double size = 0.;
    for(const Surgery_mesh::Point& p : points)
      size = (std::max)({size, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    exponent_ = size > 0. ? std::ilogb(size) : 0;
  }

  static Surgery_mesh::Point scaled(const Surgery_mesh::Point& p, int exponent) {
    return {std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent)};
  }

  template <typename FaceIndexMap>
  Index number(halfedge_descriptor h, FaceIndexMap face_index) const {
    const face_descriptor f = face(h, tm_);
    Index number = 3 * static_cast<Index>(get(face_index, f));
    for(halfedge_descriptor g = halfedge(f, tm_); g != h; g = next(g, tm_))
      ++number;
    return number;
  }

  halfedge_descriptor halfedge_of(Index h) const {
    if(h / 3 >= faces_.size())
      return borders_[h / 3 - faces_.size()];
    halfedge_descriptor descriptor = halfedge(faces_[h / 3], tm_);
    for(Index i = 0; i < h % 3; ++i)
      descriptor = next(descriptor, tm_);
    return descriptor;
  }

  bool is_original(Index f) const { return f < number_of_faces_; }

  void make_additions(const Surgery_mesh& mesh, Additions& additions) {
    const Index begin = number_of_faces_;
    additions.halfedges.resize(3 * (mesh.face_bound() - begin));
    vertices_.resize(mesh.vertex_bound(), Graph_traits::null_vertex());
    for(Index v = 0; v < mesh.vertex_bound(); ++v)
      if(vertices_[v] == Graph_traits::null_vertex() && mesh.outgoing(v) != no_index &&
         !mesh.is_hub(v)) {
        additions.vertices.push_back({v, vertices_[v] = add_vertex(tm_)});
        const Surgery_mesh::Point p = scaled(mesh.point(v), exponent_);
        put(point_, vertices_[v], Point(p.x(), p.y(), p.z()));
      }
    for(Index f = begin; f < mesh.face_bound(); ++f)
      if(mesh.is_alive(f)) {
        additions.faces.push_back({f, add_face(tm_)});
        for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
          add_halfedge(mesh, h, begin, additions);
      }
  }

  // The side of an edge that stays, or of one that is new.
  void add_halfedge(const Surgery_mesh& mesh, Index h, Index begin, Additions& additions) {
    const Index twin = mesh.twin(h);
    halfedge_descriptor& descriptor = additions.halfedges[h - 3 * begin];
    if(is_original(mesh.face(twin)))
      descriptor = opposite(halfedge_of(twin), tm_);
    else if(h < twin) {
      additions.edges.push_back(add_edge(tm_));
      descriptor = halfedge(additions.edges.back(), tm_);
      additions.halfedges[twin - 3 * begin] = opposite(descriptor, tm_);
    }
  }

  void remove_what_is_gone(const Surgery_mesh& mesh) {
    std::vector<face_descriptor> gone;
    for(Index f = 0; f < faces_.size(); ++f)
      if(faces_[f] != Graph_traits::null_face() && !mesh.is_alive(f))
        gone.push_back(faces_[f]);
    std::sort(gone.begin(), gone.end());
    for(const auto& e : edges_between(gone))
      remove_edge(e, tm_);
    for(face_descriptor f : gone)
      remove_face(f, tm_);
    for(Index v = 0; v < mesh.vertex_bound(); ++v)
      if(vertices_[v] != Graph_traits::null_vertex() && mesh.outgoing(v) == no_index)
        remove_vertex(vertices_[v], tm_);
  }

  std::vector<typename Graph_traits::edge_descriptor>
  edges_between(const std::vector<face_descriptor>& sorted_faces) const {
    std::vector<typename Graph_traits::edge_descriptor> edges;
    for(face_descriptor f : sorted_faces)
      for(halfedge_descriptor h : halfedges_around_face(halfedge(f, tm_), tm_)) {
        const face_descriptor g = face(opposite(h, tm_), tm_);
        if(f < g && std::binary_search(sorted_faces.begin(), sorted_faces.end(), g))
          edges.push_back(edge(h, tm_));
      }
    return edges;
  }

  void connect(const Surgery_mesh& mesh, const Additions& additions) {
    const Index begin = number_of_faces_;
    for(const auto& [f, face] : additions.faces) {
      set_halfedge(face, additions.halfedges[3 * (f - begin)], tm_);
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2}) {
        const halfedge_descriptor descriptor = additions.halfedges[h - 3 * begin];
        const vertex_descriptor v = vertices_[mesh.target(h)];
        set_face(descriptor, face, tm_);
        set_next(descriptor, additions.halfedges[mesh.next(h) - 3 * begin], tm_);
        set_target(descriptor, v, tm_);
        set_halfedge(v, descriptor, tm_);
      }
    }
    for(halfedge_descriptor h : borders_) // by which vertices on the boundary are known
      set_halfedge(target(h, tm_), h, tm_);
  }

  TriangleMesh& tm_;
  VertexPointMap point_;
  std::vector<vertex_descriptor> vertices_;  // by number
  std::vector<face_descriptor> faces_;       // by number, as they were read
  std::vector<halfedge_descriptor> borders_; // of the faces of caps, which follow
  Index number_of_faces_ = 0;                // with those
  int exponent_ = 0;                         // of the unit
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MESH_LINK_H
