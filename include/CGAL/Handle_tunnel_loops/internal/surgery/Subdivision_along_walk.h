// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SUBDIVISION_ALONG_WALK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SUBDIVISION_ALONG_WALK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Splits, at their midpoints, the edges that begin on a simple closed walk and are not part of it. The
faces at the walk are an annulus then, whatever they were: no other edge joins two vertices of the
walk, and the edges to its neighbours end at vertices of their own.
*/
class Subdivision_along_walk
{
public:
  Subdivision_along_walk(Surgery_mesh& mesh, const Closed_walk& walk)
      : mesh_(mesh)
      , first_face_(mesh.face_bound())
      , on_walk_(walk) {
    std::sort(on_walk_.begin(), on_walk_.end());
    for(std::size_t i = 0; i < walk.size(); ++i)
      steps_.push_back(std::minmax(walk[i], after(walk, i)));
    std::sort(steps_.begin(), steps_.end());
    split_all([this](Index u, Index v) { return is_on_walk(v) && !is_step(u, v); });
    split_all([this](Index, Index v) { return !is_on_walk(v); });
  }

  /// of the faces that are new, in order: the faces that they are parts of.
  const std::vector<Index>& parents() const { return parents_; }

private:
  using Ends = std::pair<Index, Index>;

  bool is_on_walk(Index v) const { return is_in(v, on_walk_); }
  bool is_step(Index u, Index v) const { return is_in(Ends(std::minmax(u, v)), steps_); }

  // Edges from the walk, by their ends.
  template <typename Predicate> void split_all(const Predicate& is_to_be_split) {
    std::vector<Ends> edges;
    for(Index u : on_walk_)
      mesh_.for_each_outgoing(u, [&](Index h) {
        const Index v = mesh_.target(h);
        if(is_to_be_split(u, v))
          edges.push_back(std::minmax(u, v));
      });
    make_set(edges);
    for(const Ends& e : edges)
      split(mesh_.halfedge(e.first, e.second));
  }

  void split(Index h) {
    CGAL_precondition(h != no_index);
    const Index g = mesh_.twin(h);
    const Index u = mesh_.source(h), v = mesh_.target(h);
    const Index left = mesh_.target(mesh_.next(h)), right = mesh_.target(mesh_.next(g));
    const Index m = mesh_.add_vertex(CGAL::midpoint(mesh_.point(u), mesh_.point(v)));
    std::vector<Index> out{mesh_.face(h), mesh_.face(g)};
    parents_.insert(parents_.end(),
                    {parent(out[0]), parent(out[0]), parent(out[1]), parent(out[1])});
    std::sort(out.begin(), out.end());
    mesh_.replace(out, {{u, m, left}, {m, v, left}, {v, m, right}, {m, u, right}});
  }

  Index parent(Index f) const { return f < first_face_ ? f : parents_[f - first_face_]; }

  Surgery_mesh& mesh_;
  const Index first_face_;
  std::vector<Index> parents_;
  std::vector<Index> on_walk_; // in ascending order
  std::vector<Ends> steps_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SUBDIVISION_ALONG_WALK_H
