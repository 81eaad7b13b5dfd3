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
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Unfolds a saddle with k lower components into k - 1 simple ones. In step i the contour arc around
lower components 0 .. i - 1 and the contour arc around lower component i are cut and joined
crosswise. If they belong to different contours, these meet; if not, their contour parts.
*/
class Saddle_resolution
{
public:
  /// goes through the steps; each calls `meet(a, b)`, which gives the arc above of two arcs that
  /// meet, or `part(a)`, which gives the two arcs above of one that parts. Then the contour arcs
  /// name the arcs above the saddle.
  template <typename Meet, typename Part>
  void resolve(Contour_arcs& contour_arcs, const Meet& meet, const Part& part) {
    start(contour_arcs);
    for(Index i = 1; i < contour_arcs.size(); ++i) {
      const Index a = contour_of(incoming_[i - 1]), b = contour_of(incoming_[i]);
      std::swap(leaving_[i - 1], leaving_[i]);
      if(a != b) {
        next_[b] = a;
        arc_[a] = meet(arc_[a], arc_[b]);
      } else {
        const auto [arc, other] = part(arc_[a]);
        arc_[a] = arc;
        separate_shorter(contour_arcs, i - 1, i, other);
      }
    }
    for(Index i = 0; i < contour_arcs.size(); ++i)
      contour_arcs[i].arc = arc_[contour_of(i)];
  }

private:
  // Contour_arcs of one contour below have one number.
  void start(const Contour_arcs& contour_arcs) {
    const Index k = static_cast<Index>(contour_arcs.size());
    incoming_.resize(k);
    leaving_.resize(k);
    contour_.assign(k, no_index);
    next_.clear();
    arc_.clear();
    std::iota(leaving_.begin(), leaving_.end(), Index(0));
    CGAL_expensive_precondition(is_permutation(contour_arcs));
    for(Index i = 0; i < k; ++i) {
      incoming_[contour_arcs[i].arrival] = i;
      if(contour_[i] != no_index)
        continue;
      const Index contour = new_contour(contour_arcs[i].arc);
      for(Index j = i; contour_[j] == no_index; j = contour_arcs[j].arrival)
        contour_[j] = contour;
    }
  }

  // Whether one arc arrives at each lower component.
  static bool is_permutation(const Contour_arcs& contour_arcs) {
    std::vector<char> is_taken(contour_arcs.size(), 0);
    for(const Contour_arc& arc : contour_arcs) {
      if(arc.arrival >= is_taken.size() || is_taken[arc.arrival])
        return false;
      is_taken[arc.arrival] = 1;
    }
    return true;
  }

  Index new_contour(Index arc) {
    next_.push_back(static_cast<Index>(next_.size()));
    arc_.push_back(arc);
    return next_.back();
  }

  Index contour_of(Index contour_arc) {
    Index c = contour_[contour_arc];
    while(next_[c] != c)
      c = next_[c] = next_[next_[c]];
    return c;
  }

  // The contours that leave lower components i and j are gone along in turns, and the one that
  // closes first gets a new number.
  void separate_shorter(const Contour_arcs& contour_arcs, Index i, Index j, Index arc) {
    Index at[2] = {i, j};
    const Index first[2] = {i, j};
    passed_[0].clear();
    passed_[1].clear();
    for(int side = 0;; side = 1 - side) {
      const Index contour_arc = leaving_[at[side]];
      passed_[side].push_back(contour_arc);
      at[side] = contour_arcs[contour_arc].arrival;
      if(at[side] == first[side]) {
        const Index contour = new_contour(arc);
        for(Index s : passed_[side])
          contour_[s] = contour;
        return;
      }
    }
  }

  std::vector<Index> incoming_, leaving_; // by lower component, a contour arc
  std::vector<Index> contour_;            // by contour arc, a number
  std::vector<Index> next_;               // by number, another one that it became a part of
  std::vector<Index> arc_;                // by number
  std::vector<Index> passed_[2];
};

/*!
Computes the Reeb graph of the function that an order of the vertices stands for, by a sweep from
the lowest vertex to the highest.

At a regular vertex a contour passes, at a minimum one begins, at a maximum one ends. At a saddle,
contours that are different meet, and one that comes to it twice parts; a saddle with more than two
lower components is unfolded. Hence a closed surface of genus g has g independent cycles whatever
the order is, by Euler's formula: k lower components make k - 1 nodes with three arcs.

As long as few edges are walked over, the contours are kept as labels, which is linear but for a
sort; if many, they go over into trees, and the rest takes O(n log n). So all takes O(n log n) in
any case.
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
    graph_.vertex_arc.resize(mesh_.number_of_vertices());
    reserve();
    const std::vector<Index>& vertices = order_.vertices();
    std::size_t r = 0;
    for(; r < vertices.size() && labels_.number_of_steps() <= largest_number_of_steps_; ++r)
      pass_with_labels(vertices[r]);
    if(r < vertices.size()) {
      trees_ = std::make_unique<Contour_trees>(mesh_, order_);
      trees_->build(labels_, static_cast<Index>(r));
      for(; r < vertices.size(); ++r)
        pass_with_trees(vertices[r]);
    }
    CGAL_postcondition_msg(graph_.nodes.size() == number_of_nodes_ &&
                               graph_.arcs.size() == number_of_arcs_,
                           "as many nodes and arcs as Euler's formula says");
    CGAL_expensive_postcondition(are_degrees_right());
    return std::move(graph_);
  }

  std::uint64_t number_of_steps() const { return labels_.number_of_steps(); }
  bool has_used_trees() const { return trees_ != nullptr; }

private:
  // Euler's formula tells how many nodes and arcs there will be.
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
    graph_.vertex_arc[v] = contour_arcs_[0].arc;
    Front_mean below;
    for(Index i = 0; i < at.number_of_lower_components(); ++i) {
      below += contour_arcs_[i].front;
      below += at.front_below(i);
    }
    const Vector position = below.mean(mesh_.points[v]);
    resolution_.resolve(
        contour_arcs_,
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
    for(Index i = 0; i < at.number_of_lower_components(); ++i) {
      Front_mean& front = front_[contour_arcs_[i].arc].sum;
      front += contour_arcs_[i].front;
      front += at.front_above(contour_arcs_[i].arrival);
    }
    for(const Contour_arc& contour_arc : contour_arcs_) {
      graph_.arcs[contour_arc.arc].lower_girth = front_[contour_arc.arc].sum.girth();
      sample(v, contour_arc.arc);
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
