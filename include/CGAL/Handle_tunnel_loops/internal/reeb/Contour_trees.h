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

#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The contours at the present level, as labels of the edges that they cross.

An edge is labelled when its lower end is passed, in the slot that it has there, and its label may
grow old: which arc the label has become a part of is looked up in a forest. Contours that meet cost
one entry of the forest. A contour that parts is walked from the saddle, both parts in turns, until
the shorter one has been walked around, and the edges of that one are labelled anew.
*/
class Contour_labels
{
public:
  Contour_labels(const Flat_mesh& mesh, const Sweep_order& order)
      : mesh_(mesh)
      , order_(order)
      , label_(mesh.neighbor.size()) {}

  /// the number of edges that were walked over.
  std::uint64_t number_of_steps() const { return number_of_steps_; }

  /// the arc of the contour that crosses the edge in a slot.
  Index arc_at(Index slot) { return find(label_[slot]); }

  /// says that a new contour begins around \p v, or that one of an arc passes over it.
  void pass(Index v, Index arc) {
    // The edges to lower neighbours have their label there; so no harm is done to them.
    std::fill(label_.begin() + mesh_.row_begin[v], label_.begin() + mesh_.row_begin[v + 1], arc);
  }

  /// makes room for arcs up to a number.
  void add_arcs(Index number_of_arcs) {
    const Index old = static_cast<Index>(next_.size());
    next_.resize(number_of_arcs);
    std::iota(next_.begin() + old, next_.end(), old);
  }

  /// finds the contour arcs at a saddle; \p front_of gives the front of an arc.
  template <typename FrontOfArc>
  void cut(const Swept_vertex& at, Contour_arcs& contour_arcs, const FrontOfArc& front_of) {
    const Index k = at.number_of_lower_components();
    contour_arcs.resize(k);
    walked_.resize((std::max)(walked_.size(), std::size_t(k)));
    by_arc_.resize(k);
    std::iota(by_arc_.begin(), by_arc_.end(), Index(0));
    for(Index i = 0; i < k; ++i) {
      contour_arcs[i] = {i, arc_at(at.slot_of_lower_component(i)), {}};
      walked_[i].clear();
    }
    std::stable_sort(by_arc_.begin(), by_arc_.end(),
                     [&](Index i, Index j) { return contour_arcs[i].arc < contour_arcs[j].arc; });
    groups_.clear();
    for(auto first = by_arc_.begin(); first != by_arc_.end();) {
      auto last = first;
      while(last != by_arc_.end() && contour_arcs[*last].arc == contour_arcs[*first].arc)
        ++last;
      cut_contour(at, {first, last}, contour_arcs, front_of(contour_arcs[*first].arc));
      first = last;
    }
  }

  /// labels the edges above a saddle; the contour arcs now name the arcs that they belong to.
  void join(const Swept_vertex& at, const Contour_arcs& contour_arcs) {
    for(const Group& group : groups_) {
      const Index arc = contour_arcs[group.longest].arc;
      next_[group.arc_below] = arc;
      for(auto i = group.begin; i != group.end; ++i)
        if(contour_arcs[*i].arc != arc)
          for(const Crossed_edge& edge : walked_[*i])
            label_[mesh_.row_begin[edge.lower] + edge.position] = contour_arcs[*i].arc;
    }
    for(Index i = 0; i < at.number_of_lower_components(); ++i) {
      const Index arc = contour_arcs[at.next_lower_component(i)].arc;
      at.for_each_above(i, [&](Index p) { label_[at.slot_above(p)] = arc; });
    }
  }

private:
  using Iterator = std::vector<Index>::iterator;

  // An edge by its lower end and the position of the other in the ring of that.
  struct Crossed_edge
  {
    Index lower, position;
  };

  // The contour arcs of one contour; all but the longest are walked.
  struct Group
  {
    Iterator begin, end; // in by_arc_
    Index longest = no_index;
    Index arc_below = no_index;
  };

  Index find(Index label) {
    CGAL_precondition(label < next_.size());
    while(next_[label] != label)
      label = next_[label] = next_[next_[label]];
    return label;
  }

  void
  cut_contour(const Swept_vertex& at, Group group, Contour_arcs& contour_arcs, Front_mean whole) {
    group.arc_below = contour_arcs[*group.begin].arc;
    group.longest = *group.begin;
    for(auto i = group.begin; i != group.end; ++i)
      whole -= at.front_below(*i);
    if(group.end - group.begin > 1)
      walk(at, group, contour_arcs);
    for(auto i = group.begin; i != group.end; ++i)
      if(*i != group.longest) {
        contour_arcs[*i].front = front_along(walked_[*i]);
        whole -= contour_arcs[*i].front;
      }
    contour_arcs[group.longest].front = whole;
    groups_.push_back(group);
  }

  Front_mean front_along(const std::vector<Crossed_edge>& edges) const {
    Front_mean front;
    for(const Crossed_edge& edge : edges)
      front += crossing_of_front(mesh_, order_, edge.lower, mesh_.ring(edge.lower), edge.position);
    return front;
  }

  // In turns, until all but one have arrived; where the last one arrives is then clear.
  void walk(const Swept_vertex& at, Group& group, Contour_arcs& contour_arcs) {
    walks_.clear();
    const Index level = order_.rank(at.center());
    for(auto i = group.begin; i != group.end; ++i) {
      walks_.push_back(
          {Contour_walk(mesh_, order_, level, at.first_of(*i), at.before_first_of(*i)), *i});
      contour_arcs[*i].arrival = no_index;
    }
    while(walks_.size() > 1) {
      std::size_t kept = 0, size = walks_.size();
      for(std::size_t w = 0; w < size; ++w)
        if(kept + (size - w) == 1 || step(at, walks_[w], contour_arcs))
          walks_[kept++] = walks_[w];
      walks_.erase(walks_.begin() + kept, walks_.end());
    }
    group.longest = walks_.front().contour_arc;
    settle(group, contour_arcs);
  }

  struct Walk
  {
    Contour_walk contour;
    Index contour_arc;
  };

  bool step(const Swept_vertex& at, Walk& walk, Contour_arcs& contour_arcs) {
    ++number_of_steps_;
    walked_[walk.contour_arc].push_back({walk.contour.left(), walk.contour.position()});
    if(walk.contour.advance(at.center()))
      return true;
    contour_arcs[walk.contour_arc].arrival = at.lower_component_that_ends_at(walk.contour.left());
    return false;
  }

  // The longest contour arc arrives at the one lower component of its contour at which no other
  // does.
  void settle(const Group& group, Contour_arcs& contour_arcs) {
    taken_.resize((std::max)(taken_.size(), contour_arcs.size()));
    for(auto i = group.begin; i != group.end; ++i)
      taken_[*i] = 0;
    for(auto i = group.begin; i != group.end; ++i)
      if(*i != group.longest) {
        CGAL_assertion_msg(!taken_[contour_arcs[*i].arrival],
                           "each arc arrives at a place of its own");
        taken_[contour_arcs[*i].arrival] = 1;
      }
    for(auto i = group.begin; i != group.end; ++i)
      if(!taken_[*i])
        contour_arcs[group.longest].arrival = *i;
    CGAL_assertion(contour_arcs[group.longest].arrival != no_index);
  }

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  std::vector<Index> label_; // by slot
  std::vector<Index> next_;  // the forest: by label, another one that it became a part of
  std::uint64_t number_of_steps_ = 0;

  // Of the saddle at hand.
  std::vector<Index> by_arc_;
  std::vector<Group> groups_;
  std::vector<std::vector<Crossed_edge>> walked_; // by contour arc, what it was walked over
  std::vector<Walk> walks_;
  std::vector<char> taken_;
};

/*!
The contours at the present level, as splay trees of the edges that they cross: for functions on
which walking would take too long, and for surfaces with holes. A contour is a sequence that begins
anywhere, or at a hole, if it ends at one. To cut it, to join two parts, and to find its arc takes
logarithmic amortized time, however long it is.
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
    const Ring ring = mesh_.ring(v);
    Index first = 0; // after the hole, if there is one
    for(Index p = 0; p < ring.size(); ++p)
      if(order_.is_hole(ring[p]))
        first = ring.next(p);
    Index root = none, p = first;
    const bool is_open = order_.is_hole(ring[ring.previous(first)]);
    do {
      if(!order_.is_hole(ring[p]))
        root = joined(root, new_node(v, p));
      p = ring.next(p);
    } while(p != first);
    set_contour(root, arc, is_open);
  }

  /// the contour around the maximum \p v ends; returns its arc.
  Index end(Index v) {
    Index arc = no_index;
    for(Index u : mesh_.ring(v))
      if(!order_.is_hole(u)) {
        const Index node = node_[slot_of(mesh_, u, v)];
        CGAL_precondition(node != none);
        if(arc == no_index)
          arc = nodes_[splayed(node)].arc;
        forget(slot_of(mesh_, u, v));
      }
    return arc;
  }

  /// finds the contour arcs at a saddle or a regular vertex, and takes out what is between them.
  void cut(const Swept_vertex& at, Contour_arcs& contour_arcs) {
    const Index k = at.number_of_lower_components();
    contour_arcs.assign(k, {no_index, no_index, {}});
    for(Index i = 0; i < k; ++i)
      if(!at.is_hole(i))
        contour_arcs[i].arc = nodes_[splayed(node_[at.slot_of_lower_component(i)])].arc;
    for(Index i = 0; i < k; ++i)
      if(!at.is_hole(i))
        cut_at_lower_component(at, i);
    is_reached_.assign(k, 0);
    for(Index i = 0; i < k; ++i) {
      contour_arcs[i].is_empty = at.leaves_to_hole(i);
      if(contour_arcs[i].is_empty)
        continue;
      const Index first = splayed(leaving_node(at, i));
      contour_arcs[i].front = nodes_[first].sum;
      contour_arcs[i].arrival = arrival(at, last_of(first));
      if(contour_arcs[i].arrival != no_index)
        is_reached_[contour_arcs[i].arrival] = 1;
    }
    for(Index i = 0; i < k; ++i)
      if(is_reached_[i] == 0) {
        const bool is_empty = at.arrives_from_hole(i);
        contour_arcs.push_back({i, contour_arcs[i].arc,
                                is_empty ? Front_mean() : nodes_[splayed(arriving_node(at, i))].sum,
                                is_empty});
      }
  }

  /// joins the contour arcs around the gaps above; they now name the arcs that they belong to.
  void join(const Swept_vertex& at, const Contour_arcs& contour_arcs) {
    const Index k = at.number_of_lower_components();
    const Index n = static_cast<Index>(contour_arcs.size());
    is_joined_.assign(n, 0);
    for(Index j = 0; j < n; ++j) { // contours that come from a hole first
      const Index first = j < n - k ? k + j : j - (n - k);
      if(is_joined_[first])
        continue;
      Index root = none, i = first;
      do {
        is_joined_[i] = 1;
        if(!contour_arcs[i].is_empty)
          root = joined(root, splayed(i < k ? leaving_node(at, i)
                                            : arriving_node(at, contour_arcs[i].arrival)));
        if(contour_arcs[i].arrival == no_index)
          break;
        at.for_each_above(contour_arcs[i].arrival,
                          [&](Index p) { root = joined(root, new_node(at.center(), p)); });
        i = at.next_lower_component(contour_arcs[i].arrival);
      } while(i != first);
      if(root != none)
        set_contour(root, contour_arcs[first].arc, first >= k);
    }
  }

private:
  static constexpr Index none = 0; // node 0 is not used

  struct Node
  {
    Index up, left, right; // the tree
    Index lower;           // lower end of the edge
    Index arc;             // of the contour, kept at the root; none of a part of a contour
    bool has_ends;         // of the contour, at holes; kept at the root
    Front_mean own, sum;   // of the edge, of the subtree
  };

  void build_contour(Contour_labels& labels, Contour_walk walk) {
    const Index first = walk.slot();
    Index root = none;
    do {
      root = joined(root, new_node(walk.left(), walk.position()));
      walk.advance(no_index);
    } while(walk.slot() != first);
    set_contour(root, labels.arc_at(first), false);
  }

  void set_contour(Index root, Index arc, bool has_ends) {
    nodes_[root].arc = arc;
    nodes_[root].has_ends = has_ends;
  }

  // After the first cut a closed contour is a sequence that begins with the contour arc that leaves
  // there; further cuts part it, and so does each cut of a contour that ends at holes.
  void cut_at_lower_component(const Swept_vertex& at, Index i) {
    const Index end =
        splayed(node_[at.slot_of_lower_component(i)]); // of the lower component, in clockwise order
    const bool is_closed = nodes_[end].arc != no_index && !nodes_[end].has_ends;
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

  Index arriving_node(const Swept_vertex& at, Index i) const {
    return node_[slot_of(mesh_, at.last_of(i), at.after_last_of(i))];
  }

  // The lower component at which a contour arc with this last edge arrives, if it does.
  Index arrival(const Swept_vertex& at, Index last) const {
    const Index i = at.lower_component_that_ends_at(nodes_[last].lower);
    const bool arrives = i != no_index && !at.arrives_from_hole(i) && arriving_node(at, i) == last;
    CGAL_assertion(arrives || order_.has_holes());
    return arrives ? i : no_index;
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
    const Front_mean front = crossing_of_front(mesh_, order_, lower, mesh_.ring(lower), position);
    nodes_[node] = {none, none, none, lower, no_index, false, front, front};
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
    const bool has_ends = nodes_[root].has_ends;
    while(nodes_[node].up != none) {
      const Index parent = nodes_[node].up, above = nodes_[parent].up;
      if(above != none) {
        const bool is_straight = (nodes_[parent].left == node) == (nodes_[above].left == parent);
        rotate(is_straight ? parent : node);
      }
      rotate(node);
    }
    set_contour(node, arc, has_ends);
    return node;
  }

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  std::vector<Index> node_; // by slot
  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<char> is_reached_, is_joined_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_TREES_H
