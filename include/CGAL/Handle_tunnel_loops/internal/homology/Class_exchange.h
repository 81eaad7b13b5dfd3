// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_EXCHANGE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_EXCHANGE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Class_search.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How much is spent on the search for one loop.
struct Search_effort
{
  double spacing;     ///< of the places to search from, over the length that is looked for
  std::size_t visits; ///< at most; 0: do not search
};

/*!
Divides visits of vertices among searches. What a search is expected to take is known: a disc with
half the length of the loop as radius, from each place along its partner. The cheap ones come first
and get what they need; the others share what is left, from places that are farther apart, or are
left out.
*/
class Search_plan
{
public:
  /// \p discs and \p places by search: vertices in the disc around a place, and the length of the
  /// partner over that of the loop.
  Search_plan(std::vector<double> discs, std::vector<double> places, double visits)
      : efforts_(discs.size(), {closest, 0}) {
    // Lengths may be as small as numbers get.
    for(double& disc : discs)
      disc = std::clamp(disc, 1., 1e12);
    for(double& number : places)
      number = std::clamp(number, 0., 1e6);
    std::vector<Index> order(discs.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto expected = [&](Index i) { return discs[i] * (1. + places[i] / closest); };
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return expected(a) < expected(b); });
    double planned = 0.;
    for(std::size_t n = 0; n < order.size(); ++n) {
      const Index i = order[n];
      const double share = (visits - planned) / double(order.size() - n);
      const double spacing =
          (std::max)(closest, places[i] / (std::max)(share / discs[i] - 1., 0.1 * places[i]));
      is_tight_ = is_tight_ || spacing > closest;
      if(spacing > farthest)
        continue;
      efforts_[i] = {spacing,
                     static_cast<std::size_t>(discs[i] * (1. + places[i] / spacing)) + 200};
      planned += double(efforts_[i].visits);
    }
  }

  /// whether there was not enough for all.
  bool is_tight() const { return is_tight_; }

  const Search_effort& effort(std::size_t i) const { return efforts_[i]; }

private:
  static constexpr double closest = 0.1, farthest = 1.;

  std::vector<Search_effort> efforts_;
  bool is_tight_ = false;
};

/// How loops are searched for.
struct Search_manner
{
  bool are_walls_along; ///< see `Class_search::start()`
  bool is_lean;         ///< the same
  double spacing;       ///< of the places to search from, over the length that is looked for
};

/*!
Finds short loops that cross a given one: `Class_search` from places along it, as close to each
other as it takes.

A loop through a place that is d away is longer by at most 2 d than one through this place. So
places at a part of the length of what is looked for find a loop that is longer by that part at
most, before it is tightened; and places near one through which there is no short loop can be left
out.
*/
class Partner_search
{
public:
  /// The mesh to search on has been counted.
  Partner_search(const Flat_mesh& mesh, const Search_mesh& search_mesh)
      : mesh_(mesh)
      , search_mesh_(search_mesh)
      , distances_(search_mesh)
      , search_(search_mesh) {}

  /// looks for the targets along loop \p number, that all of them have to cross.
  void run(const Crossing_loop& partner,
           Index number,
           const Search_manner& manner,
           Search_targets& targets,
           std::size_t& visits) {
    measure(partner);
    distances_.compute(partner, number, targets.limit(), visits);
    if(distances_.around() >= targets.limit())
      return;
    search_.start(manner.are_walls_along, &distances_, manner.is_lean);
    for(const auto& [bound, root] : places(partner, manner.spacing * targets.smallest_limit()))
      if(visits > 0 && bound < worth_a_way * targets.limit() &&
         search_.lower_bound(root) < worth_a_search * targets.limit())
      {
        targets.start_place();
        search_.search(root, targets, visits);
      }
  }

private:
  // However short the loops are that are looked for: lengths may be zero.
  static constexpr double most_places = 1000.;

  // Of the length that is looked for, unless no loop through a place can be so short.
  static constexpr double worth_a_search = 0.8, worth_a_way = 0.95;

  void measure(const Crossing_loop& loop) {
    along_.assign(1, 0.);
    for(std::size_t i = 0; i < loop.size(); ++i)
      along_.push_back(
          along_.back() +
          norm(position(mesh_, loop[i + 1 == loop.size() ? 0 : i + 1]) - position(mesh_, loop[i])));
  }

  // Where to search from, so far apart, and what no walk through there can be shorter than: those
  // first through which there may be short ones.
  std::vector<std::pair<double, Index>> places(const Crossing_loop& partner, double spacing) const {
    std::vector<std::pair<double, Index>> all;
    spacing = (std::max)(spacing, along_.back() / most_places);
    double s = 0.;
    do {
      const Index root = place(partner, s);
      all.emplace_back(distances_.way_on(root, distances_.first_copy(root)), root);
      s += spacing;
    } while(s < along_.back());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // A vertex to search from, near the place of the loop at a distance along it.
  Index place(const Crossing_loop& loop, double s) const {
    const std::size_t i = static_cast<std::size_t>(
        std::upper_bound(along_.begin(), along_.end() - 1, s) - along_.begin() - 1);
    const Crossing &c = loop[i], &next = loop[i + 1 == loop.size() ? 0 : i + 1];
    const double part = along_[i + 1] - along_[i];
    const Vector from = position(mesh_, c);
    const Vector p =
        part > 0. ? from + ((s - along_[i]) / part) * (position(mesh_, next) - from) : from;
    return search_mesh_.vertex_near(p, ratio_on_surface(mesh_, c) < 0.5 ? c.left : c.right);
  }

  const Flat_mesh& mesh_;
  const Search_mesh& search_mesh_;
  Partner_distances distances_;
  Class_search search_;
  std::vector<double> along_; // the loop, by crossing
};

/// A loop that may take the place of others of a basis.
struct Loop_candidate
{
  double length;
  Crossing_loop loop;
  Class_vector numbers, coordinates; ///< with and in the basis

  /// \p numbers are those with the basis, and lengths those on \p mesh. Nothing where numbers are
  /// too large.
  static std::optional<Loop_candidate>
  of(const Flat_mesh& mesh, Crossing_loop loop, Class_vector numbers, const Loop_classes& classes) {
    std::optional<Class_vector> coordinates = classes.class_with(numbers);
    if(!coordinates)
      return std::nullopt;
    const double length = CGAL::Handle_tunnel_loops::internal::length(mesh, loop);
    return Loop_candidate{length, std::move(loop), std::move(numbers), *std::move(coordinates)};
  }

  friend bool operator<(const Loop_candidate& a, const Loop_candidate& b) {
    return a.length < b.length;
  }
};

/// the loops of a basis that can be replaced by a shorter one with these coordinates in it, the
/// longest first.
inline std::vector<Index>
replaceable(const Class_vector& coordinates, double length, const std::vector<double>& lengths) {
  constexpr double gain_worth_having = 1. - 1e-7;
  std::vector<Index> places;
  for(const auto& [i, value] : coordinates)
    if(std::abs(value) == 1 && length < gain_worth_having * lengths[i])
      places.push_back(i);
  std::stable_sort(places.begin(), places.end(),
                   [&](Index a, Index b) { return lengths[a] > lengths[b]; });
  return places;
}

/*!
A basis of loops in which one after the other is replaced.

Replacing a loop by a curve gives a basis again exactly if the coordinate of the curve on that loop
is 1 or -1. The coordinates in the first basis are known from intersection numbers; each exchange
changes those in the present basis by a multiple of one column.
*/
class Class_exchange
{
public:
  explicit Class_exchange(const Loop_classes& classes)
      : classes_(classes)
      , is_replaced_(classes.size(), 0)
      , exchanges_of_(classes.size()) {
    for(Index i = 0; i < classes.size(); ++i)
      members_.push_back({{i, 1}});
  }

  /// how often a loop was replaced such that coordinates change.
  Index number_of_exchanges() const { return static_cast<Index>(exchanges_.size()); }

  /// the coordinates in the present basis of a class that is given in the one there was after so
  /// many exchanges, unless a number is too large.
  std::optional<Class_vector> coordinates(Class_vector a, Index exchanges_before = 0) const {
    // Of exchanges, the first at each coordinate that comes after those that have been looked at.
    std::priority_queue<Index, std::vector<Index>, std::greater<Index>> to_do;
    const auto look_at = [&](Index i, Index next) {
      const std::vector<Index>& own = exchanges_of_[i];
      const auto e = std::lower_bound(own.begin(), own.end(), next);
      if(e != own.end())
        to_do.push(*e);
    };
    for(const auto& c : a)
      look_at(c.first, exchanges_before);
    for(Index next = exchanges_before; !to_do.empty();) {
      const Index number = to_do.top();
      to_do.pop();
      if(number < next)
        continue;
      next = number + 1;
      const Exchange& e = exchanges_[number];
      look_at(e.index, next);
      const std::int64_t x = coordinate(a, e.index);
      if(x == 0)
        continue;
      // z_k = e (z_k' - sum of the other x_j z_j)
      if(!add_multiple(a, -x * e.unit, e.coordinates) ||
         !add_multiple(a, 1, {{e.index, x * e.unit}}))
        return std::nullopt;
      for(const auto& c : e.coordinates)
        look_at(c.first, next);
    }
    return a;
  }

  /// replaces member `k` by the class with these coordinates in the first basis and in the present
  /// one.
  void replace(Index k, const Class_vector& first, const Class_vector& present) {
    const std::int64_t unit = coordinate(present, k);
    CGAL_precondition(std::abs(unit) == 1);
    members_[k] = first;
    if(is_replaced_[k] == 0)
      replaced_.push_back(k);
    is_replaced_[k] = 1;
    if(present.size() > 1 || unit != 1) {
      exchanges_of_[k].push_back(static_cast<Index>(exchanges_.size()));
      exchanges_.push_back({k, unit, present});
    }
  }

  /// the intersection number of a class, given by its numbers with the first basis, with a member.
  std::int64_t crossing(const Class_vector& numbers, Index member) const {
    return product_sum(numbers, members_[member]);
  }

  /// the pairs whose tunnel a class crosses once, given by its numbers with the first basis.
  std::vector<Index> tunnels_crossed_once(const Class_vector& numbers) const {
    std::vector<Index> found;
    for(const auto& [i, value] : numbers)
      if(i % 2 == 1 && is_replaced_[i] == 0 && std::abs(value) == 1)
        found.push_back(i / 2);
    for(Index i : replaced_)
      if(i % 2 == 1 && std::abs(crossing(numbers, i)) == 1)
        found.push_back(i / 2);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// by their coordinates in the first basis.
  const std::vector<Class_vector>& members() const { return members_; }

  /// the intersection numbers of a member with the first basis.
  Class_vector numbers(Index member) const { return classes_.numbers_of_class(members_[member]); }

private:
  struct Exchange
  {
    Index index;
    std::int64_t unit;
    Class_vector coordinates;
  };

  const Loop_classes& classes_;
  std::vector<Class_vector> members_; // in the first basis
  std::vector<Index> replaced_;
  std::vector<char> is_replaced_; // by member
  std::vector<Exchange> exchanges_;
  std::vector<std::vector<Index>> exchanges_of_; // by member, their numbers
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_EXCHANGE_H
