// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_NUMBERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_NUMBERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The linking numbers of loops on a surface with copies of each other that are pushed outwards:
V(i, j) is that of loop i with loop j pushed out of the solid. It depends only on the classes of the
loops, so that loop i is taken as its copy across the corners of the faces and loop j as its walk
along the edges (`Surface_curves`). What is counted are the places where, seen along a direction,
the copy passes over the pushed walk, by the sense in which they cross.

- Apart from the midpoints where they touch, a copy and a walk are disjoint wherever the surface
  does not touch itself. Whether two lines cross in the projection is decided by exact predicates,
  which of them is above by another; and if a point happens to be seen on a line, all copies are
  moved aside by an infinitesimal amount, the same for all.
- Where a copy crosses an edge of a walk, that edge is pushed outwards by less than any distance but
  by more than the above amount. If both faces at the edge are seen from outside, the pushed edge
  passes over the copy; if both are seen from inside, under it. At an edge of the silhouette, with
  one face seen from either side, the pushed edge lies beyond the silhouette if the edge is convex,
  and is not crossed; if it is reflex the pushed edge lies between the two faces, and the copy
  passes over it once and under it once.
- A copy and a walk whose boxes are apart are not linked: nothing is counted of them.

No number is compared with a tolerance. The lines that may cross are found by a tree of boxes: near
linear in the number of lines and of places where one passes over another of a loop close by.
*/
class Linking_numbers
{
  using Extent = Box<3>;

  // Around a line in the projection, and around the whole loops that it is of in space.
  using Seen_box = Box<5>;

public:
  Linking_numbers(Execution execution, const Surface_curves& curves)
      : curves_(curves)
      , points_(execution, curves.vertices, next_direction(), 2 * curves.corners.size()) {
    add_intersections();
  }

  /// computes V.
  void link(Execution execution) {
    while(!are_touches_decided() && ++number_of_attempts_ < maximum_number_of_attempts)
      points_.see_along(execution, next_direction());
    add_touches();
    add_crossings(execution);
    add_up(linking_);
    std::sort(contacts_.begin(), contacts_.end());
    find_defect();
  }

  /// what has been computed.
  Linking take() {
    return {std::move(intersections_), std::move(linking_), std::move(defect_),
            std::move(contacts_), has_too_many_contacts_};
  }

private:
  using Edge = Surface_curves::Edge;
  using Corner = Surface_curves::Corner;

  static constexpr int maximum_number_of_attempts = 16;
  static constexpr std::size_t corners_at_once = 8;

  // ---- intersection numbers

  void add_intersections() {
    for(std::size_t e = 0; e < curves_.edges.size(); ++e)
      for(const Matrix_entry& copy : curves_.crossings.of(e))
        for(const Matrix_entry& walk : curves_.walks.of(e))
          intersections_.push_back({copy.column, walk.column, copy.value * walk.value});
    add_up(intersections_);
    CGAL_postcondition_msg(is_antisymmetric(intersections_),
                           "a copy crosses as often as its loop does");
  }

  void find_defect() {
    defect_ = linking_;
    for(const Matrix_entry& e : linking_)
      defect_.push_back({e.column, e.row, -e.value});
    for(const Matrix_entry& e : intersections_)
      defect_.push_back({e.row, e.column, -curves_.outward[e.row] * e.value});
    add_up(defect_);
  }

  void add_contact(const Contact& contact) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(contacts_.size() < 1000 + curves_.corners.size() / 16)
      contacts_.push_back(contact);
    else
      has_too_many_contacts_ = true;
  }

  // ---- midpoints where a copy crosses a walk

  // The same directions in each run.
  Projected_points::Direction next_direction() {
    const auto next = [this] { return (static_cast<int>(random_() % 1024) * 2 - 1023) / 1024.; };
    const double a = next();
    return {a, next()};
  }

  bool is_touched(std::size_t e) const {
    return !curves_.walks.of(e).empty() && !curves_.crossings.of(e).empty();
  }

  int outward_at(std::size_t e) const { return curves_.outward[curves_.walks.of(e)[0].column]; }

  // Which side of the face to the left, and to the right, is seen: 1 is the outer one.
  std::array<int, 2> visible_sides(std::size_t e) const {
    const Edge& edge = curves_.edges[e];
    return {outward_at(e) * points_.turn(edge.source, edge.target, edge.left),
            outward_at(e) * points_.turn(edge.target, edge.source, edge.right)};
  }

  // Whether no face at a touched edge is seen as a line.
  bool are_touches_decided() const {
    for(std::size_t e = 0; e < curves_.edges.size(); ++e)
      if(is_touched(e)) {
        const auto [left, right] = visible_sides(e);
        if(left == 0 || right == 0)
          return false;
      }
    return true;
  }

  // Whether the copy passes over the pushed edge.
  bool is_above(std::size_t e) {
    const auto [left, right] = visible_sides(e);
    if(left == right)
      return left < 0;
    const Edge& edge = curves_.edges[e];
    const int reflex =
        outward_at(e) * points_.side(edge.source, edge.target, edge.left, edge.right);
    if(reflex == 0 || left == 0 || right == 0)
      add_contact({Contact::no_corner, e});
    return reflex > 0;
  }

  void add_touches() {
    for(std::size_t e = 0; e < curves_.edges.size(); ++e)
      if(is_touched(e) && is_above(e))
        for(const Matrix_entry& copy : curves_.crossings.of(e))
          for(const Matrix_entry& walk : curves_.walks.of(e))
            linking_.push_back(
                {copy.column, walk.column, curves_.outward[walk.column] * copy.value * walk.value});
  }

  // ---- places where a copy is seen to cross a walk

  // The ends of the corners become points after the vertices.
  Index first_end(std::size_t corner) const {
    return static_cast<Index>(curves_.vertices.size() + 2 * corner);
  }

  void add_ends(Execution execution) {
    points_.add_midpoints(execution, 2 * curves_.corners.size(), [this](std::size_t i) {
      const Corner& c = curves_.corners[i / 2];
      return std::make_pair(c.apex, i % 2 == 0 ? c.from : c.to);
    });
  }

  // By loop, around the walk and around the copy.
  void find_extents() {
    extents_of_walks_.assign(curves_.outward.size(), Extent::empty());
    extents_of_copies_ = extents_of_walks_;
    for(std::size_t e = 0; e < curves_.edges.size(); ++e)
      for(const Matrix_entry& walk : curves_.walks.of(e))
        for(Index v : {curves_.edges[e].source, curves_.edges[e].target})
          extents_of_walks_[walk.column].extend(place(v));
    for(const Corner& corner : curves_.corners)
      for(Index v : {corner.apex, corner.from, corner.to})
        extents_of_copies_[corner.loop].extend(place(v));
  }

  Extent place(Index v) const { return {curves_.vertices[v], curves_.vertices[v]}; }

  // Of all loops whose walks run along an edge: nothing, if they cancel each other.
  Extent extent_at(std::size_t e) const {
    Extent all = Extent::empty();
    for(const Matrix_entry& walk : curves_.walks.of(e))
      all.extend(extents_of_walks_[walk.column]);
    return all;
  }

  Seen_box box(Index p, Index q, const Extent& of_loops) const {
    const auto [x1, y1] = points_.position(p);
    const auto [x2, y2] = points_.position(q);
    const double e = (std::max)(points_.position_error(p), points_.position_error(q));
    const auto& [low, high] = of_loops;
    return {{(std::min)(x1, x2) - e, (std::min)(y1, y2) - e, low[0], low[1], low[2]},
            {(std::max)(x1, x2) + e, (std::max)(y1, y2) + e, high[0], high[1], high[2]}};
  }

  // The order of lines along a space-filling curve, in slabs: what is seen at one place may be of
  // loops that are far apart. `vertex_of` gives a vertex of each.
  template <typename Vertex_of>
  std::vector<Index>
  order(Execution execution, const std::vector<Seen_box>& boxes, const Vertex_of& vertex_of) const {
    constexpr double slabs = 8.;
    const auto height = [&](std::size_t i) { return curves_.vertices[vertex_of(i)][2] / 2.; };
    Seen_box all = Seen_box::empty();
    double low = 0., high = 0.;
    for(std::size_t i = 0; i < boxes.size(); ++i) {
      all.extend(boxes[i]);
      low = i == 0 ? height(i) : (std::min)(low, height(i));
      high = i == 0 ? height(i) : (std::max)(high, height(i));
    }
    const auto part = [](double x, double from, double to) {
      return to > from ? (x - from) / (to - from) : 0.;
    };
    return space_filling_order(execution, boxes.size(), [&](std::size_t i) {
      const Seen_box& b = boxes[i];
      return Vector{part(b.low[0], all.low[0], all.high[0]),
                    part(b.low[1], all.low[1], all.high[1]),
                    std::floor(slabs * part(height(i), low, high)) / slabs};
    });
  }

  // Boxes with the numbers of what they are around, those that are near each other together.
  struct Sorted_boxes
  {
    std::vector<Index> numbers;
    std::vector<Seen_box> boxes;
  };

  template <typename Box_of, typename Vertex_of>
  Sorted_boxes sorted_boxes(Execution execution,
                            std::size_t n,
                            const Box_of& box_of,
                            const Vertex_of& vertex_of) const {
    std::vector<Seen_box> boxes(n);
    for_each_index(execution, n, [&](std::size_t i) { boxes[i] = box_of(i); });
    Sorted_boxes sorted{order(execution, boxes, vertex_of), std::vector<Seen_box>(n)};
    for_each_index(execution, n,
                   [&](std::size_t i) { sorted.boxes[i] = boxes[sorted.numbers[i]]; });
    return sorted;
  }

  void add_crossings(Execution execution) {
    add_ends(execution);
    find_extents();
    const auto& all_edges = curves_.edges;
    const auto& all_corners = curves_.corners;
    Sorted_boxes edges = sorted_boxes(
        execution, all_edges.size(),
        [&](std::size_t e) { return box(all_edges[e].source, all_edges[e].target, extent_at(e)); },
        [&](std::size_t e) { return all_edges[e].source; });
    const Sorted_boxes corners = sorted_boxes(
        execution, all_corners.size(),
        [&](std::size_t c) {
          return box(first_end(c), first_end(c) + 1, extents_of_copies_[all_corners[c].loop]);
        },
        [&](std::size_t c) { return all_corners[c].apex; });
    const Box_tree<5> tree(std::move(edges.boxes));
    const std::vector<Matrix_entry> entries = collect<Matrix_entry>(
        execution, corners.boxes.size(),
        [&](std::size_t begin, std::size_t end) {
          std::vector<Matrix_entry> part;
          for(std::size_t i = begin; i < end; i += corners_at_once) {
            execution.look();
            add_crossings(tree, edges.numbers, corners, i, (std::min)(end, i + corners_at_once),
                          part);
          }
          add_up(part);
          return part;
        },
        512 * corners_at_once);
    linking_.insert(linking_.end(), entries.begin(), entries.end());
  }

  // Of corners that follow each other in their order, hence lie near each other.
  void add_crossings(const Box_tree<5>& tree,
                     const std::vector<Index>& edges,
                     const Sorted_boxes& corners,
                     std::size_t begin,
                     std::size_t end,
                     std::vector<Matrix_entry>& entries) {
    Seen_box all = corners.boxes[begin];
    for(std::size_t i = begin; i < end; ++i)
      all.extend(corners.boxes[i]);
    tree.for_each_meeting(all, [&](Index i, const Seen_box& box_of_edge) {
      for(std::size_t j = begin; j < end; ++j)
        if(corners.boxes[j].meets(box_of_edge))
          add_terms(corners.numbers[j], edges[i], entries);
    });
  }

  void add_terms(Index c, Index e, std::vector<Matrix_entry>& entries) {
    const Corner& corner = curves_.corners[c];
    if(has_too_many_contacts_ || touches(corner, curves_.edges[e]))
      return;
    const int sign = crossing(c, e);
    if(sign != 0)
      for(const Matrix_entry& walk : curves_.walks.of(e))
        if(extents_of_copies_[corner.loop].meets(extents_of_walks_[walk.column]))
          entries.push_back({corner.loop, walk.column, sign * walk.value});
  }

  static bool touches(const Corner& c, const Edge& edge) {
    const Index other = edge.source == c.apex ? edge.target : edge.source;
    return (edge.source == c.apex || edge.target == c.apex) && (other == c.from || other == c.to);
  }

  // 0 unless the corner is seen to pass over the edge; 1 if the edge then leads to the left.
  int crossing(Index c, Index e) {
    const Index a = first_end(c), b = a + 1;
    const Index p = curves_.edges[e].source, q = curves_.edges[e].target;
    if(points_.turn(a, b, p) * points_.turn(a, b, q) > 0 ||
       points_.turn(p, q, a) * points_.turn(p, q, b) > 0)
      return 0;
    // They are seen to meet. If they lie in a plane they do meet.
    const int side = points_.side(a, b, p, q);
    if(side == 0) {
      add_contact({c, e});
      return 0;
    }
    // If a line is seen as a point all turns are zero, and it crosses nothing.
    const int sense = points_.turn_of_moved(a, b, q);
    if(sense == points_.turn_of_moved(a, b, p) ||
       points_.turn_to_moved(p, q, a) == points_.turn_to_moved(p, q, b))
      return 0;
    return side == sense ? sense : 0;
  }

  const Surface_curves& curves_;
  std::minstd_rand random_;
  Projected_points points_;
  Sparse_matrix linking_, intersections_, defect_; // see `Linking`
  int number_of_attempts_ = 0;
  std::vector<Extent> extents_of_walks_, extents_of_copies_; // by loop
  std::mutex mutex_;                                         // for contacts_
  std::vector<Contact> contacts_;
  std::atomic<bool> has_too_many_contacts_{false};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_NUMBERS_H
