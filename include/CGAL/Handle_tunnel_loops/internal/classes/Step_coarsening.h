// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_STEP_COARSENING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_STEP_COARSENING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Edge_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Fewer places to search from and longer steps between them, for loops that are long beside the edges
of a mesh.

Vertices that are nowhere nearer to each other than the spacing become nodes; each vertex belongs to
the nearest of them. There is a step between two nodes where an edge leads from a vertex of the one
to a vertex of the other, of each class the shortest, and from a node to itself where its vertices
lie around a handle: so walks of all classes are left.

`Mesh` is one of steps, as `Search_mesh`.
*/
template <typename Mesh> class Step_coarsening
{
public:
  /// A way from a node to another: to `from`, along a step of the mesh, and on to the node.
  struct Step
  {
    Index head;
    float length;
    Index from, step;
    Class_sums sums;
  };

  Step_coarsening(const Mesh& mesh, const Edge_classes& classes, double spacing)
      : mesh_(mesh)
      , classes_(classes)
      , spacing_(static_cast<float>(spacing))
      , ways_(mesh.number_of_vertices()) {
    for(Index v = 0; v < ways_.size(); ++v)
      if(ways_[v].node == no_index && !mesh.is_hub(v))
        add_node(v);
    steps_.resize(nodes_.size());
    for(Index v = 0; v < ways_.size(); ++v)
      if(ways_[v].node != no_index)
        add_steps(v);
  }

  /// the vertices that are nodes.
  const std::vector<Index>& nodes() const { return nodes_; }

  /// the node to which a vertex belongs.
  Index node(Index v) const { return ways_[v].node; }

  /// the steps from a node.
  const std::vector<Step>& steps(Index node) const { return steps_[node]; }

  /// appends what follows a node on the walk of a step from it, to its head, in the terms of
  /// `Mesh::for_each_edge()`.
  void append_walk(const Step& step, std::vector<Index>& walk) const {
    append_way(step.from, walk);
    append_edges(step.from, step.step, walk);
    const Index there = mesh_.head(step.step);
    std::vector<Index> back;
    append_way(there, back);
    if(back.empty())
      return;
    back.pop_back();
    walk.insert(walk.end(), back.rbegin(), back.rend());
    walk.push_back(nodes_[step.head]);
  }

private:
  // The shortest way to a vertex, from its node.
  struct Way
  {
    float distance = std::numeric_limits<float>::infinity();
    Index node = no_index, parent = no_index, step = no_index;
    Class_sums sums;
  };

  // Takes over what is nearer to the new node than to those before.
  void add_node(Index v) {
    ways_.reach(v, {0.f, static_cast<Index>(nodes_.size()), no_index, no_index, {}});
    nodes_.push_back(v);
    ways_.grow([&](Index u) {
      const Way here = ways_[u];
      for(Index step = mesh_.begin(u); step != mesh_.end(u); ++step) {
        const float there = here.distance + mesh_.length(u, step);
        const Way& way = ways_[mesh_.head(step)];
        // What is reached through u follows it, also where rounding hides that it is nearer.
        const bool follows = way.parent == u && way.step == step && way.node != here.node;
        if(follows || there < (std::min)(way.distance, spacing_))
          ways_.reach(mesh_.head(step),
                      {there, here.node, u, step, here.sums + mesh_.sums(u, step, classes_)});
      }
    });
  }

  void add_steps(Index v) {
    const Way& here = ways_[v];
    for(Index step = mesh_.begin(v); step != mesh_.end(v); ++step) {
      const Way& there = ways_[mesh_.head(step)];
      if(there.node == no_index)
        continue;
      Class_sums sums = here.sums + mesh_.sums(v, step, classes_);
      sums.add(-1, there.sums);
      if(there.node == here.node && sums.is_zero())
        continue;
      add_step({there.node, here.distance + mesh_.length(v, step) + there.distance, v, step, sums},
               steps_[here.node]);
    }
  }

  // Where a node has a great many handles around it, those found first are enough.
  static void add_step(const Step& step, std::vector<Step>& steps) {
    constexpr std::size_t largest_number = 256;
    for(Step& other : steps)
      if(other.head == step.head && other.sums == step.sums) {
        if(step.length < other.length)
          other = step;
        return;
      }
    if(steps.size() < largest_number)
      steps.push_back(step);
  }

  void append_edges(Index v, Index step, std::vector<Index>& walk) const {
    mesh_.for_each_edge(v, step, [&](Index, Index to) { walk.push_back(to); });
  }

  // What follows the node of a vertex on the way to it.
  void append_way(Index v, std::vector<Index>& walk) const {
    std::vector<Index> vertices;
    for(Index u = v; ways_[u].parent != no_index; u = ways_[u].parent)
      vertices.push_back(u);
    for(auto u = vertices.rbegin(); u != vertices.rend(); ++u)
      append_edges(ways_[*u].parent, ways_[*u].step, walk);
  }

  const Mesh& mesh_;
  const Edge_classes& classes_;
  float spacing_;
  Shortest_paths<Way> ways_; // by vertex
  std::vector<Index> nodes_;
  std::vector<std::vector<Step>> steps_; // by node
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_STEP_COARSENING_H
