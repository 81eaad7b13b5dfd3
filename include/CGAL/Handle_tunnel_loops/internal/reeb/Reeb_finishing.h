// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_FINISHING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_FINISHING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Arc_contraction.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Limb_bases.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_embedding.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Short_borders.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/draw_lines.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/measure_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// From a swept graph to one that is handed out: simplified, contracted, embedded, and with the
/// vertices of its arcs.
class Reeb_finishing
{
public:
  Reeb_finishing(Execution execution,
                 const Flat_mesh& mesh,
                 const Sweep_order& order,
                 Flat_reeb_graph& graph,
                 const Function_on_vertices& function)
      : execution_(execution)
      , mesh_(mesh)
      , order_(order)
      , graph_(graph)
      , function_(function)
      , embedding_(graph) {}

  Embedded_reeb_graph run(Reeb_measure measure, double threshold, double shortest_arc) const {
    Undrawn_reeb_graph undrawn = shortest_arc > 0.
                                     ? contracted_graph(measure, threshold, shortest_arc)
                                     : simplified_graph(measure, threshold);
    draw_lines(execution_, mesh_, order_, undrawn);
    return std::move(undrawn.graph);
  }

  /// what there is to draw. Nothing but the lines depends on how it is drawn.
  Undrawn_reeb_graph simplified_graph(Reeb_measure measure, double threshold) const {
    if(!(threshold > 0.)) {
      const auto path = [this](Index a) {
        return Path{graph_.arcs[a].lower, graph_.arcs[a].upper, {{a, false}}};
      };
      return graph_of(graph_.arcs.size(), path, [this](Index v) { return graph_.vertex_arc[v]; });
    }
    const auto [paths, path_of_arc] = simplified(measure, threshold);
    return graph_of(
        paths.size(), [&paths = paths](Index i) -> const Path& { return paths[i]; },
        [this, &path_of_arc = path_of_arc](Index v) { return path_of_arc[graph_.vertex_arc[v]]; });
  }

  /// the same without arcs between saddles that are less long than so many times their radius: each
  /// arc stands for a part of the surface, of which the borders are short.
  Undrawn_reeb_graph
  contracted_graph(Reeb_measure measure, double threshold, double shortest_arc) const {
    auto [paths, path_of_arc] = simplified(measure, threshold);
    std::vector<Index> part_of_vertex(graph_.vertex_arc.size());
    // Borders are moved on the surface with its caps: a hole goes with a vertex beside it.
    for(Index v = 0; v < part_of_vertex.size(); ++v)
      part_of_vertex[v] = path_of_arc[graph_.vertex_arc[order_.is_hole(v) ? mesh_.ring(v)[0] : v]];
    Arc_contraction contraction(graph_.nodes.size(), sized_arcs(paths, part_of_vertex),
                                shared_borders(mesh_, part_of_vertex));
    contraction.run(shortest_arc);

    std::vector<Path> kept;
    std::vector<Index> number(paths.size(), no_index);
    for(Index i = 0; i < paths.size(); ++i)
      if(contraction.is_kept(i)) {
        number[i] = static_cast<Index>(kept.size());
        kept.push_back(
            between(std::move(paths[i]), contraction.arc(i).lower, contraction.arc(i).upper));
      }
    for(Index& part : part_of_vertex)
      part = number[contraction.owner(part)];
    Short_borders(mesh_, part_of_vertex).run();
    Limb_bases(mesh_, part_of_vertex).run(tips(kept));
    Short_borders(mesh_, part_of_vertex).run();
    return graph_of(
        kept.size(), [&](Index i) -> const Path& { return kept[i]; },
        [&](Index v) { return part_of_vertex[v]; });
  }

private:
  using Path = Reeb_simplification::Path;

  // A leaf that is less long than this, in units of the radius at its base, is a bump and no limb.
  // On animals and parts, most bumps and round ends have less, toes, ears, legs and heads have
  // more.
  static constexpr double slenderness_of_limbs = 0.8;

  // The paths, and for each arc the number of its path.
  std::pair<std::vector<Path>, std::vector<Index>> simplified(Reeb_measure measure,
                                                              double threshold) const {
    Reeb_simplification simplification(graph_, extents(measure));
    if(!(threshold > 0.))
      return simplification.result();
    const std::vector<double> sizes = sizes_of_components(measure);
    simplification.run([measure](const Arc_extent& extent) { return size(extent, measure); },
                       [&](const Arc_extent& extent, const Arc_end& base, Index node) {
                         const Index c = mesh_.component[graph_.nodes[node].vertex];
                         return size(extent, measure) <= threshold * sizes[c] ||
                                (measure == Reeb_measure::LIMBS &&
                                 extent.slenderness(base) < slenderness_of_limbs);
                       });
    return simplification.result();
  }

  static double size(const Arc_extent& extent, Reeb_measure measure) {
    switch(measure) {
    case Reeb_measure::LENGTH:
      return extent.length;
    case Reeb_measure::AREA:
    case Reeb_measure::VERTICES:
      return extent.amount;
    default:
      return extent.high - extent.low;
    }
  }

  // What of the surface belongs to a vertex.
  double amount_at(Index v, Reeb_measure measure) const {
    return measure == Reeb_measure::AREA ? area_at(v) : 1.;
  }

  std::vector<Arc_extent> extents(Reeb_measure measure) const {
    std::vector<Arc_extent> extents;
    extents.reserve(Reeb_simplification::largest_number_of_paths(graph_));
    extents.resize(graph_.arcs.size());
    for_each_index(execution_, extents.size(), [&](std::size_t a) {
      extents[a].low = function_.value(graph_.nodes[graph_.arcs[a].lower].vertex);
      extents[a].high = function_.value(graph_.nodes[graph_.arcs[a].upper].vertex);
      embedding_.measure(static_cast<Index>(a), extents[a]);
    });
    for(Index v = 0; v < order_.vertices().size(); ++v) // holes come last
      extents[graph_.vertex_arc[v]].amount += amount_at(v, measure);
    return extents;
  }

  // Twice the area of the triangles that a vertex is the smallest one of.
  double area_at(Index v) const {
    const Ring ring = mesh_.ring(v);
    double sum = 0.;
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      if(v < a && v < b && !order_.is_hole(a) && !order_.is_hole(b))
        sum += norm(cross(mesh_.points[a] - mesh_.points[v], mesh_.points[b] - mesh_.points[v]));
    }
    return sum;
  }

  // What a threshold of one means: the range of the function, the diagonal of the box around the
  // component, its area, its number of vertices.
  std::vector<double> sizes_of_components(Reeb_measure measure) const {
    struct Bounds
    {
      Vector low, high;
    };
    const std::size_t number = mesh_.seeds.size();
    std::vector<Arc_extent> extents(number);
    std::vector<Bounds> boxes(number);
    for(std::size_t c = 0; c < number; ++c) {
      extents[c].low = extents[c].high = function_.value(mesh_.seeds[c]);
      boxes[c] = {mesh_.points[mesh_.seeds[c]], mesh_.points[mesh_.seeds[c]]};
    }
    for(Index v = 0; v < order_.vertices().size(); ++v) {
      Arc_extent& extent = extents[mesh_.component[v]];
      Bounds& box = boxes[mesh_.component[v]];
      extent.low = (std::min)(extent.low, function_.value(v));
      extent.high = (std::max)(extent.high, function_.value(v));
      extent.amount += amount_at(v, measure);
      for(int d = 0; d < 3; ++d) {
        box.low[d] = (std::min)(box.low[d], mesh_.points[v][d]);
        box.high[d] = (std::max)(box.high[d], mesh_.points[v][d]);
      }
    }
    std::vector<double> sizes(number);
    for(std::size_t c = 0; c < number; ++c) {
      extents[c].length = static_cast<float>(norm(boxes[c].high - boxes[c].low));
      sizes[c] = size(extents[c], measure);
    }
    return sizes;
  }

  // Of the paths, as arcs of a graph.
  std::vector<Sized_arc> sized_arcs(const std::vector<Path>& paths,
                                    const std::vector<Index>& part_of_vertex) const {
    std::vector<Sized_arc> arcs;
    for(const Path& path : paths) {
      const auto girth = [this](Reeb_simplification::Piece piece, bool is_lower) {
        const Flat_reeb_graph::Arc& arc = graph_.arcs[piece.arc];
        return is_lower != piece.is_reversed ? arc.lower_girth : arc.upper_girth;
      };
      arcs.push_back({path.lower, path.upper, 0.,
                      0.5 * (girth(path.pieces.front(), true) + girth(path.pieces.back(), false))});
    }
    for(Index v = 0; v < order_.vertices().size(); ++v)
      arcs[part_of_vertex[v]].area += area_around(mesh_, v, !order_.has_holes());
    return arcs;
  }

  // By path, the vertex at its end, if it is a leaf at one end alone.
  std::vector<Index> tips(const std::vector<Path>& paths) const {
    std::vector<Index> degree(graph_.nodes.size(), 0), tips;
    for(const Path& path : paths)
      for(const Index node : {path.lower, path.upper})
        ++degree[node];
    for(const Path& path : paths)
      tips.push_back((degree[path.lower] == 1) == (degree[path.upper] == 1)
                         ? no_index
                         : graph_.nodes[degree[path.lower] == 1 ? path.lower : path.upper].vertex);
    return tips;
  }

  // A path after its ends have become these, from the lower one to the upper one.
  static Path between(Path&& path, Index lower, Index upper) {
    Path result = std::move(path);
    result.lower = (std::min)(lower, upper);
    result.upper = (std::max)(lower, upper);
    if(upper < lower) {
      std::reverse(result.pieces.begin(), result.pieces.end());
      for(Reeb_simplification::Piece& piece : result.pieces)
        piece.is_reversed = !piece.is_reversed;
    }
    return result;
  }

  // Of so many paths: `path(i)`, to which the vertices with `path_of_vertex(v) == i` belong.
  template <typename PathAt, typename PathOfVertex>
  Undrawn_reeb_graph graph_of(std::size_t number_of_paths,
                              const PathAt& path,
                              const PathOfVertex& path_of_vertex) const {
    Undrawn_reeb_graph result;
    result.means.resize(number_of_paths);
    result.graph.arcs.resize(number_of_paths);
    number_nodes(path, result.graph);
    const Grouped<Index> vertices(number_of_paths, [&](const auto& f) {
      for(Index v : order_.vertices())
        f(path_of_vertex(v), v);
    });
    for_each_index(
        execution_, number_of_paths,
        [&](std::size_t i) {
          result.means[i] = embedding_.means(path(static_cast<Index>(i)));
          result.graph.arcs[i].vertices.assign(vertices.items.begin() + vertices.begin[i],
                                               vertices.items.begin() + vertices.begin[i + 1]);
        },
        256);
    return result;
  }

  // The nodes that are ends of paths keep their order.
  template <typename PathAt>
  void number_nodes(const PathAt& path, Embedded_reeb_graph& result) const {
    std::vector<Index> number(graph_.nodes.size(), no_index);
    for(Index i = 0; i < result.arcs.size(); ++i) {
      const Path& ends = path(i);
      number[ends.lower] = number[ends.upper] = 0;
      result.arcs[i].lower = ends.lower;
      result.arcs[i].upper = ends.upper;
    }
    for(Index node = 0; node < number.size(); ++node)
      if(number[node] != no_index) {
        number[node] = static_cast<Index>(result.nodes.size());
        result.nodes.push_back(graph_.nodes[node]);
      }
    for(Embedded_reeb_graph::Arc& arc : result.arcs) {
      arc.lower = number[arc.lower];
      arc.upper = number[arc.upper];
    }
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  const Flat_reeb_graph& graph_;
  const Function_on_vertices& function_;
  Reeb_embedding embedding_;
};

/// puts a regular node on an arc, at a part of its length in (0, 1), and returns the arc above it.
inline Embedded_reeb_graph::Arc split_arc(Embedded_reeb_graph& graph, Index a, double where) {
  Embedded_reeb_graph::Arc& arc = graph.arcs[a];
  const Polyline& line = arc.line;
  CGAL_precondition(line.size() >= 2 && where > 0. && where < 1.);
  const double last = double(line.size() - 1), place = rounded_product(where, last);
  const auto whole = static_cast<std::ptrdiff_t>((std::min)(place, last - 0.5));
  const Vector point = line[whole] + (place - double(whole)) * (line[whole + 1] - line[whole]);
  const auto middle = static_cast<std::ptrdiff_t>(where * double(arc.vertices.size()));
  const Index vertex = arc.vertices.empty() ? graph.nodes[arc.lower].vertex : arc.vertices[middle];

  const Index node = static_cast<Index>(graph.nodes.size());
  graph.nodes.push_back({vertex, Node_kind::REGULAR, point});
  Embedded_reeb_graph::Arc above = {node, arc.upper, Polyline(1, point), {}};
  above.line.insert(above.line.end(), line.begin() + whole + 1, line.end());
  above.vertices.assign(arc.vertices.begin() + middle, arc.vertices.end());
  arc.upper = node;
  arc.line.resize(whole + 1);
  arc.line.push_back(point);
  arc.vertices.resize(middle);
  return above;
}

/// marks the arcs that join the same nodes as one before them.
inline std::vector<char> parallel_arcs(const Embedded_reeb_graph& graph) {
  std::vector<std::array<Index, 3>> sorted;
  sorted.reserve(graph.arcs.size());
  for(Index a = 0; a < graph.arcs.size(); ++a) {
    const auto [low, high] = std::minmax(graph.arcs[a].lower, graph.arcs[a].upper);
    sorted.push_back({low, high, a});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> is_parallel(graph.arcs.size(), 0);
  for(std::size_t i = 1; i < sorted.size(); ++i)
    is_parallel[sorted[i][2]] =
        sorted[i][0] == sorted[i - 1][0] && sorted[i][1] == sorted[i - 1][1];
  return is_parallel;
}

/// puts regular nodes on arcs so that no two join the same nodes, and none joins a node to itself.
inline void make_simple(Embedded_reeb_graph& graph) {
  const std::vector<char> is_parallel = parallel_arcs(graph);
  for(Index a = 0; a < is_parallel.size(); ++a)
    if(graph.arcs[a].lower == graph.arcs[a].upper) {
      graph.arcs.push_back(split_arc(graph, a, 2. / 3.));
      graph.arcs.push_back(split_arc(graph, a, 0.5));
    } else if(is_parallel[a])
      graph.arcs.push_back(split_arc(graph, a, 0.5));
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_FINISHING_H
