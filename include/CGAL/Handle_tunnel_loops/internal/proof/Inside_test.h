// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_INSIDE_TEST_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_INSIDE_TEST_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Inlets.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Exact_meeting.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Which edges of a skeleton lie strictly inside the piece of the solid that they belong to, and meet
no face of any: inside are points below an odd number of faces of the surfaces that bound it.

An edge that meets no face lies on one side of each component. So do all that are connected by such
edges: the faces of the component above one point of them are counted. What is taken for a point is
half way between the ends of an edge, as these may be inlets.
*/
class Inside_test
{
public:
  /// The arrays must outlive it.
  Inside_test(const Flat_mesh& mesh,
              const Face_tree& tree,
              const Inlets& inlets,
              const Flat_skeleton& skeleton)
      : mesh_(mesh)
      , tree_(tree)
      , inlets_(inlets)
      , skeleton_(skeleton) {}

  /// What is wrong with an edge: it meets this face, or `no_index` if it lies outside as a whole.
  using Outside = std::map<Index, Index>;

  /// by edge.
  Outside edges_outside(Execution execution) const {
    const std::size_t n = skeleton_.edges.size();
    std::vector<Index> met(n);
    for_each_index(
        execution, n, [&](std::size_t e) { met[e] = face_met_by(skeleton_.edges[e]); }, 64);
    Outside outside;
    Sets_of_indices sets(skeleton_.points.size());
    for(Index e = 0; e < n; ++e)
      if(met[e] != no_index || !is_of_one_component(e))
        outside.emplace(e, met[e]);
      else
        sets.unite(skeleton_.edges[e][0], skeleton_.edges[e][1]);
    const std::map<Index, bool> is_inside = sides(execution, sets, outside);
    for(Index e = 0; e < n; ++e)
      if(const auto side = is_inside.find(sets.find(skeleton_.edges[e][0]));
         outside.count(e) == 0 && !side->second)
        outside.emplace(e, no_index);
    return outside;
  }

  /// the points that have no edges and do not lie inside.
  std::vector<Index> points_outside() const {
    std::vector<char> has_edge(skeleton_.points.size(), 0);
    for(const auto& edge : skeleton_.edges)
      has_edge[edge[0]] = has_edge[edge[1]] = 1;
    std::vector<Index> outside;
    for(Index p = 0; p < has_edge.size(); ++p)
      if(!has_edge[p] && (face_met_by({p, p}) != no_index || !is_inside({p, p})))
        outside.push_back(p);
    return outside;
  }

private:
  using Edge = std::array<Index, 2>;

  bool is_of_one_component(Index e) const {
    const auto [p, q] = skeleton_.edges[e];
    return skeleton_.component_of[p] == skeleton_.component_of[q];
  }

  Exact_triangle exact_triangle(Index face) const {
    const Triangle t = tree_.triangle(face);
    return {exact_point(t[0]), exact_point(t[1]), exact_point(t[2])};
  }

  // The first one in the order of the tree.
  Index face_met_by(const Edge& edge) const {
    const Vector &a = skeleton_.points[edge[0]], &b = skeleton_.points[edge[1]];
    const Exact_segment segment = {exact_point(a), exact_point(b)};
    Index met = no_index;
    tree_.any_near(a, b, [&](Index face) {
      if(meets(edge, segment, face))
        met = face;
      return met != no_index;
    });
    return met;
  }

  // At an inlet, other than there.
  bool meets(const Edge& edge, const Exact_segment& segment, Index face) const {
    const Exact_triangle t = exact_triangle(face);
    for(int end = 0; end < 2; ++end)
      if(const Index hub = inlets_.hub(edge[end]); hub != no_index)
        for(int i = 0; i < 3; ++i)
          if(tree_.corners(face)[i] == hub)
            return do_meet_beyond_corner(segment[1 - end], {t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
    return do_meet(segment, t);
  }

  // Of the sets of points that edges connect which meet no face, by one edge of each.
  std::map<Index, bool>
  sides(Execution execution, const Sets_of_indices& sets, const Outside& outside) const {
    std::map<Index, bool> is_inside_set;
    std::vector<Index> some;
    for(Index e = 0; e < skeleton_.edges.size(); ++e)
      if(outside.count(e) == 0 &&
         is_inside_set.emplace(sets.find(skeleton_.edges[e][0]), false).second)
        some.push_back(e);
    std::vector<char> inside(some.size());
    for_each_index(
        execution, some.size(),
        [&](std::size_t i) { inside[i] = is_inside(skeleton_.edges[some[i]]); }, 1);
    for(std::size_t i = 0; i < some.size(); ++i)
      is_inside_set[sets.find(skeleton_.edges[some[i]][0])] = inside[i] != 0;
    return is_inside_set;
  }

  bool is_inside(const Edge& edge) const {
    const Index component = skeleton_.component_of[edge[0]];
    bool is_odd = false;
    tree_.for_each_above(skeleton_.points[edge[0]], skeleton_.points[edge[1]], [&](Index face) {
      is_odd = is_odd != (mesh_.component[tree_.corners(face)[0]] == component);
    });
    return is_odd;
  }

  const Flat_mesh& mesh_;
  const Face_tree& tree_;
  const Inlets& inlets_;
  const Flat_skeleton& skeleton_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_INSIDE_TEST_H
