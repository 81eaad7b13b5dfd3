// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_INDEX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_INDEX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>

#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Intersection numbers of one curve with numbered loops: loop -> number, zeros left out.
using Sparse_numbers = std::map<Index, std::int64_t>;

/// whether curves have the same numbers, up to the sense in which they are passed.
inline bool are_same_or_opposite(const Sparse_numbers& a, const Sparse_numbers& b) {
  return a == b || std::equal(a.begin(), a.end(), b.begin(), b.end(), [](auto& p, auto& q) {
           return p.first == q.first && p.second == -q.second;
         });
}

/// A loop crosses the edge from the vertex that has this entry to another.
struct Crossing_entry
{
  Index other;
  Index loop;
  int sign; ///< 1 if the vertex that has this entry is to the left
};

/*!
Which loops of a family cross which edges, and how.

Read as functions on the directed edges, the loops are cocycles: a walk on the edges meets loop j in
as many points, counted with sign, as the sum of loop j's values along it. That number is a matter
of integers; where on an edge it is crossed, and in which order by several loops, plays no part.
*/
class Crossing_index
{
public:
  Crossing_index(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : begin_(mesh.number_of_vertices() + 1, 0) {
    count(loops);
    const Index last = begin_.back();
    std::exclusive_scan(begin_.begin(), begin_.end(), begin_.begin(), Index(0));
    fill(loops, begin_.back() + last);
  }

  /// \p execution is an `Execution`, which this header, being one of kernels, knows nothing of.
  template <typename Execution>
  Crossing_index(Execution execution,
                 const Flat_mesh& mesh,
                 const std::vector<Crossing_loop>& loops)
      : begin_(mesh.number_of_vertices() + 1, 0) {
    count(loops);
    fill(loops, sum_before_each(execution, begin_));
  }

  bool has_crossing(Index v) const { return begin_[v] != begin_[v + 1]; }

  /// whether the edge u - v is crossed by one of the given loops.
  template <typename Loop_set> bool is_crossed(Index u, Index v, const Loop_set& loops) const {
    if(number_of_entries(v) < number_of_entries(u))
      std::swap(u, v);
    // The entries are sorted by loop, so the loops of a set are found from the end.
    for(auto it = end(u); it != begin(u) && !loops.are_all_after((--it)->loop);)
      if(it->other == v && loops.contains(it->loop))
        return true;
    return false;
  }

  /// adds what the walk from `u` to `v`, an edge, contributes to the intersection numbers.
  void add_crossings(Index u, Index v, Sparse_numbers& numbers) const {
    const bool is_swapped = number_of_entries(v) < number_of_entries(u);
    if(is_swapped)
      std::swap(u, v);
    for(auto it = begin(u); it != end(u); ++it)
      if(it->other == v)
        numbers[it->loop] += is_swapped ? -it->sign : it->sign;
  }

  /// the intersection numbers of a closed walk on the edges with the loops.
  Sparse_numbers intersections(const std::vector<Index>& walk) const {
    Sparse_numbers numbers;
    for(std::size_t i = 0; i < walk.size(); ++i)
      add_crossings(walk[i], walk[i + 1 == walk.size() ? 0 : i + 1], numbers);
    return without_zeros(std::move(numbers));
  }

  /// the intersection numbers of another loop with the loops.
  Sparse_numbers intersections(const Crossing_loop& loop) const {
    Sparse_numbers numbers;
    for_each_left_edge(loop, [&](Index u, Index v) { add_crossings(u, v, numbers); });
    return without_zeros(std::move(numbers));
  }

  /// the entries of vertex v are those from `begins()[v]` to `begins()[v + 1]`.
  const std::vector<Index>& begins() const { return begin_; }
  const std::vector<Crossing_entry>& entries() const { return entries_; }

private:
  using Iterator = std::vector<Crossing_entry>::const_iterator;

  // An edge is known at both ends; a vertex with many may have as many entries.
  Index number_of_entries(Index v) const { return begin_[v + 1] - begin_[v]; }

  Iterator begin(Index v) const { return entries_.begin() + begin_[v]; }
  Iterator end(Index v) const { return entries_.begin() + begin_[v + 1]; }

  // The entries of v at v + 1.
  void count(const std::vector<Crossing_loop>& loops) {
    for(const Crossing_loop& loop : loops)
      for(const Crossing& c : loop) {
        ++begin_[c.left + 1];
        ++begin_[c.right + 1];
      }
  }

  // At v + 1 is where the entries of v begin, and in the end where they end.
  void fill(const std::vector<Crossing_loop>& loops, std::size_t number) {
    entries_.resize(number);
    for(Index j = 0; j < loops.size(); ++j)
      for(const Crossing& c : loops[j]) {
        entries_[begin_[c.left + 1]++] = {c.right, j, 1};
        entries_[begin_[c.right + 1]++] = {c.left, j, -1};
      }
  }

  static Sparse_numbers without_zeros(Sparse_numbers numbers) {
    for(auto it = numbers.begin(); it != numbers.end();)
      it = it->second == 0 ? numbers.erase(it) : std::next(it);
    return numbers;
  }

  std::vector<Index> begin_; // by vertex
  std::vector<Crossing_entry> entries_;
};

/// The loops with numbers from `first` on.
struct Loops_from
{
  static constexpr bool is_one = false;
  Index first;

  CGAL_HTL_HOST_DEVICE bool contains(Index loop) const { return loop >= first; }
  CGAL_HTL_HOST_DEVICE bool are_all_after(Index loop) const { return loop < first; }
};

/// One loop.
struct Only_loop
{
  static constexpr bool is_one = true;
  Index number;

  CGAL_HTL_HOST_DEVICE bool contains(Index loop) const { return loop == number; }
  CGAL_HTL_HOST_DEVICE bool are_all_after(Index loop) const { return loop < number; }
};

/// whether a curve with these intersection numbers crosses loop `number`, one of the `barred`
/// loops, once, and no other of them.
template <typename Loop_set>
bool is_dual(const Sparse_numbers& numbers, Index number, const Loop_set& barred) {
  bool is_crossed_once = false;
  for(const auto& [loop, count] : numbers)
    if(loop == number)
      is_crossed_once = std::abs(count) == 1;
    else if(barred.contains(loop))
      return false;
  return is_crossed_once;
}

/// Loops as walls of a field.
template <typename Loop_set> class Loop_walls
{
public:
  Loop_walls(const Crossing_index& index, const Loop_set& loops)
      : index_(index)
      , loops_(loops) {}

  bool is_wall(Index u, Index v) const { return index_.is_crossed(u, v, loops_); }

private:
  const Crossing_index& index_;
  const Loop_set& loops_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_INDEX_H
