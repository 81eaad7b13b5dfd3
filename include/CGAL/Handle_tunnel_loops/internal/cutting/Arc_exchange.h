// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_ARC_EXCHANGE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_ARC_EXCHANGE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Chord_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Disk_boundary.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Edges that may take the place of an arc.
struct Arc_proposal
{
  std::size_t arc;
  double gain;
  std::vector<Index> path;
};

/*!
Finds, for each arc of a cut of one component, the shortest path that may take its place.

Without the arc the disk is an annulus, and any path in it from one side of its boundary to the
other opens it to a disk again. The nearest places of the boundary are found once for all vertices;
for an arc they are found anew only where the nearest place is on the arc. The shortest path then
passes an edge between vertices of which one is nearer to one side, and one to the other.

Where the cut stays as it was, so do the nearest places; and an arc that nothing shorter was found
for is looked at again only when something has changed around it.
*/
class Arc_exchange
{
  struct Label
  {
    double distance = never;
    Index origin = no_index;   // the halfedge with which the way begins, in the nearest corner
    Index previous = no_index; // the halfedge that leads to the vertex
  };
  // The shortest way between two arcs, or corners at nodes.
  struct Chord_of_groups : Chord
  {
    Index from_group, to_group;
  };

public:
  explicit Arc_exchange(const Cut_problem& problem, const Cut_graph& cut)
      : problem_(problem)
      , halfedges_(problem.halfedges)
      , cut_(cut)
      , labels_(problem.mesh.number_of_vertices())
      , cell_labels_(problem.mesh.number_of_vertices())
      , cell_of_(problem.mesh.number_of_vertices(), no_index)
      , group_of_vertex_(problem.mesh.number_of_vertices(), no_index)
      , places_(problem.halfedges.size())
      , settled_size_(problem.halfedges.size(), 0) {}

  /// to go on with another component.
  void clear() { labels_.clear(); }

  /// the paths that are shorter than their arcs, the greatest gains first.
  std::vector<Arc_proposal> find(const Disk_boundary& boundary) {
    boundary_ = &boundary;
    for(Index k = 0; k < boundary.size(); ++k)
      boundary.for_each_in_corner(k, [&](Index h) { places_[h] = k; });
    arcs_ = boundary.arcs([&](Index h) { return places_[h]; });
    number_groups();
    update_labels();
    collect_cells();
    find_arcs_to_try();
    collect_chords();
    std::vector<Arc_proposal> proposals;
    for(std::size_t a = 0; a < arcs_.size(); ++a)
      if(is_to_try_[a])
        propose(a, proposals);
    for(const std::vector<Index>& cell : cells_)
      for(const Index v : cell)
        cell_of_[v] = no_index;
    std::stable_sort(proposals.begin(), proposals.end(),
                     [](const Arc_proposal& a, const Arc_proposal& b) { return a.gain > b.gain; });
    return proposals;
  }

  const std::vector<Cut_arc>& arcs() const { return arcs_; }

private:
  static constexpr double never = (std::numeric_limits<double>::max)();

  // ---- the boundary

  // Corners at nodes are groups of their own; other places belong to the group of their arc's side.
  void number_groups() {
    const Index n = boundary_->size();
    group_.assign(n, no_index);
    arc_of_place_.assign(n, no_index);
    for(std::size_t a = 0; a < arcs_.size(); ++a) {
      const Cut_arc& arc = arcs_[a];
      for(const auto& [first, last] :
          {std::make_pair(arc.first, arc.last), std::make_pair(arc.twin_first, arc.twin_last)})
      {
        group_[first] = first;
        for(Index k = boundary_->next(first); k != last; k = boundary_->next(k)) {
          group_[k] = n + first;
          arc_of_place_[k] = static_cast<Index>(a);
        }
      }
    }
  }

  // ---- the nearest places

  bool is_on_cut(Index v) const { return cut_.degree(v) != 0; }

  void update_labels() {
    changed_ = outdated_labels();
    labels_.forget(changed_);
    const std::size_t number_outdated = changed_.size();
    for(std::size_t i = 0; i < number_outdated; ++i)
      label_from_around(changed_[i]);
    for(Index k = 0; k < boundary_->size(); ++k)
      boundary_->for_each_in_corner(k, [&](Index h) {
        if(!cut_.contains(h))
          pass_on(h, {0., h, no_index});
      });
    labels_.grow([&](Index v) {
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        pass_on(h, labels_[v]);
    });
  }

  // Of vertices now on the cut, or with a way from where the cut was; and all that ways through
  // them lead to.
  std::vector<Index> outdated_labels() {
    std::vector<Index> outdated;
    const auto take = [&](Index v) {
      labels_[v].previous = no_index;
      outdated.push_back(v);
    };
    std::size_t next = 0;
    for(const Index root : labels_.reached()) {
      if(labels_[root].previous != no_index && is_outdated(root))
        take(root);
      for(; next < outdated.size(); ++next)
        for(Index h = halfedges_.begin(outdated[next]); h < halfedges_.end(outdated[next]); ++h)
          if(labels_[halfedges_.target(h)].previous == h)
            take(halfedges_.target(h));
    }
    return outdated;
  }

  bool is_outdated(Index v) const {
    const Index u = halfedges_.source(labels_[v].previous);
    return is_on_cut(v) || (!is_on_cut(u) && !labels_.is_reached(u));
  }

  void label_from_around(Index v) {
    for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
      if(labels_.is_reached(halfedges_.target(h)))
        pass_on(halfedges_.twin(h), labels_[halfedges_.target(h)]);
  }

  void pass_on(Index h, const Label& from) {
    if(!is_on_cut(halfedges_.target(h)) && relax(labels_, h, from, never))
      changed_.push_back(halfedges_.target(h));
  }

  // Passes on the nearest place along a halfedge.
  bool relax(Shortest_paths<Label>& labels, Index h, const Label& from, double most) const {
    const Index v = halfedges_.target(h);
    const double d = from.distance + problem_.weight[h];
    if(problem_.is_avoided(h) || !(2. * d < most && d < labels[v].distance))
      return false;
    labels.reach(v, {d, from.origin, h});
    return true;
  }

  // By arc, the vertices that are nearest to it, and those on it.
  void collect_cells() {
    cells_.assign(arcs_.size(), {});
    for(const Index v : labels_.reached()) {
      const Index place = place_of(labels_[v]), a = arc_of_place_[place];
      group_of_vertex_[v] = group_[place];
      if(a != no_index)
        cells_[a].push_back(v);
    }
    for(Index k = 0; k < boundary_->size(); ++k)
      group_of_vertex_[boundary_->vertex(k)] = no_index; // each corner has its own
    for(std::size_t a = 0; a < arcs_.size(); ++a) {
      for(Index k = boundary_->next(arcs_[a].first); k != arcs_[a].last; k = boundary_->next(k))
        cells_[a].push_back(boundary_->vertex(k));
      for(const Index v : cells_[a])
        cell_of_[v] = static_cast<Index>(a);
    }
  }

  // Kept arcs stay; others are settled as long as nothing changes in their cell or at it.
  void find_arcs_to_try() {
    is_to_try_.clear();
    for(const Cut_arc& arc : arcs_)
      is_to_try_.push_back(settled_size_[(*boundary_)[arc.first]] != size_of(arc));
    const auto note = [&](Index v) {
      if(cell_of_[v] != no_index)
        is_to_try_[cell_of_[v]] = 1;
    };
    for(const Index v : changed_) {
      note(v);
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        note(halfedges_.target(h));
    }
    most_ = 0.;
    for(std::size_t a = 0; a < arcs_.size(); ++a)
      if(arcs_[a].is_kept)
        is_to_try_[a] = 0;
      else if(is_to_try_[a])
        most_ = (std::max)(most_, arcs_[a].length);
    add_up_keys();
  }

  // A chord can take the place of an arc only if one of the arc's two places on the boundary lies
  // between its ends. Keys are added bit by bit, so that those of both places are nothing together.
  void add_up_keys() {
    keys_before_.assign(boundary_->size() + std::size_t{1}, 0);
    std::mt19937_64 keys;
    for(std::size_t a = 0; a < arcs_.size(); ++a)
      if(is_to_try_[a]) {
        const std::uint64_t key = keys();
        keys_before_[arcs_[a].first + std::size_t{1}] = key;
        keys_before_[arcs_[a].twin_first + std::size_t{1}] = key;
      }
    std::partial_sum(keys_before_.begin(), keys_before_.end(), keys_before_.begin(),
                     std::bit_xor<>());
  }

  Index size_of(const Cut_arc& arc) const { return boundary_->places_from(arc.first, arc.last); }

  Index place_of(const Label& label) const { return places_[label.origin]; }

  // The nearest place to the vertex to which a halfedge leads, as seen from there.
  Label label_at_end(Index h) const {
    const Index v = halfedges_.target(h);
    return is_on_cut(v) ? Label{0., halfedges_.twin(h), no_index} : labels_[v];
  }

  void collect_chords() {
    const std::vector<Index>& reached = labels_.reached();
    std::vector<Chord_of_groups> chords = collect<Chord_of_groups>(
        problem_.execution, reached.size(), [&](std::size_t begin, std::size_t end) {
          std::vector<Chord_of_groups> some;
          for(std::size_t i = begin; i < end; ++i)
            add_chords_from(reached[i], some);
          return some;
        });
    for(Index k = 0; k < boundary_->size(); ++k)
      boundary_->for_each_in_corner(k, [&](Index h) {
        if(!cut_.contains(h) && is_on_cut(halfedges_.target(h)) && h < halfedges_.twin(h))
          add_chord(h, chords);
      });
    const auto key = [](const Chord_of_groups& c) {
      return std::tie(c.from_group, c.to_group, c.length, c.halfedge);
    };
    sort(problem_.execution, chords.begin(), chords.end(),
         [&](const auto& a, const auto& b) { return key(a) < key(b); });
    const auto end = std::unique(chords.begin(), chords.end(), [](const auto& a, const auto& b) {
      return a.from_group == b.from_group && a.to_group == b.to_group;
    });
    chords_ = Chord_tree(std::vector<Chord>(chords.begin(), end));
  }

  void add_chords_from(Index v, std::vector<Chord_of_groups>& chords) const {
    for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h) {
      const Index u = halfedges_.target(h);
      if(group_of_vertex_[u] != group_of_vertex_[v] && (is_on_cut(u) || v < u))
        add_chord(h, chords);
    }
  }

  void add_chord(Index h, std::vector<Chord_of_groups>& chords) const {
    const Label a = label_at_end(halfedges_.twin(h)), b = label_at_end(h);
    if(b.origin == no_index || problem_.is_avoided(h))
      return;
    const double length = a.distance + problem_.weight[h] + b.distance;
    Index from = place_of(a), to = place_of(b);
    if(group_[from] == group_[to] || keys_before_[from] == keys_before_[to] || length >= most_)
      return;
    if(group_[from] > group_[to])
      std::swap(from, to);
    chords.push_back({{length, h, from, to}, group_[from], group_[to]});
  }

  // ---- one arc

  void propose(std::size_t a, std::vector<Arc_proposal>& proposals) {
    const Cut_arc& arc = arcs_[a];
    double best = (1. - 1e-9) * arc.length;
    Index way = no_index;
    if(const Chord* chord = chords_.shortest(best, Sides_of_arc{*boundary_, arc})) {
      best = chord->length;
      way = chord->halfedge;
    }
    label_cell(a, best);
    for(const Index v : cells_[a])
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        find_way(a, h, best, way);
    const Index settled_size = way == no_index ? size_of(arc) : 0;
    for(const Index k : {arc.first, arc.twin_first})
      settled_size_[(*boundary_)[k]] = settled_size;
    if(way != no_index) {
      proposals.push_back({a, arc.length - best, {way}});
      trace(a, halfedges_.source(way), proposals.back().path);
      trace(a, halfedges_.target(way), proposals.back().path);
    }
    cell_labels_.clear();
  }

  bool is_in_cell(std::size_t a, Index v) const { return cell_of_[v] == a; }

  // The nearest place that there is without the arc.
  Label label_without(std::size_t a, Index h) const {
    const Index v = halfedges_.target(h);
    return is_in_cell(a, v) ? cell_labels_[v] : label_at_end(h);
  }

  void label_cell(std::size_t a, double most) {
    for(const Index v : cells_[a])
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        if(!is_in_cell(a, halfedges_.target(h))) {
          const Label label = label_at_end(h);
          if(label.origin != no_index)
            relax(cell_labels_, halfedges_.twin(h), label, most);
        }
    cell_labels_.grow([&](Index v) {
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        if(is_in_cell(a, halfedges_.target(h)))
          relax(cell_labels_, h, cell_labels_[v], most);
    });
  }

  void find_way(std::size_t a, Index h, double& best, Index& way) const {
    const Label from = label_without(a, halfedges_.twin(h)), to = label_without(a, h);
    if(from.origin == no_index || to.origin == no_index || problem_.is_avoided(h))
      return;
    const double length = from.distance + problem_.weight[h] + to.distance;
    const Sides_of_arc sides{*boundary_, arcs_[a]};
    if(length < best && sides.of(place_of(from)) != sides.of(place_of(to))) {
      best = length;
      way = h;
    }
  }

  void trace(std::size_t a, Index v, std::vector<Index>& path) const {
    while(is_in_cell(a, v) || !is_on_cut(v)) {
      const Index h = is_in_cell(a, v) ? cell_labels_[v].previous : labels_[v].previous;
      path.push_back(h);
      v = halfedges_.source(h);
    }
  }

  const Cut_problem& problem_;
  const Flat_halfedges& halfedges_;
  const Cut_graph& cut_;
  const Disk_boundary* boundary_ = nullptr;
  std::vector<Cut_arc> arcs_;
  std::vector<Index> group_, arc_of_place_;    // by place
  double most_ = 0.;                           // no chord that is longer is of use
  Shortest_paths<Label> labels_, cell_labels_; // by vertex
  std::vector<std::vector<Index>> cells_;      // by arc
  std::vector<Index> cell_of_;                 // by vertex
  std::vector<Index> group_of_vertex_;
  std::vector<Index> places_;       // by halfedge that leaves a vertex of the cut
  std::vector<Index> changed_;      // vertices with a new label, or none any more
  std::vector<Index> settled_size_; // by halfedge, of the arc from there without a shorter way
  std::vector<char> is_to_try_;     // by arc
  std::vector<std::uint64_t> keys_before_; // by place, of the arcs to try up to there
  Chord_tree chords_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_ARC_EXCHANGE_H
