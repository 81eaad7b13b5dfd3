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
#include <CGAL/Handle_tunnel_loops/internal/mesh/Vertex_subset.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
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

It takes time and memory for the vertices beside the loops, of the others hardly any.
*/
class Crossing_index
{
public:
  Crossing_index(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : number_of_vertices_(mesh.number_of_vertices())
      , vertices_(number_of_vertices_) {
    for_each_end(loops, [this](Index v, const Crossing_entry&) { vertices_.insert(v); });
    vertices_.count();
    // The entries of vertex i are counted at i + 2, so that they begin at i + 1, and end there once
    // they are in their places.
    begin_.assign(vertices_.size() + 2, 0);
    for_each_end(loops, [this](Index v, const Crossing_entry&) {
      ++begin_[vertices_.number_before(v) + 2];
    });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    entries_.resize(begin_.back());
    for_each_end(loops, [this](Index v, const Crossing_entry& entry) {
      entries_[begin_[vertices_.number_before(v) + 1]++] = entry;
    });
    begin_.pop_back();
  }

  /// the vertices that have entries.
  const Vertex_subset& vertices() const { return vertices_; }

  bool has_crossing(Index v) const { return vertices_.contains(v); }

  /// whether the edge u - v is crossed by one of the given loops.
  template <typename Loop_set> bool is_crossed(Index u, Index v, const Loop_set& loops) const {
    if(!has_crossing(u) || !has_crossing(v))
      return false;
    Span<const Crossing_entry> entries = entries_at(u);
    if(const auto others = entries_at(v); others.size() < entries.size()) {
      entries = others;
      std::swap(u, v);
    }
    // The entries are sorted by loop, so the loops of a set are found from the end.
    for(auto it = entries.end(); it != entries.begin() && !loops.are_all_after((--it)->loop);)
      if(it->other == v && loops.contains(it->loop))
        return true;
    return false;
  }

  /// adds what the walk from `u` to `v`, an edge, contributes to the intersection numbers.
  void add_crossings(Index u, Index v, Sparse_numbers& numbers) const {
    const auto at_u = entries_at(u), at_v = entries_at(v);
    const bool is_swapped = at_v.size() < at_u.size();
    for(const Crossing_entry& entry : is_swapped ? at_v : at_u)
      if(entry.other == (is_swapped ? u : v))
        numbers[entry.loop] += is_swapped ? -entry.sign : entry.sign;
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

  /// the entries of a vertex, sorted by loop. An edge is known at both ends; a vertex with many
  /// neighbors may have as many entries.
  Span<const Crossing_entry> entries_at(Index v) const {
    if(!has_crossing(v))
      return {};
    const Index i = vertices_.number_before(v);
    return {entries_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }

  /// those of all vertices.
  const std::vector<Crossing_entry>& entries() const { return entries_; }

  /// where those of each of `vertices()` begin, and where the last end.
  const std::vector<Index>& begins() const { return begin_; }

  /// where those of each vertex of the mesh begin, and where the last end.
  std::vector<Index> begins_of_all() const {
    std::vector<Index> begins;
    begins.reserve(number_of_vertices_ + 1);
    for(Index v = 0; v <= number_of_vertices_; ++v)
      begins.push_back(begin_[vertices_.number_before(v)]);
    return begins;
  }

private:
  // Calls `f(vertex, entry)`, loop by loop.
  template <typename Function>
  static void for_each_end(const std::vector<Crossing_loop>& loops, const Function& f) {
    for(Index j = 0; j < loops.size(); ++j)
      for(const Crossing& c : loops[j]) {
        f(c.left, Crossing_entry{c.right, j, 1});
        f(c.right, Crossing_entry{c.left, j, -1});
      }
  }

  static Sparse_numbers without_zeros(Sparse_numbers numbers) {
    for(auto it = numbers.begin(); it != numbers.end();)
      it = it->second == 0 ? numbers.erase(it) : std::next(it);
    return numbers;
  }

  std::size_t number_of_vertices_;
  Vertex_subset vertices_;
  std::vector<Index> begin_; // by vertex of the subset
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
