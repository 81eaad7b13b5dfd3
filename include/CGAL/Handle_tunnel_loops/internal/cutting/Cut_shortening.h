// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_SHORTENING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_SHORTENING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An arc of a cut, between vertices where not just two free edges meet: it is twice on the
/// boundary of the disk, as the places from `first` to `last`, and from `twin_first` to
/// `twin_last`.
struct Cut_arc
{
  Index first, last, twin_first, twin_last;
  double length;
  bool is_kept;
};

/*!
The boundary of the disk to which a component opens: a cyclic sequence of halfedges, the disk on
their left. Place k is that of the k-th halfedge and of the corner at its source.
*/
class Disk_boundary
{
public:
  /// of the component of a halfedge of the cut; begins at a node.
  Disk_boundary(const Cut_problem& problem, const Cut_graph& cut, Index some_halfedge)
      : problem_(problem)
      , cut_(cut) {
    Index h = some_halfedge;
    do {
      halfedges_.push_back(h);
      h = cut.following(h);
    } while(h != some_halfedge);
    Index node = 0;
    while(node < size() && !is_node(node))
      ++node;
    CGAL_assertion_msg(node < size(), "the cut of a closed surface has a node");
    std::rotate(halfedges_.begin(), halfedges_.begin() + node, halfedges_.end());
  }

  Index size() const { return static_cast<Index>(halfedges_.size()); }
  Index operator[](Index place) const { return halfedges_[place]; }
  Index vertex(Index place) const { return problem_.halfedges.source(halfedges_[place]); }

  /// whether an arc ends at the corner of a place.
  bool is_node(Index place) const {
    const Index v = vertex(place);
    return cut_.degree(v) != 2 || problem_.is_cone(v) ||
           problem_.is_kept(halfedges_[place]) !=
               problem_.is_kept(halfedges_[place == 0 ? size() - 1 : place - 1]);
  }

  /// calls `f(halfedge)` for each halfedge within the corner of a place, on no edge of the cut but
  /// that of the first one.
  template <typename Function> void for_each_in_corner(Index place, const Function& f) const {
    Index h = halfedges_[place];
    do {
      f(h);
      h = problem_.halfedges.after(h);
    } while(!cut_.contains(h));
  }

  /// the arcs; `place(h)` is the place of a halfedge of the boundary.
  template <typename Place> std::vector<Cut_arc> arcs(const Place& place) const {
    std::vector<Cut_arc> arcs;
    for(Index first = 0; first < size();) {
      Index last = first;
      double length = 0.;
      do
        length += problem_.weight[halfedges_[last++]];
      while(last < size() && !is_node(last));
      const Index twin_first = place(problem_.halfedges.twin(halfedges_[last - 1]));
      if(first < twin_first)
        arcs.push_back({first, last == size() ? 0 : last, twin_first,
                        (twin_first + (last - first)) % size(), length,
                        problem_.is_kept(halfedges_[first])});
      first = last;
    }
    return arcs;
  }

private:
  const Cut_problem& problem_;
  const Cut_graph& cut_;
  std::vector<Index> halfedges_;
};

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
*/
class Arc_exchange
{
  struct Label
  {
    double distance = never;
    Index place = no_index;    // of the boundary, the nearest one
    Index previous = no_index; // the halfedge that leads to the vertex
  };
  // The shortest way between two arcs, or corners at nodes, passes this halfedge.
  struct Chord
  {
    Index from_group, to_group;
    double length;
    Index halfedge;
    Index from, to; // places
  };

public:
  explicit Arc_exchange(const Cut_problem& problem, const Cut_graph& cut)
      : problem_(problem)
      , halfedges_(problem.halfedges)
      , cut_(cut)
      , labels_(problem.mesh.number_of_vertices())
      , cell_labels_(problem.mesh.number_of_vertices())
      , cell_of_(problem.mesh.number_of_vertices(), no_index)
      , places_(problem.halfedges.size()) {}

  /// the paths that are shorter than their arcs, the greatest gains first.
  std::vector<Arc_proposal> find(const Disk_boundary& boundary) {
    boundary_ = &boundary;
    for(Index k = 0; k < boundary.size(); ++k)
      boundary.for_each_in_corner(k, [&](Index h) { places_[h] = k; });
    arcs_ = boundary.arcs([&](Index h) { return places_[h]; });
    number_groups();
    label_vertices();
    collect_cells();
    collect_chords();
    std::vector<Arc_proposal> proposals;
    for(std::size_t a = 0; a < arcs_.size(); ++a)
      if(!arcs_[a].is_kept)
        propose(a, proposals);
    labels_.clear();
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
    most_ = 0.;
    for(std::size_t a = 0; a < arcs_.size(); ++a) {
      const Cut_arc& arc = arcs_[a];
      most_ = (std::max)(most_, arc.is_kept ? 0. : arc.length);
      for(const auto& [first, last] :
          {std::make_pair(arc.first, arc.last), std::make_pair(arc.twin_first, arc.twin_last)})
      {
        group_[first] = first;
        for(Index k = next_place(first); k != last; k = next_place(k)) {
          group_[k] = n + first;
          arc_of_place_[k] = static_cast<Index>(a);
        }
      }
    }
  }

  Index next_place(Index k) const { return k + 1 == boundary_->size() ? 0 : k + 1; }
  Index places_from(Index k, Index l) const { return l >= k ? l - k : l + boundary_->size() - k; }

  // On which side of the annulus a place is that there is without the arc; 0 if it is on the arc.
  int side(const Cut_arc& arc, Index k) const {
    if(places_from(arc.last, k) <= places_from(arc.last, arc.twin_first))
      return 1;
    if(places_from(arc.twin_last, k) <= places_from(arc.twin_last, arc.first))
      return 2;
    return 0;
  }

  // ---- the nearest places

  bool is_on_cut(Index v) const { return cut_.degree(v) != 0; }

  void label_vertices() {
    for(Index k = 0; k < boundary_->size(); ++k)
      boundary_->for_each_in_corner(k, [&](Index h) {
        if(!cut_.contains(h) && !is_on_cut(halfedges_.target(h)))
          relax(labels_, h, {0., k}, most_);
      });
    labels_.grow([&](Index v) {
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        if(!is_on_cut(halfedges_.target(h)))
          relax(labels_, h, labels_[v], most_);
    });
  }

  // Passes on the nearest place along a halfedge.
  void relax(Shortest_paths<Label>& labels, Index h, const Label& from, double most) {
    const Index v = halfedges_.target(h);
    const double d = from.distance + problem_.weight[h];
    if(!problem_.is_avoided(h) && 2. * d < most && d < labels[v].distance)
      labels.reach(v, {d, from.place, h});
  }

  // By arc, the vertices that are nearest to it, and those on it.
  void collect_cells() {
    cells_.assign(arcs_.size(), {});
    for(const Index v : labels_.reached())
      if(arc_of_place_[labels_[v].place] != no_index)
        cells_[arc_of_place_[labels_[v].place]].push_back(v);
    for(std::size_t a = 0; a < arcs_.size(); ++a) {
      for(Index k = next_place(arcs_[a].first); k != arcs_[a].last; k = next_place(k))
        cells_[a].push_back(boundary_->vertex(k));
      for(const Index v : cells_[a])
        cell_of_[v] = static_cast<Index>(a);
    }
  }

  // The nearest place to the vertex to which a halfedge leads, as seen from there.
  Label label_at_end(Index h) const {
    const Index v = halfedges_.target(h);
    return is_on_cut(v) ? Label{0., places_[halfedges_.twin(h)], no_index} : labels_[v];
  }

  void collect_chords() {
    chords_.clear();
    for(const Index v : labels_.reached())
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        if(is_on_cut(halfedges_.target(h)) || v < halfedges_.target(h))
          add_chord(h);
    for(Index k = 0; k < boundary_->size(); ++k)
      boundary_->for_each_in_corner(k, [&](Index h) {
        if(!cut_.contains(h) && is_on_cut(halfedges_.target(h)) && h < halfedges_.twin(h))
          add_chord(h);
      });
    const auto key = [](const Chord& c) {
      return std::tie(c.from_group, c.to_group, c.length, c.halfedge);
    };
    std::sort(chords_.begin(), chords_.end(),
              [&](const Chord& a, const Chord& b) { return key(a) < key(b); });
    chords_.erase(std::unique(chords_.begin(), chords_.end(),
                              [](const Chord& a, const Chord& b) {
                                return a.from_group == b.from_group && a.to_group == b.to_group;
                              }),
                  chords_.end());
    std::sort(chords_.begin(), chords_.end(), [](const Chord& a, const Chord& b) {
      return std::tie(a.length, a.halfedge) < std::tie(b.length, b.halfedge);
    });
  }

  void add_chord(Index h) {
    const Label a = label_at_end(halfedges_.twin(h)), b = label_at_end(h);
    if(b.place == no_index || problem_.is_avoided(h))
      return;
    const double length = a.distance + problem_.weight[h] + b.distance;
    Index from = a.place, to = b.place;
    if(group_[from] == group_[to] || length >= most_)
      return;
    if(group_[from] > group_[to])
      std::swap(from, to);
    chords_.push_back({group_[from], group_[to], length, h, from, to});
  }

  // ---- one arc

  void propose(std::size_t a, std::vector<Arc_proposal>& proposals) {
    const Cut_arc& arc = arcs_[a];
    double best = (1. - 1e-9) * arc.length;
    Index way = no_index;
    for(const Chord& c : chords_) {
      if(c.length >= best)
        break;
      const int from = side(arc, c.from), to = side(arc, c.to);
      if(from != 0 && to != 0 && from != to) {
        best = c.length;
        way = c.halfedge;
      }
    }
    label_cell(a, best);
    for(const Index v : cells_[a])
      for(Index h = halfedges_.begin(v); h < halfedges_.end(v); ++h)
        find_way(a, h, best, way);
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
          if(label.place != no_index)
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
    if(from.place == no_index || to.place == no_index || problem_.is_avoided(h))
      return;
    const double length = from.distance + problem_.weight[h] + to.distance;
    if(length < best && side(arcs_[a], from.place) != side(arcs_[a], to.place)) {
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
  double most_ = 0.;                           // no way is longer
  Shortest_paths<Label> labels_, cell_labels_; // by vertex
  std::vector<std::vector<Index>> cells_;      // by arc
  std::vector<Index> cell_of_;                 // by vertex
  std::vector<Index> places_;                  // by halfedge that leaves a vertex of the cut
  std::vector<Chord> chords_;
};

/*!
Makes a cut shorter: arcs give way to shorter paths, whose ends may be anywhere on the cut, as long
as each component still opens to one disk. That is decided by counting alone: the boundary is one
cycle, and the numbers of vertices and edges of the cut differ by as much as before.
*/
class Cut_shortening
{
public:
  Cut_shortening(const Cut_problem& problem, Cut_graph& cut)
      : problem_(problem)
      , halfedges_(problem.halfedges)
      , cut_(cut)
      , exchange_(problem, cut) {}

  /// until no arc can be replaced by a shorter one.
  void run() {
    std::vector<char> is_done(problem_.mesh.seeds.size(), 0);
    for(Index h = 0; h < halfedges_.size(); ++h) {
      char& done = is_done[problem_.mesh.component[halfedges_.source(h)]];
      if(cut_.contains(h) && !done) {
        done = 1;
        shorten_component(h);
      }
    }
  }

private:
  struct Change
  {
    Index halfedge;
    bool is_inserted;
  };

  static constexpr int most_rounds = 40;

  void shorten_component(Index some_halfedge) {
    some_halfedge_ = some_halfedge;
    for(int round = 0; round < most_rounds; ++round) {
      const Disk_boundary boundary(problem_, cut_, some_halfedge_);
      edges_ = boundary.size() / 2;
      bool is_shorter = false;
      for(const Arc_proposal& proposal : exchange_.find(boundary))
        is_shorter = accept(boundary, proposal) || is_shorter;
      if(!is_shorter)
        return;
    }
  }

  void erase(Index h) {
    cut_.erase(h);
    note_erased(h);
  }
  void note_erased(Index h) {
    --edges_;
    excess_ -= excess_of(h);
    changes_.push_back({h, false});
  }
  void insert(Index h) {
    ++edges_;
    excess_ += excess_of(h);
    cut_.insert(h);
    changes_.push_back({h, true});
  }

  // Of an edge that is not in the cut: one, less the vertices that come with it.
  int excess_of(Index h) const {
    return 1 - (cut_.degree(halfedges_.source(h)) == 0) - (cut_.degree(halfedges_.target(h)) == 0);
  }

  // Other arcs may have changed since the proposal was made.
  bool accept(const Disk_boundary& boundary, const Arc_proposal& proposal) {
    changes_.clear();
    excess_ = 0;
    const Cut_arc& arc = exchange_.arcs()[proposal.arc];
    for(Index k = arc.first; k != arc.last; k = k + 1 == boundary.size() ? 0 : k + 1)
      if(cut_.contains(boundary[k]))
        erase(boundary[k]);
    for(const Index h : proposal.path)
      if(!cut_.contains(h))
        insert(h);
    for(const Index v : {boundary.vertex(arc.first), boundary.vertex(arc.last)})
      prune(v);
    for(const Index h : proposal.path)
      for(const Index v : {halfedges_.source(h), halfedges_.target(h)})
        prune(v);
    if(passes_cones() && gain() > 1e-12 * arc.length && opens_to_disk(proposal.path.front()))
      return true;
    undo();
    return false;
  }

  void prune(Index v) {
    cut_.prune(v, [&](Index h) { note_erased(h); });
  }

  bool passes_cones() const {
    for(const Change& change : changes_)
      for(const Index v : {halfedges_.source(change.halfedge), halfedges_.target(change.halfedge)})
        if(problem_.is_cone(v) && cut_.degree(v) == 0)
          return false;
    return true;
  }

  double gain() const {
    double sum = 0.;
    for(const Change& change : changes_)
      sum +=
          change.is_inserted ? -problem_.weight[change.halfedge] : problem_.weight[change.halfedge];
    return sum;
  }

  bool opens_to_disk(Index some_halfedge) {
    if(excess_ != 0 || !cut_.contains(some_halfedge))
      return false;
    std::size_t corners = 0;
    Index h = some_halfedge;
    do {
      ++corners;
      h = cut_.following(h);
    } while(h != some_halfedge && corners <= 2 * edges_);
    const bool is_disk = corners == 2 * edges_;
    if(is_disk) // else it is taken out again
      some_halfedge_ = some_halfedge;
    return is_disk;
  }

  void undo() {
    const std::vector<Change> changes = changes_;
    for(auto change = changes.rbegin(); change != changes.rend(); ++change)
      if(change->is_inserted)
        erase(change->halfedge);
      else
        insert(change->halfedge);
  }

  const Cut_problem& problem_;
  const Flat_halfedges& halfedges_;
  Cut_graph& cut_;
  Arc_exchange exchange_;
  Index some_halfedge_ = no_index; // of the cut of the component
  std::size_t edges_ = 0;          // of the cut of the component
  std::vector<Change> changes_;    // the last ones
  int excess_ = 0;                 // of the edges that they add over the vertices
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_SHORTENING_H
