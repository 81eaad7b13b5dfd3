// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Class_vector.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Edge_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Partner_distances.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Search_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Search_targets.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Finds the shortest closed walks through a vertex, one of each class, that cross certain loops, the
walls, not at all in net numbers.

Dijkstra's algorithm on the covering surface on which the walls unroll: a label is a vertex together
with the sum of the walls that the way to it has crossed. Where two ways come to one vertex with the
same sum, they are a closed walk that crosses the walls as often forth as back, and all shortest
such walks are of this form (two shortest ways and an edge, as Thomassen's condition on three paths
holds on the cover; Erickson and Whittlesey 2005). Without walls these are a tree and an edge. No
vertex is visited with more than eight sums: on knots something may be missed.
*/
class Class_search
{
public:
  Class_search(const Search_mesh& mesh, const Edge_classes& classes)
      : mesh_(mesh)
      , classes_(classes)
      , first_(mesh.number_of_vertices(), no_index)
      , lower_bounds_(mesh.number_of_vertices(), 0.f) {}

  /// before searches with other targets or walls. The walls are the loops of the sums `along` if
  /// \p are_walls_along, else those of `across`.
  /// With distances from a partner, walks begin near it, and ways are followed only that may
  /// be part of one that crosses it and is short enough.
  void start(bool are_walls_along, const Partner_distances* partner = nullptr) {
    are_walls_along_ = are_walls_along;
    partner_ = partner;
    for(Index v : bounded_)
      lower_bounds_[v] = 0.f;
    bounded_.clear();
  }

  /// looks for closed walks through `root` that the targets want. Stops when there are no `visits`
  /// left, of which it takes one for each label, and one for each few steps of a walk that it goes
  /// along.
  void search(Index root, Search_targets& targets, std::size_t& visits) {
    targets_ = &targets;
    visits_ = &visits;
    shortest_ = targets.limit();
    is_cut_off_ = false;
    Label first{0.f, root, no_index, no_index, no_index, false, 0, {}};
    if(partner_ != nullptr) {
      first.copy = partner_->first_copy(root);
      offset_ = partner_->distance(root);
    }
    reach(root, first);
    const auto goes_on = [&](float distance) {
      return visits > 0 && 2. * distance < targets.limit();
    };
    queue_.run(labels_, goes_on, [&](Index l) {
      if(is_too_far(labels_[l]))
        return;
      --visits;
      visit(l);
    });
    reset(visits > 0 && !is_cut_off_);
  }

  /// No walk through a vertex that the targets want can be shorter, by the searches since
  /// `start()`.
  double lower_bound(Index v) const { return lower_bounds_[v]; }

private:
  static constexpr int most_labels = 8; // of one vertex

  struct Label
  {
    float distance;
    Index vertex;
    Index parent; // a label
    Index step;   // from it
    Index next;   // of the same vertex
    bool is_settled;
    int copy; // of the surface cut open along the partner
    Class_sums sums;
  };

  std::uint64_t wall(const Class_sums& s) const { return are_walls_along_ ? s.along : s.across; }
  std::uint64_t kind(const Class_sums& s) const { return are_walls_along_ ? s.across : s.along; }

  // Whether no walk that goes this way is short enough.
  bool is_too_far(const Label& way) const {
    return partner_ != nullptr &&
           way.distance + partner_->way_on(way.vertex, way.copy) - offset_ >= targets_->limit();
  }

  void reach(Index v, Label label) {
    if(first_[v] == no_index)
      reached_.push_back(v);
    label.next = first_[v];
    first_[v] = static_cast<Index>(labels_.size());
    labels_.push_back(label);
    queue_.push(label.distance, first_[v]);
  }

  void visit(Index l) {
    labels_[l].is_settled = true;
    const Label here = labels_[l];
    Label there = here;
    there.parent = l;
    there.is_settled = false;
    for(Index step = mesh_.begin(here.vertex); step != mesh_.end(here.vertex); ++step) {
      there.vertex = mesh_.head(step);
      there.step = step;
      there.distance = here.distance + mesh_.length(here.vertex, step);
      there.sums = here.sums;
      const Class_sums sums = mesh_.sums(here.vertex, step, classes_);
      there.sums.add(1, sums);
      there.copy = here.copy;
      if(partner_ != nullptr && !sums.is_zero())
        there.copy += partner_->number(here.vertex, step);
      relax(there);
    }
  }

  void relax(const Label& way) {
    int number = 0;
    for(Index m = first_[way.vertex]; m != no_index; m = labels_[m].next, ++number) {
      Label& other = labels_[m];
      if(wall(other.sums) != wall(way.sums))
        continue;
      if(kind(other.sums) != kind(way.sums))
        note(way, other);
      if(!other.is_settled && way.distance < other.distance && !is_too_far(way)) {
        const Index next = other.next;
        other = way;
        other.next = next;
        queue_.push(way.distance, m);
      }
      return;
    }
    if(2. * way.distance >= targets_->limit() || is_too_far(way))
      return;
    if(number < most_labels)
      reach(way.vertex, way);
    else
      is_cut_off_ = true;
  }

  // Two ways to one vertex.
  void note(const Label& way, const Label& other) {
    const double length = double(way.distance) + other.distance;
    if(length >= targets_->limit())
      return;
    const std::uint64_t difference = kind(way.sums) - kind(other.sums);
    const std::uint64_t key = (std::min)(difference, 0 - difference);
    if(!targets_->is_known(key))
      targets_->add_class(key, numbers(closed_walk(way, other)));
    if(!targets_->wants(key, length))
      return;
    shortest_ = (std::min)(shortest_, length);
    if(targets_->is_shortest(key, length))
      targets_->take(key, length, closed_walk(way, other));
  }

  // On the edges behind the steps, to the place where the ways meet, and back.
  std::vector<Index> closed_walk(const Label& way, const Label& other) const {
    std::vector<Index> walk = way_from_root(way), back = way_from_root(other);
    walk.insert(walk.end(), back.rbegin(), back.rend());
    remove_spurs(walk);
    *visits_ -= (std::min)(*visits_, walk.size() / 4);
    return walk;
  }

  std::vector<Index> way_from_root(const Label& way) const {
    std::vector<const Label*> labels(1, &way);
    while(labels.back()->parent != no_index)
      labels.push_back(&labels_[labels.back()->parent]);
    std::vector<Index> walk(1, mesh_.vertex_of_walks(labels.back()->vertex));
    for(std::size_t i = labels.size() - 1; i-- > 0;)
      mesh_.for_each_edge(labels[i + 1]->vertex, labels[i]->step,
                          [&](Index, Index to) { walk.push_back(to); });
    return walk;
  }

  // How often a closed walk crosses the loops.
  Class_vector numbers(const std::vector<Index>& walk) const {
    Class_vector numbers;
    for(std::size_t i = 0; i < walk.size(); ++i)
      classes_.for_each_term(mesh_.corner(walk[i]),
                             mesh_.corner(walk[i + 1 == walk.size() ? 0 : i + 1]),
                             [&](Index loop, int number) { numbers.emplace_back(loop, number); });
    normalize(numbers);
    return numbers;
  }

  // A walk through a vertex is by the way there and back shorter, at most, than the shortest
  // through the root.
  void reset(bool is_complete) {
    for(Index v : reached_) {
      double distance = shortest_;
      for(Index l = first_[v]; l != no_index; l = labels_[l].next)
        if(labels_[l].is_settled)
          distance = (std::min)(distance, double(labels_[l].distance));
      const float bound = static_cast<float>(shortest_ - 2. * distance);
      if(is_complete && bound > lower_bounds_[v]) {
        if(lower_bounds_[v] == 0.f)
          bounded_.push_back(v);
        lower_bounds_[v] = bound;
      }
      first_[v] = no_index;
    }
    reached_.clear();
    labels_.clear();
    queue_.clear();
  }

  const Search_mesh& mesh_;
  const Edge_classes& classes_;
  std::vector<Index> first_; // label, by vertex
  std::vector<Label> labels_;
  std::vector<Index> reached_, bounded_;
  std::vector<float> lower_bounds_; // by vertex
  Distance_queue<float> queue_;
  bool are_walls_along_ = false;
  bool is_cut_off_ = false; // at a vertex that has been reached with too many sums
  double shortest_ = 0.;
  double offset_ = 0.; // of the root from the partner
  const Partner_distances* partner_ = nullptr;
  Search_targets* targets_ = nullptr;
  std::size_t* visits_ = nullptr;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_SEARCH_H
