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
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

  /// of loops that are a basis.
  Loop_sides sides(const std::vector<Crossing_loop>& loops, const Loop_relations& relations) const {
    return {std::make_shared<const Loop_classes>(execution_, mesh_, loops), relations};
  }

  /// changes the pairs. Returns, for each handle and tunnel in turn, the number that the loop had
  /// before, or `no_index` if it is new.
  std::vector<Index> run(std::vector<Flat_pair>& pairs, const Loop_relations& relations) {
    return run(pairs, relations.components, sides(loops_of(pairs), relations));
  }

  /// the same, if the sides of the loops are known; \p components are those of the loops.
  std::vector<Index> run(std::vector<Flat_pair>& pairs,
                         const std::vector<std::size_t>& components,
                         std::optional<Loop_sides> sides) {
    loops_ = loops_of(pairs);
    choose(components, *sides);
    sides.reset(); // they are large
    std::vector<Index> sources(loops_.size());
    std::iota(sources.begin(), sources.end(), Index(0));
    for(const Basis& basis : bases_)
      make(basis, pairs, sources);
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

  // A place for a loop of a class for which there is none yet.
  struct Made_loop
  {
    Crossing_loop* loop;
    const Class_vector* coordinates;
  };

  // Of the pairs of one component, which have these numbers.
  struct Basis
  {
    std::vector<Index> numbers;
    std::vector<Member> handles, tunnels;
  };

  void choose(const std::vector<std::size_t>& components, const Loop_sides& sides) {
    std::map<std::size_t, std::vector<Index>> pairs_of_component;
    weights_.clear();
    for(const Crossing_loop& loop : loops_)
      weights_.push_back(double(loop.size()));
    is_pure_.assign(loops_.size() / 2, 0);
    for(Index k = 0; k < is_pure_.size(); ++k)
      if(sides.is_decided(2 * k))
        pairs_of_component[components[2 * k]].push_back(k);
    bases_.clear();
    projected_.clear();
    for(auto& [component, numbers] : pairs_of_component)
      choose(std::move(numbers), sides);
  }

  void choose(std::vector<Index> numbers, const Loop_sides& sides) {
    std::optional<std::vector<Member>> handles = basis(numbers, sides, true);
    std::optional<std::vector<Member>> tunnels = basis(numbers, sides, false);
    if(!handles || !tunnels || !pair_up(*handles, *tunnels, sides.classes()))
      return;
    for(Index k : numbers)
      is_pure_[k] = 1;
    bases_.push_back({std::move(numbers), *std::move(handles), *std::move(tunnels)});
  }

  void make(const Basis& basis, std::vector<Flat_pair>& pairs, std::vector<Index>& sources) {
    std::vector<Made_loop> made;
    const auto put = [&](const Member& m, Index number, Crossing_loop& loop) {
      sources[number] = m.loop;
      if(m.loop == no_index)
        made.push_back({&loop, &m.coordinates});
      else
        loop = loops_[m.loop];
    };
    for(std::size_t n = 0; n < basis.numbers.size(); ++n) {
      const Index k = basis.numbers[n];
      put(basis.handles[n], 2 * k, pairs[k].handle);
      put(basis.tunnels[n], 2 * k + 1, pairs[k].tunnel);
    }
    if(!made.empty())
      make(made);
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
          std::optional<Class_vector> part =
              sides.classes().class_with(sides.numbers_of_part(i, inside));
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
    Lattice_reduction(*others, weights_).reduce();
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
        sum += crossings_of_sum(loops_, m.coordinates);
    return sum;
  }

  // In crossings, to tighten all loops that are put together.
  double work() const { return work_by_face * double(mesh_.number_of_faces()); }

  // Puts the tunnels into the order of the handles. Returns `false` if a number became too large.
  bool pair_up(const std::vector<Member>& handles,
               std::vector<Member>& tunnels,
               const Loop_classes& classes) const {
    const Index n = static_cast<Index>(handles.size());
    std::unordered_map<Index, Class_vector> tunnels_with; // by loop
    for(Index j = 0; j < n; ++j)
      for(const auto& [loop, factor] : tunnels[j].coordinates)
        tunnels_with[loop].emplace_back(j, factor);
    std::vector<Class_vector> crossings(n); // of a handle with the tunnels
    for(Index i = 0; i < n; ++i) {
      for(const auto& [loop, number] : classes.numbers_of_class(handles[i].coordinates))
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

  void make(const std::vector<Made_loop>& made) {
    if(coarse_ != nullptr && projected_.empty())
      project_loops();
    const Flat_mesh& mesh = coarse_ == nullptr ? mesh_ : coarse_->mesh;
    Workspace_pool<Loop_sum> sums(
        [&] { return std::make_unique<Loop_sum>(mesh, coarse_ == nullptr ? loops_ : projected_); });
    for_each_made(made, [&](const Made_loop& m) { *m.loop = sums.borrow()->loop(*m.coordinates); });
    double crossings = 0.; // a loop has more, until it is straight, than it is made of
    for(const Made_loop& m : made)
      crossings += (std::min)(double(m.loop->size()), crossings_of_sum(loops_, *m.coordinates));
    is_any_loose_ = is_any_loose_ || Loop_tightening::is_too_much(work(), crossings);
    for_each_made(made, [&](const Made_loop& m) {
      if(do_tighten_)
        Loop_tightening(execution_, mesh).tighten_among(*m.loop, work(), crossings);
      if(coarse_ != nullptr) {
        *m.loop = coarse_->lifted(*m.loop);
        Loop_tightening(execution_, mesh_).straighten(*m.loop);
      }
    });
  }

  template <typename Function>
  void for_each_made(const std::vector<Made_loop>& made, const Function& f) {
    for_each_index(
        execution_, made.size(),
        [&](std::size_t i) {
          if(progress_.goes_on())
            f(made[i]);
        },
        1);
    progress_.throw_if_interrupted();
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const Coarse_mesh* coarse_;
  bool do_tighten_;
  Progress& progress_;
  std::vector<Crossing_loop> loops_;     // before
  std::vector<double> weights_;          // of them
  std::vector<Crossing_loop> projected_; // on the coarse mesh, once one is to be made there
  bool is_any_loose_ = false;
  std::vector<Basis> bases_; // by component, where they are known
  std::vector<char> is_pure_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_PURIFICATION_H
