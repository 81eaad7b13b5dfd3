// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_SWEEP_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_SWEEP_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_trees.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Unfolds a saddle with k lower components into k - 1 simple ones. In step i the contour arc around
lower components 0 .. i - 1 and the contour arc around lower component i are cut and joined
crosswise. If they belong to different contours, these meet; if not, their contour parts. Two
different contours that both end at holes exchange their ends: they meet, and part.

A contour that is only the vertex, beside a hole, is none: nothing meets it, and nothing parts from
it. So a closed contour that is cut open there, or closes, goes on.
*/
class Saddle_resolution
{
public:
  /// goes through the steps; each calls `meet(a, b)`, which gives the arc above of two arcs that
  /// meet, or `part(a)`, which gives the two arcs above of one that parts. Then the contour arcs
  /// name the arcs above the saddle.
  template <typename Meet, typename Part>
  void resolve(Index number_of_lower_components,
               Contour_arcs& contour_arcs,
               const Meet& meet,
               const Part& part) {
    start(number_of_lower_components, contour_arcs);
    for(Index i = 1; i < number_of_lower_components; ++i) {
      const Index a = contour_of(incoming_[i - 1]), b = contour_of(incoming_[i]);
      std::swap(leaving_[i - 1], leaving_[i]);
      std::swap(place_[leaving_[i - 1]], place_[leaving_[i]]);
      const bool do_part = a == b || (has_ends_[a] && has_ends_[b]);
      if(a != b) {
        next_[b] = a;
        has_ends_[a] = has_ends_[a] || has_ends_[b];
        arc_[a] = arc_[a] == no_index   ? arc_[b]
                  : arc_[b] == no_index ? arc_[a]
                                        : meet(arc_[a], arc_[b]);
      }
      if(do_part)
        separate(contour_arcs, a, b, i, part);
    }
    for(Index i = 0; i < contour_arcs.size(); ++i)
      contour_arcs[i].arc = arc_[contour_of(i)];
  }

private:
  // Contour_arcs of one contour below have one number.
  void start(Index k, const Contour_arcs& contour_arcs) {
    const Index n = static_cast<Index>(contour_arcs.size());
    incoming_.assign(k, no_index);
    leaving_.resize(k);
    contour_.assign(n, no_index);
    next_.clear();
    arc_.clear();
    has_ends_.clear();
    std::iota(leaving_.begin(), leaving_.end(), Index(0));
    place_ = leaving_;
    for(Index i = 0; i < n; ++i)
      if(contour_arcs[i].arrival != no_index) {
        CGAL_expensive_precondition(incoming_[contour_arcs[i].arrival] == no_index);
        incoming_[contour_arcs[i].arrival] = i;
      }
    for(Index j = 0; j < n; ++j) { // contours that come from a hole first
      const Index i = j < n - k ? k + j : j - (n - k);
      if(contour_[i] != no_index)
        continue;
      const Index contour = new_contour(contour_arcs[i].arc, i >= k);
      for(Index c = i; c != no_index && contour_[c] == no_index; c = contour_arcs[c].arrival)
        contour_[c] = contour;
    }
  }

  Index new_contour(Index arc, bool has_ends) {
    next_.push_back(static_cast<Index>(next_.size()));
    arc_.push_back(arc);
    has_ends_.push_back(has_ends);
    return next_.back();
  }

  Index contour_of(Index contour_arc) {
    Index c = contour_[contour_arc];
    while(next_[c] != c)
      c = next_[c] = next_[next_[c]];
    return c;
  }

  // Parts contour a into those around lower components i - 1 and i. They are gone along in turns,
  // and the shorter one gets a new number.
  template <typename Part>
  void separate(const Contour_arcs& contour_arcs, Index a, Index b, Index i, const Part& part) {
    Way ways[2] = {{i - 1, i - 1}, {i, i}};
    passed_[0].clear();
    passed_[1].clear();
    int side = 0;
    while(advance(contour_arcs, ways[side], passed_[side]))
      side = 1 - side;
    const auto is_none = [&](Index component) {
      return contour_arcs[leaving_[component]].is_empty &&
             contour_arcs[incoming_[component]].is_empty;
    };
    const bool is_shorter_none = is_none(ways[side].first),
               is_other_none = is_none(ways[1 - side].first);
    Index arc = is_other_none ? no_index : arc_[a], other = is_shorter_none ? no_index : arc_[a];
    if(!is_shorter_none && !is_other_none)
      std::tie(arc, other) = part(arc_[a]);
    const bool has_ends = ways[side].is_backward;
    arc_[a] = arc;
    has_ends_[a] = has_ends_[a] && (a != b || !has_ends); // one of two that were one is closed
    const Index contour = new_contour(other, has_ends);
    for(const Index c : passed_[side])
      contour_[c] = contour;
  }

  // Along a contour from a lower component on; from where it ends at a hole, backwards from there.
  struct Way
  {
    Index first, at; // lower components
    bool is_backward = false;
  };

  // Returns false at the end.
  bool advance(const Contour_arcs& contour_arcs, Way& way, std::vector<Index>& passed) const {
    passed.push_back(way.is_backward ? incoming_[way.at] : leaving_[way.at]);
    if(way.is_backward) {
      if(passed.back() >= leaving_.size())
        return false;
      way.at = place_[passed.back()];
      return true;
    }
    way.at = contour_arcs[passed.back()].arrival;
    if(way.at == no_index) {
      way.at = way.first;
      way.is_backward = true;
      return true;
    }
    return way.at != way.first;
  }

  std::vector<Index> incoming_, leaving_; // by lower component, a contour arc
  std::vector<Index> place_;              // by contour arc, the lower component where it leaves
  std::vector<Index> contour_;            // by contour arc, a number
  std::vector<Index> next_;               // by number, another one that it became a part of
  std::vector<Index> arc_;                // by number
  std::vector<char> has_ends_;            // by number, at holes
  std::vector<Index> passed_[2];
};

/*!
Computes the Reeb graph of the function that an order of the vertices stands for, by a sweep from
the lowest vertex to the highest.

At a regular vertex a contour passes, at a minimum one begins, at a maximum one ends. At a saddle,
contours that are different meet, and one that comes to it twice parts; a saddle with more than two
lower components is unfolded. Hence a closed surface of genus g has g independent cycles whatever
the order is, by Euler's formula: k lower components make k - 1 nodes with three arcs.

Where the order leaves holes, contours end there. What the graph of a closed surface loses or gains
by a hole depends on the function: g to 2 g + b - 1 cycles, if there are b holes.

As long as few edges are walked over, the contours are kept as labels, which is linear but for a
sort; if many, or if there are holes, they are kept as trees, and the rest takes O(n log n). So all
takes O(n log n) in any case.
*/
class Reeb_sweep
{
public:
  /// \p largest_number_of_steps is how many edges may be walked over before trees are used, and
  /// \p spacing the distance of the samples.
  Reeb_sweep(const Flat_mesh& mesh,
             const Sweep_order& order,
             const std::vector<Star>& stars,
             std::uint64_t largest_number_of_steps,
             double spacing)
      : mesh_(mesh)
      , order_(order)
      , stars_(stars)
      , labels_(mesh, order)
      , largest_number_of_steps_(largest_number_of_steps)
      , squared_spacing_(spacing * spacing) {}

  Flat_reeb_graph run() {
    graph_.vertex_arc.assign(mesh_.number_of_vertices(), no_index);
    if(!order_.has_holes())
      reserve();
    const std::vector<Index>& vertices = order_.vertices();
    std::size_t r = 0;
    if(!order_.has_holes())
      for(; r < vertices.size() && labels_.number_of_steps() <= largest_number_of_steps_; ++r)
        pass_with_labels(vertices[r]);
    if(r < vertices.size()) {
      trees_ = std::make_unique<Contour_trees>(mesh_, order_);
      trees_->build(labels_, static_cast<Index>(r));
      for(; r < vertices.size(); ++r)
        pass_with_trees(vertices[r]);
    }
    CGAL_postcondition_msg(order_.has_holes() || (graph_.nodes.size() == number_of_nodes_ &&
                                                  graph_.arcs.size() == number_of_arcs_),
                           "as many nodes and arcs as Euler's formula says");
    CGAL_expensive_postcondition(are_degrees_right());
    return std::move(graph_);
  }

  std::uint64_t number_of_steps() const { return labels_.number_of_steps(); }
  bool has_used_trees() const { return trees_ != nullptr; }

private:
  // Euler's formula tells how many nodes and arcs there will be, if there are no holes.
  void reserve() {
    std::size_t extrema = 0;
    for(const Star& star : stars_)
      extrema += star.kind == Vertex_kind::MINIMUM || star.kind == Vertex_kind::MAXIMUM;
    const std::size_t saddles = extrema + 2 * mesh_.genus - 2 * mesh_.seeds.size();
    CGAL_assertion((extrema + 3 * saddles) % 2 == 0);
    number_of_nodes_ = extrema + saddles;
    number_of_arcs_ = (extrema + 3 * saddles) / 2;
    graph_.nodes.reserve(number_of_nodes_);
    graph_.arcs.reserve(number_of_arcs_);
    front_.reserve(number_of_arcs_);
  }

  // Whether extrema have one arc and saddles three, and all arcs go up.
  bool are_degrees_right() const {
    std::vector<Index> degree(graph_.nodes.size(), 0);
    for(const Flat_reeb_graph::Arc& arc : graph_.arcs) {
      if(arc.lower >= arc.upper || arc.upper >= degree.size())
        return false;
      ++degree[arc.lower];
      ++degree[arc.upper];
    }
    for(std::size_t i = 0; i < degree.size(); ++i)
      if(degree[i] != (graph_.nodes[i].kind == Node_kind::SADDLE ? 3u : 1u))
        return false;
    return true;
  }

  void pass_with_labels(Index v) {
    const Star& star = stars_[v];
    switch(star.kind) {
    case Vertex_kind::REGULAR: {
      const Index arc = labels_.arc_at(star.below);
      labels_.pass(v, arc);
      pass(v, arc);
      break;
    }
    case Vertex_kind::MINIMUM:
      begin(v);
      labels_.add_arcs(number_of_arcs());
      labels_.pass(v, graph_.vertex_arc[v]);
      break;
    case Vertex_kind::MAXIMUM:
      end(v, labels_.arc_at(star.below));
      break;
    case Vertex_kind::SADDLE: {
      const Swept_vertex at(mesh_, order_, v);
      labels_.cut(at, contour_arcs_, [this](Index arc) { return front_[arc].sum; });
      resolve(at);
      labels_.add_arcs(number_of_arcs());
      labels_.join(at, contour_arcs_);
    }
    }
  }

  void pass_with_trees(Index v) {
    switch(stars_[v].kind) {
    case Vertex_kind::MINIMUM:
      begin(v);
      trees_->start(v, graph_.vertex_arc[v]);
      break;
    case Vertex_kind::MAXIMUM:
      end(v, trees_->end(v));
      break;
    default: {
      const Swept_vertex at(mesh_, order_, v);
      trees_->cut(at, contour_arcs_);
      if(stars_[v].kind == Vertex_kind::REGULAR)
        pass(v, contour_arcs_[0].arc);
      else
        resolve(at);
      trees_->join(at, contour_arcs_);
    }
    }
  }

  Index number_of_arcs() const { return static_cast<Index>(graph_.arcs.size()); }

  Index add_node(Index v, Node_kind kind, const Vector& position) {
    graph_.nodes.push_back({v, kind, position});
    return static_cast<Index>(graph_.nodes.size() - 1);
  }

  Index add_arc(Index lower) {
    graph_.arcs.push_back({lower, no_index, 0.f, 0.f});
    front_.push_back({{}, to_float_point(graph_.nodes[lower].position)});
    return number_of_arcs() - 1;
  }

  void end_arc(Index arc, Index upper) {
    CGAL_precondition_msg(graph_.arcs[arc].upper == no_index, "an arc ends once");
    graph_.arcs[arc].upper = upper;
    graph_.arcs[arc].upper_girth = front_[arc].sum.girth();
  }

  void begin(Index v) {
    const Index arc = add_arc(add_node(v, Node_kind::MINIMUM, mesh_.points[v]));
    front_[arc].sum = stars_[v].change;
    graph_.vertex_arc[v] = arc;
  }

  void end(Index v, Index arc) {
    end_arc(arc, add_node(v, Node_kind::MAXIMUM, mesh_.points[v]));
    graph_.vertex_arc[v] = arc;
  }

  void pass(Index v, Index arc) {
    graph_.vertex_arc[v] = arc;
    front_[arc].sum += stars_[v].change;
    sample(v, arc);
  }

  // Nodes are made for each simple saddle, at the mean of all that comes to the vertex.
  void resolve(const Swept_vertex& at) {
    const Index v = at.center();
    const Index number_of_nodes = static_cast<Index>(graph_.nodes.size());
    graph_.vertex_arc[v] = contour_arcs_[at.is_hole(0) ? 1 : 0].arc;
    Front_mean below;
    for(const Contour_arc& contour_arc : contour_arcs_)
      below += contour_arc.front;
    for(Index i = 0; i < at.number_of_lower_components(); ++i)
      below += at.front_below(i);
    const Vector position = below.mean(mesh_.points[v]);
    resolution_.resolve(
        at.number_of_lower_components(), contour_arcs_,
        [&](Index a, Index b) {
          const Index node = add_node(v, Node_kind::SADDLE, position);
          end_arc(a, node);
          end_arc(b, node);
          return add_arc(node);
        },
        [&](Index a) {
          const Index node = add_node(v, Node_kind::SADDLE, position);
          end_arc(a, node);
          const Index first = add_arc(node);
          return std::make_pair(first, add_arc(node));
        });
    add_up_fronts(at);
    for(const Contour_arc& contour_arc : contour_arcs_)
      if(contour_arc.arc != no_index) {
        Flat_reeb_graph::Arc& arc = graph_.arcs[contour_arc.arc];
        if(arc.lower >= number_of_nodes) // it begins here
          arc.lower_girth = front_[contour_arc.arc].sum.girth();
        sample(v, contour_arc.arc);
      }
  }

  // Those of the arcs above a saddle.
  void add_up_fronts(const Swept_vertex& at) {
    for(const Contour_arc& contour_arc : contour_arcs_)
      if(contour_arc.arc != no_index)
        front_[contour_arc.arc].sum = {};
    for(const Contour_arc& contour_arc : contour_arcs_)
      if(contour_arc.arc != no_index) {
        Front_mean& front = front_[contour_arc.arc].sum;
        front += contour_arc.front;
        if(contour_arc.arrival != no_index)
          front += at.front_above(contour_arc.arrival);
      }
  }

  void sample(Index v, Index arc) {
    Running_front& front = front_[arc];
    const Vector mean = front.sum.mean(mesh_.points[v]);
    const Vector step = mean - to_vector(front.last_sample);
    if(dot(step, step) <= squared_spacing_)
      return;
    front.last_sample = to_float_point(mean);
    graph_.samples.push_back({arc, v, front.last_sample});
  }

  struct Running_front
  {
    Front_mean sum;
    Float_point last_sample;
  };

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  const std::vector<Star>& stars_;
  Contour_labels labels_;
  std::unique_ptr<Contour_trees> trees_;
  std::uint64_t largest_number_of_steps_;
  double squared_spacing_;
  Saddle_resolution resolution_;
  Flat_reeb_graph graph_;
  std::size_t number_of_nodes_ = 0, number_of_arcs_ = 0; // that there will be
  std::vector<Running_front> front_;                     // by arc
  Contour_arcs contour_arcs_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_SWEEP_H
