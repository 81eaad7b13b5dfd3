// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_BAND_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_BAND_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Fronts.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

/*!
The advancing front of a layer as the paper has it (section 5): the triangles with a vertex that has
a value above a threshold and below one, and the connected components of these. Two triangles are
connected that share an edge.

The paper asks for one or two such vertices. Without the triangles that have three, which are inside
of the band, a band that is wider than an edge would be two fronts, its rims.
*/
class Band_components
{
public:
  Band_components(const Flat_mesh& mesh, double band_threshold)
      : mesh_(mesh)
      , threshold_(band_threshold)
      , triangle_(mesh.neighbor.size(), no_index) {}

  /// finds those of a layer, from its values. Returns their number.
  template <typename Values> Index find(const Values& values) {
    triangles_.clear();
    for(Index u = 0; u < mesh_.number_of_vertices(); ++u)
      if(is_in_band(values[u]))
        add_triangles_at(u);
    Graph graph(triangles_.size());
    for_each_corner([&](Index t, Index u, Index v) {
      const Index beside = triangle_[slot(mesh_, v, u)];
      if(beside != no_index && beside > t)
        boost::add_edge(t, beside, graph);
    });
    component_.resize(triangles_.size());
    return static_cast<Index>(boost::connected_components(graph, component_.data()));
  }

  /// calls `f(v, component)` for each vertex of each triangle, and forgets them.
  template <typename Function> void take(const Function& f) {
    for_each_corner([&](Index t, Index u, Index) { f(u, component_[t]); });
    for_each_corner([&](Index, Index u, Index v) { triangle_[slot(mesh_, u, v)] = no_index; });
  }

private:
  bool is_in_band(double value) const { return value > threshold_ && value < 1.; }

  // Those that are not known by another vertex.
  void add_triangles_at(Index u) {
    const Ring ring = mesh_.ring(u);
    for(Index i = 0; i < ring.size(); ++i) {
      const Index a = ring[i], b = ring[ring.next(i)];
      if(triangle_[mesh_.row_begin[u] + i] != no_index)
        continue;
      const auto t = static_cast<Index>(triangles_.size());
      triangles_.push_back({u, a, b});
      for(const auto& [v, w] : {std::pair(u, a), std::pair(a, b), std::pair(b, u)})
        triangle_[slot(mesh_, v, w)] = t;
    }
  }

  template <typename Function> void for_each_corner(const Function& f) const {
    for(Index t = 0; t < triangles_.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        f(t, triangles_[t][i], triangles_[t][(i + 1) % 3]);
  }

  const Flat_mesh& mesh_;
  double threshold_;
  std::vector<Index> triangle_; // by slot of an edge that has it on its left
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Index> component_;
};

/*!
The initial pass to the letter (paper, 4.1). After each step a layer whose front has several
components is split, each of these going to a new layer; layers that have values at the same vertex
are merged to a new one, which is a handle less than there are layers. The loops are the isolines of
the layers; the longest is left out.

A layer that was split, or has no front any more, is ignored.
*/
class Band_pass
{
public:
  Band_pass(const Flat_mesh& mesh,
            const Field_constants& constants,
            const std::vector<Index>& seeds,
            const Literal_rules& rules)
      : mesh_(mesh)
      , rules_(rules)
      , patience_(patience(constants))
      , field_(mesh, constants, rules)
      , bands_(mesh, rules.band_threshold)
      , is_active_(seeds.size() + 1, 1)
      , layers_(mesh.number_of_vertices(), no_index)
      , times_(mesh.number_of_vertices(), 0.) {
    field_.start(mesh, seeds);
    note_layers();
  }

  const std::vector<Front_meeting>& meetings() const { return meetings_; }

  /// by vertex, the layer that had most of it when it passed the threshold, and the step.
  const std::vector<Index>& layers_of_vertices() const { return layers_; }
  const std::vector<double>& times() const { return times_; }

  std::size_t number_of_covered() const { return number_of_covered_; }
  bool is_done() const { return number_of_covered_ == mesh_.number_of_vertices(); }

  void step() {
    field_.step();
    const Layered_field::Vector_of_values covered = field_.covered();
    for(Index layer = 1, last = static_cast<Index>(is_active_.size()); layer < last; ++layer)
      if(is_active_[layer] != 0)
        split(layer);
    merge(covered);
    const auto now = static_cast<std::size_t>((covered.array() >= threshold).count());
    ++steps_at_rest_;
    if(now > number_of_covered_) { // on slivers the field may come and go
      number_of_covered_ = now;
      steps_at_rest_ = 0;
    }
    if(steps_at_rest_ > patience_)
      fail_at_rest(number_of_covered_, mesh_.number_of_vertices());
    ++number_of_steps_;
    note_layers();
  }

private:
  void note_layers() {
    const Layered_field::Vector_of_values covered = field_.covered();
    std::vector<double> largest(mesh_.number_of_vertices(), 0.);
    std::vector<Index> layers = layers_;
    for(Index layer = 1; layer < is_active_.size(); ++layer)
      for(Layered_field::Matrix::InnerIterator it(field_.phi(), layer); it; ++it) {
        const auto v = static_cast<Index>(it.col());
        if(layers_[v] != no_index || covered[v] < threshold || !(it.value() > largest[v]))
          continue;
        largest[v] = it.value();
        layers[v] = layer;
        times_[v] = static_cast<double>(number_of_steps_);
      }
    layers_ = std::move(layers);
  }

  Index new_layer() {
    is_active_.push_back(1);
    return static_cast<Index>(is_active_.size()) - 1;
  }

  void split(Index layer) {
    const Layered_field::Vector_of_values values = field_.phi().row(layer).transpose();
    const Index count = bands_.find(values);
    std::map<Index, Index> target;
    std::vector<Index> layers;
    for(Index i = 0; i < count && count > 1; ++i)
      layers.push_back(new_layer());
    bands_.take([&](Index v, Index component) {
      if(count > 1 && values[v] > 0. && values[v] < 1.)
        target[v] = layers[component];
    });
    if(count < 2)
      return;
    is_active_[layer] = 0;
    field_.move_rows(is_active_.size(), [&](Index row, Index v) {
      const auto it = row == layer ? target.find(v) : target.end();
      return it == target.end() ? row : it->second;
    });
  }

  void merge(const Layered_field::Vector_of_values& covered) {
    for(const std::vector<Index>& layers : layers_in_contact()) {
      add_handles(layers, covered);
      const Index merged = new_layer();
      std::vector<char> is_merged(is_active_.size(), 0);
      for(const Index layer : layers) {
        is_merged[layer] = 1;
        is_active_[layer] = 0;
      }
      field_.move_rows(is_active_.size(),
                       [&](Index row, Index) { return is_merged[row] != 0 ? merged : row; });
    }
  }

  // Groups of two or more active layers that have values at the same vertices.
  std::vector<std::vector<Index>> layers_in_contact() const {
    Graph graph(is_active_.size());
    std::vector<Index> layer_at(mesh_.number_of_vertices(), no_index);
    for(Index layer = 1; layer < is_active_.size(); ++layer)
      if(is_active_[layer] != 0)
        for(Layered_field::Matrix::InnerIterator it(field_.phi(), layer); it; ++it) {
          if(!(it.value() > rules_.contact_threshold))
            continue;
          Index& first = layer_at[static_cast<Index>(it.col())];
          if(first != no_index)
            boost::add_edge(first, layer, graph);
          first = layer;
        }
    std::vector<Index> group(is_active_.size());
    const auto count = boost::connected_components(graph, group.data());
    std::vector<std::vector<Index>> groups(static_cast<std::size_t>(count));
    for(Index layer = 1; layer < is_active_.size(); ++layer)
      groups[group[layer]].push_back(layer);
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const auto& layers) { return layers.size() < 2; }),
                 groups.end());
    return groups;
  }

  // The isolines of the layers but the longest.
  void add_handles(const std::vector<Index>& layers,
                   const Layered_field::Vector_of_values& covered) {
    std::vector<Crossing_loop> loops = isolines(layers, covered);
    std::stable_sort(loops.begin(), loops.end(),
                     [this](const auto& a, const auto& b) { return is_shorter(mesh_, a, b); });
    if(!loops.empty())
      loops.pop_back();
    for(Crossing_loop& loop : loops)
      meetings_.push_back({std::move(loop), no_index, no_index, no_index, area_of(covered)});
    if(meetings_.size() > mesh_.genus)
      throw Literal_failure_exception("the fronts merged more often than there are handles (" +
                                      std::to_string(mesh_.genus) + ")");
  }

  // Of each of the layers the front, of those around what is covered, that has most of it behind.
  std::vector<Crossing_loop> isolines(const std::vector<Index>& layers,
                                      const Layered_field::Vector_of_values& covered) const {
    Covered_region region(mesh_);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(covered[v] >= threshold) {
        region.add(v);
        for(Index run = 1; run < region.number_of_runs(); ++run)
          region.link_next_run();
      }
    const Fronts fronts(region);
    std::vector<Crossing_loop> loops;
    for(const Index layer : layers) {
      const Layered_field::Vector_of_values values = field_.phi().row(layer).transpose();
      std::vector<double> share(fronts.number_of_fronts(), 0.);
      std::vector<const Crossing*> some(fronts.number_of_fronts(), nullptr);
      for(const Crossing& c : fronts.crossings()) {
        share[fronts.front(c)] += values[c.left];
        some[fronts.front(c)] = &c;
      }
      const auto most = std::max_element(share.begin(), share.end());
      if(most == share.end() || !(*most > 0.))
        continue; // it is about to close
      loops.push_back(placed(fronts.loop(*some[most - share.begin()]), covered));
    }
    return loops;
  }

  const Flat_mesh& mesh_;
  Literal_rules rules_;
  std::size_t patience_;
  Layered_field field_;
  Band_components bands_;
  std::vector<char> is_active_; // by layer
  std::vector<Index> layers_;   // by vertex
  std::vector<double> times_;
  std::vector<Front_meeting> meetings_;
  std::size_t number_of_covered_ = 0, number_of_steps_ = 0, steps_at_rest_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_BAND_PASS_H
