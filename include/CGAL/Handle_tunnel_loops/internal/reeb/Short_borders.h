// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SHORT_BORDERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SHORT_BORDERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/length_across.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/measure_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Minimum_cut.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Moves the borders of parts of a surface to where they are short, and makes each part one piece.

What of a part does not hang together with most of it goes to those around. Then each border of two
parts, piece by piece, becomes a minimum cut of a band around it, as wide to both sides as the
radius of a circle of its length; lengths there count up to twice, the more the farther away. The
inner half of a part stays, and so does a border if a part would come apart.
*/
class Short_borders
{
public:
  /// \p part_of_vertex has the hubs, too. Both must outlive the object.
  Short_borders(const Flat_mesh& mesh, std::vector<Index>& part_of_vertex)
      : mesh_(mesh)
      , part_(part_of_vertex)
      , paths_(part_of_vertex.size())
      , node_(part_of_vertex.size(), no_index)
      , visit_(part_of_vertex.size(), 0) {}

  void run() {
    connect_parts();
    is_inner_ = inner_halves(mesh_, part_);
    for(const auto& [parts, vertices] : borders())
      for(const std::vector<Index>& band : bands(parts, vertices))
        shorten(parts, band);
  }

private:
  using Pair = std::array<Index, 2>;

  struct Label
  {
    double distance = (std::numeric_limits<double>::max)();
  };

  // ---- parts in one piece

  void connect_parts() {
    Sets_of_indices sets(part_.size());
    for_each_edge([&](Index v, Index u) {
      if(part_[v] == part_[u])
        sets.unite(v, u);
    });
    std::vector<Index> size(part_.size(), 0), largest; // by vertex that represents others, by part
    for(Index v = 0; v < part_.size(); ++v)
      ++size[sets.find(v)];
    for(Index v = 0; v < part_.size(); ++v) {
      if(part_[v] >= largest.size())
        largest.resize(part_[v] + 1, no_index);
      if(Index& best = largest[part_[v]]; best == no_index || size[v] > size[best])
        best = v;
    }
    std::vector<Index> reached;
    for(Index v = 0; v < part_.size(); ++v)
      if(sets.find(v) == largest[part_[v]])
        reached.push_back(v);
      else
        node_[v] = 0; // not reached yet
    for(std::size_t i = 0; i < reached.size() && reached.size() < part_.size(); ++i)
      for(const Index u : mesh_.ring(reached[i]))
        if(node_[u] == 0) {
          part_[u] = part_[reached[i]];
          node_[u] = no_index;
          reached.push_back(u);
        }
  }

  // ---- borders

  template <typename Function> void for_each_edge(const Function& f) const {
    for(Index v = 0; v < part_.size(); ++v)
      for(const Index u : mesh_.ring(v))
        if(v < u)
          f(v, u);
  }

  // By the parts, the vertices at the edges between them.
  std::map<Pair, std::vector<Index>> borders() const {
    std::map<Pair, std::vector<Index>> borders;
    for_each_edge([&](Index v, Index u) {
      if(part_[v] != part_[u]) {
        const auto [a, b] = std::minmax(part_[v], part_[u]);
        std::vector<Index>& vertices = borders[{a, b}];
        vertices.insert(vertices.end(), {v, u});
      }
    });
    for(auto& border : borders)
      make_set(border.second);
    return borders;
  }

  bool is_of(const Pair& parts, Index v) const {
    return part_[v] == parts[0] || part_[v] == parts[1];
  }

  double radius(const Pair& parts, const std::vector<Index>& vertices) const {
    constexpr double circle = 6.283185307179586, across = 3.;
    double length = 0.;
    for(const Index v : vertices)
      if(part_[v] == parts[0])
        for(const Index u : mesh_.ring(v))
          if(part_[u] == parts[1])
            length += length_across(mesh_, v, u);
    return length / (circle * across);
  }

  // What is near a border on both sides of it, in connected pieces.
  std::vector<std::vector<Index>> bands(const Pair& parts, const std::vector<Index>& vertices) {
    width_ = radius(parts, vertices);
    if(!(width_ > 0.)) // it is gone since
      return {};
    paths_.clear();
    for(const Index v : vertices)
      if(is_of(parts, v))
        paths_.reach(v, {0.});
    paths_.grow([](double) { return true; },
                [&](Index v) {
                  for(const Index u : mesh_.ring(v)) {
                    const double sum = paths_[v].distance + mesh_.edge_length(v, u);
                    if(is_of(parts, u) && sum <= width_ && sum < paths_[u].distance)
                      paths_.reach(u, {sum});
                  }
                });
    std::vector<std::vector<Index>> bands;
    ++number_of_visits_;
    for(const Index v : paths_.reached())
      if(visit_[v] != number_of_visits_)
        bands.push_back(reached_from(v, [this](Index u) { return paths_.is_reached(u); }));
    return bands;
  }

  // Those with a property that have not been visited; they are then.
  template <typename Predicate>
  std::vector<Index> reached_from(Index first, const Predicate& has_property) {
    std::vector<Index> reached = {first};
    visit_[first] = number_of_visits_;
    for(std::size_t i = 0; i < reached.size(); ++i)
      for(const Index u : mesh_.ring(reached[i]))
        if(visit_[u] != number_of_visits_ && has_property(u)) {
          visit_[u] = number_of_visits_;
          reached.push_back(u);
        }
    return reached;
  }

  // Of an edge in a band: limbs taper, and their borders are not to slip to the tips.
  double weight(Index v, Index u) const {
    const double moved = (std::min)(paths_[v].distance, paths_[u].distance);
    return (1. + moved / width_) * length_across(mesh_, v, u);
  }

  void shorten(const Pair& parts, const std::vector<Index>& band) {
    std::vector<Index> free;
    for(const Index v : band)
      if(is_inner_[v] == 0) {
        node_[v] = static_cast<Index>(2 + free.size());
        free.push_back(v);
      }
    Minimum_cut cut;
    bool has_end[2] = {false, false};
    for(const Index v : free)
      for(const Index u : mesh_.ring(v)) {
        if(!is_of(parts, u) || (node_[u] != no_index && u < v))
          continue;
        const Index end = part_[u] == parts[0] ? Minimum_cut::source : Minimum_cut::sink;
        if(node_[u] == no_index)
          has_end[end] = true;
        cut.add_edge(node_[v], node_[u] == no_index ? end : node_[u], weight(v, u));
      }
    for(const Index v : free)
      node_[v] = no_index;
    if(has_end[0] && has_end[1])
      move(parts, band, free, cut.source_side(static_cast<Index>(2 + free.size())));
  }

  // Unless a part comes apart by that.
  void move(const Pair& parts,
            const std::vector<Index>& band,
            const std::vector<Index>& free,
            const std::vector<char>& side) {
    std::vector<Index> before;
    bool is_changed = false;
    for(std::size_t i = 0; i < free.size(); ++i) {
      const Index part = parts[side[i + 2] != 0 ? 0 : 1];
      is_changed = is_changed || part != part_[free[i]];
      before.push_back(part_[free[i]]);
      part_[free[i]] = part;
    }
    if(is_changed && !(is_in_one_piece(parts[0], band) && is_in_one_piece(parts[1], band)))
      for(std::size_t i = 0; i < free.size(); ++i)
        part_[free[i]] = before[i];
  }

  // Of a part that was in one piece before a band was divided anew. It is enough if all that is in
  // and beside the band hangs together, there or elsewhere.
  bool is_in_one_piece(Index part, const std::vector<Index>& band) {
    std::vector<Index> around;
    for(const Index v : band) {
      if(part_[v] == part)
        around.push_back(v);
      for(const Index u : mesh_.ring(v))
        if(part_[u] == part)
          around.push_back(u);
    }
    if(around.empty())
      return false;
    make_set(around);
    ++number_of_visits_;
    const auto all_reached = [&] {
      return std::all_of(around.begin(), around.end(),
                         [&](Index v) { return visit_[v] == number_of_visits_; });
    };
    reached_from(around.front(), [&](Index u) { return is_in(u, around); });
    if(all_reached())
      return true;
    ++number_of_visits_;
    reached_from(around.front(), [&](Index u) { return part_[u] == part; });
    return all_reached();
  }

  const Flat_mesh& mesh_;
  std::vector<Index>& part_;
  std::vector<char> is_inner_;  // by vertex
  Shortest_paths<Label> paths_; // from a border
  double width_ = 0.;           // of the band around it
  std::vector<Index> node_;     // by vertex, in the graph that is cut
  std::vector<Index> visit_;    // by vertex, the last one
  Index number_of_visits_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SHORT_BORDERS_H
