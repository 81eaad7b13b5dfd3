// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_TREES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_TREES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_labels.h>

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
The contours at the present level, as splay trees of the edges that they cross: for functions on
which walking would take too long. A contour is a sequence that begins anywhere. To cut it, to join
two parts, and to find its arc takes logarithmic amortized time, however long it is.
*/
class Contour_trees
{
public:
  Contour_trees(const Flat_mesh& mesh, const Sweep_order& order)
      : mesh_(mesh)
      , order_(order)
      , node_(mesh.neighbor.size(), none)
      , nodes_(1) {}

  /// takes over the contours at the level below the vertex of a rank.
  void build(Contour_labels& labels, Index rank) {
    for(Index r = 0; r < rank; ++r) {
      const Index u = order_.vertices()[r];
      for(Index v : mesh_.ring(u))
        if(order_.rank(v) >= rank && node_[slot_of(mesh_, u, v)] == none)
          build_contour(labels, Contour_walk(mesh_, order_, rank, u, v));
    }
  }

  /// a new contour begins around the minimum \p v.
  void start(Index v, Index arc) {
    Index root = none;
    for(Index p = 0; p < mesh_.ring(v).size(); ++p)
      root = joined(root, new_node(v, p));
    nodes_[root].arc = arc;
  }

  /// the contour around the maximum \p v ends; returns its arc.
  Index end(Index v) {
    const Ring ring = mesh_.ring(v);
    CGAL_precondition(node_[slot_of(mesh_, ring[0], v)] != none);
    const Index arc = nodes_[splayed(node_[slot_of(mesh_, ring[0], v)])].arc;
    for(Index u : ring)
      forget(slot_of(mesh_, u, v));
    return arc;
  }

  /// finds the contour arcs at a saddle or a regular vertex, and takes out what is between them.
  void cut(const Swept_vertex& at, Contour_arcs& contour_arcs) {
    const Index k = at.number_of_lower_components();
    contour_arcs.resize(k);
    for(Index i = 0; i < k; ++i)
      contour_arcs[i].arc = nodes_[splayed(node_[at.slot_of_lower_component(i)])].arc;
    for(Index i = 0; i < k; ++i)
      cut_at_lower_component(at, i);
    for(Index i = 0; i < k; ++i) {
      const Index first = splayed(leaving_node(at, i));
      contour_arcs[i].front = nodes_[first].sum;
      contour_arcs[i].arrival = at.lower_component_that_ends_at(nodes_[last_of(first)].lower);
    }
  }

  /// joins the contour arcs around the gaps above; they now name the arcs that they belong to.
  void join(const Swept_vertex& at, const Contour_arcs& contour_arcs) {
    is_joined_.assign(contour_arcs.size(), 0);
    for(Index first = 0; first < at.number_of_lower_components(); ++first) {
      if(is_joined_[first])
        continue;
      Index root = none, i = first;
      do {
        is_joined_[i] = 1;
        root = joined(root, splayed(leaving_node(at, i)));
        at.for_each_above(contour_arcs[i].arrival,
                          [&](Index p) { root = joined(root, new_node(at.center(), p)); });
        i = at.next_lower_component(contour_arcs[i].arrival);
      } while(i != first);
      nodes_[root].arc = contour_arcs[first].arc;
    }
  }

private:
  static constexpr Index none = 0; // node 0 is not used

  struct Node
  {
    Index up, left, right; // the tree
    Index lower;           // lower end of the edge
    Index arc;             // of the contour, kept at the root; none while the contour is open
    Front_mean own, sum;   // of the edge, of the subtree
  };

  void build_contour(Contour_labels& labels, Contour_walk walk) {
    const Index first = walk.slot();
    Index root = none;
    do {
      root = joined(root, new_node(walk.left(), walk.position()));
      walk.advance(no_index);
    } while(walk.slot() != first);
    nodes_[root].arc = labels.arc_at(first);
  }

  // After the first cut the contour is a sequence that begins with the contour arc that leaves
  // there; further cuts part it.
  void cut_at_lower_component(const Swept_vertex& at, Index i) {
    const Index end =
        splayed(node_[at.slot_of_lower_component(i)]); // of the lower component, in clockwise order
    const bool is_closed = nodes_[end].arc != no_index;
    const Index after = std::exchange(nodes_[end].right, none);
    add_up(end);
    nodes_[after].up = none;
    nodes_[after].arc = nodes_[end].arc = no_index;
    if(is_closed)
      joined(after, end);
    at.for_each_below(i, [&](Index p) {
      const Index before = nodes_[splayed(node_[at.slot_below(p)])].left;
      nodes_[before].up = none;
      nodes_[before].arc = no_index;
      forget(at.slot_below(p));
    });
  }

  Index leaving_node(const Swept_vertex& at, Index i) const {
    return node_[slot_of(mesh_, at.first_of(i), at.before_first_of(i))];
  }

  Index new_node(Index lower, Index position) {
    Index node;
    if(free_.empty()) {
      node = static_cast<Index>(nodes_.size());
      nodes_.emplace_back();
    } else {
      node = free_.back();
      free_.pop_back();
    }
    const Front_mean front = crossing_of_front(mesh_, lower, mesh_.ring(lower), position);
    nodes_[node] = {none, none, none, lower, no_index, front, front};
    node_[mesh_.row_begin[lower] + position] = node;
    return node;
  }

  void forget(Index slot) {
    CGAL_precondition_msg(node_[slot] != none, "a contour crosses the edge");
    free_.push_back(std::exchange(node_[slot], none));
  }

  Index last_of(Index root) {
    while(nodes_[root].right != none)
      root = nodes_[root].right;
    return splayed(root);
  }

  Index joined(Index a, Index b) {
    if(a == none)
      return b;
    if(b == none)
      return a;
    a = last_of(a);
    nodes_[a].right = b;
    nodes_[b].up = a;
    add_up(a);
    return a;
  }

  void add_up(Index node) {
    Node& n = nodes_[node];
    n.sum = n.own;
    if(n.left != none)
      n.sum += nodes_[n.left].sum;
    if(n.right != none)
      n.sum += nodes_[n.right].sum;
  }

  void rotate(Index node) {
    const Index parent = nodes_[node].up, above = nodes_[parent].up;
    const bool is_left = nodes_[parent].left == node;
    Index& inner = is_left ? nodes_[node].right : nodes_[node].left;
    (is_left ? nodes_[parent].left : nodes_[parent].right) = inner;
    if(inner != none)
      nodes_[inner].up = parent;
    inner = parent;
    nodes_[parent].up = node;
    nodes_[node].up = above;
    if(above != none)
      (nodes_[above].left == parent ? nodes_[above].left : nodes_[above].right) = node;
    add_up(parent);
    add_up(node);
  }

  /// makes a node the root of its tree, and returns it.
  Index splayed(Index node) {
    Index root = node;
    while(nodes_[root].up != none)
      root = nodes_[root].up;
    CGAL_assertion(node != none);
    const Index arc = nodes_[root].arc;
    while(nodes_[node].up != none) {
      const Index parent = nodes_[node].up, above = nodes_[parent].up;
      if(above != none) {
        const bool is_straight = (nodes_[parent].left == node) == (nodes_[above].left == parent);
        rotate(is_straight ? parent : node);
      }
      rotate(node);
    }
    nodes_[node].arc = arc;
    return node;
  }

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  std::vector<Index> node_; // by slot
  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<char> is_joined_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_TREES_H
