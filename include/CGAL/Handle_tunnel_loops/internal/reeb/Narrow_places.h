// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_NARROW_PLACES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_NARROW_PLACES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Bridge_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The contours of a function that separate the surface and are short compared with those on either
side: the local minima of their lengths along the arcs of a Reeb graph, each so far down that on any
way to a shorter one there is a contour longer by the factor `prominence`.

Ways lead along bridges of the graph, and no further than where a negligible part of the surface is
left: there, and at the ends of the graph, contours shrink to a point. Where a bridge ends at arcs
that are none, at a handle, no contour can shrink, and the way is not counted.
*/
class Narrow_places
{
public:
  static constexpr float prominence = 1.2f;

  /// \p negligible is a share of the area of the component. Contours longer than \p most_girth are
  /// not looked at.
  Narrow_places(const Flat_mesh& mesh,
                const Sweep_order& order,
                const std::vector<Star>& stars,
                const Flat_reeb_graph& graph,
                const std::vector<double>& vertex_areas,
                double most_girth,
                double negligible)
      : order_(order)
      , stars_(stars)
      , graph_(graph)
      , vertex_areas_(vertex_areas)
      , most_girth_(static_cast<float>(prominence * most_girth))
      , negligible_(negligible)
      , arc_areas_(areas_of_arcs(mesh, order, graph, vertex_areas))
      , bridges_(graph, arc_areas_) {}

  /// the vertices, in a fixed order, at which such contours begin: each lies just above its vertex,
  /// on the same arc.
  std::vector<Index> find() {
    follow_arcs();
    join_at_nodes();
    return minima();
  }

private:
  /// A contour on a bridge.
  struct Place
  {
    Index vertex;
    float girth;
  };

  /// Places next to each other on a way; the second may be the end of all ways.
  struct Link
  {
    Index first, second;
    float girth; ///< of the longer one
  };

  enum class Kind { NONE, PLACE, LONG, NEGLIGIBLE };

  /// The contour at an end of an arc.
  struct End
  {
    Kind kind = Kind::NONE;
    Index place = no_index;
  };

  /// Where the sweep is on an arc.
  struct Front
  {
    double girth, area_below;
    End first, last;
  };

  static std::vector<double> areas_of_arcs(const Flat_mesh& mesh,
                                           const Sweep_order& order,
                                           const Flat_reeb_graph& graph,
                                           const std::vector<double>& vertex_areas) {
    std::vector<double> areas(graph.arcs.size(), 0.);
    for(std::size_t r = 0; r < mesh.number_of_vertices(); ++r) {
      const Index v = order.vertices()[r];
      areas[graph.vertex_arc[v]] += vertex_areas[v];
    }
    return areas;
  }

  void follow_arcs() {
    start_arcs();
    for(const Index v : order_.vertices()) {
      const Index arc = graph_.vertex_arc[v];
      if(!bridges_.is_bridge(arc))
        continue;
      Front& front = fronts_[arc];
      front.area_below += vertex_areas_[v];
      if(stars_[v].kind == Vertex_kind::REGULAR || stars_[v].kind == Vertex_kind::MINIMUM) {
        front.girth += stars_[v].change.weight / weight_of_length;
        pass(arc, v);
      }
    }
  }

  // The contour above a saddle is as long as the graph says; it has the next vertex, if any.
  void start_arcs() {
    fronts_.resize(graph_.arcs.size());
    for(Index arc = 0; arc < fronts_.size(); ++arc) {
      fronts_[arc] = {graph_.arcs[arc].lower_girth, bridges_.below(arc), {}, {}};
      if(bridges_.is_bridge(arc) && graph_.nodes[graph_.arcs[arc].lower].kind == Node_kind::SADDLE)
        pass(arc, no_index);
    }
  }

  void pass(Index arc, Index v) {
    Front& front = fronts_[arc];
    if(front.last.kind == Kind::PLACE && places_[front.last.place].vertex == no_index)
      places_[front.last.place].vertex = v;
    const float girth = static_cast<float>((std::max)(front.girth, 0.));
    const double total = bridges_.total(arc);
    const double smaller = (std::min)(front.area_below, total - front.area_below);
    End end;
    end.kind = smaller < negligible_ * total ? Kind::NEGLIGIBLE
               : girth > most_girth_         ? Kind::LONG
                                             : Kind::PLACE;
    if(end.kind == Kind::PLACE) {
      end.place = static_cast<Index>(places_.size());
      places_.push_back({v, girth});
    }
    link(front.last, end);
    link(end, front.last);
    front.last = end;
    if(front.first.kind == Kind::NONE)
      front.first = end;
  }

  void link(const End& a, const End& b) {
    if(a.kind != Kind::PLACE)
      return;
    if(b.kind == Kind::NEGLIGIBLE)
      links_.push_back({a.place, no_index, places_[a.place].girth});
    else if(b.kind == Kind::PLACE && a.place < b.place)
      links_.push_back(
          {a.place, b.place, (std::max)(places_[a.place].girth, places_[b.place].girth)});
  }

  // At a node ways go on from each place to each other one, but not into arcs of which next to
  // nothing is beyond: these are bumps. If there is nowhere to go, the way ends.
  void join_at_nodes() {
    for(Index node = 0; node < graph_.nodes.size(); ++node) {
      std::vector<End> ends;
      bool is_end = true;
      for(const Index arc : bridges_.arcs_at(node)) {
        const bool is_upper_end = graph_.arcs[arc].upper == node;
        const End end = is_upper_end ? fronts_[arc].last : fronts_[arc].first;
        is_end = is_end && bridges_.is_bridge(arc) && end.kind != Kind::LONG;
        if(end.kind == Kind::PLACE)
          ends.push_back(end);
      }
      for(const End& a : ends)
        for(const End& b : ends)
          link(a, b);
      if(is_end && ends.size() == 1)
        link(ends.front(), {Kind::NEGLIGIBLE, no_index});
    }
  }

  // Minima grow together over links from short contours to long ones: of two the less low one is
  // at an end, and is a narrow place if it has come far enough. The end of all ways is the lowest.
  std::vector<Index> minima() {
    std::sort(links_.begin(), links_.end(), [](const Link& a, const Link& b) {
      return std::tie(a.girth, a.first, a.second) < std::tie(b.girth, b.first, b.second);
    });
    const Index end = static_cast<Index>(places_.size());
    places_.push_back({no_index, -1.f});
    lowest_.resize(places_.size());
    std::iota(lowest_.begin(), lowest_.end(), Index(0));
    std::vector<char> is_minimum(places_.size(), 1);
    for(const Link& link : links_) {
      Index a = find(link.first), b = find(link.second == no_index ? end : link.second);
      if(a == b)
        continue;
      if(std::make_pair(places_[a].girth, a) < std::make_pair(places_[b].girth, b))
        std::swap(a, b);
      is_minimum[a] = link.girth >= prominence * places_[a].girth;
      lowest_[a] = b;
    }
    std::vector<Index> vertices;
    for(Index i = 0; i < end; ++i)
      if(is_minimum[i] != 0 && places_[i].vertex != no_index &&
         prominence * places_[i].girth <= most_girth_)
        vertices.push_back(places_[i].vertex);
    return vertices;
  }

  Index find(Index i) {
    while(lowest_[i] != i)
      i = lowest_[i] = lowest_[lowest_[i]];
    return i;
  }

  static constexpr double weight_of_length = 3.46; // see Front_mean::girth()

  const Sweep_order& order_;
  const std::vector<Star>& stars_;
  const Flat_reeb_graph& graph_;
  const std::vector<double>& vertex_areas_;
  float most_girth_;
  double negligible_;
  std::vector<double> arc_areas_;
  Bridge_arcs bridges_;
  std::vector<Front> fronts_; // by arc
  std::vector<Place> places_;
  std::vector<Link> links_;
  std::vector<Index> lowest_; // by place, a lower one
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_NARROW_PLACES_H
