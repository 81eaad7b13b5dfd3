// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Closed_graph_traits.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A `Flat_mesh`, with its caps, as a closed model of `FaceListGraph`, for what is written for any.
/// The arrays must outlive it. Around vertices of few neighbours these are looked up by going
/// through them, which takes no memory.
class Flat_graph
{
public:
  /// The edge to a neighbour, by its place in the ring of the source. It stands for its face, too,
  /// where its source is the smallest vertex of that.
  struct Halfedge
  {
    Index source = no_index, place = 0;

    friend bool operator==(const Halfedge& a, const Halfedge& b) {
      return a.source == b.source && a.place == b.place;
    }
    friend bool operator!=(const Halfedge& a, const Halfedge& b) { return !(a == b); }
    friend bool operator<(const Halfedge& a, const Halfedge& b) {
      return std::tie(a.source, a.place) < std::tie(b.source, b.place);
    }
  };

  explicit Flat_graph(const Flat_mesh& mesh)
      : mesh_(&mesh) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index p = 0; mesh.ring(v).size() > few && p < mesh.ring(v).size(); ++p)
        places_.emplace_back(v, mesh.ring(v)[p], p);
    std::sort(places_.begin(), places_.end());
  }

  const Flat_mesh& mesh() const { return *mesh_; }

  /// the halfedge between two neighbours.
  Halfedge find(Index source, Index target) const {
    const Ring ring = mesh_->ring(source);
    if(ring.size() <= few)
      return {source, ring.position(target)};
    const auto it =
        std::lower_bound(places_.begin(), places_.end(), std::make_tuple(source, target, Index(0)));
    const bool is_there =
        it != places_.end() && std::get<0>(*it) == source && std::get<1>(*it) == target;
    return {source, is_there ? std::get<2>(*it) : ring.size()};
  }

  friend Index source(Halfedge h, const Flat_graph&) { return h.source; }
  friend Index target(Halfedge h, const Flat_graph& g) { return g.mesh_->ring(h.source)[h.place]; }
  friend Index apex(Halfedge h, const Flat_graph& g) {
    const Ring ring = g.mesh_->ring(h.source);
    return ring[ring.next(h.place)];
  }
  friend Halfedge opposite(Halfedge h, const Flat_graph& g) {
    return g.find(target(h, g), h.source);
  }
  friend Halfedge next(Halfedge h, const Flat_graph& g) { return g.find(target(h, g), apex(h, g)); }
  friend Halfedge prev(Halfedge h, const Flat_graph& g) { return g.find(apex(h, g), h.source); }
  friend Halfedge halfedge(Index v, const Flat_graph& g) { return opposite({v, 0}, g); }
  friend Halfedge halfedge(Halfedge f, const Flat_graph&) { return f; }
  friend std::pair<Halfedge, bool> halfedge(Index u, Index v, const Flat_graph& g) {
    const Halfedge h = g.find(u, v);
    return {h, h.place < g.mesh_->ring(u).size()};
  }

  /// whether a halfedge stands for its face.
  static bool is_face(Halfedge h, const Flat_graph& g) {
    return h.source < target(h, g) && h.source < apex(h, g);
  }
  friend Halfedge face(Halfedge h, const Flat_graph& g) {
    while(!is_face(h, g))
      h = next(h, g);
    return h;
  }

  friend bool is_border(Halfedge, const Flat_graph&) { return false; }
  friend std::array<Index, 3> corners(Halfedge f, const Flat_graph& g) {
    return {target(f, g), apex(f, g), f.source};
  }

  class Halfedge_iterator
      : public boost::
            iterator_facade<Halfedge_iterator, Halfedge, boost::forward_traversal_tag, Halfedge>
  {
  public:
    Halfedge_iterator() = default;
    Halfedge_iterator(const Flat_graph& g, Index source)
        : mesh_(g.mesh_)
        , h_{source, 0} {}

  private:
    friend class boost::iterator_core_access;
    Halfedge dereference() const { return h_; }
    bool equal(const Halfedge_iterator& other) const { return h_ == other.h_; }
    void increment() {
      if(++h_.place == mesh_->ring(h_.source).size())
        h_ = {h_.source + 1, 0};
    }

    const Flat_mesh* mesh_ = nullptr;
    Halfedge h_;
  };

  struct Is_face
  {
    const Flat_graph* g = nullptr;
    bool operator()(Halfedge h) const { return is_face(h, *g); }
  };

  /// Elements by their sources: parts of them begin anywhere at no cost.
  template <typename Iterator> struct Range
  {
    const Flat_graph& g;
    std::size_t size;
    std::function<Iterator(Index)> at; ///< the first one at a vertex or after it

    Iterator begin() const { return at(0); }
    Iterator end() const { return at(static_cast<Index>(num_vertices(g))); }

    friend Range_parts<Iterator> parts_of(const Range& range) {
      constexpr Index vertices_in_part = 2048;
      std::vector<Iterator> bounds;
      for(Index v = 0; v < num_vertices(range.g); v += vertices_in_part)
        bounds.push_back(range.at(v));
      bounds.push_back(range.end());
      return {range.size, std::move(bounds)};
    }
  };

  using Vertex_iterator = boost::counting_iterator<Index>;
  using Face_iterator = boost::filter_iterator<Is_face, Halfedge_iterator>;

  friend Iterator_range<Vertex_iterator> vertices(const Flat_graph& g) {
    return {Vertex_iterator(0), Vertex_iterator(g.end())};
  }
  friend auto halfedges(const Flat_graph& g) {
    return Range<Halfedge_iterator>{g, num_halfedges(g),
                                    [&g](Index v) { return Halfedge_iterator(g, v); }};
  }
  friend auto faces(const Flat_graph& g) {
    return Range<Face_iterator>{g, num_faces(g), [&g](Index v) {
                                  return Face_iterator(Is_face{&g}, Halfedge_iterator(g, v),
                                                       Halfedge_iterator(g, g.end()));
                                }};
  }
  friend std::size_t num_vertices(const Flat_graph& g) { return g.end(); }
  friend std::size_t num_halfedges(const Flat_graph& g) { return g.mesh_->neighbor.size(); }
  friend std::size_t num_faces(const Flat_graph& g) { return g.mesh_->number_of_faces(); }

private:
  static constexpr Index few = 64; // neighbours

  Index end() const { return static_cast<Index>(mesh_->number_of_vertices()); }

  const Flat_mesh* mesh_;
  std::vector<std::tuple<Index, Index, Index>>
      places_; // in the rings of vertices of many neighbours
};

} // namespace CGAL::Handle_tunnel_loops::internal

namespace boost {

template <>
struct graph_traits<CGAL::Handle_tunnel_loops::internal::Flat_graph>
    : CGAL::Handle_tunnel_loops::internal::Closed_graph_traits<
          CGAL::Handle_tunnel_loops::internal::Flat_graph>
{};

} // namespace boost

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_GRAPH_H
