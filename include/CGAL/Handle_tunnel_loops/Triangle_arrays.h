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

A triangle mesh made of an array of points and an array of triangles, as files and many programs
store them. Its connectivity cannot be changed; its points can. The mesh is an oriented 2-manifold,
with or without boundary, with any number of components. Vertices without faces are allowed.
Vertices and faces have the numbers that they have in the arrays.

If you have such arrays, use this class instead of `CGAL::Surface_mesh`: it takes a third of the
time to build and little more than half of the memory (38 bytes per face with points of three
doubles). Members that have the name of a member of `CGAL::Surface_mesh` have the same meaning.

The halfedge from corner i of face f to the next corner has the number 3 f + i. Halfedges without a
face follow after these. The number of an edge is the smaller number of its two halfedges.

\tparam Point_ a point type, such as `CGAL::Simple_cartesian<double>::Point_3`

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
  /// The point type.
  using Point = Point_;

  /// \name Descriptors
  /// Each is constructed from a number, and its member `idx()` returns this number. A
  /// default-constructed descriptor refers to no element.
  /// @{
  /// The vertex descriptor.
  using Vertex_index = internal::Element_number<Vertex_kind>;
  /// The halfedge descriptor.
  using Halfedge_index = internal::Element_number<Halfedge_kind>;
  /// The edge descriptor.
  using Edge_index = internal::Edge_number<Halfedge_index>;
  /// The face descriptor.
  using Face_index = internal::Element_number<Face_kind>;
  /// @}

  /// Constructs a mesh without vertices.
  Triangle_arrays() = default;

  /*!
  Constructs a mesh from points and triangles. The running time is near linear. The construction
  needs 24 bytes of temporary memory per face.

  \tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
    `Sequential_tag`, `Parallel_tag` and `Parallel_if_available_tag`. The result does not depend on
    the tag.
  \tparam TriangleRange a model of `RandomAccessContainer`. Its elements have the functions `size()`
    and `operator[]` and contain three positions in the array of points, counterclockwise when seen
    from outside

  \param points the points
  \param triangles the triangles

  \throws Invalid_mesh_exception if the triangles do not form an oriented 2-manifold; the message
    names an element
  \throws std::out_of_range if a triangle refers to a point that does not exist
  */
  template <typename ConcurrencyTag, typename TriangleRange>
  Triangle_arrays(ConcurrencyTag, std::vector<Point> points, const TriangleRange& triangles)
      : points_(std::move(points))
      , connectivity_(
            internal::execution_of<ConcurrencyTag>(),
            points_.size(),
            corners(internal::execution_of<ConcurrencyTag>(), triangles, points_.size())) {}

  /// Constructs a mesh from points and triangles sequentially.
  template <typename TriangleRange>
  Triangle_arrays(std::vector<Point> points, const TriangleRange& triangles)
      : Triangle_arrays(Sequential_tag(), std::move(points), triangles) {}

  /// \name Points
  /// @{
  /// Returns the points, by number of vertex.
  const std::vector<Point>& points() const { return points_; }
  /// Returns the point of a vertex.
  const Point& point(Vertex_index v) const { return points_[v.idx()]; }
  /// Returns the point of a vertex, which you may change.
  Point& point(Vertex_index v) { return points_[v.idx()]; }
  /// @}

  /// \name Elements
  /// @{
  /// Returns the number of vertices, including isolated ones.
  std::size_t number_of_vertices() const { return points_.size(); }
  /// Returns the number of halfedges.
  std::size_t number_of_halfedges() const { return connectivity_.number_of_halfedges(); }
  /// Returns the number of edges.
  std::size_t number_of_edges() const { return number_of_halfedges() / 2; }
  /// Returns the number of faces.
  std::size_t number_of_faces() const { return connectivity_.number_of_faces(); }

  /// Returns the range of all vertices.
  auto vertices() const { return Vertex_index::range(number_of_vertices()); }
  /// Returns the range of all halfedges.
  auto halfedges() const { return Halfedge_index::range(number_of_halfedges()); }
  /// Returns the range of all faces.
  auto faces() const { return Face_index::range(number_of_faces()); }
  /// Returns the range of all edges.
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
  /// Returns the source vertex of a halfedge.
  Vertex_index source(Halfedge_index h) const {
    return Vertex_index(connectivity_.source(h.idx()));
  }
  /// Returns the target vertex of a halfedge.
  Vertex_index target(Halfedge_index h) const {
    return Vertex_index(connectivity_.target(h.idx()));
  }
  /// Returns the opposite halfedge.
  Halfedge_index opposite(Halfedge_index h) const {
    return Halfedge_index(connectivity_.opposite(h.idx()));
  }
  /// Returns the next halfedge around the face, or around the boundary curve.
  Halfedge_index next(Halfedge_index h) const {
    return Halfedge_index(connectivity_.next(h.idx()));
  }
  /// Returns the previous halfedge around the face, or around the boundary curve.
  Halfedge_index prev(Halfedge_index h) const {
    return Halfedge_index(connectivity_.previous(h.idx()));
  }
  /// Returns the face of a halfedge, or a null descriptor on the boundary.
  Face_index face(Halfedge_index h) const {
    return is_border(h) ? Face_index() : Face_index(h.idx() / 3);
  }
  /// Returns the edge of a halfedge.
  Edge_index edge(Halfedge_index h) const { return Edge_index(h, opposite(h)); }
  /// Returns the halfedge through which the descriptor of the edge was obtained.
  Halfedge_index halfedge(Edge_index e) const { return e.halfedge(); }
  /// Returns the halfedge between the first two corners.
  Halfedge_index halfedge(Face_index f) const { return Halfedge_index(3 * f.idx()); }
  /// Returns a halfedge with target `v`; if `v` is on the boundary, one without a face.
  Halfedge_index halfedge(Vertex_index v) const {
    return Halfedge_index(connectivity_.arriving(v.idx()));
  }
  /// Returns the halfedge from `u` to `v`, or none. Visits the neighbors of `v`.
  Halfedge_index halfedge(Vertex_index u, Vertex_index v) const {
    return Halfedge_index(connectivity_.between(u.idx(), v.idx()));
  }
  /// Returns the target (`i` is 0) or the source of the halfedge that has the number of the edge.
  Vertex_index vertex(Edge_index e, int i) const {
    const Halfedge_index h(e.idx());
    return i == 0 ? target(h) : source(h);
  }
  /// Returns whether the halfedge has no face.
  bool is_border(Halfedge_index h) const { return connectivity_.is_border(h.idx()); }
  /// Returns whether the edge is on the boundary.
  bool is_border(Edge_index e) const { return is_border(opposite(Halfedge_index(e.idx()))); }
  /// Returns whether the vertex has no face.
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

  // Returns the corners of the triangles. Throws if a triangle is not valid.
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
                              " uses a vertex that does not exist: there are " +
                              std::to_string(number_of_points));
    return corners;
  }

  std::vector<Point> points_;
  internal::Triangle_connectivity connectivity_;

  // The functions of the concept `FaceListGraph`.

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
