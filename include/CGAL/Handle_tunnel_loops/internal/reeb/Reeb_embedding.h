// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_EMBEDDING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_EMBEDDING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_simplification.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Numbers sorted by groups: those of group g are `items[begin[g]]` to `items[begin[g + 1] - 1]`.
template <typename T> struct Grouped
{
  std::vector<std::size_t> begin;
  std::vector<T> items;

  /// \p for_each calls its argument with (group, item), always in the same order.
  template <typename ForEach>
  Grouped(std::size_t number_of_groups, const ForEach& for_each)
      : begin(number_of_groups + 1, 0) {
    for_each([&](Index group, const T&) { ++begin[group + 1]; });
    for(std::size_t g = 0; g < number_of_groups; ++g)
      begin[g + 1] += begin[g];
    items.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each([&](Index group, const T& item) { items[next[group]++] = item; });
  }
};

/// A mean of the contours that come to a vertex.
struct Reeb_mean
{
  Index vertex;
  Float_point position;
};

using Reeb_means = std::vector<Reeb_mean>;

/// A Reeb graph without its lines, and the means along each arc.
struct Undrawn_reeb_graph
{
  Embedded_reeb_graph graph;
  std::vector<Reeb_means> means;
};

/// The places of a swept Reeb graph.
class Reeb_embedding
{
public:
  /// the samples of the graph are taken from it.
  explicit Reeb_embedding(Flat_reeb_graph& graph)
      : graph_(graph)
      , samples_(graph.arcs.size(), [samples = std::move(graph.samples)](const auto& f) {
        for(const Flat_reeb_graph::Sample& sample : samples)
          f(sample.arc, {sample.vertex, sample.position});
      }) {}

  /// the means along a path, without its ends.
  Reeb_means means(const Reeb_simplification::Path& path) const {
    Reeb_means means;
    for(const Reeb_simplification::Piece& piece : path.pieces) {
      const auto size = static_cast<std::ptrdiff_t>(means.size());
      means.insert(means.end(), samples_.items.begin() + samples_.begin[piece.arc],
                   samples_.items.begin() + samples_.begin[piece.arc + 1]);
      if(piece.is_reversed)
        std::reverse(means.begin() + size, means.end());
    }
    return means;
  }

  /// fills in what the means say of an arc.
  void measure(Index a, Arc_extent& extent) const {
    const Flat_reeb_graph::Arc& arc = graph_.arcs[a];
    Polyline line;
    if(graph_.nodes[arc.lower].kind == Node_kind::MINIMUM)
      line.push_back(graph_.nodes[arc.lower].position);
    append_samples(a, line);
    if(graph_.nodes[arc.upper].kind == Node_kind::MAXIMUM)
      line.push_back(graph_.nodes[arc.upper].position);
    extent.lower.girth = arc.lower_girth;
    extent.upper.girth = arc.upper_girth;
    extent.has_points = !line.empty();
    if(extent.has_points) {
      extent.length = static_cast<float>(length(line));
      extent.lower.point = to_float_point(line.front());
      extent.upper.point = to_float_point(line.back());
    }
  }

private:
  void append_samples(Index arc, Polyline& line) const {
    for(std::size_t i = samples_.begin[arc]; i < samples_.begin[arc + 1]; ++i)
      line.push_back(to_vector(samples_.items[i].position));
  }

  const Flat_reeb_graph& graph_;
  Grouped<Reeb_mean> samples_; // by arc
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_EMBEDDING_H
