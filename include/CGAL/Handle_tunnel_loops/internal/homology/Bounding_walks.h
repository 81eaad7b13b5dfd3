// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_BOUNDING_WALKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_BOUNDING_WALKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Search_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A closed walk that bounds on one side. Its class is known by a sum that is zero for all that
/// bound on the other side; a walk there and back is of the same.
struct Bounding_walk
{
  bool is_inside; ///< where it bounds
  std::uint64_t sum;
  float length;
  Index root;
  std::vector<Index> vertices;

  bool is_of_same_class(const Bounding_walk& w) const {
    return is_inside == w.is_inside && sum == w.sum;
  }
  friend bool operator<(const Bounding_walk& a, const Bounding_walk& b) {
    return std::tie(a.is_inside, a.sum, a.length, a.root) <
           std::tie(b.is_inside, b.sum, b.length, b.root);
  }
};

/*!
Finds short closed walks through a vertex that bound on one side and not on the other, whatever the
basis: two shortest ways from it, and a step between their ends (Erickson and Whittlesey 2005). Of
the sums of a walk, `across` is to be zero if it bounds inside, `along` if it does outside.

It ends when there are walks of both kinds and all that is left is longer, or after so many
vertices: around most handles there is a short loop, and for the others there are other searches.
The shortest walk through a vertex that is d away is shorter by 2 d at most, so that none needs to
be looked for through those that are very near.
*/
class Bounding_walks
{
public:
  /// The mesh has been counted.
  explicit Bounding_walks(const Search_mesh& mesh)
      : mesh_(mesh)
      , paths_(mesh.number_of_vertices()) {}

  /// What is known of a vertex.
  struct Finding
  {
    std::vector<Bounding_walk> walks; ///< through it: the shortest of few classes of each kind
    std::vector<Index> vertices;      ///< through which none needs to be looked for now
    bool is_complete = false;         ///< there are walks of both kinds
  };

  Finding search(Index root) {
    closings_.clear();
    settled_.clear();
    shortest_ = {infinity, infinity};
    const auto goes_on = [&](float distance) {
      const float longest = (std::max)(shortest_[0], shortest_[1]);
      return settled_.size() < most_vertices && 2.f * distance < slack * longest;
    };
    paths_.reach(root, {0.f, no_index, no_index, false, {}});
    paths_.grow(goes_on, [this](Index v) { visit(v); });
    Finding found = {shortest_walks(root), vertices_near(), is_complete()};
    paths_.clear();
    return found;
  }

private:
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static constexpr std::size_t most_vertices = 200;
  static constexpr float slack = 1.5f; // to be looked for beyond the shortest
  static constexpr int most_classes = 4;
  static constexpr float very_near = 0.2f; // of the length of a walk

  // The shortest way to a vertex.
  struct Way
  {
    float distance = infinity;
    Index parent = no_index, step = no_index;
    bool is_settled = false;
    Class_sums sums;
  };

  // A step from the end of a way to that of another.
  struct Closing
  {
    float length; // of the walk
    bool is_inside;
    std::uint64_t sum;
    Index vertex, step;
  };

  void visit(Index v) {
    settled_.push_back(v);
    paths_[v].is_settled = true;
    const Way here = paths_[v];
    const Sums_of_steps sums = mesh_.sums_from(v);
    for(Index step = mesh_.begin(v); step != mesh_.end(v); ++step) {
      const Index head = mesh_.head(step);
      const float there = here.distance + mesh_.length(v, step);
      if(paths_[head].is_settled)
        close(there + paths_[head].distance, v, step, here.sums + sums[step]);
      else if(there < paths_[head].distance)
        paths_.reach(head, {there, v, step, false, here.sums + sums[step]});
    }
  }

  void close(float length, Index v, Index step, Class_sums sums) {
    sums.add(-1, paths_[mesh_.head(step)].sums);
    const bool is_inside = sums.across == 0;
    if(is_inside == (sums.along == 0))
      return;
    const std::uint64_t sum = is_inside ? sums.along : sums.across;
    note({length, is_inside, (std::min)(sum, 0 - sum), v, step});
    shortest_[is_inside] = (std::min)(shortest_[is_inside], length);
  }

  void note(const Closing& c) {
    for(Closing& other : closings_)
      if(other.is_inside == c.is_inside && other.sum == c.sum) {
        if(c.length < other.length)
          other = c;
        return;
      }
    closings_.push_back(c);
  }

  bool is_complete() const { return (std::max)(shortest_[0], shortest_[1]) < infinity; }

  std::vector<Bounding_walk> shortest_walks(Index root) {
    std::stable_sort(closings_.begin(), closings_.end(),
                     [](const Closing& a, const Closing& b) { return a.length < b.length; });
    std::vector<Bounding_walk> walks;
    std::array<int, 2> taken = {0, 0};
    for(const Closing& c : closings_)
      if(taken[c.is_inside]++ < most_classes)
        walks.push_back({c.is_inside, c.sum, c.length, root, closed_walk(c)});
    return walks;
  }

  // If there is no walk, one is twice as long as what has been looked at, at least.
  std::vector<Index> vertices_near() const {
    const float least =
        (std::min)({shortest_[0], shortest_[1], 2.f * paths_[settled_.back()].distance});
    std::vector<Index> vertices;
    for(Index v : settled_)
      if(paths_[v].distance <= very_near * least)
        vertices.push_back(v);
    return vertices;
  }

  std::vector<Index> closed_walk(const Closing& c) const {
    std::vector<Index> walk = way_from_root(c.vertex), back = way_from_root(mesh_.head(c.step));
    mesh_.append_walk(c.vertex, c.step, walk);
    walk.insert(walk.end(), back.rbegin(), back.rend());
    remove_spurs(walk);
    return walk;
  }

  std::vector<Index> way_from_root(Index v) const {
    std::vector<std::pair<Index, Index>> steps; // each with the vertex it leads from
    for(; paths_[v].parent != no_index; v = paths_[v].parent)
      steps.emplace_back(paths_[v].parent, paths_[v].step);
    std::vector<Index> walk(1, mesh_.vertex_of_walks(v));
    for(auto s = steps.rbegin(); s != steps.rend(); ++s)
      mesh_.append_walk(s->first, s->second, walk);
    return walk;
  }

  const Search_mesh& mesh_;
  Shortest_paths<Way> paths_; // by vertex
  std::vector<Index> settled_;
  std::vector<Closing> closings_;
  std::array<float, 2> shortest_ = {}; // of walks that bound outside, and inside
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_BOUNDING_WALKS_H
