// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURGERY_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURGERY_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Closed_graph_traits.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>

namespace CGAL::Handle_tunnel_loops::internal {

/// A `Surgery_mesh` as it is by now, with its caps, as a closed model of `FaceListGraph`. Numbers
/// are those of the mesh, with gaps where something was taken out.
class Surgery_graph
{
public:
  /// Stands for its face, too, if it is the first one there.
  struct Halfedge
  {
    Index number = no_index;

    friend bool operator==(Halfedge a, Halfedge b) { return a.number == b.number; }
    friend bool operator!=(Halfedge a, Halfedge b) { return a.number != b.number; }
  };

  /// The mesh must outlive it.
  explicit Surgery_graph(const Surgery_mesh& mesh)
      : mesh_(&mesh) {}

  friend Index source(Halfedge h, const Surgery_graph& g) { return g.mesh_->source(h.number); }
  friend Index target(Halfedge h, const Surgery_graph& g) { return g.mesh_->target(h.number); }
  friend Halfedge opposite(Halfedge h, const Surgery_graph& g) { return {g.mesh_->twin(h.number)}; }
  friend Halfedge next(Halfedge h, const Surgery_graph&) { return {Surgery_mesh::next(h.number)}; }
  friend Halfedge prev(Halfedge h, const Surgery_graph&) {
    return {Surgery_mesh::previous(h.number)};
  }
  friend Halfedge halfedge(Index v, const Surgery_graph& g) {
    return {Surgery_mesh::previous(g.mesh_->outgoing(v))}; // of the last face, as `Triangle_arrays`
  }
  friend Halfedge halfedge(Halfedge f, const Surgery_graph&) { return f; }
  friend std::pair<Halfedge, bool> halfedge(Index u, Index v, const Surgery_graph& g) {
    const Index h = g.mesh_->halfedge(u, v);
    return {{h}, h != no_index};
  }
  friend Halfedge face(Halfedge h, const Surgery_graph&) { return {h.number - h.number % 3}; }
  friend bool is_border(Halfedge, const Surgery_graph&) { return false; }

  // Those that are there.
  struct Is_vertex
  {
    const Surgery_mesh* mesh = nullptr;
    bool operator()(Index v) const { return mesh->outgoing(v) != no_index; }
  };
  struct Is_alive
  {
    const Surgery_mesh* mesh = nullptr;
    bool operator()(Halfedge h) const { return mesh->is_alive(Surgery_mesh::face(h.number)); }
  };
  struct Halfedge_of_number
  {
    Halfedge operator()(Index h) const { return {h}; }
  };
  struct Halfedge_of_face
  {
    Halfedge operator()(Index f) const { return {3 * f}; }
  };

  using Numbers = boost::counting_iterator<Index>;
  using Vertex_iterator = boost::filter_iterator<Is_vertex, Numbers>;
  using Halfedge_iterator =
      boost::filter_iterator<Is_alive, boost::transform_iterator<Halfedge_of_number, Numbers>>;
  using Face_iterator =
      boost::filter_iterator<Is_alive, boost::transform_iterator<Halfedge_of_face, Numbers>>;

  friend Iterator_range<Vertex_iterator> vertices(const Surgery_graph& g) {
    return range<Vertex_iterator>(Is_vertex{g.mesh_}, g.mesh_->vertex_bound());
  }
  friend Iterator_range<Halfedge_iterator> halfedges(const Surgery_graph& g) {
    return range<Halfedge_iterator>(Is_alive{g.mesh_}, 3 * g.mesh_->face_bound());
  }
  friend Iterator_range<Face_iterator> faces(const Surgery_graph& g) {
    return range<Face_iterator>(Is_alive{g.mesh_}, g.mesh_->face_bound());
  }

  /// an upper bound.
  friend std::size_t num_vertices(const Surgery_graph& g) { return g.mesh_->vertex_bound(); }
  friend std::size_t num_halfedges(const Surgery_graph& g) {
    return 3 * g.mesh_->number_of_faces();
  }
  friend std::size_t num_faces(const Surgery_graph& g) { return g.mesh_->number_of_faces(); }

  /// the number of a vertex.
  using Vertex_index_map = boost::typed_identity_property_map<Index>;

  /// the point of a vertex.
  struct Point_map
  {
    using key_type = Index;
    using value_type = Surgery_mesh::Point;
    using reference = const value_type&;
    using category = boost::readable_property_map_tag;

    const Surgery_mesh* mesh;

    friend reference get(const Point_map& map, Index v) { return map.mesh->point(v); }
  };
  Point_map point() const { return {mesh_}; }

private:
  template <typename Iterator, typename Predicate>
  static Iterator_range<Iterator> range(const Predicate& is_there, Index end) {
    using Base = typename Iterator::base_type;
    const Base first{Numbers(0)}, last{Numbers(end)};
    return {Iterator(is_there, first, last), Iterator(is_there, last, last)};
  }

  const Surgery_mesh* mesh_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

namespace boost {

template <>
struct graph_traits<CGAL::Handle_tunnel_loops::internal::Surgery_graph>
    : CGAL::Handle_tunnel_loops::internal::Closed_graph_traits<
          CGAL::Handle_tunnel_loops::internal::Surgery_graph>
{};

} // namespace boost

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURGERY_GRAPH_H
