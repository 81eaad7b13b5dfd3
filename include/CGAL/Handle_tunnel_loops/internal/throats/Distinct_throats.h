// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_DISTINCT_THROATS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_DISTINCT_THROATS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Slipping.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/find_throats.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Which loops are throats, and which of these are one. Loops that slip off without becoming much
longer are none. Of loops of one class between which nothing is much longer the shortest remains;
and of those that cross each other the most prominent one, as the others go aslant.
*/
class Distinct_throats
{
public:
  /// \p basis is the family of loops by which classes are told; \p least_prominence is a part of the
  /// lengths.
  Distinct_throats(Execution execution,
                   const Flat_mesh& mesh,
                   const std::vector<Crossing_loop>& basis,
                   double least_prominence)
      : execution_(execution)
      , mesh_(mesh)
      , classes_(mesh, basis)
      , least_prominence_(least_prominence)
      , slippings_([&] { return std::make_unique<Slipping>(mesh); }) {
    std::mt19937_64 random;
    std::generate_n(std::back_inserter(names_), basis.size(), std::ref(random));
  }

  bool is_throat(const Flat_throat& loop) { return is_held(*slippings_.borrow(), loop); }

  /// the throats among tight loops.
  std::vector<Flat_throat> among(std::vector<Flat_throat> loops) {
    std::vector<Flat_throat> throats = one_of_each(without_sums(without_copies(std::move(loops))));
    for(Flat_throat& throat : throats)
      throat.prominence = std::numeric_limits<double>::infinity();
    find_prominences(throats, most_passes_of_fronts);
    return without_those_aslant(std::move(throats));
  }

  /// those that are throats of a coarse mesh. On the mesh itself it is looked at all of them as far
  /// as it goes in linear time.
  std::vector<Flat_throat> among_coarse_ones(std::vector<Flat_throat> throats) {
    throats = without_copies(std::move(throats));
    find_prominences(throats, most_passes_on_fine_mesh);
    throats.erase(std::remove_if(throats.begin(), throats.end(),
                                 [&](const Flat_throat& t) {
                                   return t.prominence < least_prominence_ && !is_wanted(t);
                                 }),
                  throats.end());
    return throats;
  }

private:
  /// until loops are how many times as long it is looked for a way on which they slip off.
  static constexpr double most_times = 4.;

  /// how often all fronts together pass all vertices at most, or what is known of a coarse mesh is
  /// taken.
  static constexpr std::size_t most_passes_of_fronts = 512, most_passes_on_fine_mesh = 16;

  // Where that takes too long they stay what they are.
  void find_prominences(std::vector<Flat_throat>& throats, std::size_t most_passes) {
    const std::size_t most_vertices =
        most_passes * mesh_.number_of_vertices() / (throats.size() + 1);
    for_each_index(
        execution_, throats.size(),
        [&](std::size_t i) {
          Flat_throat& t = throats[i];
          if(const auto prominence =
                 slippings_.borrow()->prominence(t.loop, t.length, most_times, most_vertices))
            t.prominence = *prominence;
        },
        1);
  }

  // From short ones to long ones. Many candidates become one loop when they are tightened: they
  // pass between the same vertices, if not all on the same side.
  std::vector<Flat_throat> without_copies(std::vector<Flat_throat> loops) const {
    constexpr double same = 0.5, as_long = 0.99;
    std::stable_sort(loops.begin(), loops.end(), [](const Flat_throat& a, const Flat_throat& b) {
      return a.length < b.length;
    });
    for_each_index(
        execution_, loops.size(), [&](std::size_t i) { name_class(loops[i]); }, 16);
    Loops_at at(mesh_.number_of_vertices());
    std::vector<Flat_throat> kept;
    for(Flat_throat& loop : loops) {
      const std::vector<Index> ends = ends_of(loop);
      Flat_throat* other = nullptr;
      for_each_met(ends, at, [&](Index k, double times) {
        if(other == nullptr && times >= same * double(ends.size()) &&
           kept[k].length >= as_long * loop.length && are_of_one_class(kept[k], loop))
          other = &kept[k];
      });
      if(other != nullptr) {
        other->through.insert(other->through.end(), loop.through.begin(), loop.through.end());
        continue;
      }
      for(const Index v : ends)
        at[v].push_back(static_cast<Index>(kept.size()));
      kept.push_back(std::move(loop));
    }
    return kept;
  }

  bool is_held(Slipping& slipping, const Flat_throat& loop) const {
    return slipping.is_held(loop.loop, loop.length, 1. + least_prominence_);
  }

  // Classes have random names, of which the sum of two is that of the sum. That of zero is 0.
  void name_class(Flat_throat& loop) const {
    loop.class_name = 0;
    for(const auto& [k, number] : classes_.intersections(loop.loop))
      loop.class_name += static_cast<std::uint64_t>(number) * names_[k];
  }

  // Up to the sense.
  static bool are_of_one_class(const Flat_throat& a, const Flat_throat& b) {
    return a.class_name == b.class_name || a.class_name + b.class_name == 0;
  }

  static std::vector<Index> left_ends(const Flat_throat& loop) {
    std::vector<Index> ends;
    for(const Crossing& c : loop.loop)
      ends.push_back(c.left);
    make_set(ends);
    return ends;
  }

  static std::vector<Index> ends_of(const Flat_throat& loop) {
    std::vector<Index> ends;
    for(const Crossing& c : loop.loop)
      ends.insert(ends.end(), {c.left, c.right});
    make_set(ends);
    return ends;
  }

  // It stays, whatever it is beside.
  static bool is_wanted(const Flat_throat& throat) { return !throat.through.empty(); }

  using Loops_at = std::vector<std::vector<Index>>; // by vertex

  // Calls f(loop, times) for the loops that are at some of these vertices, at how many.
  template <typename Function>
  static void
  for_each_met(const std::vector<Index>& vertices, const Loops_at& at, const Function& f) {
    std::vector<Index> met;
    for(const Index v : vertices)
      met.insert(met.end(), at[v].begin(), at[v].end());
    std::sort(met.begin(), met.end());
    for(auto it = met.begin(); it != met.end();) {
      const auto next = std::upper_bound(it, met.end(), *it);
      f(*it, static_cast<double>(next - it));
      it = next;
    }
  }

  // From short ones to long ones: one is another's if that lies between it and what is longer.
  std::vector<Flat_throat> one_of_each(const std::vector<Flat_throat>& loops) {
    Loops_at at(mesh_.number_of_vertices());
    for(Index i = 0; i < loops.size(); ++i)
      for(const Index v : left_ends(loops[i]))
        at[v].push_back(i);
    std::vector<char> is_throat(loops.size(), 0);
    std::vector<std::vector<Index>> in_place(loops.size());
    for_each_index(
        execution_, loops.size(),
        [&](std::size_t i) {
          const auto slipping = slippings_.borrow();
          is_throat[i] = is_held(*slipping, loops[i]);
          if(is_throat[i] != 0)
            in_place[i] = shorter_ones_in_place(*slipping, Index(i), loops, at);
        },
        1);
    std::vector<Flat_throat> throats;
    std::vector<char> is_kept(loops.size(), 0);
    for(std::size_t i = 0; i < loops.size(); ++i) {
      if(is_throat[i] == 0)
        continue;
      const bool is_anothers = std::any_of(in_place[i].begin(), in_place[i].end(), [&](Index j) {
        return is_kept[j] != 0 && are_of_one_class(loops[i], loops[j]);
      });
      is_kept[i] = !is_anothers || is_wanted(loops[i]);
      if(is_kept[i] != 0)
        throats.push_back(loops[i]);
    }
    return without_slides(throats);
  }

  // Of a whole family of loops that are equally short there may be several, far from each other.
  std::vector<Flat_throat> without_slides(std::vector<Flat_throat>& throats) {
    constexpr double as_long = 0.95;
    const auto slipping = slippings_.borrow();
    std::vector<Flat_throat> kept;
    for(Flat_throat& throat : throats) {
      if(is_wanted(throat) || std::none_of(kept.begin(), kept.end(), [&](const Flat_throat& k) {
           return k.length >= as_long * throat.length && are_of_one_class(throat, k) &&
                  slipping->slides(throat.loop, k.loop, throat.length, 1. + least_prominence_);
         }))
        kept.push_back(std::move(throat));
    }
    return kept;
  }

  // A loop whose class is the sum of those of two shorter ones may part into these; if they are not
  // much longer together, it is no throat. One that separates may always become a point.
  std::vector<Flat_throat> without_sums(std::vector<Flat_throat> throats) const {
    std::unordered_map<std::uint64_t, double> shortest;  // in either sense
    std::vector<std::pair<std::uint64_t, double>> parts; // in one
    std::vector<Flat_throat> kept;
    for(Flat_throat& throat : throats) {
      const std::uint64_t whole = throat.class_name;
      const double most = (1. + least_prominence_) * throat.length;
      const auto is_rest = [&](std::uint64_t rest, double length) {
        const auto found = shortest.find(rest);
        return found != shortest.end() && found->second + length <= most;
      };
      const bool is_sum = whole != 0 && std::any_of(parts.begin(), parts.end(), [&](auto& part) {
                            return is_rest(whole - part.first, part.second) ||
                                   is_rest(whole + part.first, part.second);
                          });
      if(is_sum && !is_wanted(throat))
        continue;
      if(whole != 0 && shortest.emplace(whole, throat.length).second) {
        shortest.emplace(-whole, throat.length);
        parts.emplace_back(whole, throat.length);
      }
      kept.push_back(std::move(throat));
    }
    return kept;
  }

  // Those of which about all vertices are there.
  static std::vector<Index> shorter_ones_in_place(const Slipping& slipping,
                                                  Index loop,
                                                  const std::vector<Flat_throat>& loops,
                                                  const Loops_at& at) {
    constexpr double about_all = 0.9;
    std::vector<Index> vertices, there;
    slipping.for_each_in_place([&](Index v) { vertices.push_back(v); });
    make_set(vertices);
    for_each_met(vertices, at, [&](Index other, double times) {
      if(other < loop && times >= about_all * double(left_ends(loops[other]).size()))
        there.push_back(other);
    });
    return there;
  }

  std::vector<Flat_throat> without_those_aslant(std::vector<Flat_throat> throats) const {
    std::stable_sort(throats.begin(), throats.end(), [](const auto& a, const auto& b) {
      return std::make_tuple(-a.prominence, a.length) < std::make_tuple(-b.prominence, b.length);
    });
    Cut_along_loop cut(mesh_);
    Loops_at at(mesh_.number_of_vertices());
    std::vector<Flat_throat> kept;
    for(Flat_throat& throat : throats) {
      cut.start(throat.loop);
      const std::vector<Index> ends = ends_of(throat);
      bool is_aslant = false;
      for_each_met(ends, at, [&](Index k, double) {
        is_aslant =
            is_aslant || (is_on_both_sides(cut, kept[k].loop) && are_of_one_class(throat, kept[k]));
      });
      if(is_aslant && !is_wanted(throat))
        continue;
      for(const Index v : ends)
        at[v].push_back(static_cast<Index>(kept.size()));
      kept.push_back(std::move(throat));
    }
    return kept;
  }

  // And does not only touch it.
  static bool is_on_both_sides(const Cut_along_loop& cut, const Crossing_loop& loop) {
    bool is_on_other_side = false;
    std::array<bool, 2> is_there = {false, false};
    for_each_left_edge(loop, [&](Index u, Index v) {
      is_on_other_side ^= cut.is_crossed(u, v);
      is_there[is_on_other_side ? 1 : 0] |= !cut.is_end(v);
    });
    return is_there[0] && is_there[1];
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  Crossing_index classes_;
  std::vector<std::uint64_t> names_; // by loop of the basis
  double least_prominence_;
  Workspace_pool<Slipping> slippings_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_DISTINCT_THROATS_H
