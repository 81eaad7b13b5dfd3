// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WALKS_OF_CLASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WALKS_OF_CLASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Class_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Cover_places.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The shortest closed walk of a class that passes one of some vertices.

Dijkstra's algorithm from each of these in the cover of the surface whose points are vertices with
the number of the class of the way there (`Class_numbers`). Two ways to the ends of an edge make a
walk of the class if their numbers say so; so ways are looked at up to half of the length only. What
is begun from has been dealt with afterwards, and is a wall.

The number of ways up to some length may grow exponentially with it where there are many handles or
boundary curves. Hence a budget, for each curve and for all of them.
*/
class Walks_of_class
{
public:
  Walks_of_class(const Flat_mesh& mesh, const Class_numbers& numbers)
      : mesh_(mesh)
      , numbers_(numbers)
      , budget_((std::min)(most_labels,
                           most_labels_of_all / ((std::max)(mesh.number_of_hubs, Index(1)))))
      , is_wall_(mesh.number_of_vertices(), 0)
      , places_(logarithm_of_most_labels) {}

  /// looks for walks homologous to a curve that are shorter than \p length. Returns the shortest,
  /// or the shortest up to where the budget was spent; empty if there is none.
  std::vector<Index> shortest(const std::vector<Index>& curve,
                              const std::vector<Index>& vertices_on_way,
                              double length) {
    class_ = numbers_.of_walk(curve);
    length_ = length;
    best_.clear();
    labels_left_ = budget_;
    for(const Index v : vertices_on_way) {
      search_from(v);
      is_wall_[v] = 1;
    }
    for(const Index v : vertices_on_way)
      is_wall_[v] = 0;
    remove_spurs(best_);
    if(!best_.empty() && !numbers_.are_homologous(best_, curve))
      best_.clear(); // the numbers agree by chance
    return std::move(best_);
  }

private:
  static constexpr int logarithm_of_most_labels = 18;
  static constexpr std::size_t most_labels = std::size_t(1) << logarithm_of_most_labels,
                               most_labels_of_all = std::size_t(1) << 22;

  using Place = Cover_places::Place;

  // Of a place.
  struct Label
  {
    double distance;
    Index previous;
  };

  void search_from(Index start) {
    labels_.clear();
    places_.clear();
    queue_.clear();
    end_ = {};
    reach({start, 0}, 0., no_index);
    queue_.run(
        labels_, [this](double distance) { return 2. * distance < length_ && labels_left_ > 0; },
        [this](Index i) { visit(i); });
    if(end_.first != end_.second)
      best_ = walk();
  }

  void visit(Index i) {
    const Place from = places_[i];
    const double distance_before = labels_[i].distance;
    const Flat_halfedges& halfedges = numbers_.halfedges();
    for(Index h = halfedges.begin(from.vertex); h < halfedges.end(from.vertex); ++h) {
      const Index v = halfedges.target(h);
      if(mesh_.is_hub(v) || is_wall_[v])
        continue;
      const double distance = distance_before + mesh_.edge_length(from.vertex, v);
      if(!(distance < length_))
        continue;
      const std::uint64_t number = from.number + numbers_.of_halfedge(h);
      close({v, number - class_}, distance, i, true);
      close({v, number + class_}, distance, i, false);
      if(2. * distance < length_)
        reach({v, number}, distance, i);
    }
  }

  void reach(const Place& place, double distance, Index previous) {
    Index i = places_.find(place);
    if(i == no_index && labels_left_ > 0) {
      --labels_left_;
      i = static_cast<Index>(places_.size());
      places_.add(place);
      labels_.push_back({distance, previous});
    } else if(i != no_index && distance < labels_[i].distance)
      labels_[i] = {distance, previous};
    else
      return;
    queue_.push(distance, i);
  }

  // If there is a way to a place, the one of label `i` and an edge leads there and back by that
  // way.
  void close(const Place& place, double distance, Index i, bool is_forward) {
    const Index back = places_.find(place);
    if(back == no_index || !(distance + labels_[back].distance < length_))
      return;
    length_ = distance + labels_[back].distance;
    end_ = is_forward ? std::make_pair(i, back) : std::make_pair(back, i);
  }

  // There by the first way, and back by the second.
  std::vector<Index> walk() const {
    std::vector<Index> vertices;
    for(Index i = end_.first; i != no_index; i = labels_[i].previous)
      vertices.push_back(places_[i].vertex);
    std::reverse(vertices.begin(), vertices.end());
    for(Index i = end_.second; labels_[i].previous != no_index; i = labels_[i].previous)
      vertices.push_back(places_[i].vertex);
    return vertices;
  }

  const Flat_mesh& mesh_;
  const Class_numbers& numbers_;
  std::size_t budget_;        // of labels, for one curve
  std::vector<char> is_wall_; // by vertex
  std::uint64_t class_ = 0;
  double length_ = 0.; // of the shortest so far
  std::vector<Index> best_;
  std::size_t labels_left_ = 0;
  Cover_places places_;
  std::vector<Label> labels_; // by place
  Distance_queue<double> queue_;
  std::pair<Index, Index> end_; // labels of the two ways of the best walk; equal if there is none
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WALKS_OF_CLASS_H
