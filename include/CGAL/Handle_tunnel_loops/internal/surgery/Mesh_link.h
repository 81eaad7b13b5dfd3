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
#include <CGAL/Handle_tunnel_loops/internal/surgery/removal.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Changes a mesh as surgery has changed what was read of it: what was taken out is removed, what was
put in is added, the rest is not touched.

\tparam TriangleMesh a model of `MutableFaceGraph`, a triangle mesh
*/
template <typename TriangleMesh, typename VertexPointMap> class Mesh_link
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  /// numbers as a `Triangle_list` does that \p reader reads.
  template <typename VertexIndexMap, typename Reader>
  Mesh_link(TriangleMesh& tm,
            VertexPointMap point,
            VertexIndexMap vertex_index,
            const Reader& reader)
      : tm_(tm)
      , point_(point)
      , faces_(reader.number_of_faces()) {
    for(vertex_descriptor v : vertices(tm_))
      if(halfedge(v, tm_) != Graph_traits::null_halfedge()) { // isolated ones are left alone
        const std::size_t i = get(vertex_index, v);
        if(vertices_.size() <= i)
          vertices_.resize(i + 1, Graph_traits::null_vertex());
        vertices_[i] = v;
      }
    for(face_descriptor f : faces(tm_))
      faces_[reader.number_of_face(f)] = f;
  }

  /// a face by its number, as it was read.
  face_descriptor face_read(Index number) const { return faces_[number]; }

  /// calls `on_vertex(v)` for the vertices and `on_face(face, f)` for the faces that are added.
  /// Leaves the mesh as it is if there is no memory for what is to be added.
  template <typename OnVertex, typename OnFace>
  void write_back(const Mesh_change& change, const OnVertex& on_vertex, const OnFace& on_face) {
    first_new_face_ = change.first_new_face;
    for(Index h : change.twins_of_caps)
      borders_.push_back(opposite(halfedge_of(h), tm_));
    Additions additions(tm_);
    make_additions(change, additions);
    remove_what_is_gone(change);
    connect(change, additions);
    // From now on they stay, whatever the functions throw.
    const auto vertices = std::exchange(additions.vertices, {});
    const auto faces = std::exchange(additions.faces, {});
    additions.edges.clear();
    for(const auto v : vertices)
      on_vertex(v);
    for(std::size_t i = 0; i < faces.size(); ++i)
      on_face(change.new_faces[i], faces[i]);
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
      for(const auto f : faces)
        remove_face(f, tm);
      for(const auto& e : edges)
        remove_edge(e, tm);
      for(const auto v : vertices)
        remove_vertex(v, tm);
    }

    TriangleMesh& tm;
    std::vector<vertex_descriptor> vertices;
    std::vector<typename Graph_traits::edge_descriptor> edges;
    std::vector<face_descriptor> faces;
    std::vector<halfedge_descriptor> halfedges; // of the faces
  };

  halfedge_descriptor halfedge_of(Index h) const {
    if(h / 3 >= faces_.size())
      return borders_[h / 3 - faces_.size()];
    halfedge_descriptor descriptor = halfedge(faces_[h / 3], tm_);
    for(Index i = 0; i < h % 3; ++i)
      descriptor = next(descriptor, tm_);
    return descriptor;
  }

  void make_additions(const Mesh_change& change, Additions& additions) {
    if(!change.new_faces.empty())
      additions.halfedges.resize(3 * (change.new_faces.back().number + 1 - first_new_face_));
    vertices_.resize(change.vertex_bound, Graph_traits::null_vertex());
    for(const Mesh_change::New_vertex& v : change.new_vertices) {
      additions.vertices.push_back(vertices_[v.number] = add_vertex(tm_));
      put(point_, vertices_[v.number], Point(v.point[0], v.point[1], v.point[2]));
    }
    for(const Mesh_change::New_face& f : change.new_faces) {
      additions.faces.push_back(add_face(tm_));
      for(Index i : {0, 1, 2})
        add_halfedge(3 * f.number + i, f.twins[i], additions);
    }
  }

  // The side of an edge that stays, or of one that is new.
  void add_halfedge(Index h, Index twin, Additions& additions) {
    const Index begin = 3 * first_new_face_;
    halfedge_descriptor& descriptor = additions.halfedges[h - begin];
    if(twin < begin)
      descriptor = opposite(halfedge_of(twin), tm_);
    else if(h < twin) {
      additions.edges.push_back(add_edge(tm_));
      descriptor = halfedge(additions.edges.back(), tm_);
      additions.halfedges[twin - begin] = opposite(descriptor, tm_);
    }
  }

  void remove_what_is_gone(const Mesh_change& change) {
    std::vector<face_descriptor> gone;
    for(Index f : change.faces_gone)
      gone.push_back(faces_[f]);
    std::sort(gone.begin(), gone.end());
    for(const auto& e : edges_between(gone))
      remove_edge(e, tm_);
    for(face_descriptor f : gone)
      remove_face(f, tm_);
    for(Index v : change.vertices_gone)
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

  void connect(const Mesh_change& change, const Additions& additions) {
    for(std::size_t k = 0; k < change.new_faces.size(); ++k) {
      const Mesh_change::New_face& f = change.new_faces[k];
      const halfedge_descriptor* own = &additions.halfedges[3 * (f.number - first_new_face_)];
      const face_descriptor face = additions.faces[k];
      set_halfedge(face, own[0], tm_);
      for(std::size_t i = 0; i < 3; ++i) {
        const vertex_descriptor v = vertices_[f.corners[(i + 1) % 3]];
        set_face(own[i], face, tm_);
        set_next(own[i], own[(i + 1) % 3], tm_);
        set_target(own[i], v, tm_);
        set_halfedge(v, own[i], tm_);
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
  Index first_new_face_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MESH_LINK_H
