// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_BOUNDING_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_BOUNDING_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Bounding_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Search_ground.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Puts short loops that bound on one side in the place of loops of any basis, which need not bound.

On which side a class bounds shows before there is a basis of such classes. Let r be a class with
random coordinates, and r_in and r_out its parts in L_in and L_out. A class x is in L_in exactly if
its intersection number with r_in is zero, but for chance, since L_in is its own annihilator. That
is a sum over what x crosses of the coordinates of r_in: so weights of the loops, once found, tell
it of any walk. Every loop that does not bound on both sides crosses some loop of the basis, so
walks are looked for from the vertices along these (`Bounding_walks`).

The shortest walk of each class is tightened; then, the shortest first, each takes the place of the
longest loop that can be replaced by it. Coordinates are exact, and so is what is known of the
sides.
*/
class Bounding_loops
{
public:
  /// The levels of the ground, which is of the mesh, have been prepared.
  Bounding_loops(Execution execution,
                 const Flat_mesh& mesh,
                 Search_ground& ground,
                 Progress& progress)
      : execution_(execution)
      , mesh_(mesh)
      , ground_(ground)
      , progress_(progress)
      , sums_([] { return std::make_unique<Sparse_sum<std::int64_t>>(); }) {}

  /// changes loops, which are a basis with these sides, and makes `sources` of those that have been
  /// replaced `no_index`. Returns their sides then; nothing, and nothing is changed, if there are
  /// none to be replaced, or a number became too large.
  std::optional<Loop_sides>
  take(std::vector<Crossing_loop>& loops, const Loop_sides& sides, std::vector<Index>& sources) {
    if(!sides.is_any_decided())
      return std::nullopt;
    const Loop_classes& classes = sides.classes();
    ground_.prepare(execution_, {}, loops, classes.edge_crossings(), weights(sides));
    Changing_basis basis(mesh_, classes, loops);
    exchange(candidates(classes), basis);
    if(std::find(basis.is_new.begin(), basis.is_new.end(), 1) == basis.is_new.end())
      return std::nullopt;
    std::optional<Loop_sides> changed =
        sides.of_basis(basis.exchange.members(),
                       std::make_shared<const Loop_classes>(execution_, mesh_, basis.loops));
    if(changed) {
      loops = std::move(basis.loops);
      for(std::size_t i = 0; i < loops.size(); ++i)
        sources[i] = basis.is_new[i] ? no_index : sources[i];
    }
    return changed;
  }

  /// whether through each vertex along the loops a short one of each kind was found.
  bool are_there_all() const { return are_there_all_; }

private:
  struct Changing_basis
  {
    Changing_basis(const Flat_mesh& mesh,
                   const Loop_classes& classes,
                   const std::vector<Crossing_loop>& all)
        : loops(all)
        , is_new(all.size(), 0)
        , exchange(classes) {
      for(const Crossing_loop& loop : loops)
        lengths.push_back(length(mesh, loop));
    }

    std::vector<Crossing_loop> loops;
    std::vector<double> lengths;
    std::vector<char> is_new; // by loop
    Class_exchange exchange;
  };

  // What was seen of a candidate.
  struct Prospect
  {
    std::optional<Class_vector> coordinates; // at that time; none if they are too large
    Crossing_loop loop;                      // on the mesh, if it could take a place
  };

  // Of the sums of walks, by what they cross.
  static std::vector<Class_sums> weights(const Loop_sides& sides) {
    // Coordinates of the parts of a random class are to be below the prime. What is larger makes
    // sums that are never zero.
    constexpr int bits = 24;
    const Loop_classes& classes = sides.classes();
    std::mt19937_64 random;
    std::vector<Class_sums> weights(classes.size());
    for(const auto part : {&Class_sums::across, &Class_sums::along}) {
      std::vector<Residue> numbers(classes.size(), 0); // of the part of the class, with the basis
      for(Index i = 0; i < classes.size(); ++i) {
        const Residue factor = random() >> (64 - bits);
        if(sides.is_decided(i))
          for(const auto& [j, value] : sides.numbers_of_part(i, part == &Class_sums::across))
            numbers[j] = difference(numbers[j], product(factor, residue_of(-value)));
      }
      Class_vector numbers_of_part;
      for(Index j = 0; j < numbers.size(); ++j)
        if(numbers[j] != 0)
          numbers_of_part.emplace_back(j, smallest_integer_of(numbers[j]));
      classes.for_each_coordinate(numbers_of_part, [&](Index i, std::int64_t x) {
        weights[i].*part = static_cast<std::uint64_t>(x);
      });
    }
    return weights;
  }

  // On the ground: of each class the shortest that was found, and of these the shortest first.
  std::vector<Loop_candidate> candidates(const Loop_classes& classes) {
    const std::vector<Bounding_walk> walks = shortest_walks(vertices_along(classes.size()));
    std::vector<std::optional<Loop_candidate>> made(walks.size());
    for_each_index(
        execution_, walks.size(),
        [&](std::size_t i) {
          if(progress_.goes_on())
            made[i] = candidate(walks[i].vertices, classes);
        },
        1);
    progress_.throw_if_interrupted();
    std::vector<Loop_candidate> candidates;
    for(std::optional<Loop_candidate>& c : made)
      if(c)
        candidates.push_back(std::move(*c));
    std::stable_sort(candidates.begin(), candidates.end());
    return candidates;
  }

  std::optional<Loop_candidate> candidate(const std::vector<Index>& walk,
                                          const Loop_classes& classes) {
    if(walk.size() < 3)
      return std::nullopt;
    Crossing_loop loop = ground_.tightened(execution_, walk);
    Class_vector numbers = ground_.crossings().numbers(loop, *sums_.borrow());
    return Loop_candidate::of(ground_.mesh(), std::move(loop), std::move(numbers), classes);
  }

  // On the ground, at the nearer ends of the edges that the loops cross.
  std::vector<Index> vertices_along(std::size_t number_of_loops) const {
    std::vector<char> is_along(ground_.mesh().number_of_vertices(), 0);
    std::vector<Index> vertices;
    for(Index i = 0; i < number_of_loops; ++i)
      for(const Crossing& c : ground_.loop(i)) {
        const Index v = ratio_on_surface(ground_.mesh(), c) < 0.5 ? c.left : c.right;
        if(std::exchange(is_along[v], 1) == 0)
          vertices.push_back(v);
      }
    return vertices;
  }

  // From vertices that are far apart first, which leave few of those between them.
  std::vector<Bounding_walk> shortest_walks(const std::vector<Index>& roots) {
    constexpr std::size_t widest = 64;
    constexpr double least_complete = 0.25; // searches, for all others to be worth it
    const Search_mesh& mesh = ground_.levels()[0];
    Workspace_pool<Bounding_walks> searches([&] { return std::make_unique<Bounding_walks>(mesh); });
    std::vector<Bounding_walk> walks;
    std::vector<char> is_done(mesh.number_of_vertices(), 0);
    double searched = 0., complete = 0.;
    for(std::size_t step = widest; step != 0; step /= 2) {
      std::vector<Index> some;
      for(std::size_t i = 0; i < roots.size(); i += step)
        if(is_done[roots[i]] == 0)
          some.push_back(roots[i]);
      for(Bounding_walks::Finding& f : search_from(some, searches)) {
        ++searched;
        complete += f.is_complete;
        for(Index v : f.vertices)
          is_done[v] = 1;
        std::move(f.walks.begin(), f.walks.end(), std::back_inserter(walks));
      }
      keep_shortest(walks);
      if(step == widest && complete < least_complete * searched)
        return {};
    }
    are_there_all_ = searched == complete;
    return walks;
  }

  std::vector<Bounding_walks::Finding> search_from(const std::vector<Index>& roots,
                                                   Workspace_pool<Bounding_walks>& searches) const {
    std::vector<Bounding_walks::Finding> found(roots.size());
    for_each_index(
        execution_, roots.size(),
        [&](std::size_t i) {
          if(progress_.goes_on())
            found[i] = searches.borrow()->search(roots[i]);
        },
        16);
    return found;
  }

  static void keep_shortest(std::vector<Bounding_walk>& walks) {
    std::sort(walks.begin(), walks.end());
    walks.erase(std::unique(walks.begin(), walks.end(),
                            [](const Bounding_walk& a, const Bounding_walk& b) {
                              return a.is_of_same_class(b);
                            }),
                walks.end());
  }

  // The shortest first.
  void exchange(std::vector<Loop_candidate> candidates, Changing_basis& basis) const {
    constexpr std::size_t part = 256; // is looked at side by side
    std::vector<Prospect> prospects(part);
    for(std::size_t first = 0; first < candidates.size(); first += part) {
      const std::size_t number = (std::min)(part, candidates.size() - first);
      const Index exchanges_before = basis.exchange.number_of_exchanges();
      for_each_index(
          execution_, number,
          [&](std::size_t i) { prospects[i] = prospect(candidates[first + i], basis); }, 1);
      for(std::size_t i = 0; i < number; ++i)
        try_candidate(candidates[first + i], prospects[i], exchanges_before, basis);
    }
  }

  Prospect prospect(const Loop_candidate& c, const Changing_basis& basis) const {
    Prospect p = {basis.exchange.coordinates(c.coordinates), {}};
    if(p.coordinates && is_short_enough(c, *p.coordinates, basis))
      p.loop = ground_.on_mesh(execution_, c.loop);
    return p;
  }

  bool is_short_enough(const Loop_candidate& c,
                       const Class_vector& coordinates,
                       const Changing_basis& basis) const {
    return !replaceable(coordinates, ground_.least_on_mesh(c.length), basis.lengths).empty();
  }

  void try_candidate(const Loop_candidate& c,
                     Prospect& p,
                     Index exchanges_before,
                     Changing_basis& basis) const {
    if(p.coordinates)
      p.coordinates = basis.exchange.coordinates(std::move(*p.coordinates), exchanges_before);
    if(!p.coordinates || !is_short_enough(c, *p.coordinates, basis))
      return;
    if(p.loop.empty()) // it could not take any place before
      p.loop = ground_.on_mesh(execution_, c.loop);
    const double length_of_loop = length(mesh_, p.loop);
    const std::vector<Index> places = replaceable(*p.coordinates, length_of_loop, basis.lengths);
    if(places.empty())
      return;
    const Index i = places.front();
    basis.exchange.replace(i, c.coordinates, *p.coordinates);
    basis.loops[i] = std::move(p.loop);
    basis.lengths[i] = length_of_loop;
    basis.is_new[i] = 1;
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  Search_ground& ground_;
  Progress& progress_;
  bool are_there_all_ = false;
  Workspace_pool<Sparse_sum<std::int64_t>> sums_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_BOUNDING_LOOPS_H
