// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_TRIANGLE_ARRAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_TRIANGLE_ARRAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Element_number.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Triangle_connectivity.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

A triangle mesh that is made of an array of points and an array of triangles, as they stand in
files and in the memory of many programs, to compute with and not to change: only its points can
be. It is an oriented 2-manifold, with or without boundary, of any number of components; vertices
without faces are allowed. Vertices and faces are numbered as in the arrays.

Whoever has such arrays is spared a `CGAL::Surface_mesh`: this takes a third of the time to build
and little more than half of the memory, 38 bytes per face with points of three doubles. What has
the name of a member of `CGAL::Surface_mesh` means the same.

The halfedge from corner i of face f to the next one has the number 3 f + i; halfedges without a
face come after those. An edge has the smaller one of the numbers of its halfedges.

\tparam Point_ a point type, as `CGAL::Simple_cartesian<double>::Point_3`

\cgalModels `FaceListGraph`

\sa `CGAL::handle_tunnel_loops()`
\sa `CGAL::reeb_graph()`
*/
template <typename Point_> class Triangle_arrays
{
  using Index = internal::Index;
  struct Vertex_kind;
  struct Halfedge_kind;
  struct Face_kind;

public:
  using Point = Point_;

  /// \name Numbers
  /// Their member `idx()` says which, and they are made from it. By default they are of no element.
  /// @{
  using Vertex_index = internal::Element_number<Vertex_kind>;
  using Halfedge_index = internal::Element_number<Halfedge_kind>;
  using Edge_index = internal::Edge_number<Halfedge_index>;
  using Face_index = internal::Element_number<Face_kind>;
  /// @}

  /// a mesh without vertices.
  Triangle_arrays() = default;

  /*!
  makes a mesh of points and triangles. Takes near linear time, and a memory of 24 bytes per face
  meanwhile.

  \tparam ConcurrencyTag enables sequential versus parallel computation; possible values are
    `Sequential_tag`, `Parallel_tag` and `Parallel_if_available_tag`. The result is the same.
  \tparam TriangleRange a model of `RandomAccessContainer` whose elements have three positions in
    the array of points, counterclockwise seen from outside, and the functions `size()` and
    `operator[]`

  \throws Invalid_mesh_exception if this is not an oriented 2-manifold of triangles; the message
    names an element
  \throws std::out_of_range if a triangle names a point that is not there
  */
  template <typename ConcurrencyTag, typename TriangleRange>
  Triangle_arrays(ConcurrencyTag, std::vector<Point> points, const TriangleRange& triangles)
      : points_(std::move(points))
      , connectivity_(
            internal::execution_of<ConcurrencyTag>(),
            points_.size(),
            corners(internal::execution_of<ConcurrencyTag>(), triangles, points_.size())) {}

  /// the same, sequentially.
  template <typename TriangleRange>
  Triangle_arrays(std::vector<Point> points, const TriangleRange& triangles)
      : Triangle_arrays(Sequential_tag(), std::move(points), triangles) {}

  /// \name Points
  /// @{
  const std::vector<Point>& points() const { return points_; }
  const Point& point(Vertex_index v) const { return points_[v.idx()]; }
  Point& point(Vertex_index v) { return points_[v.idx()]; }
  /// @}

  /// \name Elements
  /// @{
  std::size_t number_of_vertices() const { return points_.size(); }
  std::size_t number_of_halfedges() const { return connectivity_.number_of_halfedges(); }
  std::size_t number_of_edges() const { return number_of_halfedges() / 2; }
  std::size_t number_of_faces() const { return connectivity_.number_of_faces(); }

  auto vertices() const { return Vertex_index::range(number_of_vertices()); }
  auto halfedges() const { return Halfedge_index::range(number_of_halfedges()); }
  auto faces() const { return Face_index::range(number_of_faces()); }
  auto edges() const {
    const auto all = halfedges();
    const auto edge = [&](auto h) {
      return Edge_iterator(Halfedge_of_edge_iterator(Is_of_edge{this}, h, all.end()),
                           Edge_of_halfedge{this});
    };
    return Iterator_range<Edge_iterator>(edge(all.begin()), edge(all.end()));
  }
  /// @}

  /// \name Connectivity
  /// @{
  Vertex_index source(Halfedge_index h) const {
    return Vertex_index(connectivity_.source(h.idx()));
  }
  Vertex_index target(Halfedge_index h) const {
    return Vertex_index(connectivity_.target(h.idx()));
  }
  Halfedge_index opposite(Halfedge_index h) const {
    return Halfedge_index(connectivity_.opposite(h.idx()));
  }
  Halfedge_index next(Halfedge_index h) const {
    return Halfedge_index(connectivity_.next(h.idx()));
  }
  Halfedge_index prev(Halfedge_index h) const {
    return Halfedge_index(connectivity_.previous(h.idx()));
  }
  Face_index face(Halfedge_index h) const {
    return is_border(h) ? Face_index() : Face_index(h.idx() / 3);
  }
  Edge_index edge(Halfedge_index h) const { return Edge_index(h, opposite(h)); }
  /// the halfedge by which the edge was come upon.
  Halfedge_index halfedge(Edge_index e) const { return e.halfedge(); }
  /// the halfedge between the first two corners.
  Halfedge_index halfedge(Face_index f) const { return Halfedge_index(3 * f.idx()); }
  /// a halfedge with this target: one without a face if there is one.
  Halfedge_index halfedge(Vertex_index v) const {
    return Halfedge_index(connectivity_.arriving(v.idx()));
  }
  /// the halfedge between two vertices, or none. Goes through the neighbors of `v`.
  Halfedge_index halfedge(Vertex_index u, Vertex_index v) const {
    return Halfedge_index(connectivity_.between(u.idx(), v.idx()));
  }
  /// the target of the halfedge that has the number of the edge, and its source.
  Vertex_index vertex(Edge_index e, int i) const {
    const Halfedge_index h(e.idx());
    return i == 0 ? target(h) : source(h);
  }
  bool is_border(Halfedge_index h) const { return connectivity_.is_border(h.idx()); }
  bool is_border(Edge_index e) const { return is_border(opposite(Halfedge_index(e.idx()))); }
  bool is_isolated(Vertex_index v) const { return halfedge(v) == Halfedge_index(); }
  /// @}

private:
  struct Is_of_edge
  {
    const Triangle_arrays* mesh = nullptr;
    bool operator()(Halfedge_index h) const { return h < mesh->opposite(h); }
  };
  struct Edge_of_halfedge
  {
    const Triangle_arrays* mesh = nullptr;
    Edge_index operator()(Halfedge_index h) const { return mesh->edge(h); }
  };
  using Halfedge_of_edge_iterator =
      boost::filter_iterator<Is_of_edge, typename Halfedge_index::Iterator>;
  using Edge_iterator = boost::transform_iterator<Edge_of_halfedge, Halfedge_of_edge_iterator>;

  struct Point_map
  {
    using key_type = Vertex_index;
    using value_type = Point;
    using reference = const Point&;
    using category = boost::readable_property_map_tag;

    const Triangle_arrays* mesh = nullptr;

    friend reference get(const Point_map& map, Vertex_index v) { return map.mesh->point(v); }
    reference operator[](Vertex_index v) const { return mesh->point(v); }
  };

  // Throws where there are none.
  template <typename TriangleRange>
  static internal::Uninitialized_vector<Index> corners(internal::Execution execution,
                                                       const TriangleRange& triangles,
                                                       std::size_t number_of_points) {
    const auto begin = std::begin(triangles);
    const std::size_t n = std::size(triangles);
    internal::check_size(n, number_of_points);
    internal::Uninitialized_vector<Index> corners(3 * n);
    internal::First_index not_triangle, out_of_range;
    internal::for_each_index(execution, n, [&](std::size_t f) {
      const auto& triangle = begin[static_cast<std::ptrdiff_t>(f)];
      if(std::size(triangle) != 3) {
        not_triangle.see(f);
        return;
      }
      for(std::size_t i = 0; i < 3; ++i) {
        if(static_cast<std::uint64_t>(triangle[i]) >= number_of_points)
          out_of_range.see(f);
        corners[3 * f + i] = static_cast<Index>(triangle[i]);
      }
    });
    if(not_triangle.found())
      throw Invalid_mesh_exception(Mesh_defect::NOT_TRIANGULATED, {},
                                   "a face is not a triangle: face " +
                                       std::to_string(not_triangle.get()));
    if(out_of_range.found())
      throw std::out_of_range("face " + std::to_string(out_of_range.get()) +
                              " names a vertex that is not one of the " +
                              std::to_string(number_of_points));
    return corners;
  }

  std::vector<Point> points_;
  internal::Triangle_connectivity connectivity_;

  // The functions of the concept.

  friend boost::graph_traits<Triangle_arrays>;
  friend boost::property_map<Triangle_arrays, vertex_point_t>;

  friend Vertex_index source(Halfedge_index h, const Triangle_arrays& g) { return g.source(h); }
  friend Vertex_index target(Halfedge_index h, const Triangle_arrays& g) { return g.target(h); }
  friend Halfedge_index opposite(Halfedge_index h, const Triangle_arrays& g) {
    return g.opposite(h);
  }
  friend Halfedge_index next(Halfedge_index h, const Triangle_arrays& g) { return g.next(h); }
  friend Halfedge_index prev(Halfedge_index h, const Triangle_arrays& g) { return g.prev(h); }
  friend Face_index face(Halfedge_index h, const Triangle_arrays& g) { return g.face(h); }
  friend Edge_index edge(Halfedge_index h, const Triangle_arrays& g) { return g.edge(h); }
  friend Halfedge_index halfedge(Vertex_index v, const Triangle_arrays& g) { return g.halfedge(v); }
  friend Halfedge_index halfedge(Face_index f, const Triangle_arrays& g) { return g.halfedge(f); }
  friend Halfedge_index halfedge(Edge_index e, const Triangle_arrays& g) { return g.halfedge(e); }
  friend bool is_border(Halfedge_index h, const Triangle_arrays& g) { return g.is_border(h); }
  friend std::pair<Halfedge_index, bool>
  halfedge(Vertex_index u, Vertex_index v, const Triangle_arrays& g) {
    const Halfedge_index h = g.halfedge(u, v);
    return {h, h != Halfedge_index()};
  }

  friend Vertex_index source(Edge_index e, const Triangle_arrays& g) {
    return g.source(g.halfedge(e));
  }
  friend Vertex_index target(Edge_index e, const Triangle_arrays& g) {
    return g.target(g.halfedge(e));
  }
  friend std::pair<Edge_index, bool>
  edge(Vertex_index u, Vertex_index v, const Triangle_arrays& g) {
    const Halfedge_index h = g.halfedge(u, v);
    return h == Halfedge_index() ? std::make_pair(Edge_index(), false)
                                 : std::make_pair(g.edge(h), true);
  }
  friend std::size_t degree(Vertex_index v, const Triangle_arrays& g) {
    const auto around = halfedges_around_target(v, g);
    return static_cast<std::size_t>(std::distance(around.begin(), around.end()));
  }
  friend std::size_t in_degree(Vertex_index v, const Triangle_arrays& g) { return degree(v, g); }
  friend std::size_t out_degree(Vertex_index v, const Triangle_arrays& g) { return degree(v, g); }
  friend std::size_t degree(Face_index, const Triangle_arrays&) { return 3; }
  friend auto in_edges(Vertex_index v, const Triangle_arrays& g) {
    using Iterator = In_edge_iterator<Triangle_arrays>;
    const Halfedge_index h = g.halfedge(v);
    return make_range(Iterator(h, g), Iterator(h, g, 1));
  }
  friend auto out_edges(Vertex_index v, const Triangle_arrays& g) {
    using Iterator = Out_edge_iterator<Triangle_arrays>;
    const Halfedge_index h = g.halfedge(v);
    return make_range(Iterator(h, g), Iterator(h, g, 1));
  }

  friend std::size_t num_vertices(const Triangle_arrays& g) { return g.number_of_vertices(); }
  friend std::size_t num_halfedges(const Triangle_arrays& g) { return g.number_of_halfedges(); }
  friend std::size_t num_edges(const Triangle_arrays& g) { return g.number_of_edges(); }
  friend std::size_t num_faces(const Triangle_arrays& g) { return g.number_of_faces(); }
  friend auto vertices(const Triangle_arrays& g) { return g.vertices(); }
  friend auto halfedges(const Triangle_arrays& g) { return g.halfedges(); }
  friend auto edges(const Triangle_arrays& g) { return g.edges(); }
  friend auto faces(const Triangle_arrays& g) { return g.faces(); }

  friend Point_map get(vertex_point_t, const Triangle_arrays& g) { return {&g}; }
  friend const Point& get(vertex_point_t, const Triangle_arrays& g, Vertex_index v) {
    return g.point(v);
  }
  friend typename Vertex_index::Map get(vertex_index_t, const Triangle_arrays&) { return {}; }
  friend typename Halfedge_index::Map get(halfedge_index_t, const Triangle_arrays&) { return {}; }
  friend typename Face_index::Map get(face_index_t, const Triangle_arrays&) { return {}; }
};

} // namespace CGAL::Handle_tunnel_loops

namespace boost {

template <typename Point> struct graph_traits<CGAL::Handle_tunnel_loops::Triangle_arrays<Point>>
{
private:
  using Mesh = CGAL::Handle_tunnel_loops::Triangle_arrays<Point>;
  struct Traversal_category : virtual bidirectional_graph_tag,
                              virtual vertex_list_graph_tag,
                              virtual edge_list_graph_tag
  {};

public:
  using vertex_descriptor = typename Mesh::Vertex_index;
  using halfedge_descriptor = typename Mesh::Halfedge_index;
  using edge_descriptor = typename Mesh::Edge_index;
  using face_descriptor = typename Mesh::Face_index;
  using vertex_iterator = typename vertex_descriptor::Iterator;
  using halfedge_iterator = typename halfedge_descriptor::Iterator;
  using edge_iterator = typename Mesh::Edge_iterator;
  using face_iterator = typename face_descriptor::Iterator;
  using in_edge_iterator = CGAL::In_edge_iterator<Mesh>;
  using out_edge_iterator = CGAL::Out_edge_iterator<Mesh>;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using directed_category = undirected_tag;
  using edge_parallel_category = disallow_parallel_edge_tag;
  using traversal_category = Traversal_category;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <typename Point>
struct graph_traits<const CGAL::Handle_tunnel_loops::Triangle_arrays<Point>>
    : graph_traits<CGAL::Handle_tunnel_loops::Triangle_arrays<Point>>
{};

template <typename Point>
struct property_map<CGAL::Handle_tunnel_loops::Triangle_arrays<Point>, vertex_point_t>
{
  using type = typename CGAL::Handle_tunnel_loops::Triangle_arrays<Point>::Point_map;
  using const_type = type;
};
template <typename Point>
struct property_map<CGAL::Handle_tunnel_loops::Triangle_arrays<Point>, vertex_index_t>
{
  using type = typename CGAL::Handle_tunnel_loops::Triangle_arrays<Point>::Vertex_index::Map;
  using const_type = type;
};
template <typename Point>
struct property_map<CGAL::Handle_tunnel_loops::Triangle_arrays<Point>, halfedge_index_t>
{
  using type = typename CGAL::Handle_tunnel_loops::Triangle_arrays<Point>::Halfedge_index::Map;
  using const_type = type;
};
template <typename Point>
struct property_map<CGAL::Handle_tunnel_loops::Triangle_arrays<Point>, face_index_t>
{
  using type = typename CGAL::Handle_tunnel_loops::Triangle_arrays<Point>::Face_index::Map;
  using const_type = type;
};

} // namespace boost

namespace CGAL {

template <typename Point>
struct graph_has_property<Handle_tunnel_loops::Triangle_arrays<Point>, vertex_point_t> : Tag_true
{};
template <typename Point>
struct graph_has_property<Handle_tunnel_loops::Triangle_arrays<Point>, vertex_index_t> : Tag_true
{};
template <typename Point>
struct graph_has_property<Handle_tunnel_loops::Triangle_arrays<Point>, halfedge_index_t> : Tag_true
{};
template <typename Point>
struct graph_has_property<Handle_tunnel_loops::Triangle_arrays<Point>, face_index_t> : Tag_true
{};

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_TRIANGLE_ARRAYS_H
