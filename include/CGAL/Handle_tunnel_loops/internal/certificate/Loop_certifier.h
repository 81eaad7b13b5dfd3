// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_LOOP_CERTIFIER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_LOOP_CERTIFIER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/homology_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

/// the end of its edge that a step is at; if it is at neither, the source.
template <typename Step, typename TriangleMesh>
auto nearest_end(const Step& step, const TriangleMesh& tm) {
  return step.ratio == 1. ? target(step.halfedge, tm) : source(step.halfedge, tm);
}

/*!
Decides whether loops on a closed triangle mesh are closed curves on it and a basis of its first
homology group over the integers.

Let z_1 .. z_N be the loops, moved onto the edges, with N = 2g. Sending a closed curve y to its
intersection numbers (z_1 . y, .., z_N . y) is a homomorphism from H1 = Z^N to Z^N, and the z_i are
a basis if and only if it is onto (Poincare duality; a surjective endomorphism of Z^N is an
isomorphism). H1 is generated by the closed dual curves that cross one edge outside of a spanning
tree of the dual graph. The tree is made to cross edges of no loop wherever it can, so that almost
all of these curves meet no loop at all, and the vectors of the others are short.
*/
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Loop_certifier
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  Loop_certifier(const TriangleMesh& tm, VertexIndexMap vertex_index, FaceIndexMap face_index)
      : tm_(tm)
      , vertex_index_(vertex_index)
      , pieces_(tm, vertex_index, face_index) {}

  /// takes pointers to loops, ranges of steps with members `halfedge` and `ratio`.
  template <typename Loop>
  void set_loops(Execution execution, const std::vector<const Loop*>& loops) {
    number_of_loops_ = loops.size();
    std::vector<Moved_loop> moved(loops.size());
    for_each_index(
        execution, loops.size(),
        [&](std::size_t i) {
          check(*loops[i], i, moved[i].failures);
          if(moved[i].failures.empty())
            move_onto_edges(*loops[i], i, moved[i].chain);
        },
        1);
    for(const Moved_loop& m : moved) {
      failures_.insert(failures_.end(), m.failures.begin(), m.failures.end());
      chains_.insert(chains_.end(), m.chain.begin(), m.chain.end());
    }
    are_closed_ = failures_.empty();
  }

  bool are_closed_on_surface() const { return are_closed_; }

  /// in words, what failed.
  const std::vector<std::string>& failures() const { return failures_; }

  /// cuts the surface along the loops; to be called once, before what follows.
  void cut(Execution execution) {
    cut_to_pieces(execution);
    number_components(execution);
  }

  std::size_t number_of_components() const { return number_of_components_; }

  /// the number of the component of a face.
  std::size_t component(face_descriptor f) const {
    return number_of_components_ == 1 ? 0 : pieces_.piece(f);
  }

  /// whether there are as many loops as a basis has; after `cut()`.
  bool are_as_many_as_asked_for() const {
    CGAL_precondition_msg(number_of_components_ > 0 || number_of_loops_ == 0, "after `cut()`");
    return number_of_loops_ == 2 * genus();
  }

  bool are_basis() {
    if(!are_as_many_as_asked_for())
      return fail("there are " + std::to_string(number_of_loops_) + " loops instead of " +
                  std::to_string(2 * genus()));
    const std::vector<std::string> reasons = why_no_basis(number_of_loops_, chains_, used_edges_);
    failures_.insert(failures_.end(), reasons.begin(), reasons.end());
    return reasons.empty();
  }

  /// the numbers of those pairs of loops, 2k and 2k + 1, that are not homologous over the integers,
  /// as they are directed: of which the difference does not bound. In place of `cut()`. The surface
  /// may have a boundary.
  std::vector<std::size_t> pairs_of_different_class(Execution execution) {
    for(Chain_entry& entry : chains_) {
      if(entry.loop % 2 == 1)
        entry.value = -entry.value;
      entry.loop /= 2;
    }
    cut_to_pieces(execution);
    return loops_that_do_not_bound(number_of_loops_ / 2, chains_, used_edges_);
  }

private:
  // What one loop brings.
  struct Moved_loop
  {
    std::vector<Chain_entry> chain;
    std::vector<std::string> failures;
  };

  std::uint32_t index(vertex_descriptor v) const {
    return static_cast<std::uint32_t>(get(vertex_index_, v));
  }

  bool fail(const std::string& message) {
    failures_.push_back(message);
    return false;
  }

  // ---- closed, and on the surface

  template <typename Loop>
  void check(const Loop& loop, std::size_t number, std::vector<std::string>& failures) const {
    const auto& steps = loop.steps();
    const auto fails_at = [&](std::size_t i, const char* problem) {
      failures.push_back(name_of_loop(number) + ", step " + std::to_string(i) + ": " + problem);
    };
    if(steps.size() < 2)
      failures.push_back(name_of_loop(number) + " has fewer than two steps");
    for(std::size_t i = 0; i < steps.size(); ++i) {
      const auto &a = steps[i], &b = steps[i + 1 == steps.size() ? 0 : i + 1];
      if(a.halfedge == Graph_traits::null_halfedge() || b.halfedge == Graph_traits::null_halfedge())
        fails_at(i, "this step or the next does not lie on an edge");
      else if(!(a.ratio >= 0. && a.ratio <= 1.))
        fails_at(i, "the ratio is not in [0, 1]");
      else if(!have_common_face(a, b))
        fails_at(i, "this step and the next lie on no common face");
    }
  }

  template <typename Step> bool lies_on(const Step& step, face_descriptor f) const {
    if(!step.is_vertex())
      return face(step.halfedge, tm_) == f || face(opposite(step.halfedge, tm_), tm_) == f;
    for(halfedge_descriptor h : halfedges_around_face(halfedge(f, tm_), tm_))
      if(target(h, tm_) == nearest_end(step, tm_))
        return true;
    return false;
  }

  template <typename Step> bool have_common_face(const Step& a, const Step& b) const {
    const auto meets = [&](halfedge_descriptor h) {
      return !is_border(h, tm_) && lies_on(b, face(h, tm_));
    };
    if(!a.is_vertex())
      return meets(a.halfedge) || meets(opposite(a.halfedge, tm_));
    for(halfedge_descriptor h : halfedges_around_target(nearest_end(a, tm_), tm_))
      if(meets(h))
        return true;
    return false;
  }

  // ---- the loops as chains of edges

  // Two places on a face move to two of its corners, which are equal or joined by an edge.
  template <typename Loop>
  void
  move_onto_edges(const Loop& loop, std::size_t number, std::vector<Chain_entry>& chain) const {
    const auto& steps = loop.steps();
    if(steps.empty())
      return;
    std::uint32_t u = index(nearest_end(steps.back(), tm_));
    for(const auto& step : steps) {
      const std::uint32_t v = index(nearest_end(step, tm_));
      if(u != v)
        chain.push_back({edge_key(u, v), static_cast<std::uint32_t>(number), u < v ? 1 : -1});
      u = v;
    }
  }

  // The number of an edge, or that of edges if there is none.
  std::size_t find_used_edge(std::uint64_t key) const {
    const auto it =
        std::lower_bound(used_edges_.begin(), used_edges_.end(), key,
                         [](const Used_edge& e, std::uint64_t k) { return e.edge < k; });
    return it != used_edges_.end() && it->edge == key ? it - used_edges_.begin()
                                                      : used_edges_.size();
  }

  // ---- the pieces into which the used edges cut the surface

  void cut_to_pieces(Execution execution) {
    used_edges_ = add_up_chains(execution, chains_);
    find_pieces(execution);
    keep_distinct_edges(execution, chains_, used_edges_);
  }

  void find_pieces(Execution execution) {
    CGAL_expensive_assertion(
        std::is_sorted(used_edges_.begin(), used_edges_.end(),
                       [](const Used_edge& a, const Used_edge& b) { return a.edge < b.edge; }));
    std::vector<Index> ends;
    for(const Used_edge& e : used_edges_)
      for(const std::uint64_t v : {e.edge >> 32, e.edge & 0xffffffffu})
        ends.push_back(static_cast<Index>(v));
    std::vector<halfedge_descriptor> halfedges(used_edges_.size());
    pieces_.cut(execution, ends, [&](halfedge_descriptor h) {
      const std::size_t e = find_used_edge(edge_key(index(source(h, tm_)), index(target(h, tm_))));
      if(e == halfedges.size())
        return false;
      halfedges[e] = h;
      return true;
    });
    for_each_index(execution, used_edges_.size(), [&](std::size_t i) {
      Used_edge& e = used_edges_[i];
      CGAL_assertion_msg(halfedges[i] != Graph_traits::null_halfedge(), "a step is along no edge");
      e.left = pieces_.piece(face(halfedges[i], tm_));
      e.right = pieces_.piece(face(opposite(halfedges[i], tm_), tm_));
    });
  }

  // ---- components

  // The pieces of a component hang together by used edges. A component without any is one piece.
  void number_components(Execution execution) {
    const std::vector<Index>& all = pieces_.pieces();
    const auto position = [&](Index piece) {
      return static_cast<Index>(std::lower_bound(all.begin(), all.end(), piece) - all.begin());
    };
    Concurrent_disjoint_sets sets(execution, all.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      sets.insert(static_cast<Index>(i));
    for(const Used_edge& e : used_edges_)
      sets.unite(position(e.left), position(e.right));
    sets.flatten(execution);
    std::vector<Index> number(all.size());
    for(std::size_t i = 0; i < all.size(); ++i) {
      const Index root = sets.label(static_cast<Index>(i));
      CGAL_assertion(root <= i);
      number[i] = root == i ? static_cast<Index>(number_of_components_++) : number[root];
    }
    if(number_of_components_ != 1)
      pieces_.renumber(execution, [&](Index piece) { return number[position(piece)]; });
  }

  // V - E + F = 2 c - 2 g, with 2 E = 3 F.
  std::size_t genus() const {
    CGAL_assertion(pieces_.number_of_faces() % 2 == 0);
    CGAL_assertion(pieces_.number_of_vertices() % 2 == pieces_.number_of_faces() / 2 % 2);
    return (2 * number_of_components_ + pieces_.number_of_faces() / 2 -
            pieces_.number_of_vertices()) /
           2;
  }

  const TriangleMesh& tm_;
  VertexIndexMap vertex_index_;
  Cut_components<TriangleMesh, VertexIndexMap, FaceIndexMap> pieces_;
  std::vector<Chain_entry> chains_;
  std::vector<Used_edge> used_edges_;
  std::size_t number_of_components_ = 0;
  std::size_t number_of_loops_ = 0;
  bool are_closed_ = true;
  std::vector<std::string> failures_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_LOOP_CERTIFIER_H
