// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_PURIFICATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_PURIFICATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_lattice.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Closed walks of given classes: loops one after the other, each as often as it is asked for,
/// joined by paths with few edges, there and back. A workspace that can be used again.
class Loop_sum
{
public:
  Loop_sum(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : mesh_(mesh)
      , loops_(loops)
      , labels_(mesh.number_of_vertices()) {}

  /// a closed walk of the class with these coordinates in the loops, which lie on one component.
  std::vector<Index> walk(const Class_vector& coordinates) {
    CGAL_precondition(!coordinates.empty());
    walks_.clear();
    for(const auto& [i, factor] : coordinates)
      walks_.push_back(repeated(left_side(loops_[i], factor > 0), std::abs(factor)));
    join_all();
    std::vector<Index> all = std::move(walks_[joined(0)]);
    remove_spurs(all);
    return all;
  }

private:
  static std::vector<Index> left_side(const Crossing_loop& loop, bool forward) {
    std::vector<Index> walk;
    for(const Crossing& c : loop)
      if(walk.empty() || walk.back() != c.left)
        walk.push_back(c.left);
    while(walk.size() > 1 && walk.back() == walk.front())
      walk.pop_back();
    if(!forward)
      std::reverse(walk.begin(), walk.end());
    return walk;
  }

  static std::vector<Index> repeated(const std::vector<Index>& walk, std::int64_t number) {
    std::vector<Index> result;
    for(std::int64_t i = 0; i < number; ++i)
      result.insert(result.end(), walk.begin(), walk.end());
    return result;
  }

  // How a vertex is reached, and from which walk.
  struct Label
  {
    Index parent = no_index;
    Index walk = no_index;
  };

  // The walks as a forest, whose trees are those that have been joined.
  struct Node
  {
    Index parent;
    Index height = 0;
  };

  // Joins walks where the regions meet that grow around them, the nearest to each other first: by
  // the number of edges, since what is joined is tightened anyway.
  void join_all() {
    nodes_.clear();
    for(Index w = 0; w < walks_.size(); ++w)
      nodes_.push_back({w});
    std::size_t parts = walks_.size();
    for(Index w = 0; w < walks_.size(); ++w)
      for(Index v : std::vector<Index>(walks_[w]))
        if(labels_[v].walk == no_index)
          reach(v, {no_index, w});
        else
          parts -= join(v, v, labels_[v].walk, w);
    for(std::size_t i = 0; parts > 1; ++i) {
      CGAL_assertion_msg(i < reached_.size(), "the loops of a class lie on one component");
      const Index v = reached_[i];
      for(Index u : mesh_.ring(v))
        if(labels_[u].walk == no_index)
          reach(u, {v, labels_[v].walk});
        else
          parts -= join(v, u, labels_[v].walk, labels_[u].walk);
    }
    for(Index v : reached_)
      labels_[v] = Label();
    reached_.clear();
  }

  // Joins the walks of which `a` and `b` have become parts, where `u` and `v` have been reached
  // from these. Returns whether they were two.
  bool join(Index u, Index v, Index a, Index b) {
    a = joined(a);
    b = joined(b);
    if(a == b)
      return false;
    std::vector<Index> way = way_back(u); // to a walk
    std::reverse(way.begin(), way.end());
    if(u != v) {
      const std::vector<Index> other_way = way_back(v);
      way.insert(way.end(), other_way.begin(), other_way.end());
    }
    if(nodes_[a].height <= nodes_[b].height) {
      std::swap(a, b);
      std::reverse(way.begin(), way.end());
    }
    nodes_[b].parent = a;
    nodes_[a].height = (std::max)(nodes_[a].height, nodes_[b].height + 1);
    splice(walks_[a], way, walks_[b]);
    return true;
  }

  // The walk that has become the one of all in its tree.
  Index joined(Index w) const {
    while(nodes_[w].parent != w)
      w = nodes_[w].parent;
    return w;
  }

  // Leads a walk along a way that begins on it, around another walk at its end, and back.
  static void
  splice(std::vector<Index>& walk, const std::vector<Index>& way, std::vector<Index>& around) {
    std::rotate(around.begin(), std::find(around.begin(), around.end(), way.back()), around.end());
    std::vector<Index> detour(way.begin(), way.end() - 1);
    detour.insert(detour.end(), around.begin(), around.end());
    detour.insert(detour.end(), way.rbegin(), way.rend() - 1);
    walk.insert(std::find(walk.begin(), walk.end(), way.front()), detour.begin(), detour.end());
  }

  void reach(Index v, const Label& label) {
    reached_.push_back(v);
    labels_[v] = label;
  }

  std::vector<Index> way_back(Index v) const {
    std::vector<Index> way;
    for(; v != no_index; v = labels_[v].parent)
      way.push_back(v);
    return way;
  }

  const Flat_mesh& mesh_;
  const std::vector<Crossing_loop>& loops_;
  std::vector<Label> labels_; // by vertex
  std::vector<Index> reached_;
  std::vector<std::vector<Index>> walks_; // those that have been joined are at the root
  std::vector<Node> nodes_;               // by walk
};

/*!
From any basis in pairs to one in which all handles bound inside and all tunnels outside, on every
component for which that is known. What bounds already is kept. The other loops are projected to
L_in and to L_out; a basis of each is chosen from the projections, and loops of these classes are
made of those that there are.

Then handles and tunnels are paired so that each pair crosses once. Should there be no such pairing,
which unimodularity alone does not exclude, the tunnels become the dual basis of the handles.
*/
class Purification
{
public:
  /// Loops are put together on a coarse mesh, if there is one.
  Purification(Execution execution,
               const Flat_mesh& mesh,
               bool do_tighten,
               Progress& progress,
               const Coarse_mesh* coarse = nullptr)
      : execution_(execution)
      , mesh_(mesh)
      , coarse_(coarse)
      , do_tighten_(do_tighten)
      , progress_(progress) {}

  /// changes the pairs. Returns, for each handle and tunnel in turn, the number that the loop had
  /// before, or `no_index` if it is new.
  std::vector<Index> run(std::vector<Flat_pair>& pairs, const Loop_relations& relations) {
    loops_ = loops_of(pairs);
    classes_ = std::make_unique<Loop_classes>(mesh_, loops_);
    const Loop_sides sides(*classes_, relations);
    std::map<std::size_t, std::vector<Index>> pairs_of_component;
    is_pure_.assign(pairs.size(), 0);
    for(Index k = 0; k < pairs.size(); ++k) {
      is_pure_[k] = sides.is_decided(2 * k);
      if(is_pure_[k])
        pairs_of_component[relations.components[2 * k]].push_back(k);
    }
    std::vector<Index> sources(loops_.size());
    std::iota(sources.begin(), sources.end(), Index(0));
    for(const auto& [component, numbers] : pairs_of_component)
      purify(numbers, sides, pairs, sources);
    return sources;
  }

  /// whether loops have been put together that are so long, all of them, that there was too much
  /// to do to tighten each.
  bool is_any_loose() const { return is_any_loose_; }

  /// by pair, whether both loops bound on their sides now.
  const std::vector<char>& is_pure() const { return is_pure_; }

  static std::vector<Crossing_loop> loops_of(const std::vector<Flat_pair>& pairs) {
    std::vector<Crossing_loop> loops;
    for(const Flat_pair& pair : pairs) {
      loops.push_back(pair.handle);
      loops.push_back(pair.tunnel);
    }
    return loops;
  }

private:
  static constexpr double work_by_face = 128.;

  // A loop of the basis, or a class for which there is none yet.
  struct Member
  {
    Index loop; // or `no_index`
    Class_vector coordinates;
  };

  static Member member(Index i) { return {i, {{i, 1}}}; }

  // The pairs of one component.
  void purify(const std::vector<Index>& numbers,
              const Loop_sides& sides,
              std::vector<Flat_pair>& pairs,
              std::vector<Index>& sources) {
    std::optional<std::vector<Member>> handles = basis(numbers, sides, true);
    std::optional<std::vector<Member>> tunnels = basis(numbers, sides, false);
    if(!handles || !tunnels || !pair_up(*handles, *tunnels)) {
      for(Index k : numbers)
        is_pure_[k] = 0;
      return;
    }
    const auto is_made = [](const Member& m) { return m.loop == no_index; };
    if(coarse_ != nullptr && projected_.empty() &&
       (std::any_of(handles->begin(), handles->end(), is_made) ||
        std::any_of(tunnels->begin(), tunnels->end(), is_made)))
      project_loops();
    crossings_to_make_ = crossings_of_made(*handles) + crossings_of_made(*tunnels);
    is_any_loose_ = is_any_loose_ || Loop_tightening::is_too_much(work(), crossings_to_make_);
    Workspace_pool<Loop_sum> sums([this] {
      return coarse_ == nullptr ? std::make_unique<Loop_sum>(mesh_, loops_)
                                : std::make_unique<Loop_sum>(coarse_->mesh, projected_);
    });
    for_each_index(
        execution_, numbers.size(),
        [&](std::size_t n) {
          if(!progress_.goes_on())
            return;
          const Index k = numbers[n];
          const Member &handle = (*handles)[n], &tunnel = (*tunnels)[n];
          pairs[k] = {loop_of(handle, sums), loop_of(tunnel, sums)};
          sources[2 * k] = handle.loop;
          sources[2 * k + 1] = tunnel.loop;
        },
        1);
    progress_.throw_if_interrupted();
  }

  // A basis of L_in or of L_out of a component, first of all the loops that bound; nothing if a
  // number became too large.
  std::optional<std::vector<Member>>
  basis(const std::vector<Index>& numbers, const Loop_sides& sides, bool inside) const {
    std::vector<Member> members;
    std::vector<Class_vector> generators;
    const auto bounds = [&](Index i, bool in) {
      return in ? sides.bounds_inside(i) : sides.bounds_outside(i);
    };
    for(Index k : numbers)
      for(Index i : {2 * k, 2 * k + 1})
        if(bounds(i, inside))
          members.push_back(member(i));
        else if(!bounds(i, !inside)) {
          std::optional<Class_vector> part = classes_->class_with(sides.numbers_of_part(i, inside));
          if(!part)
            return std::nullopt;
          // Modulo the loops that bound already.
          part->erase(std::remove_if(part->begin(), part->end(),
                                     [&](const auto& c) { return bounds(c.first, inside); }),
                      part->end());
          generators.push_back(std::move(*part));
        }
    std::optional<std::vector<Class_vector>> others = lattice_basis(std::move(generators));
    if(!others)
      return std::nullopt;
    std::vector<double> weights;
    for(const Crossing_loop& loop : loops_)
      weights.push_back(double(loop.size()));
    Lattice_reduction(*others, weights).reduce();
    for(Class_vector& a : *others)
      members.push_back({no_index, std::move(a)});
    // The rank is g, but for surfaces that cross themselves in such a way that no loop shows it.
    if(members.size() != numbers.size() || !can_be_made(members))
      return std::nullopt;
    return members;
  }

  // Whether the loops that are to be put together are of a size that any computer can hold.
  bool can_be_made(const std::vector<Member>& members) const {
    constexpr double most_crossings = 5e7;
    return crossings_of_made(members) <= most_crossings;
  }

  // How many, about, the loops have that are to be put together.
  double crossings_of_made(const std::vector<Member>& members) const {
    double sum = 0.;
    for(const Member& m : members)
      if(m.loop == no_index)
        for(const auto& [i, factor] : m.coordinates)
          sum += std::abs(double(factor)) * double(loops_[i].size());
    return sum;
  }

  // In crossings, to tighten all loops that are put together.
  double work() const { return work_by_face * double(mesh_.number_of_faces()); }

  // Puts the tunnels into the order of the handles. Returns `false` if a number became too large.
  bool pair_up(const std::vector<Member>& handles, std::vector<Member>& tunnels) const {
    const Index n = static_cast<Index>(handles.size());
    std::vector<Class_vector> tunnels_with(loops_.size()); // by loop
    for(Index j = 0; j < n; ++j)
      for(const auto& [loop, factor] : tunnels[j].coordinates)
        tunnels_with[loop].emplace_back(j, factor);
    std::vector<Class_vector> crossings(n); // of a handle with the tunnels
    for(Index i = 0; i < n; ++i) {
      for(const auto& [loop, number] : classes_->numbers_of_class(handles[i].coordinates))
        for(const auto& [j, factor] : tunnels_with[loop])
          crossings[i].emplace_back(j, number * factor);
      normalize(crossings[i]);
    }
    Pairing pairing(n);
    for(Index i = 0; i < n; ++i)
      if(!pairing.augment(
             i, [&](Index row) { return partners(handles[row], crossings[row], tunnels); }))
        return make_dual(std::move(crossings), tunnels);
    std::vector<Member> ordered;
    for(Index i = 0; i < n; ++i)
      ordered.push_back(tunnels[pairing.column_of(i)]);
    tunnels = std::move(ordered);
    return true;
  }

  // The tunnels that cross a handle once, that of the same pair first.
  static std::vector<Index> partners(const Member& handle,
                                     const Class_vector& crossings,
                                     const std::vector<Member>& tunnels) {
    std::vector<Index> found;
    for(const auto& [j, number] : crossings)
      if(std::abs(number) == 1)
        found.push_back(j);
    std::stable_partition(found.begin(), found.end(), [&](Index j) {
      return handle.loop != no_index && tunnels[j].loop != no_index &&
             tunnels[j].loop / 2 == handle.loop / 2;
    });
    return found;
  }

  // Replaces the tunnels by classes that cross one handle each, and that once.
  bool make_dual(std::vector<Class_vector> crossings, std::vector<Member>& tunnels) const {
    const Unimodular_system system(std::move(crossings));
    if(!system.is_regular())
      return false;
    std::vector<Member> duals;
    for(Index i = 0; i < tunnels.size(); ++i) {
      const std::optional<Class_vector> solution = system.solve({{i, 1}});
      duals.push_back({no_index, {}});
      if(!solution)
        return false;
      for(const auto& [j, factor] : *solution)
        if(!add_multiple(duals.back().coordinates, factor, tunnels[j].coordinates))
          return false;
    }
    tunnels = std::move(duals);
    return can_be_made(tunnels);
  }

  void project_loops() {
    projected_.resize(loops_.size());
    for_each_index(
        execution_, projected_.size(),
        [&](std::size_t i) { projected_[i] = coarse_->projected(loops_[i]); }, 16);
  }

  Crossing_loop loop_of(const Member& m, Workspace_pool<Loop_sum>& sums) const {
    if(m.loop != no_index)
      return loops_[m.loop];
    const std::vector<Index> walk = sums.borrow()->walk(m.coordinates);
    const Flat_mesh& mesh = coarse_ == nullptr ? mesh_ : coarse_->mesh;
    Crossing_loop loop = pushed_left(mesh, walk);
    if(do_tighten_)
      Loop_tightening(execution_, mesh).tighten_among(loop, work(), crossings_to_make_);
    if(coarse_ != nullptr) {
      loop = coarse_->lifted(loop);
      Loop_tightening(execution_, mesh_).straighten(loop);
    }
    return loop;
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const Coarse_mesh* coarse_;
  bool do_tighten_;
  Progress& progress_;
  std::vector<Crossing_loop> loops_;     // before
  std::vector<Crossing_loop> projected_; // on the coarse mesh, once one is to be made there
  double crossings_to_make_ = 0.;
  bool is_any_loose_ = false;
  std::unique_ptr<Loop_classes> classes_;
  std::vector<char> is_pure_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_PURIFICATION_H
