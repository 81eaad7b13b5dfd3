// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_PROBLEM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_PROBLEM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_halfedges.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What the caller wants of an edge.
enum class Edge_rule : unsigned char { FREE, KEEP, AVOID };

/// A surface, and what its cut has to be like. If the surface has a boundary, the cut is one of the
/// surface with its caps that goes to all hubs: without the caps, a disk remains of each disk.
/// Edges to hubs cost nothing, and those on the boundary are not to be cut.
struct Cut_problem
{
  Cut_problem(Execution e, const Flat_mesh& m)
      : execution(e)
      , mesh(m)
      , halfedges(e, m) {}

  Execution execution;
  const Flat_mesh& mesh;
  Flat_halfedges halfedges;
  std::vector<double> weight;            ///< by halfedge, the same both ways
  std::vector<Edge_rule> rules;          ///< by halfedge, the same both ways; empty: all are free
  std::vector<char> cones;               ///< by vertex, whether the cut goes there; empty: nowhere
  std::vector<std::vector<Index>> walks; ///< closed, on the edges, to begin with
  bool do_cut_spheres = false;
  bool has_rules_of_caller = false;

  Edge_rule rule(Index h) const { return rules.empty() ? Edge_rule::FREE : rules[h]; }
  bool is_kept(Index h) const { return rule(h) == Edge_rule::KEEP; }
  bool is_avoided(Index h) const { return rule(h) == Edge_rule::AVOID; }
  bool is_spoke(Index h) const { return mesh.is_spoke(halfedges.source(h), halfedges.target(h)); }
  bool is_cone(Index v) const { return !cones.empty() && cones[v] != 0; }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_PROBLEM_H
