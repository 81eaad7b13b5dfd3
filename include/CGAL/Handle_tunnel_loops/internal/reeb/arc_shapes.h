// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_SHAPES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_SHAPES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Bridge_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Face_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

template <typename Point> double distance_of_points(const Point& p, const Point& q) {
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
}

/// The contours of arcs, one of each, as they are found face by face.
class Contours_of_arcs
{
public:
  explicit Contours_of_arcs(std::size_t number_of_arcs)
      : number_of_arcs_(number_of_arcs) {}

  /// of an arc: across a face from one edge to another.
  void add(std::size_t arc, const std::array<std::uint64_t, 2>& edges, double length) {
    std::array<Index, 2> ends;
    for(std::size_t i : {0, 1})
      ends[i] = ends_.try_emplace({arc, edges[i]}, static_cast<Index>(ends_.size())).first->second;
    pieces_.push_back({arc, ends, length});
  }

  /// by arc, the length of what hangs together, where there are several of them that of the
  /// longest.
  std::vector<double> longest() const {
    Sets_of_indices sets(ends_.size());
    for(Index i = 0; i < ends_.size(); ++i)
      sets.make_set(i);
    for(const Piece& piece : pieces_)
      sets.unite(piece.ends[0], piece.ends[1]);
    std::vector<double> lengths(ends_.size()), longest(number_of_arcs_);
    for(const Piece& piece : pieces_)
      lengths[sets.find(piece.ends[0])] += piece.length;
    for(const Piece& piece : pieces_)
      longest[piece.arc] = (std::max)(longest[piece.arc], lengths[sets.find(piece.ends[0])]);
    return longest;
  }

private:
  struct Piece
  {
    std::size_t arc;
    std::array<Index, 2> ends;
    double length;
  };

  std::size_t number_of_arcs_;
  std::map<std::pair<std::size_t, std::uint64_t>, Index> ends_; // numbers of places
  std::vector<Piece> pieces_;
};

/// by arc, how long its contour is half way. See `CGAL::reeb_arc_girths()`.
template <typename Vertices, typename Graph, typename VertexPointMap>
std::vector<double>
girths_of_arcs(const Vertices& vertices, const Graph& graph, VertexPointMap point) {
  using Vertex = typename Vertices::Vertex;
  std::vector<double> levels(num_edges(graph));
  for(const auto e : CGAL::make_range(edges(graph))) {
    const auto& arc = graph[e];
    if(!arc.vertices.empty())
      levels[arc.index] = vertices.value(arc.vertices[arc.vertices.size() / 2]);
  }
  const auto at = [&](Vertex v, Vertex w, double level) {
    const double low = vertices.value(v), high = vertices.value(w);
    const double ratio = low < high ? (level - low) / (high - low) : 0.;
    return get(point, v) + ratio * (get(point, w) - get(point, v));
  };
  Face_arcs<Vertices, Graph> arcs(vertices, graph);
  Contours_of_arcs contours(levels.size());
  for(const auto f : faces(vertices.mesh())) {
    const auto v = arcs.corners_of(f);
    for(const Face_part& part : arcs.parts_of(v)) {
      const double level = levels[part.arc];
      if(!(part.low < level && level <= part.high))
        continue;
      const bool is_above = vertices.value(v[1]) < level;
      const auto [low, high] = is_above ? std::pair(v[1], v[2]) : std::pair(v[0], v[1]);
      contours.add(part.arc, {vertices.edge(v[0], v[2]), vertices.edge(low, high)},
                   distance_of_points(at(v[0], v[2], level), at(low, high, level)));
    }
  }
  return contours.longest();
}

// Vertices and points of a polyline follow each other by the same values, so that the nearest one
// is not far from that of the vertex before.
template <typename Point>
std::size_t nearest_place(const std::vector<Point>& line, const Point& p, std::size_t k) {
  const auto squared = [&](std::size_t i) { return CGAL::squared_distance(line[i], p); };
  while(k + 1 < line.size() && squared(k + 1) <= squared(k))
    ++k;
  while(k > 0 && squared(k - 1) < squared(k))
    --k;
  return k;
}

// Fills places without a number from both sides.
inline void fill_gaps(const std::vector<std::size_t>& counts, std::vector<double>& numbers) {
  const std::size_t n = numbers.size();
  for(std::size_t i = 0; i < n; ++i) {
    if(counts[i] > 0)
      continue;
    std::size_t end = i;
    while(end < n && counts[end] == 0)
      ++end;
    const double before = i > 0 ? numbers[i - 1] : numbers[end];
    const double after = end < n ? numbers[end] : before;
    for(std::size_t k = i; k < end; ++k) {
      const double t = static_cast<double>(k - i + 1) / static_cast<double>(end - i + 1);
      numbers[k] = before + t * (after - before);
    }
    i = end;
  }
}

/// by point of the polyline of an arc, how far away its vertices are. See `CGAL::Reeb_arc_shapes`.
template <typename Arc, typename VertexPointMap>
std::vector<double> radii_of_arc(const Arc& arc, VertexPointMap point, double girth) {
  std::vector<double> radii(arc.polyline.size(), 0.);
  std::vector<std::size_t> counts(radii.size(), 0);
  std::size_t k = 0;
  for(const auto v : arc.vertices) {
    k = nearest_place(arc.polyline, get(point, v), k);
    radii[k] += distance_of_points(arc.polyline[k], get(point, v));
    ++counts[k];
  }
  if(arc.vertices.empty())
    return std::vector<double>(radii.size(), girth / (2. * CGAL_PI));
  for(std::size_t i = 0; i < radii.size(); ++i)
    if(counts[i] > 0)
      radii[i] /= static_cast<double>(counts[i]);
  fill_gaps(counts, radii);
  return radii;
}

/// by arc, whether the graph stays connected without it.
template <typename Graph> std::vector<bool> arcs_on_cycles(const Graph& graph) {
  Flat_reeb_graph flat;
  flat.nodes.resize(num_vertices(graph));
  flat.arcs.resize(num_edges(graph));
  for(const auto e : CGAL::make_range(edges(graph))) {
    flat.arcs[graph[e].index].lower = static_cast<Index>(source(e, graph));
    flat.arcs[graph[e].index].upper = static_cast<Index>(target(e, graph));
  }
  const std::vector<double> weights(flat.arcs.size());
  const Bridge_arcs bridges(flat, weights);
  std::vector<bool> is_on_cycle(flat.arcs.size());
  for(Index arc = 0; arc < is_on_cycle.size(); ++arc)
    is_on_cycle[arc] = !bridges.is_bridge(arc);
  return is_on_cycle;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_SHAPES_H
