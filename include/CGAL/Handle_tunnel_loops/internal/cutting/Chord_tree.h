// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CHORD_TREE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CHORD_TREE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Disk_boundary.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A way through the disk, between two places of its boundary.
struct Chord
{
  double length;
  Index halfedge; ///< that it passes
  Index from, to; ///< places

  /// the shorter ones first.
  bool operator<(const Chord& other) const {
    return std::tie(length, halfedge) < std::tie(other.length, other.halfedge);
  }
};

/*!
Finds the shortest chord that may take the place of an arc. A k-d tree over the places of both ends:
what lies on one side of the arc is passed over, and so is what is longer than a chord known
already.
*/
class Chord_tree
{
public:
  Chord_tree() = default;

  explicit Chord_tree(std::vector<Chord> chords)
      : chords_(std::move(chords)) {
    if(!chords_.empty())
      build(0, chords_.size(), true);
  }

  /// of those shorter than `most`, from one side of an arc to the other.
  const Chord* shortest(double most, const Sides_of_arc& sides) const {
    const Chord limit{most, 0, 0, 0};
    const Chord* best = &limit;
    if(!nodes_.empty())
      search(0, sides, best);
    return best == &limit ? nullptr : best;
  }

private:
  static constexpr std::size_t most_in_leaf = 8;

  // The first child follows its parent.
  struct Node
  {
    std::size_t begin, end, second_child;
    double length; // the least
    Index from_first, from_last, to_first, to_last;
  };

  std::size_t build(std::size_t begin, std::size_t end, bool is_by_from) {
    const std::size_t number = nodes_.size();
    nodes_.push_back(node(begin, end));
    if(end - begin <= most_in_leaf)
      return number;
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](const Chord& a, const Chord& b) {
      return is_by_from ? std::tie(a.from, a) < std::tie(b.from, b)
                        : std::tie(a.to, a) < std::tie(b.to, b);
    });
    build(begin, middle, !is_by_from);
    const std::size_t second_child = build(middle, end, !is_by_from);
    nodes_[number].second_child = second_child;
    return number;
  }

  std::vector<Chord>::iterator at(std::size_t i) {
    return chords_.begin() + static_cast<std::ptrdiff_t>(i);
  }

  Node node(std::size_t begin, std::size_t end) const {
    const Chord& first = chords_[begin];
    Node node{begin, end, 0, first.length, first.from, first.from, first.to, first.to};
    for(std::size_t i = begin; i < end; ++i) {
      node.length = (std::min)(node.length, chords_[i].length);
      node.from_first = (std::min)(node.from_first, chords_[i].from);
      node.from_last = (std::max)(node.from_last, chords_[i].from);
      node.to_first = (std::min)(node.to_first, chords_[i].to);
      node.to_last = (std::max)(node.to_last, chords_[i].to);
    }
    return node;
  }

  void search(std::size_t number, const Sides_of_arc& sides, const Chord*& best) const {
    const Node& node = nodes_[number];
    if(node.length > best->length)
      return;
    const int from = sides.of(node.from_first, node.from_last);
    if(from != 0 && from == sides.of(node.to_first, node.to_last))
      return;
    if(node.second_child != 0) {
      search(number + 1, sides, best);
      search(node.second_child, sides, best);
      return;
    }
    for(std::size_t i = node.begin; i < node.end; ++i)
      if(const Chord& c = chords_[i]; c < *best && connects(c, sides))
        best = &c;
  }

  static bool connects(const Chord& c, const Sides_of_arc& sides) {
    const int from = sides.of(c.from), to = sides.of(c.to);
    return from != 0 && to != 0 && from != to;
  }

  std::vector<Chord> chords_;
  std::vector<Node> nodes_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CHORD_TREE_H
