// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CUT_COMPONENTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CUT_COMPONENTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Concurrent_disjoint_sets.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Range_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The pieces into which a triangle mesh falls when it is cut along some of its edges: sets of
/// faces, one of which is the outside where the mesh has a boundary. Almost linear in the size of
/// the mesh.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Cut_components
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  Cut_components(const TriangleMesh& tm, VertexIndexMap vertex_index, FaceIndexMap face_index)
      : tm_(tm)
      , vertex_index_(vertex_index)
      , face_index_(face_index) {}

  /// \p ends are indices of vertices, and among them those at which cuts end; `is_cut(h)` tells
  /// whether the edge of a halfedge between two of them is cut. It is called once for each of these
  /// edges, with the halfedge to the larger index.
  template <typename IsCut>
  void cut(Execution execution, const std::vector<Index>& ends, const IsCut& is_cut) {
    measure_vertices(execution);
    for(Index i : ends) {
      CGAL_precondition(i < is_end_.size());
      is_end_[i] = 1;
    }
    insert_faces(execution);
    // In the order of memory.
    parts_of(halfedges(tm_)).for_each(execution, [&](halfedge_descriptor h) {
      const Index u = index(source(h, tm_)), v = index(target(h, tm_));
      if(v < u || (is_end_[u] && is_end_[v] && is_cut(h)))
        return;
      sets_.unite(index(face(h, tm_)), index(face(opposite(h, tm_), tm_)));
    });
    pieces_ = sets_.flatten(execution);
    if(pieces_.back() == outside_)
      pieces_.pop_back();
    CGAL_expensive_postcondition(std::is_sorted(pieces_.begin(), pieces_.end()));
  }

  /// the number of the piece of a face or, of the null face, the outside; any number.
  Index piece(face_descriptor f) const { return sets_.label(index(f)); }

  /// the numbers of all pieces of the surface, in ascending order.
  const std::vector<Index>& pieces() const { return pieces_; }

  /// replaces the number of each piece by `number(piece)`; to be called once.
  template <typename Function> void renumber(Execution execution, const Function& number) {
    sets_.relabel(execution,
                  [&](Index piece) { return piece == outside_ ? piece : number(piece); });
  }

  /// without isolated ones.
  std::size_t number_of_vertices() const { return number_of_vertices_; }

  std::size_t number_of_faces() const { return number_of_faces_; }

private:
  Index index(vertex_descriptor v) const { return static_cast<Index>(get(vertex_index_, v)); }
  Index index(face_descriptor f) const {
    return f == Graph_traits::null_face() ? outside_ : static_cast<Index>(get(face_index_, f));
  }

  // What is found of a part of the vertices or the faces. Indices may leave gaps.
  struct Extent
  {
    std::size_t number = 0, bound = 0;
  };

  template <typename Parts, typename Counts>
  Extent extent(Execution execution, const Parts& all, const Counts& counts) const {
    Extent sum;
    std::mutex mutex;
    all.for_each_part(execution, [&](std::size_t, auto begin, auto end) {
      Extent e;
      for(; begin != end; ++begin) {
        e.bound = (std::max)(e.bound, std::size_t(index(*begin)) + 1);
        e.number += counts(*begin) ? 1 : 0;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      sum.number += e.number;
      sum.bound = (std::max)(sum.bound, e.bound);
    });
    return sum;
  }

  void measure_vertices(Execution execution) {
    const Extent all = extent(execution, parts_of(vertices(tm_)), [this](vertex_descriptor v) {
      return halfedge(v, tm_) != Graph_traits::null_halfedge();
    });
    number_of_vertices_ = all.number;
    is_end_.assign(all.bound, 0);
  }

  void insert_faces(Execution execution) {
    const auto all = parts_of(faces(tm_));
    number_of_faces_ = all.size();
    outside_ =
        static_cast<Index>(extent(execution, all, [](face_descriptor) { return true; }).bound);
    sets_ = Concurrent_disjoint_sets(execution, std::size_t(outside_) + 1);
    all.for_each(execution, [this](face_descriptor f) { sets_.insert(index(f)); });
    sets_.insert(outside_);
  }

  const TriangleMesh& tm_;
  VertexIndexMap vertex_index_;
  FaceIndexMap face_index_;
  std::size_t number_of_vertices_ = 0, number_of_faces_ = 0;
  std::vector<char> is_end_;      // by vertex
  Concurrent_disjoint_sets sets_; // of faces
  std::vector<Index> pieces_;     // the roots of the sets
  Index outside_ = no_index;      // beyond all faces
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CUT_COMPONENTS_H
